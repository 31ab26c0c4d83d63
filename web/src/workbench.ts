// The page around the picture: answer, event, counts, list of events, time.
import { h, iconButton, swatch } from "./dom";
import { Aftermath } from "./aftermath";
import { Background } from "./background";
import { BodyTree } from "./bodytree";
import { EventList } from "./eventlist";
import { Excursion } from "./excursion";
import { EventText } from "./eventtext";
import { placed } from "./figure";
import { helpDialog } from "./help";
import { Legend } from "./legend";
import { CountPlot } from "./plot";
import type { Player } from "./player";
import { Stage } from "./stage";
import { EventStrip } from "./strip";
import { Transport } from "./transport";
import { Lanes } from "./lanes";
import { QuestionPanel } from "./questionpanel";
import { Questions } from "./questions";
import { isDark } from "./theme";
import { clockText, explanation, headline, aboutTilings, turnedText } from "./words";

/** What is said in place of the scene's answer. */
export interface Verdict {
  headline: string;
  outcome: "free" | "contact" | "undecided" | "running" | "invalid";
  lines: string[];
}

export class Workbench {
  readonly stage: Stage;
  readonly element: HTMLElement;
  /** Where the playground puts its own controls. */
  readonly side: HTMLElement;
  readonly headerTools = h("div", { class: "tools" });
  title: string | null = null;
  /** The scene that is being edited is not valid: what is known belongs to an older one. */
  invalid = false;

  /** Of another question than the scene's first contact. */
  verdict: (() => Verdict) | null = null;
  readonly background = new Background();
  readonly excursion = new Excursion(this);
  private readonly aftermath = new Aftermath(this);

  private readonly events: EventList;
  private readonly plot: CountPlot;
  private readonly titleLine = h("h1");
  private readonly answerChip = h("p", { class: "chip", role: "status", "aria-live": "polite", id: "headline" });
  private readonly answerText = h("div", { class: "answer", id: "answer" });
  private readonly eventText = new EventText();
  private readonly counts = h("div", { class: "counts", id: "counts" });
  private readonly strip: EventStrip;
  private readonly transport: Transport;
  readonly questions: Questions;
  private readonly lanes: Lanes;
  private readonly questionPanel: QuestionPanel;
  private readonly proofSwitch = h(
    "button",
    {
      type: "button",
      id: "proof",
      "aria-pressed": "false",
      title: "The map of the space between the bodies, whose events are the proof (p)",
      onclick: () => this.showProof(!this.stage.layers.proof),
    },
    "Show the proof",
  );
  private readonly help: HTMLDialogElement;
  private readonly legend: Legend;
  /** Panels about the map between the bodies, which is the proof. */
  private readonly proofParts: HTMLDetailsElement[] = [];
  readonly tree: BodyTree;
  /** Below the tree of bodies the playground puts what changes it. */
  readonly bodiesPart: HTMLElement;
  private dirty = true;
  private fittedFinal = false;
  private fittedBeyond = false;
  private lastFrame = 0;
  private lastDrawn = 0;
  private drew = false;
  private settledOnce = false;
  private panelsShown = 0;

