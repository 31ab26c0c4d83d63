// What is marked in the picture: events, the contact, faults; and what is written into it.
import type { Camera } from "./camera";
import { addSegmentOf } from "./curvedrawing";
import { placed } from "./figure";
import type { ContactMarks, Culprit, EventMarks, FaultMarks, Frame, NearestMarks } from "./frame";
import { ascent, descent, Labels, type Label } from "./labels";
import { addSegment } from "./pixels";
import type { Edge } from "./replay";
import type { Colours } from "./theme";

/** The pixels of all vertices of the map, by internal number. */
export interface VertexPixels {
  px: Float64Array;
  py: Float64Array;
}

export function pixelOf(camera: Camera, frame: Frame, body: number, index: number): [number, number] {
  const figure = frame.figures[body];
  return camera.pixel(...placed(frame.poses[body], figure.x[index], figure.y[index]));
}

export class Marks {
  /** Of contacts and overlaps in the present frame. */
  readonly labels = new Labels();

  constructor(
    private readonly context: CanvasRenderingContext2D,
    private readonly camera: Camera,
    private readonly at: VertexPixels,
  ) {}

  private lines(lines: Edge[], colour: string, width: number): void {
    const c = this.context;
    const { px, py } = this.at;
    c.beginPath();
    for (const [a, b] of lines) addSegment(c, px[a], py[a], px[b], py[b], this.camera);
    c.strokeStyle = colour;
    c.lineWidth = width;
    c.stroke();
  }

  event(marks: EventMarks, colours: Colours): void {
    const c = this.context;
    const { px, py } = this.at;
    const [u, v, w] = marks.event.corner;
    this.lines(
      [
        [u, v],
        [v, w],
      ],
      colours.failing,
      14,
    );
    this.lines(marks.come, colours.paper, 6);
    this.lines(marks.come, colours.come, 3.2);
    this.gone(marks.gone, colours);
    const dots: [number, string, number][] = [
      [u, "u", 4],
      [v, "v", 6],
      [w, "w", 4],
    ];
    c.font = "600 13px system-ui, sans-serif";
    for (const [vertex, label, radius] of dots) {
      c.beginPath();
      c.arc(px[vertex], py[vertex], radius, 0, 2 * Math.PI);
      c.fillStyle = label === "v" ? colours.failingEdge : colours.paper;
      c.fill();
      c.strokeStyle = colours.failingEdge;
      c.lineWidth = 2;
      c.stroke();
      this.text(label, px[vertex] + 10, py[vertex] - 9, colours.ink, colours.paper);
    }
  }

  /** Beside its place, for at an event the edge that goes and the one that comes lie on one another. */
  private gone(gone: Edge[], colours: Colours): void {
    const c = this.context;
    const { px, py } = this.at;
    c.beginPath();
    for (const [a, b] of gone) {
      const dx = px[b] - px[a];
      const dy = py[b] - py[a];
      const shift = 4.5 / (Math.hypot(dx, dy) || 1);
      const [ox, oy] = [-dy * shift, dx * shift];
      addSegment(c, px[a] + ox, py[a] + oy, px[b] + ox, py[b] + oy, this.camera);
    }
    c.strokeStyle = colours.paper;
    c.lineWidth = 4.5;
    c.stroke();
    c.setLineDash([7, 5]);
    c.strokeStyle = colours.gone;
    c.lineWidth = 2.2;
    c.stroke();
    c.setLineDash([]);
  }

  contact(frame: Frame, contact: ContactMarks, colours: Colours): void {
    const c = this.context;
    const [x, y] = this.camera.pixel(contact.point[0], contact.point[1]);
    const tip: [number, number] = [x + 34 * contact.normal[0], y - 34 * contact.normal[1]];
    for (const [colour, width] of [
      [colours.paper, 6],
      [colours.contact, 3],
    ] as [string, number][]) {
      c.strokeStyle = colour;
      c.lineWidth = width;
      c.beginPath();
      for (const feature of contact.features) this.edge(frame, feature.body, feature);
      c.moveTo(x + (tip[0] - x) * 0.26, y + (tip[1] - y) * 0.26);
      c.lineTo(tip[0], tip[1]);
      c.moveTo(x + 9, y);
      c.arc(x, y, 9, 0, 2 * Math.PI);
      c.stroke();
    }
    c.beginPath();
    c.arc(x, y, 2.5, 0, 2 * Math.PI);
    c.fillStyle = colours.contact;
    c.fill();
  }

