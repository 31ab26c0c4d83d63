// The page of `taut envelope --html`: a map of all combinations of joint values, and the linkage at the one that the
// pointer is on.
import { h, iconButton } from "./dom";
import { Labels } from "./labels";
import { CellIndex, placementOf, type Cell, type CellState, type EnvelopePage, type LinkedBody } from "./linkage";
import { saveFile } from "./files";
import { roundText } from "./words";

const margin = { left: 64, right: 16, top: 16, bottom: 44 };
const svgSpace = "http://www.w3.org/2000/svg";

class EnvelopeViewer {
  readonly values: number[];
  private readonly joints = this.data.envelope.joints;
  private readonly cells: CellIndex;
  private readonly canvas = h("canvas", { tabindex: "0", role: "application" });
  private readonly svg = document.createElementNS(svgSpace, "svg");
  private readonly pictures: SVGGElement[];
  private readonly state = h("span", { class: "state", role: "status" });
  private readonly sliders: HTMLInputElement[];
  private readonly outputs: HTMLOutputElement[];
  private readonly labels: SVGTextElement[];
  /** A click keeps the pose; another one lets it follow the pointer again. */
  private kept = false;
  /** How high letters are in the picture, in its units. */
  private letter = 1;
  private readonly places = new Labels();

  constructor(private readonly data: EnvelopePage) {
    this.values = this.joints.map(
      ({ name, range }) => data.envelope.witness?.values[name] ?? (range[0] + range[1]) / 2,
    );
    this.cells = new CellIndex(data.envelope.cells, this.joints);
    this.pictures = data.bodies.map((body, k) => this.pictureOf(body, k));
    this.labels = data.bodies.map((body) => this.labelOf(body));
    this.outputs = this.joints.map(() => h("output"));
    this.sliders = this.joints.map(({ name, range }, k) => {
      const step = (range[1] - range[0]) / 1000;
      const moved = () => this.set(k, Number(slider.value));
      const slider = h("input", {
        type: "range",
        min: range[0],
        max: range[1],
        step,
        "aria-label": name,
        oninput: moved,
      });
      return slider;
    });
    this.svg.setAttribute("role", "img");
    this.svg.setAttribute("aria-label", "the bodies at these joint values");
    this.fit();
    this.listen();
  }

  element(): HTMLElement {
    const names = this.joints.map(({ name }) => name).join(", ");
    this.canvas.setAttribute("aria-label", `combinations of ${names}; arrow keys move the point`);
    const controls = this.joints.map(({ name }, k) =>
      h("label", { class: "joint" }, name, this.sliders[k]!, this.outputs[k]!),
    );
    const help =
      "Move over the map to see the bodies there. A click keeps the pose, another one lets it go. Arrow keys move the point, with Shift in small steps.";
    return h(
      "div",
      { class: "envelope" },
      h(
        "header",
        {},
        h("h1", {}, this.data.title ?? "All combinations"),
        h("span", { class: "shares" }, ...this.shares()),
        h(
          "button",
          { type: "button", id: "copy", title: "The joint values as JSON", onclick: () => void this.copy() },
          "Copy pose",
        ),
        h(
          "button",
          { type: "button", id: "svg", title: "The bodies as a picture", onclick: () => this.save() },
          "Save SVG",
        ),
        iconButton("theme", "Light or dark", () => this.toggleTheme(), "t"),
      ),
      h("div", { class: "map" }, this.canvas),
      h("div", { class: "pose" }, this.svg),
      h("div", { class: "controls" }, this.state, ...controls, h("p", { class: "help" }, help)),
    );
  }

  /** The pose of the page's values, and what is known of it. */
  show(): void {
    const cell = this.cells.at(this.values);
    this.places.clear();
    this.data.bodies.forEach((body, k) => {
      const { x, y, c, s } = placementOf(this.data.bodies, body, this.values, this.joints);
      this.pictures[k]!.setAttribute("transform", `matrix(${c} ${s} ${-s} ${c} ${x} ${y})`);
      this.place(this.labels[k]!, body, { x, y, c, s });
      this.pictures[k]!.classList.toggle("meets", cell?.state === "colliding" && !!cell.pair?.includes(body.name));
    });
    this.joints.forEach((_, k) => {
      this.sliders[k]!.value = String(this.values[k]);
      this.outputs[k]!.value = roundText(this.values[k]!, 6) + (this.inDegrees(k) ? "°" : "");
    });
    this.state.className = `state ${cell?.state ?? "undecided"}`;
    this.state.replaceChildren(h("i"), stateText(cell));
    this.drawMap();
  }

