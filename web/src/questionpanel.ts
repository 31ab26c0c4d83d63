// What is asked, and the answers in words; the free directions as roses.
import { h } from "./dom";
import type { Excursion } from "./excursion";
import type { NearestMarks, RegionMarks } from "./frame";
import { NumberField } from "./numberfield";
import type { Player } from "./player";
import type { Scene } from "./engine";
import type {
  FreeDirections,
  Nearest,
  Overlap,
  QuestionName,
  Questions,
  SeparationAnswer,
  SweptAnswer,
} from "./questions";
import { arcText, rose } from "./rose";
import type { Verdict } from "./workbench";
import { coverageText, roundText, timeText, untested } from "./words";

/** Bodies that have a rose of their own. */
const mostRoses = 12;

/** In the words of docs/questions.md, with the command that asks the same. */
const questions: [QuestionName, string, string][] = [
  ["clearance", "How close do they come?", "taut clearance"],
  ["check_clearance", "Do they keep a clearance?", "taut check --clearance C"],
  ["distance_profile", "How far apart, all of the time?", "taut clearance --profile 200"],
  ["intervals", "When do they overlap, all of the time?", "taut intervals"],
  ["range", "How far can they go from here?", "taut range --from T"],
  ["separate", "In which directions do they come apart?", "taut separate"],
  ["swept", "Which region does a body pass over?", "taut swept --body NAME"],
];

export class QuestionPanel {
  readonly element = h("div", { class: "questions", id: "questions" });
  private readonly boxes = new Map<QuestionName, HTMLInputElement>();
  private readonly words = new Map<QuestionName, HTMLElement>();
  /** The clearance that is to be kept. */
  private readonly margin = new NumberField(
    "Clearance, in the scene's units",
    { id: "margin", min: 0 },
    {
      taken: () => this.choose("check_clearance"),
      wrong: (value) => (value > 0 ? "" : "it must be greater than 0"),
    },
  );
  /** Do bodies turn where they come apart? */
  private readonly turns = h("input", {
    type: "checkbox",
    id: "turns",
    onchange: () => this.choose("separate"),
  });
  private readonly turnsLabel = h(
    "label",
    { class: "of-question", title: "taut separate --turns" },
    this.turns,
    "also one by one, along ways on which they turn",
  );
  /** Which body passes over a region? */
  private readonly body = h("select", {
    id: "swept-body",
    class: "of-question",
    "aria-label": "Body",
    onchange: () => this.choose("swept"),
  });
  private shown = -1;

  constructor(
    private readonly player: Player,
    private readonly asked: Questions,
    private readonly excursion: Excursion,
  ) {
    for (const [name, text, command] of questions) {
      const box = h("input", { type: "checkbox", id: `ask-${name}`, onchange: () => this.choose(name) });
      const words = h("div", { class: "words", id: `answer-${name}`, "aria-live": "polite" });
      this.boxes.set(name, box);
      this.words.set(name, words);
      const label = h("label", { title: command }, box, text);
      this.element.append(label, ...this.optionsBelow(name), words);
    }
  }

  private optionsBelow(name: QuestionName): HTMLElement[] {
    if (name === "check_clearance") return [this.margin.input, this.margin.fault];
    if (name === "separate") return [this.turnsLabel];
    return name === "swept" ? [this.body] : [];
  }

  private choose(name: QuestionName): void {
    this.asked.choose(name, this.boxes.get(name)!.checked ? this.optionsOf(name) : null);
  }

  private optionsOf(name: QuestionName): Record<string, unknown> {
    if (name === "distance_profile") return { instants: 200 };
    if (name === "range") return { from: this.player.t };
    if (name === "separate") return this.turns.checked ? { turns: true, scene: true } : {};
    if (name === "swept") return { body: this.body.value };
    if (name !== "check_clearance") return {};
    // To begin with, a hundredth of the first body.
    if (this.margin.value === null) this.margin.show(roundText(this.player.figures[0].diameter / 100, 1));
    return { clearance: this.margin.value };
  }

  /** The points that are closest, or first closer than is wanted, while the instant is shown at which they are. */
  marks(): NearestMarks | null {
    const { clearance, check_clearance: margin } = this.asked.answers;
    const nearest = clearance?.clearance;
    const { t } = this.player;
    if (nearest?.points && t === nearest.t[0])
      return { points: nearest.points, label: `${roundText(nearest.hi, 9)} apart` };
    const points = margin?.first?.points;
    if (!points || t !== (margin.t?.[0] ?? this.player.start)) return null;
    return { points, label: `${roundText(margin.first!.distance!, 9)} apart` };
  }

  /** What is shown of the answers in the picture. */
  region(): RegionMarks | null {
    const { swept } = this.asked.answers;
    if (!swept) return null;
    const body = this.player.scene.bodies.findIndex(({ name }) => name === swept.body);
    return { body, parts: swept.parts.map(({ outline, holes = [] }) => [outline, ...holes]) };
  }

