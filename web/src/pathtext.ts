// The outline of a body with curves as text: the data of its paths, a part a line.
import { h } from "./dom";
import type { Scene } from "./engine";
import { isPath } from "./shapes";

export class PathText {
  readonly element: HTMLDetailsElement;
  private readonly text = h("textarea", { id: "path-text", rows: 5, spellcheck: "false", "aria-label": "Outline" });
  private body = 0;

  constructor(apply: (body: number, paths: string[]) => void) {
    const paths = (): string[] => this.text.value.split("\n").filter((line) => line.trim() !== "");
    this.element = h(
      "details",
      { class: "part part-path", hidden: true },
      h("summary", {}, "Outline"),
      h("p", { class: "hint" }, "Data of an SVG path, y upwards: M L H V C S Q T A Z. Each line is a part."),
      this.text,
      h("button", { type: "button", id: "apply-path", onclick: () => apply(this.body, paths()) }, "Apply"),
    );
  }

  /** Of the chosen body, if it has curves; unless someone is writing. */
  show(scene: Scene, body: number): void {
    const paths = (scene.bodies[body].parts ?? []).filter(isPath).map((part) => part.path);
    this.element.hidden = paths.length === 0;
    if (document.activeElement === this.text && this.body === body) return;
    this.body = body;
    this.text.value = paths.join("\n");
  }
}
