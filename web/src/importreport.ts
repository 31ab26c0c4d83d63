// What was read of a drawing, and what a person should look at: beside the scene that it became.
import { h } from "./dom";
import type { Decisions, DrawingReport, ReadDrawing } from "./engine";
import { roundText } from "./words";

/** What a person may decide, and what its button says. */
type Choice = [Partial<Decisions>, string];
const openChoices: Choice[] = [
  [{ open: "close" }, "Close them by straight lines"],
  [{ open: "skip" }, "Leave them out"],
];
const crossingChoices: Choice[] = [
  [{ crossing: "subtract" }, "Cut the smaller one out"],
  [{ crossing: "union" }, "One part of both"],
  [{ crossing: "parts" }, "All lines are cuts"],
];

/** Longer lists are cut: the command has all. */
const mostNamed = 50;

export class ImportReport {
  readonly element = h("section", { class: "importreport hidden", id: "importreport", "aria-label": "Drawing" });
  /** The picture, and all of it that there is to see. */
  private svg: SVGSVGElement | null = null;
  private whole = "";

  /** `again`: reads the drawing anew. */
  constructor(private readonly again: (decided: Partial<Decisions>) => void) {}

  hide(): void {
    this.element.classList.add("hidden");
  }

  show(name: string, drawing: ReadDrawing): void {
    const { report, picture } = drawing;
    const file = report.files[0];
    const asks = (option: string): boolean => report.faults.some(({ hint }) => hint.includes(option));
    const crossing = asks("--crossing");
    const open = asks("--open") && file?.open.length > 0;
    this.element.classList.remove("hidden");
    this.element.replaceChildren(
      h("h2", {}, name),
      // What can be done about open lines, and about contours that cross, are buttons.
      ...report.faults.map(({ problem, hint }) =>
        h("p", { class: "fault" }, open || crossing ? problem : `${problem}: ${hint}`),
      ),
      ...(open ? [this.decisions(openChoices)] : []),
      ...(crossing ? [this.decisions(crossingChoices)] : []),
      ...(file ? [h("p", {}, `${file.format}, units: ${file.units}`)] : []),
      this.pictureOf(picture),
      ...bodiesOf(report),
      ...(file ? this.marksOf(file) : []),
      h("button", { type: "button", onclick: () => this.hide() }, "Close report"),
    );
  }

  private decisions(choices: Choice[]): HTMLElement {
    const button = ([decided, label]: Choice): HTMLElement => {
      const id = `import-${Object.values(decided)[0]}`;
      return h("button", { type: "button", id, onclick: () => this.again(decided) }, label);
    };
    return h("p", {}, ...choices.flatMap((choice) => [button(choice), " "]));
  }

  private pictureOf(picture: string): HTMLElement {
    const document = new DOMParser().parseFromString(picture, "image/svg+xml");
    this.svg = document.documentElement as unknown as SVGSVGElement;
    this.whole = this.svg.getAttribute("viewBox")!;
    this.svg.removeAttribute("width");
    this.svg.removeAttribute("height");
    const title = "Click for the whole drawing";
    return h("div", { class: "importpicture", title, onclick: () => this.look(null) }, this.svg);
  }

  /** A mark of the picture, large; or all of it. */
  private look(id: string | null): void {
    const mark = id && this.svg?.querySelector<SVGGraphicsElement>(`#${id}`);
    if (!mark) return void this.svg?.setAttribute("viewBox", this.whole);
    const box = mark.getBBox();
    const size = Math.max(box.width, box.height, 10) * 3;
    const [x, y] = [box.x + box.width / 2 - size / 2, box.y + box.height / 2 - size / 2];
    this.svg!.setAttribute("viewBox", `${x} ${y} ${size} ${size}`);
  }

  private marksOf(file: DrawingReport["files"][0]): HTMLElement[] {
    const item = (id: string, text: string): HTMLElement =>
      h("li", {}, h("button", { type: "button", class: "link", onclick: () => this.look(id) }, text));
    const point = ([x, y]: [number, number]): string => `(${roundText(x)}, ${roundText(y)})`;
    return [
      ...list("Gaps that were closed", file.gaps, (gap, k) =>
        item(`gap-0-${k}`, `${roundText(gap.width)} at ${point(gap.from)}`),
      ),
      ...list("Open lines", file.open, (line, k) =>
        item(`open-0-${k}`, `from ${point(line.from)} to ${point(line.to)}`),
      ),
      ...list("Cut off", file.repairs, (repair, k) =>
        item(`repair-0-${k}`, `a ${repair.what} of ${roundText(repair.size)} at ${point(repair.at)}`),
      ),
      ...list("Contours that meet themselves", file.crossings, (crossing, k) =>
        item(`crossing-0-${k}`, `at ${point(crossing.at)}: several parts`),
      ),
      ...list("Notes", file.notes, (note) => h("li", {}, note)),
      ...list("Skipped", file.skipped, ({ what, reason, place, times }) =>
        h("li", {}, `${what} ${reason}, ${place}${times > 1 ? `, and ${times - 1} more` : ""}`),
      ),
    ];
  }
}

function bodiesOf(report: DrawingReport): HTMLElement[] {
  return list("Bodies", report.bodies, ({ name, parts, holes, area, box }) => {
    const [width, height] = [box[1][0] - box[0][0], box[1][1] - box[0][1]];
    const size = `${roundText(width)} x ${roundText(height)}`;
    return h("li", {}, `${name}: area ${roundText(area)}, ${size}, parts: ${parts}, holes: ${holes}`);
  });
}

/** A heading and the items, if there are any. */
function list<Item>(title: string, items: Item[], line: (item: Item, k: number) => HTMLElement): HTMLElement[] {
  if (items.length === 0) return [];
  const lines = items.slice(0, mostNamed).map(line);
  if (items.length > mostNamed) lines.push(h("li", {}, `${items.length - mostNamed} more`));
  return [h("h3", {}, title), h("ul", {}, ...lines)];
}
