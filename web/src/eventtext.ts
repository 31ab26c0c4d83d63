// The event that was stepped to, in words.
import { h, swatch } from "./dom";
import type { Player } from "./player";
import { repairNames, story } from "./words";

export class EventText {
  readonly element = h("div", { class: "event", id: "event", "aria-live": "polite" });

  show(player: Player): void {
    // Nobody can listen as fast as events come.
    this.element.setAttribute("aria-live", player.playing ? "off" : "polite");
    const event = player.told();
    if (!event) return this.invite(player.replay.count > 0);
    const { vertexBody, vertexIndex } = player.replay;
    const vertex = (v: number): string => `${vertexIndex[v]} of ${player.scene.bodies[vertexBody[v]].name}`;
    const [u, v, w] = event.corner;
    const key = `${event.number}/${player.replay.count}/${event.lo}`;
    if (this.element.dataset.key === key) return;
    this.element.dataset.key = key;
    const term = (name: string, id: string, text: string): HTMLElement[] => [
      h("dt", {}, name),
      h("dd", id ? { id } : {}, text),
    ];
    this.element.replaceChildren(
      h(
        "p",
        { class: "event-name" },
        h("strong", {}, repairNames[event.repair]),
        ` event ${event.number} of ${player.replay.count}`,
      ),
      h("p", {}, story(event)),
      h(
        "dl",
        {},
        ...term("Time", "event-time", event.lo === event.hi ? String(event.lo) : `[${event.lo}, ${event.hi}]`),
        ...term("Corner", "", `u: vertex ${vertex(u)}; v: ${vertex(v)}; w: ${vertex(w)}`),
        ...term("Certificates after", "", String(event.certificates)),
      ),
      marks(),
    );
  }

  private invite(events: boolean): void {
    const text = events ? "Step to an event to see which corner fails and what changes." : "";
    if (this.element.dataset.key === text) return;
    this.element.dataset.key = text;
    this.element.replaceChildren(...(text ? [h("p", {}, text)] : []));
  }
}

const marks = (): HTMLElement =>
  h(
    "p",
    { class: "marks" },
    swatch("gone", "line dashed"),
    " gone ",
    swatch("come", "line"),
    " come ",
    swatch("failing", "line"),
    " failing corner",
  );