  /** The bodies of the scene; the one that was asked about stays chosen while it is there. */
  private showBodies(): void {
    const names = this.player.scene.bodies.map(({ name }) => name);
    const key = JSON.stringify(names);
    if (this.body.dataset.key === key) return;
    this.body.dataset.key = key;
    const last = this.body.value || (this.asked.asked.swept?.body as string | undefined);
    const chosen = last !== undefined && names.includes(last) ? last : names[names.length - 1];
    this.body.replaceChildren(...names.map((name) => h("option", { value: name, selected: name === chosen }, name)));
    if (this.asked.asked.swept && chosen !== this.asked.asked.swept.body) this.choose("swept");
  }

  show(): void {
    this.showBodies();
    if (this.shown === this.asked.version) return;
    this.shown = this.asked.version;
    this.turnsLabel.hidden = this.asked.asked.separate === undefined;
    this.body.hidden = this.asked.asked.swept === undefined;
    this.margin.input.hidden = this.asked.asked.check_clearance === undefined;
    for (const [name] of questions) {
      this.boxes.get(name)!.checked = this.asked.asked[name] !== undefined;
      this.words.get(name)!.replaceChildren(...this.wordsOf(name));
    }
  }

  private wordsOf(name: QuestionName): Node[] {
    const { asked, answers, failures } = this.asked;
    if (!asked[name]) return [];
    const failure = failures[name];
    if (failure) return [h("p", {}, failure)];
    const answer = answers[name];
    if (!answer) return [h("p", { class: "none" }, "…")];
    if (!("outcome" in answer)) return sweptWords(answer);
    if (answer.outcome === "untested") return [h("p", {}, answer.reason ?? "")];
    const untestedPairs = untested(answer.coverage) > 0 ? [h("p", {}, coverageText(answer.coverage))] : [];
    return [...untestedPairs, ...this.decidedWords(name)];
  }

  /** What an answer says about the pairs that were tested. */
  private decidedWords(name: QuestionName): Node[] {
    const { answers } = this.asked;
    if (name === "intervals") return this.intervalsWords();
    if (name === "clearance") return this.clearanceWords();
    if (name === "distance_profile") return this.profileWords();
    if (name === "check_clearance") return this.marginWords();
    if (name === "range") return this.rangeWords();
    return [...separationWords(answers.separate!), ...this.leavingWords(answers.separate!)];
  }

  /** With turns: who leaves along a way, and who does not. */
  private leavingWords({ ways, unsure = [], scene }: SeparationAnswer): Node[] {
    if (!ways) return [];
    const lines = ways.map(({ body, points }) => {
      const turned = points.some(({ deg }) => deg !== points[0].deg);
      return h("li", {}, `${body}: ${turned ? "turning on its way" : "without a turn"}`);
    });
    const words: Node[] = [];
    if (lines.length > 0)
      words.push(h("p", {}, "They leave one by one, each instant proved free:"), h("ol", {}, ...lines));
    if (unsure.length > 0) words.push(h("p", {}, `Undecided: ${unsure.join(", ")}.`));
    if (scene && lines.length > 0)
      words.push(
        h(
          "button",
          { type: "button", id: "show-leaving", onclick: () => this.showLeaving(scene, ways.length) },
          "Show them leave",
        ),
      );
    return words;
  }

  private showLeaving(scene: Scene, count: number): void {
    const verdict: Verdict = {
      headline: count === 1 ? "One body leaves" : `${count} bodies leave`,
      outcome: "free",
      lines: ["One after the other; those that have left wait in nobody's way. Every instant of it is proved free."],
    };
    this.excursion.show({ scene: structuredClone(scene), verdict, more: [], back: "Back to where they stand" });
  }

  private intervalsWords(): Node[] {
    const { intervals, undecided } = this.asked.answers.intervals!;
    const lines = intervals.slice(0, 20).map(({ pair, from, to }) => {
      const text = `${pair.join(" x ")}: ${timeText(...from)} to ${timeText(...to)}`;
      return h("li", {}, this.link(text, from[0]));
    });
    if (intervals.length > lines.length) lines.push(h("li", {}, `and ${intervals.length - lines.length} more`));
    const open = undecided.length;
    if (open > 0) {
      const [first] = undecided;
      const which = open === 1 ? first.bodies.join(" x ") : `${open} pairs`;
      return [h("p", {}, `Undecided: ${which}. ${first.reason ?? ""}`), h("ul", {}, ...lines)];
    }
    return lines.length > 0 ? [h("ul", {}, ...lines)] : [h("p", {}, "They never overlap.")];
  }

  private clearanceWords(): Node[] {
    const { clearance, reason, wide } = this.asked.answers.clearance!;
    if (!clearance) return [h("p", {}, `Undecided. ${reason ?? ""}`)];
    return [h("p", {}, this.nearestText(clearance)), ...(wide ? [h("p", {}, wide)] : [])];
  }