  /** Over the marks of all contacts; of names that would lie on each other, the first one. */
  contactNames(contacts: ContactMarks[], colours: Colours): void {
    this.context.font = "600 13px system-ui, sans-serif";
    for (const { point, label } of contacts) {
      const [x, y] = this.camera.pixel(...point);
      this.beside(label, x, y + 18, colours);
    }
  }

  /** Adds an edge, or a segment of a curve, to the path. */
  private edge(frame: Frame, body: number, { part, ring, index }: Culprit): void {
    const c = this.context;
    const figure = frame.shapes[body].parts[part][ring];
    const pose = frame.poses[body];
    if (figure.curve) return addSegmentOf(c, figure, figure.curve[index % figure.corners], pose, this.camera);
    const [ax, ay] = this.camera.pixel(...placed(pose, ...figure.corner(index)));
    const [bx, by] = this.camera.pixel(...placed(pose, ...figure.corner((index + 1) % figure.size)));
    addSegment(c, ax, ay, bx, by, this.camera);
  }

  /** The points at which two bodies are closest, and their distance; with rings where they are too close to be told apart. */
  nearest({ points, label }: NearestMarks, colours: Colours): void {
    const c = this.context;
    const [[ax, ay], [bx, by]] = points.map((p) => this.camera.pixel(...p));
    const near = Math.hypot(ax - bx, ay - by) < 12;
    for (const [colour, width] of [
      [colours.paper, 6],
      [colours.nearest, 2.5],
    ] as [string, number][]) {
      c.strokeStyle = colour;
      c.lineWidth = width;
      c.beginPath();
      addSegment(c, ax, ay, bx, by, this.camera);
      for (const [x, y] of near ? [[(ax + bx) / 2, (ay + by) / 2]] : []) {
        c.moveTo(x + 13, y);
        c.arc(x, y, 13, 0, 2 * Math.PI);
      }
      c.stroke();
    }
    c.fillStyle = colours.nearest;
    c.strokeStyle = colours.paper;
    c.lineWidth = 1;
    for (const [x, y] of [
      [ax, ay],
      [bx, by],
    ]) {
      c.beginPath();
      c.arc(x, y, near ? 2 : 3.5, 0, 2 * Math.PI);
      c.fill();
      c.stroke();
    }
    c.font = "600 13px system-ui, sans-serif";
    const [x, y] = [Math.max(ax, bx), Math.max(ay, by)];
    const { width } = c.measureText(label);
    const right = x + 18 + width < this.camera.width - 4;
    this.text(
      label,
      right ? x + 18 : Math.max(4, Math.min(ax, bx) - 18 - width),
      y + 18,
      colours.nearest,
      colours.paper,
    );
  }

  /** In the colour of contacts, to the right of a pixel, or to the left where there is no room; not on another label. */
  beside(text: string, x: number, y: number, colours: Colours): void {
    const { width } = this.context.measureText(text);
    const right = x + 14 + width < this.camera.width - 4;
    const place = { x: right ? x + 14 : Math.max(4, x - 14 - width), y, width };
    if (this.labels.take(place)) this.text(text, place.x, y, colours.contact, colours.paper);
  }

  fault(frame: Frame, fault: FaultMarks, colours: Colours): void {
    const c = this.context;
    const pixel = ({ part, ring, index }: Culprit): [number, number] => {
      const figure = frame.shapes[fault.body].parts[part][ring];
      return this.camera.pixel(...placed(frame.poses[fault.body], ...figure.corner(index % figure.corners)));
    };
    c.strokeStyle = colours.fault;
    c.lineWidth = 4;
    c.beginPath();
    for (const edge of fault.edges) this.edge(frame, fault.body, edge);
    for (const vertex of fault.vertices) {
      const [x, y] = pixel(vertex);
      c.moveTo(x + 10, y);
      c.arc(x, y, 10, 0, 2 * Math.PI);
    }
    c.stroke();
  }