  /** The legend of the map, with how much of it there is of each kind. */
  private shares(): HTMLElement[] {
    const states: CellState[] = ["free", "colliding", "undecided"];
    const shares = states.map((state) => {
      const percent = `${roundText(100 * this.data.envelope[state], 3)} %`;
      return h("span", { class: `state ${state}` }, h("i"), `${state} ${percent}`);
    });
    if (!this.data.envelope.other_poses) return shares;
    return [...shares, h("span", {}, "Cells are about one pose; other ways without a lock may lead to another one.")];
  }

  private async copy(): Promise<void> {
    const pose = Object.fromEntries(this.joints.map(({ name }, k) => [name, this.values[k]]));
    await navigator.clipboard.writeText(JSON.stringify(pose));
  }

  /** The bodies as they are shown: a picture on its own has no style sheet of the page. */
  private save(): void {
    const picture = this.svg.cloneNode(true) as SVGSVGElement;
    const ruled = "path, text";
    const properties = ["fill-opacity", "fill", "stroke", "stroke-width", "stroke-linejoin", "vector-effect"];
    const ofText = ["paint-order", "text-anchor", "font-family", "font-weight"];
    const from = [...this.svg.querySelectorAll(ruled)];
    [...picture.querySelectorAll(ruled)].forEach((copy, i) => {
      const style = getComputedStyle(from[i]!);
      for (const name of copy.tagName === "text" ? [...properties, ...ofText] : properties)
        copy.setAttribute(name, style.getPropertyValue(name));
    });
    picture.setAttribute("xmlns", svgSpace);
    picture.style.background = getComputedStyle(document.body).backgroundColor;
    saveFile(picture.outerHTML, `${this.data.title ?? "pose"}.svg`, "image/svg+xml");
  }

  private toggleTheme(): void {
    const { dataset } = document.documentElement;
    dataset.theme = dataset.theme === "dark" ? "light" : "dark";
    this.show();
  }

  /** Does the joint turn bodies, and shift none? */
  private inDegrees(k: number): boolean {
    const motions = this.data.bodies.flatMap(({ motion }) => motion ?? []).filter(({ joint }) => joint === k);
    return motions.length > 0 && motions.every(({ pivot }) => pivot !== undefined);
  }

  private labelOf(body: LinkedBody): SVGTextElement {
    const label = document.createElementNS(svgSpace, "text");
    label.textContent = body.name;
    return label;
  }

  /** Above the middle of the body's highest vertices there. */
  private place(label: SVGTextElement, body: LinkedBody, at: { x: number; y: number; c: number; s: number }): void {
    const points = body.parts.flat(2).map(([u, v]) => [at.x + at.c * u - at.s * v, at.y + at.s * u + at.c * v]);
    const top = points.reduce((most, [, y]) => Math.max(most, y!), -Infinity);
    const highest = points.flatMap(([x, y]) => (y! > top - 0.1 * this.letter ? [x!] : []));
    const middle = highest.reduce((sum, x) => sum + x, 0) / highest.length;
    const y = -top - 0.3 * this.letter;
    label.setAttribute("x", String(middle));
    label.setAttribute("y", String(y));
    label.setAttribute("font-size", String(this.letter));
    // A letter is about half as wide as it is high. The names of hidden labels are the bodies' tooltips.
    const width = 0.5 * this.letter * body.name.length;
    label.style.display = this.places.take({ x: middle - width / 2, y, width }, this.letter) ? "" : "none";
  }

  private pictureOf(body: LinkedBody, k: number): SVGGElement {
    const picture = document.createElementNS(svgSpace, "g");
    picture.setAttribute("fill", this.data.colours[k % this.data.colours.length]!);
    picture.setAttribute("fill-rule", "evenodd");
    const title = document.createElementNS(svgSpace, "title");
    title.textContent = body.name;
    const paths = body.parts.map((rings) => {
      const path = document.createElementNS(svgSpace, "path");
      path.setAttribute("d", rings.map((ring) => `M${ring.map((p) => p.join(",")).join("L")}Z`).join(""));
      return path;
    });
    picture.append(title, ...paths);
    return picture;
  }

