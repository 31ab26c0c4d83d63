// The bodies of a scene below their parents: colours, numbers, and which are to be seen; and the pairs that are ignored.
import { h } from "./dom";
import type { Scene, WorldLooks } from "./engine";
import { treeOf, type Branch } from "./shapes";

/** So many ignored pairs are listed; the others are counted. */
const mostPairs = 20;

export const nameOfIgnored = (name: string): string => (name === "*" ? "every other body" : name);

export interface BodyTreeHost {
  /** Bodies that are not to be seen. */
  readonly hidden: Set<number>;
  changed(): void;
  /** Where pairs can be asked about again: the k-th of those that are ignored. */
  askAgain?(k: number): void;
}

export class BodyTree {
  private readonly list = h("ul", { class: "bodies", id: "bodies" });
  private readonly ignored = h("div", { class: "ignored", id: "ignored" });
  readonly element = h("div", {}, this.list, this.ignored);
  private key = "";

  constructor(readonly host: BodyTreeHost) {}

  /** Other bodies are to be seen from the next time on. */
  reset(): void {
    this.key = "";
  }

  show(scene: Scene, world: WorldLooks | null): void {
    const key = JSON.stringify([scene.bodies.map((b) => [b.name, b.relative_to]), scene.ignore, !world]);
    if (key === this.key) return;
    this.key = key;
    for (const body of [...this.host.hidden]) if (body >= scene.bodies.length) this.host.hidden.delete(body);
    this.list.replaceChildren(...treeOf(scene).map((branch) => this.branch(scene, world, branch)));
    this.showIgnored(scene.ignore ?? []);
  }

  private branch(scene: Scene, world: WorldLooks | null, { body, children }: Branch): HTMLElement {
    const { name } = scene.bodies[body];
    const box = h("input", {
      type: "checkbox",
      "aria-label": `Show ${name}`,
      onchange: () => {
        if (box.checked) this.host.hidden.delete(body);
        else this.host.hidden.add(body);
        this.host.changed();
      },
    });
    box.checked = !this.host.hidden.has(body);
    const look = world?.looks[body % world.looks.length];
    const chip = h("i", { class: "number", "aria-hidden": "true" }, String(body + 1));
    if (look) Object.assign(chip.style, { background: look[0], borderColor: look[1], color: look[2] });
    const below = children.map((child) => this.branch(scene, world, child));
    return h(
      "li",
      {},
      h("label", { title: "Show or hide" }, box, chip, " ", h("span", {}, name)),
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
