// A field for a number. Text that is not a number is not taken: the field keeps its value, is marked, and says why.
import { h } from "./dom";

export interface NumberFieldHost {
  /** A number was typed. */
  taken(value: number): void;
  /** Why a number cannot be meant; empty if it can. */
  wrong?(value: number): string;
  /** The field was emptied; without this, it may not be. */
  emptied?(): void;
}

let count = 0;

export class NumberField {
  readonly input: HTMLInputElement;
  /** What was not taken, and what stays; to be placed near the field. */
  readonly fault: HTMLElement;
  /** The number that counts, as the field shows it; empty before the first. */
  private kept = "";

  /** `label` names the field in its message, and for those who do not see it. */
  constructor(
    private readonly label: string,
    attributes: Record<string, unknown>,
    private readonly host: NumberFieldHost,
  ) {
    const id = `number-fault-${++count}`;
    this.fault = h("p", { class: "number-fault", role: "alert", id, hidden: true });
    this.input = h("input", {
      type: "number",
      step: "any",
      "aria-label": label,
      "aria-describedby": id,
      ...attributes,
      oninput: () => this.mark(""),
      onchange: () => this.read(),
    });
  }

  /** Null before the first number. */
  get value(): number | null {
    return this.kept === "" ? null : Number(this.kept);
  }

  /** Shows a number that counts, rounded for the eye if need be. */
  show(text: string): void {
    this.kept = text;
    this.input.value = text;
    this.mark("");
  }

  private read(): void {
    const { value, validity } = this.input;
    const fault = this.faultOf(value, validity.badInput);
    if (fault === "") {
      this.kept = value.trim();
      if (this.kept === "") this.host.emptied!();
      else this.host.taken(Number(value));
    } else {
      this.input.value = this.kept;
      this.mark(`${this.label}: ${fault}. ${this.kept === "" ? "" : `It stays ${this.kept}.`}`);
    }
  }

  /** The browser empties what it cannot read, and says so. */
  private faultOf(text: string, unreadable: boolean): string {
    if (unreadable || (text !== "" && !Number.isFinite(Number(text)))) return "this is not a number that can be read";
    if (text.trim() === "") return this.host.emptied ? "" : "nothing was typed";
    return this.host.wrong?.(Number(text)) ?? "";
  }

  private mark(fault: string): void {
    if (fault === "") this.input.removeAttribute("aria-invalid");
    else this.input.setAttribute("aria-invalid", "true");
    this.fault.textContent = fault;
    this.fault.hidden = fault === "";
  }
}