  /** Around all that the bodies reach, by some poses; y upwards. */
  private fit(): void {
    const xs: number[] = [];
    const ys: number[] = [];
    const steps = 8;
    for (let i = 0; i < (steps + 1) ** this.joints.length; ++i) {
      const values = this.joints.map(({ range }, k) => {
        const share = (Math.floor(i / (steps + 1) ** k) % (steps + 1)) / steps;
        return range[0] + share * (range[1] - range[0]);
      });
      for (const body of this.data.bodies) {
        const { x, y, c, s } = placementOf(this.data.bodies, body, values, this.joints);
        for (const [u, v] of body.parts.flat(2)) {
          xs.push(x + c * u - s * v);
          ys.push(y + s * u + c * v);
        }
      }
    }
    const least = (all: number[]) => all.reduce((a, b) => Math.min(a, b));
    const most = (all: number[]) => all.reduce((a, b) => Math.max(a, b));
    const [left, right, low, high] = [least(xs), most(xs), least(ys), most(ys)];
    const room = 0.06 * Math.max(right - left, high - low);
    this.letter = 0.027 * Math.max(right - left, high - low);
    this.svg.setAttribute(
      "viewBox",
      [left - room, -high - room, right - left + 2 * room, high - low + 2 * room].join(" "),
    );
    const upwards = document.createElementNS(svgSpace, "g");
    upwards.setAttribute("transform", "scale(1 -1)");
    upwards.append(...this.pictures);
    this.svg.replaceChildren(upwards, ...this.labels);
  }

  private listen(): void {
    this.canvas.addEventListener("pointermove", (event) => {
      if (!this.kept || event.buttons) this.point(event);
    });
    this.canvas.addEventListener("pointerdown", (event) => {
      this.kept = !this.kept;
      this.point(event);
    });
    this.canvas.addEventListener("keydown", (event) => {
      const step = { ArrowLeft: [0, -1], ArrowRight: [0, 1], ArrowDown: [1, -1], ArrowUp: [1, 1] }[event.key];
      if (!step || !this.joints[step[0]!]) return;
      event.preventDefault();
      const [lo, hi] = this.joints[step[0]!]!.range;
      this.set(step[0]!, this.values[step[0]!]! + (step[1]! * (hi - lo)) / (event.shiftKey ? 1000 : 100));
    });
    document.addEventListener("keydown", (event) => {
      if (event.key === "t" && !event.ctrlKey && !event.metaKey && !event.altKey) this.toggleTheme();
    });
    new ResizeObserver(() => this.show()).observe(this.canvas);
  }

  private set(k: number, value: number): void {
    const [lo, hi] = this.joints[k]!.range;
    this.values[k] = Math.min(hi, Math.max(lo, value));
    this.show();
  }

  private point(event: PointerEvent): void {
    const { left, top } = this.canvas.getBoundingClientRect();
    const { width, height } = this.plot();
    const across = (event.clientX - left - margin.left) / width;
    const up = 1 - (event.clientY - top - margin.top) / height;
    [across, up].slice(0, this.joints.length).forEach((share, k) => {
      const [lo, hi] = this.joints[k]!.range;
      this.values[k] = lo + Math.min(1, Math.max(0, share)) * (hi - lo);
    });
    this.show();
  }

  private plot(): { width: number; height: number } {
    const { clientWidth, clientHeight } = this.canvas;
    return { width: clientWidth - margin.left - margin.right, height: clientHeight - margin.top - margin.bottom };
  }

