// The list of events. Only the rows in view exist, since there may be tens of thousands.
import { h } from "./dom";
import type { Player } from "./player";
import { repairNames, roundText } from "./words";

const rowHeight = 30;

export class EventList {
  readonly element: HTMLElement;
  private readonly rows = h("div", { class: "rows" });
  private shown = "";
  private content = "";
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
    const { replay, selected } = this.player;
    const count = replay.count;
    const first = Math.max(0, Math.floor(this.element.scrollTop / rowHeight) - 4);
    const last = Math.min(count, first + Math.ceil(this.element.clientHeight / rowHeight) + 8);
    const key = [first, last, count, this.current, selected, this.player.opened].join();
    if (key === this.shown) return;
    this.shown = key;
    this.rows.style.height = `${count * rowHeight}px`;
    this.showRows(first, last, count);
    for (const row of this.rows.querySelectorAll<HTMLElement>(".row")) this.mark(row, selected);
    this.element.setAttribute(
      "aria-activedescendant",
      this.current >= first && this.current < last ? `event-${this.current}` : "",
    );
  }

  /** Rows in view stay what they are: one that was replaced between press and release would not be clicked. */
  private showRows(first: number, last: number, count: number): void {
    const content = [count, this.player.opened].join();
    if (content !== this.content) this.rows.replaceChildren();
    this.content = content;
    for (const row of [...this.rows.children] as HTMLElement[]) {
      const k = Number(row.dataset.event);
      if (!(k >= first && k < last)) row.remove();
    }
    const names = this.player.scene.bodies.map((b) => b.name);
    for (let k = first; k < last; ++k) {
      const next = this.rows.children[k - first] as HTMLElement | undefined;
      if (next?.dataset.event !== String(k)) this.rows.insertBefore(this.row(k, names), next ?? null);
    }
    if (count === 0) this.rows.append(h("p", { class: "none" }, this.player.finished ? "No events." : "None yet."));
  }

  private mark(row: HTMLElement, selected: number): void {
    const k = Number(row.dataset.event);
    row.classList.toggle("selected", k === selected);
    row.classList.toggle("current", k === this.current && k !== selected);
    row.setAttribute("aria-selected", String(k === selected));
  }

  private row(k: number, names: string[]): HTMLElement {
    const event = this.player.replay.event(k);
    const v = event.corner[1];
    const { vertexBody, vertexIndex } = this.player.replay;
    const row = h(
      "div",
      {
        class: "row",
        "data-event": k,
        role: "option",
        id: `event-${k}`,
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
