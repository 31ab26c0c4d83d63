// The list of events. Only the rows in view exist, since there may be tens of thousands.
import { h } from "./dom";
import type { Player } from "./player";
import { repairNames, roundText } from "./words";

const rowHeight = 30;

export class EventList {
  readonly element: HTMLElement;
  private readonly rows = h("div", { class: "rows" });
  private shown = "";
  private current = -2;

  constructor(private readonly player: Player) {
    this.element = h(
      "div",
      {
        class: "events",
        role: "listbox",
        tabindex: 0,
        "aria-label": "Events",
        id: "events",
        onscroll: () => this.render(),
        onkeydown: (e: KeyboardEvent) => this.key(e),
      },
      this.rows,
    );
  }

  update(): void {
    const { replay, selected } = this.player;
    const current = selected >= 0 ? selected : replay.applied - 1;
    if (current !== this.current) {
      this.current = current;
      this.keepInView(current);
    }
    this.render();
  }

  private keepInView(k: number): void {
    const list = this.element;
    const y = Math.max(0, k) * rowHeight;
    if (y < list.scrollTop || y + rowHeight > list.scrollTop + list.clientHeight) {
      list.scrollTop = y - (list.clientHeight - rowHeight) / 2;
    }
  }

  private key(e: KeyboardEvent): void {
    const step = { ArrowDown: 1, ArrowUp: -1 }[e.key];
    if (!step) return;
    e.preventDefault();
    e.stopPropagation();
    this.player.stepEvent(step as 1 | -1);
  }

  private render(): void {
    const { replay, selected, scene } = this.player;
    const count = replay.count;
    const first = Math.max(0, Math.floor(this.element.scrollTop / rowHeight) - 4);
    const last = Math.min(count, first + Math.ceil(this.element.clientHeight / rowHeight) + 8);
    const key = [first, last, count, this.current, selected, this.player.opened].join();
    if (key === this.shown) return;
    this.shown = key;
    this.rows.style.height = `${count * rowHeight}px`;
    const rows: HTMLElement[] = [];
    for (let k = first; k < last; ++k)
      rows.push(
        this.row(
          k,
          selected,
          scene.bodies.map((b) => b.name),
        ),
      );
    this.rows.replaceChildren(...rows);
    if (count === 0) this.rows.append(h("p", { class: "none" }, this.player.finished ? "No events." : "None yet."));
    this.element.setAttribute(
      "aria-activedescendant",
      this.current >= first && this.current < last ? `event-${this.current}` : "",
    );
  }

  private row(k: number, selected: number, names: string[]): HTMLElement {
    const event = this.player.replay.event(k);
    const v = event.corner[1];
    const { vertexBody, vertexIndex } = this.player.replay;
    const classes = ["row"];
    if (k === selected) classes.push("selected");
    else if (k === this.current) classes.push("current");
    const row = h(
      "div",
      {
        class: classes.join(" "),
        role: "option",
        id: `event-${k}`,
        "aria-selected": k === selected,
        title: `corner at vertex ${vertexIndex[v]} of ${names[vertexBody[v]]}`,
        onclick: () => this.player.show(k),
      },
      h("span", { class: "number" }, String(event.number)),
      h("span", { class: "when" }, roundText(event.lo, 7)),
      h("span", { class: `kind ${event.repair}` }, repairNames[event.repair]),
    );
    row.style.top = `${k * rowHeight}px`;
    return row;
  }
}
