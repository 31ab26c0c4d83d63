// What is asked about a way, in numbers and switches.
import { h } from "./dom";
import { NumberField } from "./numberfield";
import type { WayProblem } from "./wayproblem";
import { roundText } from "./words";

export interface WayPanelHost {
  setTurns(on: boolean): void;
  setOutside(on: boolean): void;
  setClearance(distance: number): void;
  setShortest(on: boolean): void;
  setValue(end: "start" | "goal", joint: number, value: number): void;
  stop(): void;
  again(): void;
}

export class WayPanel {
  private readonly turns = this.box("way-turns", "It may turn", (on) => this.host.setTurns(on));
  private readonly outside = this.box("way-outside", "Goal: outside of all others", (on) => this.host.setOutside(on));
  private readonly shortest = this.box("way-shortest", "Make it short", (on) => this.host.setShortest(on));
  private readonly clearance = new NumberField(
    "Distance to keep, in the scene's units",
    { id: "way-clearance", min: 0 },
    {
      taken: (value) => this.host.setClearance(value),
      wrong: (value) => (value >= 0 ? "" : "it must not be negative"),
    },
  );
  private readonly table = h("div", { class: "keyframes", id: "way-values" });
  private readonly button = h(
    "button",
    { type: "button", id: "way-search", onclick: () => (this.searching ? this.host.stop() : this.host.again()) },
    "Look again",
  );
  private searching = false;
  readonly element = h(
    "details",
    { open: true, class: "part part-way", hidden: true },
    h("summary", {}, "Way"),
    this.turns.label,
    this.outside.label,
    this.shortest.label,
    h("div", { class: "fields" }, h("label", { for: "way-clearance" }, "Keep apart by"), this.clearance.input),
    this.clearance.fault,
    this.table,
    this.button,
  );

  constructor(private readonly host: WayPanelHost) {
    this.clearance.show("0");
  }

  /** `made`: of the scene that is open, where the body may turn or not. */
  show(problem: WayProblem | null, made: boolean, turns: boolean, searching = false): void {
    this.element.hidden = !problem;
    this.turns.label.hidden = !made;
    this.turns.input.checked = turns;
    this.searching = searching;
    this.button.textContent = searching ? "Stop" : "Look again";
    if (!problem) return;
    this.outside.input.checked = problem.outside;
    this.showValues(problem);
  }

  private box(
    id: string,
    text: string,
    changed: (on: boolean) => void,
  ): { input: HTMLInputElement; label: HTMLElement } {
    const input = h("input", { type: "checkbox", id, onchange: () => changed(input.checked) });
    return { input, label: h("label", { class: "check" }, input, text) };
  }

  private showValues(problem: WayProblem): void {
    if (this.table.contains(document.activeElement)) return this.refresh(problem);
    this.fields = problem.read.joints.map((joint, k) =>
      (["start", "goal"] as const).map((end) => {
        const [lo, hi] = joint.range;
        return new NumberField(
          `${joint.name} at the ${end}`,
          {},
          {
            taken: (value) => this.host.setValue(end, k, value),
            wrong: (value) =>
              value >= lo && value <= hi ? "" : `it must lie between ${roundText(lo)} and ${roundText(hi)}`,
          },
        );
      }),
    );
    const rows = problem.read.joints.map(({ name }, k) =>
      h("tr", {}, h("th", { scope: "row" }, name), ...this.fields[k].map((field) => h("td", {}, field.input))),
    );
    const head = h("tr", {}, ...["", "start", "goal"].map((text) => h("th", { scope: "col" }, text)));
    this.table.replaceChildren(
      h("table", {}, h("thead", {}, head), h("tbody", {}, ...rows)),
      ...this.fields.flat().map((field) => field.fault),
    );
    this.refresh(problem);
  }

  private fields: NumberField[][] = [];

  private refresh(problem: WayProblem): void {
    this.fields.forEach(([start, goal], k) => {
      start.show(roundText(problem.start[k], 8));
      goal.show(roundText(problem.goal[k], 8));
      goal.input.disabled = problem.outside;
    });
  }
}
