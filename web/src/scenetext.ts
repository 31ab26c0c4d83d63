// The scene as the text of its file, to be read and changed by hand.
import { h } from "./dom";
import type { Scene } from "./engine";

export class SceneText {
  readonly element: HTMLDetailsElement;
  private readonly text = h("textarea", { id: "scene-text", rows: 9, spellcheck: "false", "aria-label": "Scene file" });

  constructor(
    private readonly scene: () => Scene,
    apply: (text: string) => void,
  ) {
    this.element = h(
      "details",
      { class: "part part-text" },
      h("summary", {}, "Scene file"),
      this.text,
      h("button", { type: "button", id: "apply", onclick: () => apply(this.text.value) }, "Apply"),
    );
    this.element.addEventListener("toggle", () => this.show());
  }

  /** The present scene, unless someone is writing. */
  show(): void {
    if (!this.element.open || document.activeElement === this.text) return;
    this.text.value = JSON.stringify(this.scene(), null, 1).replace(
      /\[\s+([-\d.e+]+),\s+([-\d.e+]+)\s+\]/g,
      "[$1, $2]",
    );
  }
}
