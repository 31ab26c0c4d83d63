// The bodies of a scene below their parents: colours, numbers, and which are to be seen; and the pairs that are ignored.
import { h } from "./dom";
import type { Scene, WorldStyles } from "./engine";
import { heightsOf, heightsText, layersOf, layersText, type Hidden } from "./heights";
import { treeOf, type Branch } from "./shapes";
import { pairStyles } from "./theme";

/** So many ignored pairs are listed; the others are counted. */
const mostPairs = 20;

export const nameOfIgnored = (name: string): string => (name === "*" ? "every other body" : name);

export interface BodyTreeHost {
  /** What is not to be seen. */
  readonly hidden: Hidden;
  changed(): void;
  /** Where pairs can be asked about again: the k-th of those that are ignored. */
  askAgain?(k: number): void;
}

export class BodyTree {
  private readonly list = h("ul", { class: "bodies", id: "bodies" });
  private readonly ignored = h("div", { class: "ignored", id: "ignored" });
  private readonly layers = h("div", { class: "bodies layers", id: "layers" });
  readonly element = h("div", {}, this.list, this.layers, this.ignored);
  private key = "";

  constructor(readonly host: BodyTreeHost) {}

  /** Other bodies are to be seen from the next time on. */
  reset(): void {
    this.key = "";
  }

  show(scene: Scene, world: WorldStyles | null): void {
    const key = JSON.stringify([scene.bodies.map((b) => [b.name, b.relative_to, layersText(b)]), scene.ignore, !world]);
    if (key === this.key) return;
    this.key = key;
    const { bodies } = this.host.hidden;
    for (const body of [...bodies]) if (body >= scene.bodies.length) bodies.delete(body);
    this.list.replaceChildren(...treeOf(scene).map((branch) => this.branch(scene, world, branch)));
    this.showLayers(scene);
    this.showIgnored(scene.ignore ?? []);
  }

  /** Whether something is to be seen: its key is in the set if not. */
  private box<Key>(hidden: Set<Key>, key: Key, what: string): HTMLInputElement {
    const box = h("input", {
      type: "checkbox",
      "aria-label": `Show ${what}`,
      onchange: () => {
        if (box.checked) hidden.delete(key);
        else hidden.add(key);
        this.host.changed();
      },
    });
    box.checked = !hidden.has(key);
    return box;
  }

  /** The highest one first, as they lie. */
  private showLayers(scene: Scene): void {
    const { layers } = this.host.hidden;
    const texts = layersOf(scene.bodies).map(heightsText).reverse();
    for (const text of [...layers]) if (!texts.includes(text)) layers.delete(text);
    if (texts.length === 0) return this.layers.replaceChildren();
    const row = (text: string): HTMLElement => {
      const on = scene.bodies.filter((body) => heightsOf(body).some((z) => heightsText(z) === text));
      const names = h("span", { class: "heights" }, on.map((body) => body.name).join(", "));
      return h(
        "li",
        {},
        h("label", { title: "Show or hide what is on it" }, this.box(layers, text, text), h("span", {}, text), names),
      );
    };
    this.layers.replaceChildren(h("p", {}, "Layers:"), h("ul", {}, ...texts.map(row)));
  }

  private branch(scene: Scene, world: WorldStyles | null, { body, children }: Branch): HTMLElement {
    const { name } = scene.bodies[body];
    const box = this.box(this.host.hidden.bodies, body, name);
    const heights = layersText(scene.bodies[body]);
    const styles = world?.styles ?? pairStyles;
    const [background, borderColor, color] = styles[body % styles.length];
    const chip = h("i", { class: "number", "aria-hidden": "true" }, String(body + 1));
    Object.assign(chip.style, { background, borderColor, color });
    const below = children.map((child) => this.branch(scene, world, child));
    return h(
      "li",
      {},
      h(
        "label",
        { title: "Show or hide" },
        box,
        chip,
        " ",
        h("span", {}, name),
        heights && h("span", { class: "heights" }, heights),
      ),
      below.length > 0 ? h("ul", {}, ...below) : null,
    );
  }

  private pair(text: string, k: number): HTMLElement {
    const { askAgain } = this.host;
    const label = `Ask about ${text} again`;
    const button = h(
      "button",
      { type: "button", "aria-label": label, title: label, onclick: () => askAgain?.(k) },
      "×",
    );
    return h("li", {}, text, " ", askAgain ? button : null);
  }

  private showIgnored(pairs: [string, string][]): void {
    if (pairs.length === 0) return this.ignored.replaceChildren();
    const more = pairs.length - mostPairs;
    const items = pairs.slice(0, mostPairs).map((pair, k) => this.pair(pair.map(nameOfIgnored).join(" x "), k));
    if (more > 0) items.push(h("li", {}, `and ${more} more`));
    this.ignored.replaceChildren(h("p", {}, `Ignored (${pairs.length}):`), h("ul", {}, ...items));
  }
}
