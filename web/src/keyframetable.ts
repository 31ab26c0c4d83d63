// The keyframes of a body as a table of numbers.
import { h } from "./dom";
import type { Keyframe } from "./motions";
import { roundText } from "./words";

export interface KeyframeHost {
  set(frames: Keyframe[]): void;
  /** One more at the instant shown. */
  add(frames: Keyframe[]): void;
  /** Keyframes in place of a formula. */
  sample(): void;
}

export class KeyframeTable {
  readonly element = h("div", { class: "keyframes", id: "keyframes" });

  constructor(private readonly host: KeyframeHost) {}

  /** Null: the motion is a formula. */
  show(frames: Keyframe[] | null): void {
    if (!frames) {
      this.element.replaceChildren(
        h("p", {}, "This motion is a formula. Keyframes would replace it by steady motion between eight instants."),
        h("button", { type: "button", id: "sample", onclick: () => this.host.sample() }, "Replace by keyframes"),
      );
      return;
    }
    const input = (k: number, field: keyof Keyframe, label: string): HTMLInputElement => {
      const scale = field === "angle" ? 180 / Math.PI : 1;
      const element = h("input", {
        type: "number",
        step: "any",
        value: roundText(frames[k][field] * scale, 8),
        "aria-label": `${label} of keyframe ${k + 1}`,
        disabled: field === "t" && (k === 0 || k === frames.length - 1),
        onchange: () => {
          frames[k] = { ...frames[k], [field]: Number(element.value) / scale };
          this.host.set(frames);
        },
      });
      return element;
    };
    const rows = frames.map((_, k) =>
      h(
        "tr",
        {},
        ...(["t", "x", "y", "angle"] as const).map((field) => h("td", {}, input(k, field, field))),
        h(
          "td",
          {},
          frames.length > 1
            ? h(
                "button",
                {
                  type: "button",
                  "aria-label": `Remove keyframe ${k + 1}`,
                  title: "Remove",
                  onclick: () =>
                    this.host.set(frames.length === 2 ? [{ ...frames[1 - k], t: frames[0].t }] : keepEnds(frames, k)),
                },
                "×",
              )
            : null,
        ),
      ),
    );
    this.element.replaceChildren(
      h(
        "table",
        {},
        h("thead", {}, h("tr", {}, ...["t", "x", "y", "angle °", ""].map((t) => h("th", { scope: "col" }, t)))),
        h("tbody", {}, ...rows),
      ),
      h(
        "button",
        { type: "button", id: "add-keyframe", title: "Where the body is now", onclick: () => this.host.add(frames) },
        "Add keyframe at the instant shown",
      ),
    );
  }
}

function keepEnds(frames: Keyframe[], remove: number): Keyframe[] {
  const out = frames.filter((_, i) => i !== remove);
  // The first and the last keyframe stand at the ends of the time.
  out[0] = { ...out[0], t: frames[0].t };
  out[out.length - 1] = { ...out[out.length - 1], t: frames[frames.length - 1].t };
  return out;
}
