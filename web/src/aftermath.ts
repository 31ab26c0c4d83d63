// After a contact: what if the bodies bounce, or stop there?
import { linesOf } from "./background";
import { h } from "./dom";
import { inParts, type Scene } from "./engine";
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
  /** What is shown, and what was there before. */
  private shown: { follows: WhatFollows; bounce: boolean; opened: number; before: Scene } | null = null;
  private working = false;
  private fault: string[] = [];
  private key = "";

  constructor(private readonly workbench: Workbench) {}

  /** To be called with every answer. */
  update(): void {
    const { player } = this.workbench;
    if (this.shown && this.shown.opened !== player.opened) this.forget();
    const { answer } = player.status;
    const offered =
      !this.workbench.verdict &&
      !this.workbench.invalid &&
      player.finished &&
      answer.outcome === "contact" &&
      canGoOn(player.scene);
    const key = [offered, this.working, this.shown?.opened, player.opened, this.fault.join()].join();
    if (key === this.key) return;
    this.key = key;
    this.element.replaceChildren(
      ...(this.shown ? this.contactsShown(this.shown.follows) : offered ? this.choices() : []),
    );
  }

  /** The scene as it was, up to its first contact. */
  reset(): void {
    const { shown, workbench } = this;
    if (!shown) return;
    this.forget();
    workbench.player.open(shown.before, workbench.player.closed, undefined);
    workbench.redraw();
  }

  get active(): boolean {
    return this.shown !== null;
  }

  private forget(): void {
    this.shown = null;
    this.workbench.verdict = null;
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
    const { player, background } = this.workbench;
    const before = player.scene;
    const about = player.opened;
    this.working = true;
    this.fault = [];
    player.play(false);
    try {
      const follows = await background.call("goOn", before, player.closed, bounce);
      if (follows && player.opened === about) this.show(follows, bounce, before);
    } catch (error) {
      this.fault = linesOf(error);
    }
    this.working = false;
    this.workbench.redraw();
  }

  private show(follows: WhatFollows, bounce: boolean, before: Scene): void {
    const { workbench } = this;
    const { player } = workbench;
    player.open(inParts(follows.scene), player.closed, undefined);
    this.shown = { follows, bounce, opened: player.opened, before };
    workbench.verdict = (): Verdict => verdictOf(follows, bounce);
    workbench.stage.refit();
    player.play(true);
  }

  private contactsShown({ contacts }: WhatFollows): Node[] {
    const { player } = this.workbench;
    const item = ({ t, pair }: WhatFollows["contacts"][number]): HTMLElement =>
      h(
        "li",
        {},
        h(
          "button",
          {
            type: "button",
            class: "instant",
            title: "Show this instant",
            onclick: () => {
              player.play(false);
              player.seek(t);
            },
          },
          `t = ${roundText(t, 9)}: ${pair.join(" x ")}`,
        ),
      );
    const more = contacts.length - mostListed;
    return [
      h("ul", {}, ...contacts.slice(0, mostListed).map(item), more > 0 ? h("li", {}, `and ${more} more`) : null),
      h("button", { type: "button", id: "reset", onclick: () => this.reset() }, "Back to the first contact"),
    ];
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
