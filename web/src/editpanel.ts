// The panel beside the picture: what dragging does, and the numbers of the scene and of the chosen body.
import { h } from "./dom";
import type { Scene } from "./engine";
import type { Mode } from "./handles";
import { KeyframeTable, type KeyframeHost } from "./keyframetable";
import { isJoined } from "./mechanisms";
import type { Keyframe } from "./motions";
import { NumberField } from "./numberfield";

const modes: [Mode, string, string][] = [
  ["look", "Look", "Drag to move the view, or a link of a mechanism: the others follow."],
  ["shape", "Shape", "Drag a body or a vertex. Double-click an edge to add a vertex; Delete removes the chosen one."],
  ["keyframes", "Keyframes", "Drag a ghost to where the body is to be at that instant; drag its handle to turn it."],
  [
    "drive",
    "Drive",
    "Drag the arrow or the spin handle: the plan changes from the instant shown on, also while time runs.",
  ],
  ["way", "Way", "Drag start and goal, or their handles, which turn them: a way is found, or proved not to be there."],
];
/** The mode that the key with this number stands for. */
export const modeOfKey = (number: number): Mode => modes[number - 1][0];

export interface EditPanelHost extends KeyframeHost {
  setMode(mode: Mode): void;
  choose(body: number): void;
  setTouch(): void;
  setTime(start: number, end: number): void;
}

export class EditPanel {
  readonly element: HTMLElement;
  private readonly noteLine = h("p", { class: "note", role: "status", id: "note" });
  private readonly hint = h("p", { class: "hint" });
  private readonly modeButtons: HTMLButtonElement[];
  private readonly body: HTMLSelectElement;
  private readonly touchSelect: HTMLSelectElement;
  private readonly start: NumberField;
  private readonly end: NumberField;
  private readonly table: KeyframeTable;

  constructor(host: EditPanelHost) {
    this.modeButtons = modes.map(([mode, label]) =>
      h(
        "button",
        { type: "button", id: `mode-${mode}`, "aria-pressed": "false", onclick: () => host.setMode(mode) },
        label,
      ),
    );
    this.body = h("select", { id: "body", onchange: () => host.choose(Number(this.body.value)) });
    this.touchSelect = h(
      "select",
      { id: "touch", onchange: () => host.setTouch() },
      h("option", { value: "open" }, "open: touching is allowed"),
      h("option", { value: "closed" }, "closed: touching counts"),
    );
    const taken = (): void => host.setTime(this.start.value!, this.end.value!);
    this.start = new NumberField("Start of the time", { id: "time-start" }, { taken });
    this.end = new NumberField("End of the time", { id: "time-end" }, { taken });
    this.table = new KeyframeTable(host);
    this.element = this.build();
  }

  /** What was done, or is to be known, in words. */
  set note(text: string) {
    this.noteLine.textContent = text;
  }

  get touch(): "open" | "closed" {
    return this.touchSelect.value as "open" | "closed";
  }

  set touch(touch: "open" | "closed") {
    this.touchSelect.value = touch;
  }

  showMode(mode: Mode): void {
    modes.forEach(([name, , hint], i) => {
      this.modeButtons[i].setAttribute("aria-pressed", String(name === mode));
      if (name === mode) this.hint.textContent = hint;
    });
  }

  /** Fields and keyframes of the chosen body. */
  show(scene: Scene, body: number, keyframes: Keyframe[] | null): void {
    this.body.replaceChildren(...scene.bodies.map((b, i) => h("option", { value: i, selected: i === body }, b.name)));
    [this.start, this.end].forEach((field, i) => {
      field.show(String(scene.time[i]));
    });
    if (isJoined(scene, body)) this.table.showJoined();
    else this.table.show(keyframes);
  }

  private build(): HTMLElement {
    return h(
      "details",
      { open: true, class: "part part-edit" },
      h("summary", {}, "Edit"),
      h("div", { class: "modes", role: "group", "aria-label": "What dragging does" }, ...this.modeButtons),
      this.hint,
      h(
        "div",
        { class: "fields" },
        h("label", { for: "body" }, "Body"),
        this.body,
        h("label", { for: "time-start" }, "Time"),
        h("span", { class: "pair" }, this.start.input, h("label", { for: "time-end" }, "to"), this.end.input),
        h("label", { for: "touch" }, "Touch"),
        this.touchSelect,
      ),
      this.start.fault,
      this.end.fault,
      this.table.element,
      this.noteLine,
    );
  }
}
