// The bar below the picture: play, step, scrub, the time in digits, and the speed.
import { h, iconButton, setIcon } from "./dom";
import type { Player } from "./player";
import { clockText, roundText } from "./words";

export class Transport {
  readonly element: HTMLElement;
  private readonly playButton: HTMLButtonElement;
  private readonly slider = h("input", {
    type: "range",
    id: "time",
    min: 0,
    max: 1,
    step: "any",
    "aria-label": "Time",
  });
  private readonly clock = h("output", { class: "clock", id: "clock", for: "time" });

  /** The lanes and the strip of events lie along the slider. */
  constructor(
    private readonly player: Player,
    lanes: HTMLElement,
    strip: HTMLElement,
  ) {
    this.playButton = iconButton("play", "Play", () => player.play(!player.playing), "Space");
    this.playButton.id = "play";
    this.element = this.build(lanes, strip);
  }

  /** The instant shown. */
  show(): void {
    const { player, slider } = this;
    slider.value = String((player.t - player.start) / (player.end - player.start || 1));
    const text = player.atContact || player.selected >= 0 ? roundText(player.t, 16) : clockText(player.t, player.scene);
    this.clock.textContent = `t = ${text}`;
    this.clock.dataset.t = String(player.t);
    this.clock.title = `t = ${text}`;
    slider.setAttribute("aria-valuetext", `t = ${text}`);
    setIcon(this.playButton, player.playing ? "pause" : "play", player.playing ? "Pause" : "Play", "Space");
  }

  private build(lanes: HTMLElement, strip: HTMLElement): HTMLElement {
    const { player } = this;
    const speeds = [0.05, 0.1, 0.25, 0.5, 1, 2, 4, 10];
    const speed = h(
      "select",
      { id: "speed", "aria-label": "Speed", title: "Speed", onchange: () => (player.speed = Number(speed.value)) },
      ...speeds.map((s) => h("option", { value: s, selected: s === 1 }, `${s} ×`)),
    );
    this.slider.addEventListener("input", () => {
      player.playing = false;
      // The slider counts shares of the time, because it rounds: its right end is the very last instant.
      const share = Number(this.slider.value);
      player.seek(share >= 1 ? player.end : player.start + share * (player.end - player.start));
    });
    const button = (
      name: "first" | "previous" | "next" | "last",
      label: string,
      action: () => void,
      key: string,
    ): HTMLButtonElement => {
      const b = iconButton(name, label, action, key);
      b.id = name;
      return b;
    };
    return h(
      "footer",
      { class: "transport" },
      h(
        "div",
        { class: "buttons", role: "group", "aria-label": "Time" },
        button("first", "Start", () => player.show(-1), "Home"),
        button("previous", "Previous event", () => player.stepEvent(-1), "←"),
        this.playButton,
        button("next", "Next event", () => player.stepEvent(1), "→"),
        button("last", "Contact, lock or end", () => player.toTheEnd(), "End"),
      ),
      h("div", { class: "scrub" }, lanes, strip, this.slider),
      this.clock,
      speed,
    );
  }
}
