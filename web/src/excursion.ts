// Another scene that was made of the one that is open: what follows a contact, or how bodies leave. It is shown until one
// goes back, or something else is opened.
import { h } from "./dom";
import { inParts, type Scene } from "./engine";
import type { Verdict, Workbench } from "./workbench";

export interface Trip {
  scene: Scene;
  verdict: Verdict;
  /** What there is besides. */
  more: Node[];
  /** What leads back. */
  back: string;
}

export class Excursion {
  readonly element = h("div", { class: "excursion", id: "excursion" });
  private shown: { opened: number; before: Scene } | null = null;

  constructor(private readonly workbench: Workbench) {}

  get active(): boolean {
    return this.shown !== null;
  }

  show({ scene, verdict, more, back }: Trip): void {
    const { workbench } = this;
    const { player } = workbench;
    const before = this.shown?.before ?? player.scene;
    player.open(inParts(scene), player.closed);
    this.shown = { opened: player.opened, before };
    workbench.verdict = () => verdict;
    this.element.replaceChildren(
      ...more,
      h("button", { type: "button", id: "reset", onclick: () => this.reset() }, back),
    );
    workbench.stage.refit();
    player.play(true);
  }

  /** To be called with every frame of words: another scene ends it. */
  update(): void {
    if (this.shown && this.shown.opened !== this.workbench.player.opened) this.forget();
  }

  /** The scene as it was. */
  reset(): void {
    const { shown, workbench } = this;
    if (!shown) return;
    this.forget();
    workbench.player.open(shown.before, workbench.player.closed);
    workbench.stage.refit();
    workbench.redraw();
  }

  private forget(): void {
    this.shown = null;
    this.workbench.verdict = null;
    this.element.replaceChildren();
  }
}
