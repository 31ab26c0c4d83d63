// What is asked, and the answers in words; the free directions as roses.
import { h } from "./dom";
import type { NearestMarks } from "./frame";
import type { Player } from "./player";
import type { FreeDirections, Nearest, QuestionName, Questions, SeparationAnswer } from "./questions";
import { arcText, rose } from "./rose";
import { roundText, timeText } from "./words";

/** Bodies that have a rose of their own. */
const mostRoses = 12;

/** In the words of docs/questions.md, with the command that asks the same. */
const questions: [QuestionName, string, string, Record<string, unknown>][] = [
  ["intervals", "When do they overlap, all of the time?", "taut intervals", {}],
  ["clearance", "How close do they come?", "taut clearance", {}],
  ["distance_profile", "How far apart, all of the time?", "taut clearance --profile 200", { instants: 200 }],
  ["separate", "In which directions do they come apart?", "taut separate", {}],
];

export class QuestionPanel {
  readonly element = h("div", { class: "questions", id: "questions" });
  private readonly boxes = new Map<QuestionName, HTMLInputElement>();
  private readonly words = new Map<QuestionName, HTMLElement>();
  private shown = -1;

  constructor(
    private readonly player: Player,
    private readonly asked: Questions,
  ) {
    for (const [name, text, command, options] of questions) {
      const box = h("input", {
        type: "checkbox",
        id: `ask-${name}`,
        onchange: () => asked.choose(name, box.checked ? options : null),
      });
      const words = h("div", { class: "words", id: `answer-${name}`, "aria-live": "polite" });
      this.boxes.set(name, box);
      this.words.set(name, words);
      this.element.append(h("label", { title: command }, box, text), words);
    }
  }

  /** The closest points, while the instant is shown at which they are. */
  marks(): NearestMarks | null {
    const nearest = this.asked.answers.clearance?.clearance;
    if (!nearest?.points || this.player.t !== nearest.t[0]) return null;
    return { points: nearest.points, label: `${roundText(nearest.hi, 9)} apart` };
  }

  show(): void {
    if (this.shown === this.asked.version) return;
    this.shown = this.asked.version;
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
    if (!answers[name]) return [h("p", { class: "none" }, "…")];
    if (name === "intervals") return this.intervalsWords();
    if (name === "clearance") return this.clearanceWords();
    if (name === "distance_profile") return this.profileWords();
    return separationWords(answers.separate!);
  }

  private intervalsWords(): Node[] {
    const { intervals, undecided } = this.asked.answers.intervals!;
    const lines = intervals.slice(0, 20).map(({ pair, from, to }) => {
      const text = `${pair.join(" x ")}: ${timeText(...from)} to ${timeText(...to)}`;
      return h("li", {}, this.link(text, from[0]));
    });
    if (intervals.length > lines.length) lines.push(h("li", {}, `and ${intervals.length - lines.length} more`));
    lines.push(...undecided.map((u) => h("li", {}, `${u.bodies.join(" x ")}: not decided. ${u.reason ?? ""}`)));
    return lines.length > 0 ? [h("ul", {}, ...lines)] : [h("p", {}, "They never overlap.")];
  }

  private clearanceWords(): Node[] {
    const { clearance, reason } = this.asked.answers.clearance!;
    if (reason) return [h("p", {}, reason)];
    return [clearance ? h("p", {}, this.nearestText(clearance)) : h("p", {}, "No pair is asked about.")];
  }

  private nearestText(n: Nearest): Node {
    const what = n.hi > 0 ? timeText(n.lo, n.hi) : "0, they touch";
    return this.link(`${what}: ${n.pair.join(" x ")}, at t = ${roundText(n.t[0], 9)}`, n.t[0]);
  }

  private profileWords(): Node[] {
    const { profile, reason } = this.asked.answers.distance_profile!;
    if (reason || profile.length === 0) return [h("p", {}, reason ?? "No pair is asked about.")];
    const { lo, hi, t, settled } = profile[0].largest;
    const text = `Greatest: ${bracketText(lo, hi)}, at t = ${roundText(t)}${settled ? "" : " (not as narrow as wanted)"}`;
    return [h("p", {}, this.link(text, t))];
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
  if (bodies.length > mostRoses) words.push(h("p", {}, `and ${bodies.length - mostRoses} more bodies`));
  if (answer.order?.length) {
    const steps = answer.order.map((s) => `${s.body} (${roundText(s.direction_deg, 4)}°)`);
    words.push(h("p", {}, `One by one: ${steps.join(", ")}.`));
  }
  if (answer.stuck?.length) words.push(h("p", {}, `Stuck: ${answer.stuck.join(", ")}.`));
  return words;
}
