// What the picture consists of, and which of it is to be seen.
import { h, swatch } from "./dom";
import type { Layers } from "./frame";

export class Legend {
  readonly element: HTMLElement;
  private readonly boxes: Partial<Record<keyof Layers, HTMLInputElement>> = {};
  private readonly names = [h("span"), h("span")];

  constructor(
    private readonly layers: Layers,
    private readonly redraw: () => void,
  ) {
    const ofTiling = h(
      "div",
      { class: "of-tiling" },
      h("p", { class: "of-pair" }, swatch("body0"), " ", this.names[0]),
      h("p", { class: "of-pair" }, swatch("body1"), " ", this.names[1]),
      h("p", {}, swatch("pq", "line"), " edges between the bodies"),
      this.ofPair(this.layer("faces", "faces, strong near the root", "f", swatch("face0"), swatch("face1"))),
      this.layer("tiling", "edges of the tiling", "e", swatch("tiling", "line")),
      this.ofPair(
        this.layer(
          "corners",
          "active corners: convex, reflex",
          "c",
          swatch("convex", "line"),
          swatch("reflex", "line"),
        ),
      ),
    );
    const ofCurves = h(
      "div",
      { class: "of-curves" },
      this.layer("bands", "bands in which curves are known to lie", "b"),
    );
    this.element = h("div", { class: "legend" }, ofTiling, ofCurves, this.layer("vertices", "vertices", "v"));
  }

  showNames(names: string[]): void {
    this.names.forEach((element, b) => {
      const name = names[b] ?? "";
      if (element.textContent !== name) element.textContent = name;
    });
  }

  toggle(name: keyof Layers): void {
    this.boxes[name]?.click();
  }

  /** Of worlds, only the edges of tilings are drawn. */
  private ofPair(element: HTMLElement): HTMLElement {
    element.classList.add("of-pair");
    return element;
  }

  private layer(name: keyof Layers, label: string, key: string, ...marks: Node[]): HTMLElement {
    const box = h("input", {
      type: "checkbox",
      id: `layer-${name}`,
      onchange: () => {
        this.layers[name] = box.checked;
        this.redraw();
      },
    });
    box.checked = this.layers[name];
    this.boxes[name] = box;
    return h("label", { title: key }, box, ...marks, ` ${label}`);
  }
}
