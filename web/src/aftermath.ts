// After a contact: what if the bodies bounce, or stop there?
import { linesOf } from "./background";
import { h } from "./dom";
import type { Scene } from "./engine";
import { isCurved } from "./shapes";
import type { Verdict, Workbench } from "./workbench";
import { roundText } from "./words";

/** What the library says: see wasm/aftermath.hpp. */
export interface WhatFollows {
  scene: Scene;
  contacts: { t: number; pair: [string, string]; point: [number, number] }[];
  state: string;
  reason: string;
}

/** So many contacts are listed; the others are counted. */
const mostListed = 40;

export class Aftermath {
  readonly element = h("div", { class: "aftermath", id: "aftermath" });
  private working = false;
  private fault: string[] = [];
  private key = "";

  constructor(private readonly workbench: Workbench) {}

  /** To be called with every answer. */
  update(): void {
    const { player, verdict, invalid } = this.workbench;
    const met = player.finished && player.status.answer.outcome === "contact";
    const offered = met && !verdict && !invalid && canGoOn(player.scene);
    const key = [offered, this.working, player.opened, this.fault.join()].join();
    if (key === this.key) return;
    this.key = key;
    this.element.replaceChildren(...(offered ? this.choices() : []));
  }

  private choices(): Node[] {
    const button = (id: string, text: string, title: string, bounce: boolean): HTMLElement =>
      h("button", { type: "button", id, title, disabled: this.working, onclick: () => void this.goOn(bounce) }, text);
    return [
      h("p", {}, this.working ? "Going on from contact to contact …" : "And then?"),
      h(
        "div",
        { class: "row-of-buttons" },
        button("bounce", "They bounce", "Elastic, without friction; bodies at rest stay there", true),
        button("stop", "They stop", "Each body that moves rests from its first contact on", false),
        this.working
          ? h(
              "button",
              { type: "button", id: "stop-going-on", onclick: () => this.workbench.background.stop() },
              "Cancel",
            )
          : null,
      ),
      ...this.fault.map((line) => h("p", { class: "number-fault", role: "alert" }, line)),
    ].flatMap((node) => node ?? []);
  }

  private async goOn(bounce: boolean): Promise<void> {
    const { player, background, excursion } = this.workbench;
    const about = player.opened;
    this.working = true;
    this.fault = [];
    player.play(false);
    try {
      const follows = await background.call("goOn", player.scene, player.closed, bounce);
      const back = "Back to the first contact";
      if (follows && player.opened === about)
        excursion.show({ scene: follows.scene, verdict: verdictOf(follows, bounce), more: [this.list(follows)], back });
    } catch (error) {
      this.fault = linesOf(error);
    }
    this.working = false;
    this.workbench.redraw();
  }

  private list({ contacts }: WhatFollows): HTMLElement {
    const { player } = this.workbench;
    const item = ({ t, pair }: WhatFollows["contacts"][number]): HTMLElement => {
      const show = (): void => {
        player.play(false);
        player.seek(t);
      };
      const text = `t = ${roundText(t, 9)}: ${pair.join(" x ")}`;
      return h(
        "li",
        {},
        h("button", { type: "button", class: "instant", title: "Show this instant", onclick: show }, text),
      );
    };
    const more = contacts.length - mostListed;
    return h("ul", {}, ...contacts.slice(0, mostListed).map(item), more > 0 ? h("li", {}, `and ${more} more`) : null);
  }
}

/** One by one, and of polygons. */
const canGoOn = (scene: Scene): boolean =>
  !scene.mechanism && scene.bodies.every((body) => !body.relative_to && !isCurved(body));

function verdictOf({ contacts, state, reason, scene }: WhatFollows, bounce: boolean): Verdict {
  const count = contacts.length === 1 ? "1 contact" : `${contacts.length} contacts`;
  const until = state === "contact" ? `Given up after ${count}.` : state === "undecided" ? reason : "";
  return {
    headline: `${bounce ? "They bounce" : "They stop"}: ${count}`,
    outcome: state === "undecided" ? "undecided" : "contact",
    lines: [
      `In between, the bodies are proved apart, up to t = ${roundText(scene.time[1])}.`,
      until,
      bounce
        ? "Elastic, without friction, of one density; bodies at rest stay there."
        : "Each body that moves rests from its first contact on.",
    ].filter(Boolean),
  };
}