  names(frame: Frame, colours: Colours): void {
    const c = this.context;
    c.font = "600 13px system-ui, sans-serif";
    const outlines = [0, 1].map((b) =>
      [...frame.figures[b].outline(4 / this.camera.scale)].map((i) => pixelOf(this.camera, frame, b, i)),
    );
    const names = new Labels();
    for (const b of [0, 1]) {
      const width = c.measureText(frame.names[b]).width;
      const places = labelPlaces(outlines[b], width).map(([x, y]) => this.within(x, y, width));
      const free = (place: Label): boolean =>
        names.isFree(place) && !outlines.some((outline) => covers(outline, place));
      const besideOther = (place: Label): boolean => !covers(outlines[1 - b], place);
      const place = places.find(free) ?? places.find(besideOther) ?? places[0];
      names.take(place);
      this.text(frame.names[b], place.x, place.y, colours.bodyLine[b], colours.paper);
    }
  }

  /** Left of the buttons for the view, and above the scale. */
  private within(x: number, y: number, width: number): Label {
    return {
      x: Math.min(Math.max(x, 10), Math.max(10, this.camera.width - width - 58)),
      y: Math.min(Math.max(y, 20), this.camera.height - 40),
      width,
    };
  }

  scaleBar(colours: Colours): void {
    const c = this.context;
    const unit = 10 ** Math.floor(Math.log10(110 / this.camera.scale));
    const length = [5, 2, 1].map((k) => k * unit).find((l) => l * this.camera.scale <= 110) ?? unit;
    const pixels = length * this.camera.scale;
    const y = this.camera.height - 14;
    c.strokeStyle = colours.muted;
    c.lineWidth = 1.5;
    c.beginPath();
    c.moveTo(14, y - 4);
    c.lineTo(14, y);
    c.lineTo(14 + pixels, y);
    c.lineTo(14 + pixels, y - 4);
    c.stroke();
    c.font = "12px system-ui, sans-serif";
    this.text(String(Number(length.toPrecision(3))), 20, y - 5, colours.muted, colours.paper);
  }

  private text(text: string, x: number, y: number, colour: string, halo: string): void {
    const c = this.context;
    c.strokeStyle = halo;
    c.lineWidth = 3.5;
    c.strokeText(text, x, y);
    c.fillStyle = colour;
    c.fillText(text, x, y);
  }
}

/** Above, below, and beside an outline. */
function labelPlaces(outline: [number, number][], width: number): [number, number][] {
  const most = (of: (p: [number, number]) => number): [number, number] =>
    outline.reduce((best, p) => (of(p) > of(best) ? p : best));
  const top = most(([, y]) => -y);
  const bottom = most(([, y]) => y);
  const left = most(([x]) => -x);
  const right = most(([x]) => x);
  return [
    [top[0] - width / 2, top[1] - 9],
    [bottom[0] - width / 2, bottom[1] + ascent + 7],
    [left[0] - width - 9, left[1] + 4],
    [right[0] + 9, right[1] + 4],
  ];
}

/** Does the label lie on the outline, or on what it goes around? */
function covers(outline: [number, number][], { x, y, width }: Label): boolean {
  const inLabel = (u: number, v: number): boolean =>
    u > x - 3 && u < x + width + 3 && v > y - ascent && v < y + descent;
  const corners: [number, number][] = [
    [x, y - ascent],
    [x + width, y - ascent],
    [x, y + descent],
    [x + width, y + descent],
  ];
  const inside = corners.map(() => false);
  for (let i = 0, j = outline.length - 1; i < outline.length; j = i++) {
    const [ax, ay] = outline[i];
    const [bx, by] = outline[j];
    corners.forEach(([u, v], k) => {
      if (ay > v !== by > v && u < ax + ((v - ay) / (by - ay)) * (bx - ax)) inside[k] = !inside[k];
    });
    // Sides that cross a label this small pass its middle line or end in it, nearly always.
    const steps = Math.min(200, Math.ceil((Math.abs(bx - ax) + Math.abs(by - ay)) / 8));
    for (let k = 0; k <= steps; ++k)
      if (inLabel(ax + ((bx - ax) * k) / (steps || 1), ay + ((by - ay) * k) / (steps || 1))) return true;
  }
  return inside.some(Boolean);
}
