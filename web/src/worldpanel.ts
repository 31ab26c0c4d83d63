// Below the tree of bodies: more of them, fewer, holes, parents, and pairs that are not asked about.
import { h } from "./dom";
import type { Heights, Scene } from "./engine";
import { NumberField } from "./numberfield";
import { familyOf } from "./shapes";

export interface WorldPanelHost {
  rename(name: string): void;
  addBody(): void;
  removeBody(): void;
  cutHole(): void;
  /** Null: the world. */
  setParent(name: string | null): void;
  ignore(other: string): void;
  setHeights(z: Heights): void;
}

export class WorldPanel {
  readonly element: HTMLElement;
  private readonly remove: HTMLButtonElement;
  private readonly name: HTMLInputElement;
  private readonly parent: HTMLSelectElement;
  private readonly other: HTMLSelectElement;
  private readonly low: NumberField;
  private readonly high: NumberField;
  private readonly hint = h("p", { class: "hint" });

  constructor(host: WorldPanelHost) {
    const button = (id: string, label: string, title: string, action: () => void): HTMLButtonElement =>
      h("button", { type: "button", id, title, onclick: action }, label);
    this.remove = button("remove-body", "Remove", "Remove the chosen body", () => host.removeBody());
    this.name = h("input", { type: "text", id: "name", onchange: () => host.rename(this.name.value) });
    this.parent = h("select", { id: "parent", onchange: () => host.setParent(this.parent.value || null) });
    this.other = h("select", { id: "ignore-other", "aria-label": "Pair that is not asked about" });
    const taken = (): void => host.setHeights([this.low.value, this.high.value]);
    const height = (label: string, id: string, wrong: (z: number) => string): NumberField =>
      new NumberField(label, { id, placeholder: "no end" }, { taken, emptied: taken, wrong });
    const below = (lo: number, hi: number): string => (lo < hi ? "" : "the lower height must be below the upper one");
    this.low = height("Lower height", "height-low", (z) => below(z, this.high.value ?? Infinity));
    this.high = height("Upper height", "height-high", (z) => below(this.low.value ?? -Infinity, z));
    this.element = h(
      "div",
      { class: "world-panel" },
      h(
        "div",
        { class: "modes" },
        button("add-body", "Add body", "One more body, where the view is", () => host.addBody()),
        this.remove,
        button("cut-hole", "Cut hole", "A hole where the chosen body has most room", () => host.cutHole()),
      ),
      h(
        "div",
        { class: "fields" },
        h("label", { for: "name" }, "Name"),
        this.name,
        h("label", { for: "parent" }, "Moves with"),
        this.parent,
        h("label", { for: "height-low", title: "Bodies meet only what shares some of their heights" }, "Layers, z"),
        h("span", { class: "pair" }, this.low.input, h("label", { for: "height-high" }, "to"), this.high.input),
        h("label", { for: "ignore-other" }, "Ignore with"),
        h(
          "span",
          { class: "pair" },
          this.other,
          button("ignore", "Ignore", "", () => host.ignore(this.other.value)),
        ),
      ),
      this.low.fault,
      this.high.fault,
      this.hint,
    );
  }

  /** For the chosen body. */
  show(scene: Scene, body: number): void {
    const { name, relative_to, z = [null, null], parts = [] } = scene.bodies[body];
    [this.low, this.high].forEach((field, k) => field.show(String(z[k] ?? "")));
    const own = parts.filter((part) => "z" in part && part.z).length;
    const family = familyOf(scene, body);
    const names = scene.bodies.map((b) => b.name);
    if (document.activeElement !== this.name || this.name.value.trim() === "") this.name.value = name;
    this.remove.disabled = names.length < 2;
    this.parent.replaceChildren(
      h("option", { value: "" }, "nothing"),
      ...names.filter((_, b) => !family.has(b)).map((n) => h("option", { value: n, selected: n === relative_to }, n)),
    );
    this.other.replaceChildren(
      ...names.filter((n) => n !== name).map((n) => h("option", { value: n }, n)),
      h("option", { value: "*" }, "every other body"),
    );
    this.hint.textContent = [
      relative_to === undefined ? "" : `The keyframes of ${name} are seen from ${relative_to}.`,
      own === 0 ? "" : `${own} of ${parts.length} parts of ${name} have layers of their own.`,
    ].join(" ");
  }
}