  private nearestText(n: Nearest): Node {
    const what = n.hi > 0 ? timeText(n.lo, n.hi) : "0, they touch";
    return this.link(`${what}: ${n.pair.join(" x ")}, at t = ${roundText(n.t[0], 9)}`, n.t[0]);
  }

  private profileWords(): Node[] {
    const { profile, reason } = this.asked.answers.distance_profile!;
    if (profile.length === 0) return [h("p", {}, `Undecided. ${reason ?? ""}`)];
    const { lo, hi, t, wide } = profile[0].largest;
    const text = `Greatest: ${bracketText(lo, hi)}, at t = ${roundText(t)}`;
    return [h("p", {}, this.link(text, t)), ...(wide ? [h("p", {}, wide)] : [])];
  }

  private marginWords(): Node[] {
    const { outcome, clearance, clearances, first, t, pair, reason, lock } = this.asked.answers.check_clearance!;
    const margin = first?.margin_at ?? first?.margin ?? clearance;
    const closer = `${pair?.join(" x ")}: closer than ${margin}`;
    if (outcome === "free" || outcome === "locked") {
      const all = untested(this.asked.answers.check_clearance!.coverage) > 0 ? "Tested pairs keep" : "All keep";
      const time = outcome === "free" ? "for the whole time" : `until the lock at t = ${timeText(...lock!.t)}`;
      return [h("p", {}, `${all} ${clearances ? "their clearances" : clearance}: proved ${time}.`)];
    }
    if (outcome === "contact") return [h("p", {}, this.link(`${closer} at t = ${timeText(...t!)}`, t![0]))];
    if (outcome === "closer_at_start") return [h("p", {}, this.link(`${closer} at the start`, this.player.start))];
    if (outcome === "overlap_at_start")
      return [h("p", {}, this.link(`${pair?.join(" x ")}: overlap at the start`, this.player.start))];
    return [h("p", {}, `Undecided. ${reason ?? ""}`)];
  }

  private rangeWords(): Node[] {
    const { range, around, before, after, reason } = this.asked.answers.range!;
    if (!range) return [h("p", {}, `Undecided. ${reason ?? ""}`)];
    const end = (at: [number, number] | null, stop: Overlap | undefined, own: string): HTMLElement =>
      h("li", {}, at ? this.link(`${timeText(...at)}: ${stop?.pair.join(" x ")}`, at[0]) : own);
    return [
      h("p", {}, `Around t = ${roundText(around, 9)}, without overlap:`),
      h(
        "ul",
        {},
        end(range.from, before, "from the start"),
        end(range.to_lock ? null : range.to, after, range.to_lock ? "to the lock" : "to the end"),
      ),
    ];
  }

  /** Words that lead to an instant. */
  private link(text: string, t: number): HTMLElement {
    return h(
      "button",
      { type: "button", class: "instant", title: "Show this instant", onclick: () => this.seek(t) },
      text,
    );
  }

  private seek(t: number): void {
    this.player.playing = false;
    this.player.seek(t);
  }
}

/** Of a distance: its digits, or its bracket where that is wide. */
function bracketText(lo: number, hi: number): string {
  return hi - lo < 1e-6 * hi ? roundText((lo + hi) / 2, 7) : `${roundText(lo)} to ${roundText(hi)}`;
}

function sweptWords({ area, tolerance }: SweptAnswer): Node[] {
  return [
    h(
      "p",
      {},
      `The region has an area of ${roundText(area)}. It contains all that the body passes over, and reaches at most ${roundText(tolerance, 3)} beyond.`,
    ),
  ];
}

function roseOf(directions: FreeDirections): HTMLElement {
  const { body, all } = directions;
  const free = all ? "free in every direction" : directions.directions.map((arc) => `${arcText(arc)}°`).join(", ");
  return h("figure", {}, rose(directions), h("figcaption", {}, h("b", {}, body), " ", free || "locked"));
}

function separationWords(answer: SeparationAnswer): Node[] {
  if (answer.reason) return [h("p", {}, answer.reason)];
  if (answer.pair) return [h("p", {}, `${answer.pair.join(" and ")} overlap at the start.`)];
  const bodies = answer.bodies ?? [answer as FreeDirections];
  const words: Node[] = [h("div", { class: "roses" }, ...bodies.slice(0, mostRoses).map(roseOf))];
  if (answer.wide) words.push(h("p", {}, answer.wide));
  if (bodies.length > mostRoses) words.push(h("p", {}, `and ${bodies.length - mostRoses} more bodies`));
  if (answer.order?.length) {
    const steps = answer.order.map((s) => `${s.body} (${roundText(s.direction_deg, 4)}°)`);
    words.push(h("p", {}, `One by one: ${steps.join(", ")}.`));
  }
  if (answer.stuck?.length) words.push(h("p", {}, `Stuck: ${answer.stuck.join(", ")}.`));
  return words;
}