  /** All cells; of three joints, those that hold the third one's value. */
  private drawMap(): void {
    const ratio = window.devicePixelRatio || 1;
    const { clientWidth, clientHeight } = this.canvas;
    this.canvas.width = Math.round(clientWidth * ratio);
    this.canvas.height = Math.round(clientHeight * ratio);
    const g = this.canvas.getContext("2d")!;
    g.scale(ratio, ratio);
    const { width, height } = this.plot();
    const place = (value: number, k: number) => {
      const [lo, hi] = this.joints[k]!.range;
      return (value - lo) / (hi - lo);
    };
    const x = (value: number) => margin.left + place(value, 0) * width;
    const y = (value: number) => (this.joints[1] ? margin.top + (1 - place(value, 1)) * height : margin.top);
    const style = getComputedStyle(document.documentElement);
    for (const cell of this.data.envelope.cells) {
      if (this.joints[2] && (this.values[2]! < cell.lo[2]! || this.values[2]! > cell.hi[2]!)) continue;
      g.fillStyle = style.getPropertyValue(`--cell-${cell.state}`);
      const bottom = this.joints[1] ? y(cell.lo[1]!) : margin.top + height;
      const upper = this.joints[1] ? y(cell.hi[1]!) : margin.top;
      // A little more, so that no seams show.
      g.fillRect(x(cell.lo[0]!), upper, x(cell.hi[0]!) - x(cell.lo[0]!) + 0.4, bottom - upper + 0.4);
    }
    this.drawAxes(g, width, height, style);
    g.strokeStyle = style.getPropertyValue("--ink");
    g.lineWidth = 1.5;
    const [px, py] = [x(this.values[0]!), this.joints[1] ? y(this.values[1]!) : margin.top + height / 2];
    g.beginPath();
    g.arc(px, py, 6, 0, 2 * Math.PI);
    g.moveTo(px - 12, py);
    g.lineTo(px + 12, py);
    g.moveTo(px, py - 12);
    g.lineTo(px, py + 12);
    g.stroke();
  }

  private drawAxes(g: CanvasRenderingContext2D, width: number, height: number, style: CSSStyleDeclaration): void {
    g.fillStyle = style.getPropertyValue("--ink");
    g.strokeStyle = style.getPropertyValue("--line");
    g.font = "12px system-ui, sans-serif";
    g.strokeRect(margin.left, margin.top, width, height);
    const share = (k: number, value: number): number => {
      const [lo, hi] = this.joints[k]!.range;
      return (value - lo) / (hi - lo);
    };
    const name = (k: number): string => this.joints[k]!.name + (this.inDegrees(k) ? " (deg)" : "");
    g.textAlign = "center";
    for (const value of roundTicks(this.joints[0]!.range)) {
      const x = margin.left + width * share(0, value);
      g.strokeRect(x, margin.top + height, 0, 4);
      g.fillText(roundText(value, 6), x, margin.top + height + 17);
    }
    g.fillText(name(0), margin.left + width / 2, margin.top + height + 36);
    if (!this.joints[1]) return;
    g.textAlign = "right";
    for (const value of roundTicks(this.joints[1].range)) {
      const y = margin.top + height * (1 - share(1, value));
      g.strokeRect(margin.left - 4, y, 4, 0);
      g.fillText(roundText(value, 6), margin.left - 7, y + 4);
    }
    g.textAlign = "center";
    g.save();
    g.translate(14, margin.top + height / 2);
    g.rotate(-Math.PI / 2);
    g.fillText(name(1), 0, 0);
    g.restore();
  }
}

/** Some five round numbers in a range. */
function roundTicks([lo, hi]: [number, number]): number[] {
  const raw = (hi - lo) / 5;
  const unit = 10 ** Math.floor(Math.log10(raw));
  const step = [1, 2, 5, 10].map((k) => k * unit).find((s) => s >= raw)!;
  const ticks: number[] = [];
  for (let k = Math.ceil(lo / step - 1e-9); k * step <= hi + 1e-9 * step; ++k) ticks.push(k * step);
  return ticks;
}

function stateText(cell: Cell | undefined): string {
  const says: Record<CellState, string> = {
    free: "free: proved for all combinations around this one",
    colliding: `${cell?.pair?.join(" and ")} overlap`,
    undecided: cell?.may_lock
      ? "not decided: the mechanism may lock, or does not get there"
      : `not decided${cell?.pair ? `: ${cell.pair.join(" and ")} touch, or nearly do` : ""}`,
  };
  return says[cell?.state ?? "undecided"];
}

const data = JSON.parse(document.getElementById("taut-data")!.textContent!) as EnvelopePage;
if (matchMedia("(prefers-color-scheme: dark)").matches) document.documentElement.dataset.theme = "dark";
document.title = data.title ?? "taut envelope";
const viewer = new EnvelopeViewer(data);
document.querySelector(".loading")?.remove();
document.body.append(viewer.element());
viewer.show();
/** For tests. */
(window as unknown as { envelope: EnvelopeViewer }).envelope = viewer;