  constructor(
    readonly player: Player,
    moreKeys: [string, string][] = [],
  ) {
    this.stage = new Stage(player, () => this.redraw());
    this.events = new EventList(player);
    this.strip = new EventStrip(player);
    this.questions = new Questions(player, () => this.redraw());
    this.lanes = new Lanes(player, this.questions);
    this.questionPanel = new QuestionPanel(player, this.questions, this.excursion);
    const plotCanvas = h("canvas", {
      class: "plot",
      id: "plot",
      role: "img",
      "aria-label": "Active certificates and events over time",
    });
    this.plot = new CountPlot(plotCanvas, player, (t) => player.seek(t));
    this.help = helpDialog(moreKeys);
    this.legend = new Legend(this.stage.layers, () => this.redraw());
    this.tree = new BodyTree({ hidden: this.stage.hidden, changed: () => this.redraw() });
    this.bodiesPart = section("Bodies", this.tree.element);
    this.side = h(
      "aside",
      { "aria-label": "Details" },
      section("Answer", this.answerChip, this.answerText, this.excursion.element, this.aftermath.element),
      section("Questions", this.questionPanel.element),
      this.bodiesPart,
    );
    this.proofParts.push(
      section("Event", this.eventText.element),
      section("Counts over time", this.counts, plotCanvas),
      section("Events", this.events.element),
      section("Picture", this.legend.element),
    );
    for (const part of this.proofParts) part.open = false;
    this.side.append(...this.proofParts);
    this.transport = new Transport(player, this.lanes.element, this.strip.canvas);
    this.element = h(
      "div",
      { class: "app" },
      h(
        "header",
        {},
        this.titleLine,
        this.headerTools,
        this.proofSwitch,
        iconButton("theme", "Light or dark", () => this.toggleTheme(), "t"),
        iconButton("help", "Keys", () => this.help.showModal(), "?"),
      ),
      this.stage.element,
      this.side,
      this.transport.element,
      this.help,
    );
    player.onChange = () => this.redraw();
    document.addEventListener("keydown", (e) => this.key(e));
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.redraw());
    const loop = (now: number): void => {
      if (this.player.scene) {
        this.adaptDetail(now);
        if (this.player.frame(now) || this.dirty) this.render();
      }
      requestAnimationFrame(loop);
    };
    requestAnimationFrame(loop);
  }

  redraw(): void {
    this.dirty = true;
  }

  /** The motion is what is seen first; the proof is there for those who ask for it. */
  showProof(on: boolean): void {
    if (this.stage.layers.proof === on) return;
    this.stage.layers.proof = on;
    this.proofSwitch.setAttribute("aria-pressed", String(on));
    for (const part of this.proofParts) part.open = on;
    this.redraw();
  }

  /** A scene was opened. */
  opened(): void {
    this.fittedFinal = false;
    this.settledOnce = false;
    this.stage.hidden.clear();
    this.tree.reset();
    this.stage.fit();
  }

  /** Draws `frames` frames spread over the time, each down to its pixels; milliseconds of each. */
  measure(frames: number): number[] {
    const { player, stage } = this;
    const out: number[] = [];
    const context = stage.canvas.getContext("2d")!;
    for (let i = 0; i < frames; ++i) {
      const t = player.start + ((player.limit - player.start) * i) / Math.max(1, frames - 1);
      const begun = performance.now();
      player.seek(t);
      stage.draw();
      context.getImageData(0, 0, 1, 1);
      out.push(performance.now() - begun);
    }
    return out;
  }

  /** Small things are left out while frames come late, and come back when the picture stands still. */
  private adaptDetail(now: number): void {
    const took = now - this.lastFrame;
    this.lastFrame = now;
    const { painter } = this.stage;
    if (this.drew) {
      if (took > 20) painter.detail = Math.max(0.05, painter.detail * 0.85);
      else painter.detail = Math.min(1, painter.detail * 1.03);
      this.lastDrawn = now;
    } else if (painter.detail < 1 && now - this.lastDrawn > 250) {
      painter.detail = 1;
      this.redraw();
      this.lastDrawn = now + 1e3; // this frame may well be late
    }
    this.drew = false;
  }

  private render(): void {
    this.drew = true;
    this.dirty = false;
    const { player, stage } = this;
    // An event that was stepped to is one of the map.
    if (player.selected >= 0) this.showProof(true);
    if (player.finished && !this.fittedFinal) {
      this.fittedFinal = true;
      // Not while something is being edited: the picture would move away below the pointer.
      if (!stage.tool || !this.settledOnce) stage.refit();
      this.settledOnce = true;
    }
    document.documentElement.dataset.theme = isDark(stage.theme) ? "dark" : "light";
    this.questions.update();
    if (this.fittedBeyond !== player.beyond) {
      this.fittedBeyond = player.beyond;
      stage.refit();
    }
    stage.nearest = this.questionPanel.marks();
    stage.region = this.questionPanel.region();
    stage.draw();
    this.lanes.draw(stage.colours());
    this.transport.show();
    this.plot.draw(stage.colours());
    // Words need not change faster than they can be read.
    const now = performance.now();
    if (player.playing && now - this.panelsShown < 120) return;
    this.panelsShown = now;
    this.showTitle();
    this.showAnswer();
    this.eventText.show(player);
    this.showCounts();
    this.questionPanel.show();
    this.events.update();
    this.strip.draw(stage.colours());
  }

  private showTitle(): void {
    const { scene, world } = this.player;
    const names = scene.bodies.map((b) => b.name);
    const title = this.title ?? (names.length > 3 ? `${names.length} bodies` : names.join(world ? ", " : " and "));
    this.element.classList.toggle("world", world !== null);
    this.element.classList.toggle("curved", world?.bands !== undefined);
    this.tree.show(scene, world);
    if (this.titleLine.textContent !== title) {
      this.titleLine.textContent = title;
      document.title = `${title}: taut`;
    }
    this.legend.showNames(names);
  }

  private showAnswer(): void {
    this.excursion.update();
    this.aftermath.update();
    if (this.verdict) return this.showVerdict(this.verdict());
    const { player } = this;
    const running = !player.finished;
    const { answer } = player.status;
    const text = this.invalid ? "No valid scene" : player.failure ? "Failed" : headline(answer, running);
    if (this.answerChip.textContent !== text) this.answerChip.replaceChildren(this.headlineElement(text));
    this.answerChip.dataset.outcome = this.invalid ? "invalid" : running ? "running" : answer.outcome;
    let lines = player.failure ? [player.failure] : explanation(answer, player.scene, player.status.freeUntil, running);
    if (!player.failure) lines = [...lines, turnedText(player)];
    const curved = player.world?.bands !== undefined;
    if (player.world && !player.failure && (curved || this.stage.layers.proof))
      lines = [...lines, aboutTilings(curved)];
    if (this.invalid) lines = ["The scene has to be mended before there is an answer."];
    setLines(this.answerText, lines);
    const names = player.scene.bodies.map((b) => b.name);
    const shown = names.length > 6 ? `${names.length} bodies` : names.join(" and ");
    this.stage.canvas.setAttribute("aria-label", `${shown} at t = ${clockText(player.t, player.scene)}. ${text}`);
  }

  private showVerdict({ headline, outcome, lines }: Verdict): void {
    if (this.answerChip.textContent !== headline) this.answerChip.replaceChildren(headline);
    this.answerChip.dataset.outcome = outcome;
    setLines(this.answerText, lines);
    this.stage.canvas.setAttribute("aria-label", `${headline}. ${lines.join(" ")}`);
  }

  /** What is said of an instant leads there. */
  private headlineElement(text: string): Node {
    const { player } = this;
    if (!["contact", "locked"].includes(player.status.answer.outcome) || this.invalid || player.failure)
      return document.createTextNode(text);
    const action = (): void => player.seek(player.known);
    return h("button", { type: "button", title: "Show this instant", onclick: action }, text);
  }

  private showCounts(): void {
    const { player } = this;
    const key = [player.certificates(), player.status.max, player.replay.applied, player.replay.count].join();
    if (this.counts.dataset.key === key) return;
    this.counts.dataset.key = key;
    this.counts.replaceChildren(
      h(
        "span",
        {},
        swatch("certificates", "line"),
        " certificates ",
        h("b", { id: "certificates" }, String(player.certificates())),
        ` (at most ${player.status.max})`,
      ),
      h(
        "span",
        {},
        swatch("events-line", "line"),
        " events ",
        h("b", { id: "events-count" }, String(player.replay.applied)),
        ` of ${player.replay.count}`,
      ),
    );
  }

  private toggleTheme(): void {
    this.stage.theme = isDark(this.stage.theme) ? "light" : "dark";
    this.redraw();
  }

  /** To the marked corner, or to the contact. */
  private zoomToMarks(): void {
    const { player } = this;
    const marks = player.marks();
    const [contact] = player.contactMarks();
    const poses = player.poses();
    if (marks) {
      const { vertexBody, vertexIndex } = player.replay;
      this.stage.zoomTo(
        marks.event.corner.map((v) => {
          const figure = player.figures[vertexBody[v]];
          return placed(poses[vertexBody[v]], figure.x[vertexIndex[v]], figure.y[vertexIndex[v]]);
        }),
      );
    } else if (contact) {
      // Curves are known so well near a contact that their bands are seen from much nearer only.
      const band = 12 * (player.status.answer.geometry?.tolerance ?? 0);
      if (!(band > 0 && this.stage.zoomedTo === contact.point)) this.stage.zoomTo([contact.point]);
      else this.stage.zoomTo([contact.point], band);
    }
  }

  /** A part of the proof; all of it, if none is to be seen yet. */
  private toggleOfProof(layer: "faces" | "tiling" | "corners"): void {
    if (this.stage.layers.proof) this.legend.toggle(layer);
    else this.showProof(true);
  }

  private key(e: KeyboardEvent): void {
    const target = e.target as HTMLElement;
    if (!this.player.scene || this.help.open || e.ctrlKey || e.metaKey || e.altKey) return;
    if (target.matches("textarea, select, input:not([type=range]):not([type=checkbox])")) return;
    const { player, stage } = this;
    const hundredth = (player.end - player.start) / 100;
    const arrow = e.key === "ArrowRight" ? 1 : -1;
    const actions: Record<string, () => void> = {
      ArrowRight: () => (e.shiftKey ? player.seek(player.t + hundredth) : player.stepEvent(arrow as 1)),
      ArrowLeft: () => (e.shiftKey ? player.seek(player.t - hundredth) : player.stepEvent(arrow as -1)),
      Home: () => player.show(-1),
      End: () => player.toTheEnd(),
      "+": () => stage.zoom(1.4),
      "=": () => stage.zoom(1.4),
      "-": () => stage.zoom(1 / 1.4),
      "0": () => stage.fit(),
      w: () => stage.pan(0, 60),
      s: () => stage.pan(0, -60),
      a: () => stage.pan(60, 0),
      d: () => stage.pan(-60, 0),
      z: () => this.zoomToMarks(),
      p: () => this.showProof(!stage.layers.proof),
      f: () => this.toggleOfProof("faces"),
      e: () => this.toggleOfProof("tiling"),
      c: () => this.toggleOfProof("corners"),
      v: () => this.legend.toggle("vertices"),
      b: () => this.legend.toggle("bands"),
      t: () => this.toggleTheme(),
      "?": () => this.help.showModal(),
    };
    // A focused button or box takes the space bar for itself.
    if (!target.matches("button, input[type=checkbox], summary, a")) actions[" "] = () => player.play(!player.playing);
    const action = actions[e.key];
    if (!action) return;
    e.preventDefault();
    action();
  }
}

function section(title: string, ...children: Node[]): HTMLDetailsElement {
  const details = h(
    "details",
    { open: true, class: `part part-${title.toLowerCase().split(" ")[0]}` },
    h("summary", {}, title),
    ...children,
  );
  return details;
}

function setLines(element: HTMLElement, lines: string[]): void {
  const key = lines.join("\n");
  if (element.dataset.key === key) return;
  element.dataset.key = key;
  element.replaceChildren(...lines.filter((l) => l !== "").map((l) => h("p", {}, l)));
}
