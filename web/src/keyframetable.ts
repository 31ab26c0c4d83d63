// The keyframes of a body as a table of numbers.
import { h } from "./dom";
import type { Keyframe } from "./motions";
import { NumberField } from "./numberfield";
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

  /** Of a link of a mechanism. */
  showJoined(): void {
    this.element.replaceChildren(h("p", {}, "Joints move this body. Drag it: the time follows."));
  }

  /** Null: the motion is a formula. */
  show(frames: Keyframe[] | null): void {
    if (!frames) {
      this.element.replaceChildren(
        h("p", {}, "This motion is a formula. Keyframes would replace it by steady motion between eight instants."),
        h("button", { type: "button", id: "sample", onclick: () => this.host.sample() }, "Replace by keyframes"),
      );
      return;
    }
    const fields = frames.map((_, k) => (["t", "x", "y", "angle"] as const).map((name) => this.field(frames, k, name)));
    const rows = fields.map((row, k) =>
      h(
        "tr",
        {},
        ...row.map((field) => h("td", {}, field.input)),
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
      ...fields.flat().map((field) => field.fault),
      h(
        "button",
        { type: "button", id: "add-keyframe", title: "Where the body is now", onclick: () => this.host.add(frames) },
        "Add keyframe at the instant shown",
      ),
    );
  }

  private field(frames: Keyframe[], k: number, name: keyof Keyframe): NumberField {
    const scale = name === "angle" ? 180 / Math.PI : 1;
    const attributes = { disabled: name === "t" && (k === 0 || k === frames.length - 1) };
    const field = new NumberField(`${name} of keyframe ${k + 1}`, attributes, {
      taken: (value) =>
        this.host.set(frames.map((frame, i) => (i === k ? { ...frame, [name]: value / scale } : frame))),
      wrong: (value) => (name === "t" ? wrongTime(frames, k, value) : ""),
    });
    field.show(roundText(frames[k][name] * scale, 8));
    return field;
  }
}

/** A keyframe may pass others, but neither of those at the ends of the time. */
function wrongTime(frames: Keyframe[], k: number, t: number): string {
  const [first, last] = [frames[0].t, frames[frames.length - 1].t];
  if (t <= first || t >= last) return `it must lie between ${roundText(first, 8)} and ${roundText(last, 8)}`;
  return frames.some((frame, i) => i !== k && frame.t === t) ? "another keyframe has this time" : "";
}

function keepEnds(frames: Keyframe[], remove: number): Keyframe[] {
  const out = frames.filter((_, i) => i !== remove);
  // The first and the last keyframe stand at the ends of the time.
  out[0] = { ...out[0], t: frames[0].t };
  out[out.length - 1] = { ...out[out.length - 1], t: frames[frames.length - 1].t };
  return out;
}
