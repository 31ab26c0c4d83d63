// The picture, drawn anew for every frame. Its cost is held down by leaving out what cannot be seen: outlines are
// simplified to a third of a pixel, tiling edges and faces come in falling size until they are too small or too many,
// and of lines that fall on the same pixels one is drawn.
import type { Camera } from "./camera";
import type { Pose } from "./engine";
import { type Figure, placed } from "./figure";
import { MapShape } from "./mapshape";
import type { Edge, MapEvent, Replay } from "./replay";
import type { Colours } from "./theme";

export interface Layers {
  faces: boolean;
  tiling: boolean;
  corners: boolean;
  vertices: boolean;
}

export interface EventMarks {
  event: MapEvent;
  gone: Edge[];
  come: Edge[];
}

export interface ContactMarks {
  point: [number, number];
  normal: [number, number];
  edge: { body: number; index: number };
}

export interface FaultMarks {
  body: number;
  vertices: number[];
  edges: number[];
}

export interface Frame {
  figures: [Figure, Figure];
  names: [string, string];
  poses: [Pose, Pose];
  /** Null where there is no map: bodies that overlap, or a scene that is being edited. */
  replay: Replay | null;
  event: EventMarks | null;
  contact: ContactMarks | null;
  faults: FaultMarks[];
}

/** At full detail; see Painter.detail. */
const mostTilingEdges = 5000;
const mostFaceCorners = 14000;
const mostCorners = 1500;
const shades = 6;
/** Pixels beyond which coordinates are clipped here, because the canvas computes with 24 bits. */
const farAway = 20000;

export class Painter {
  private shape: MapShape | null = null;
  private shapeOf: { replay: Replay; version: number } | null = null;
  /** The share of small things that is drawn, from 0 to 1: less while frames are late. */
  detail = 1;
  private readonly seen = new SeenSegments();
  private px = new Float64Array(0);
  private py = new Float64Array(0);
  /** Numbers of things drawn in the last frame. */
  readonly drawn = { vertices: 0, tilingEdges: 0, faceCorners: 0 };

  constructor(
    private readonly context: CanvasRenderingContext2D,
    private readonly camera: Camera,
  ) {}

  draw(frame: Frame, layers: Layers, colours: Colours, ratio: number): void {
    const c = this.context;
    c.setTransform(ratio, 0, 0, ratio, 0, 0);
    c.fillStyle = colours.paper;
    c.fillRect(0, 0, this.camera.width, this.camera.height);
    c.lineJoin = "round";
    c.lineCap = "round";
    this.drawn.vertices = this.drawn.tilingEdges = this.drawn.faceCorners = 0;
    const shape = this.update(frame);
    if (shape && layers.faces) this.drawFaces(shape, colours);
    for (const b of [0, 1]) this.drawBody(frame, b, layers, colours);
    if (shape) {
      if (layers.tiling) this.drawTiling(shape, colours);
      this.drawPq(shape, colours);
      if (layers.corners) this.drawCorners(shape, colours);
    }
    this.drawNames(frame, colours);
    if (shape && frame.event) this.drawEvent(frame.event, colours);
    if (frame.contact) this.drawContact(frame, frame.contact, colours);
    for (const fault of frame.faults) this.drawFault(frame, fault, colours);
    this.drawScaleBar(colours);
  }

  /** The map's elements, and the pixels of all its vertices. */
  private update(frame: Frame): MapShape | null {
    const replay = frame.replay;
    if (!replay) return null;
    if (!this.shape || this.shapeOf?.replay !== replay || this.shapeOf.version !== replay.version) {
      this.shape = new MapShape(replay, frame.figures);
      this.shapeOf = { replay, version: replay.version };
    }
    const n = replay.vertexBody.length;
    if (this.px.length !== n) {
      this.px = new Float64Array(n);
      this.py = new Float64Array(n);
    }
    for (let i = 0; i < n; ++i) {
      const b = replay.vertexBody[i];
      const k = replay.vertexIndex[i];
      const [x, y] = this.pixelOf(frame, b, k);
      this.px[i] = x;
      this.py[i] = y;
    }
    return this.shape;
  }

  private pixelOf(frame: Frame, body: number, index: number): [number, number] {
    const f = frame.figures[body];
    const [x, y] = placed(frame.poses[body], f.x[index], f.y[index]);
    return this.camera.pixel(x, y);
  }

  private drawBody(frame: Frame, body: number, layers: Layers, colours: Colours): void {
    const c = this.context;
    const figure = frame.figures[body];
    const kept = figure.outline(0.33 / this.camera.scale);
    this.drawn.vertices += kept.length;
    let outline: [number, number][] = [];
    for (const i of kept) outline.push(this.pixelOf(frame, body, i));
    if (figure.diameter * this.camera.scale > farAway) outline = this.clip(outline);
    c.beginPath();
    outline.forEach(([x, y], i) => (i === 0 ? c.moveTo(x, y) : c.lineTo(x, y)));
    c.closePath();
    c.globalAlpha = 0.92;
    c.fillStyle = colours.bodyFill[body];
    c.fill();
    c.globalAlpha = 1;
    c.strokeStyle = colours.bodyLine[body];
    c.lineWidth = kept.length > 1500 ? 0.8 : 1.3;
    c.stroke();
    if (layers.vertices && kept.length === figure.size) this.drawVertices(outline, colours.bodyLine[body]);
  }

  private drawVertices(points: [number, number][], colour: string): void {
    const c = this.context;
    c.fillStyle = colour;
    for (const [x, y] of points) if (this.inWindow(x, y, 4)) c.fillRect(x - 1.75, y - 1.75, 3.5, 3.5);
  }

  private inWindow(x: number, y: number, margin: number): boolean {
    return x > -margin && y > -margin && x < this.camera.width + margin && y < this.camera.height + margin;
  }

  /** Sutherland and Hodgman: the part of a polygon in a box around the window. */
  private clip(points: [number, number][]): [number, number][] {
    const margin = 50;
    const sides: [number, number, number][] = [
      [1, 0, margin],
      [-1, 0, this.camera.width + margin],
      [0, 1, margin],
      [0, -1, this.camera.height + margin],
    ];
    for (const [a, b, d] of sides) {
      const out: [number, number][] = [];
      let previous = points[points.length - 1];
      for (const point of points) {
        const before = previous ? a * previous[0] + b * previous[1] + d : 0;
        const here = a * point[0] + b * point[1] + d;
        if (before >= 0 !== here >= 0) {
          const t = before / (before - here);
          out.push([previous[0] + t * (point[0] - previous[0]), previous[1] + t * (point[1] - previous[1])]);
        }
        if (here >= 0) out.push(point);
        previous = point;
      }
      points = out;
    }
    return points;
  }

  private outside(ax: number, ay: number, bx: number, by: number): boolean {
    const { width, height } = this.camera;
    return (ax < 0 && bx < 0) || (ay < 0 && by < 0) || (ax > width && bx > width) || (ay > height && by > height);
  }

  /** Adds a segment to the path, cut to the surroundings of the window if it is very long. */
  private segment(a: number, b: number): boolean {
    let ax = this.px[a];
    let ay = this.py[a];
    let bx = this.px[b];
    let by = this.py[b];
    if (this.outside(ax, ay, bx, by)) return false;
    if (Math.abs(ax) + Math.abs(ay) + Math.abs(bx) + Math.abs(by) > farAway) {
      const cut = clipSegment(ax, ay, bx, by, -50, -50, this.camera.width + 50, this.camera.height + 50);
      if (!cut) return false;
      [ax, ay, bx, by] = cut;
    }
    this.context.moveTo(ax, ay);
    this.context.lineTo(bx, by);
    return true;
  }

  /** As segment(), but only the first one between two pixels. */
  private freshSegment(a: number, b: number): boolean {
    const { px, py } = this;
    if (this.outside(px[a], py[a], px[b], py[b]) || !this.seen.add(px[a], py[a], px[b], py[b])) return false;
    return this.segment(a, b);
  }

  private drawTiling(shape: MapShape, colours: Colours): void {
    const c = this.context;
    const { px, py } = this;
    const most = mostTilingEdges * this.detail;
    const end = shape.endOf(shape.rigidOrder, 1.5 / this.camera.scale);
    let count = 0;
    this.seen.clear();
    c.beginPath();
    for (let i = 0; i < end && count < most; ++i) {
      const e = shape.rigidOrder.items[i];
      const a = shape.rigid[2 * e];
      const b = shape.rigid[2 * e + 1];
      const length = Math.abs(px[a] - px[b]) + Math.abs(py[a] - py[b]);
      if (length > 1.5 && this.freshSegment(a, b)) ++count;
    }
    this.drawn.tilingEdges = count;
    c.strokeStyle = colours.tiling;
    c.lineWidth = count > 1200 ? 0.5 : 0.8;
    c.stroke();
  }

  private drawPq(shape: MapShape, colours: Colours): void {
    const c = this.context;
    let count = 0;
    this.seen.clear();
    c.beginPath();
    for (let i = 0; i < shape.pq.length; i += 2) if (this.freshSegment(shape.pq[i], shape.pq[i + 1])) ++count;
    c.strokeStyle = colours.pq;
    c.lineWidth = count > 800 ? 1 : 2;
    c.stroke();
  }

  private drawLines(lines: Edge[], colour: string, width: number, dash: number[]): void {
    const c = this.context;
    c.beginPath();
    for (const [a, b] of lines) this.segment(a, b);
    c.strokeStyle = colour;
    c.lineWidth = width;
    c.setLineDash(dash);
    c.stroke();
    c.setLineDash([]);
  }

  private facePath(shape: MapShape, face: number): void {
    const { px, py } = this;
    const from = shape.faceBegin[face];
    const to = shape.faceBegin[face + 1];
    let lowX = Infinity, lowY = Infinity, highX = -Infinity, highY = -Infinity;
    for (let i = from; i < to; ++i) {
      const x = px[shape.boundary[i]];
      const y = py[shape.boundary[i]];
      if (x < lowX) lowX = x;
      if (x > highX) highX = x;
      if (y < lowY) lowY = y;
      if (y > highY) highY = y;
    }
    // What is thinner than half a pixel does not show.
    if (this.outside(lowX, lowY, highX, highY) || Math.min(highX - lowX, highY - lowY) < 0.5) return;
    const c = this.context;
    if (highX - lowX + highY - lowY > farAway) {
      let outline: [number, number][] = [];
      for (let i = from; i < to; ++i) outline.push([px[shape.boundary[i]], py[shape.boundary[i]]]);
      outline = this.clip(outline);
      outline.forEach(([x, y], i) => (i === 0 ? c.moveTo(x, y) : c.lineTo(x, y)));
      c.closePath();
      return;
    }
    // Corners close to the one before are left out.
    let lastX = px[shape.boundary[from]];
    let lastY = py[shape.boundary[from]];
    c.moveTo(lastX, lastY);
    for (let i = from + 1; i < to; ++i) {
      const x = px[shape.boundary[i]];
      const y = py[shape.boundary[i]];
      if (Math.abs(x - lastX) + Math.abs(y - lastY) < 0.7) continue;
      c.lineTo((lastX = x), (lastY = y));
      this.drawn.faceCorners++;
    }
    c.closePath();
  }

  private drawFaces(shape: MapShape, colours: Colours): void {
    const groups: number[][] = Array.from({ length: 2 * shades + 1 }, () => []);
    const end = shape.endOf(shape.faceOrder, 2 / this.camera.scale);
    const most = mostFaceCorners * this.detail;
    let corners = 0;
    for (let i = 0; i < end && corners < most; ++i) {
      const face = shape.faceOrder.items[i];
      const depth = shape.faceDepth[face];
      const shade = Math.floor((depth * (shades - 1)) / shape.deepest);
      groups[depth < 0 ? 2 * shades : shape.faceBody[face] * shades + shade].push(face);
      corners += shape.faceBegin[face + 1] - shape.faceBegin[face];
    }
    const c = this.context;
    groups.forEach((faces, i) => {
      if (faces.length === 0) return;
      c.beginPath();
      for (const face of faces) this.facePath(shape, face);
      const strength = 0.6 - (0.5 * (i % shades)) / (shades - 1);
      c.fillStyle = i === 2 * shades ? colours.root : `rgba(${colours.faceTint[i < shades ? 0 : 1]},${strength.toFixed(2)})`;
      c.fill();
    });
  }

  /** Arcs at the corners whose certificates are active; smaller ones where there are many. */
  private drawCorners(shape: MapShape, colours: Colours): void {
    const c = this.context;
    const { px, py } = this;
    const count = shape.corners.length / 3;
    const largest = count > 600 ? 5 : 10;
    const least = count > 600 ? 2 : 0.8;
    const most = mostCorners * this.detail;
    let drawn = 0;
    for (const convex of [true, false]) {
      this.seen.clear();
      c.beginPath();
      for (let i = 0; i < shape.corners.length && drawn < most; i += 3) {
        const u = shape.corners[i], v = shape.corners[i + 1], w = shape.corners[i + 2];
        if (!this.inWindow(px[v], py[v], 12)) continue;
        const ux = px[u] - px[v], uy = py[u] - py[v], wx = px[w] - px[v], wy = py[w] - py[v];
        // On the screen y points down: a left turn in the world has a negative cross product here.
        if (ux * wy - uy * wx > 0 !== convex) continue;
        const radius = Math.min(largest, 0.35 * Math.sqrt(Math.min(ux * ux + uy * uy, wx * wx + wy * wy)));
        if (radius < least || (count > 600 && !this.seen.add(px[v] / 3, py[v] / 3, 0, 0))) continue;
        const from = Math.atan2(wy, wx);
        c.moveTo(px[v] + radius * Math.cos(from), py[v] + radius * Math.sin(from));
        c.arc(px[v], py[v], radius, from, Math.atan2(uy, ux), true);
        ++drawn;
      }
      c.strokeStyle = convex ? colours.convex : colours.reflex;
      c.lineWidth = count > 600 ? 1 : 1.4;
      c.stroke();
    }
  }

  private drawEvent(marks: EventMarks, colours: Colours): void {
    const c = this.context;
    const { px, py } = this;
    const [u, v, w] = marks.event.corner;
    this.drawLines([[u, v], [v, w]], colours.failing, 14, []);
    this.drawLines(marks.come, colours.paper, 6, []);
    this.drawLines(marks.come, colours.come, 3.2, []);
    this.drawGone(marks.gone, colours);
    const dots: [number, string, number][] = [[u, "u", 4], [v, "v", 6], [w, "w", 4]];
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
  private drawGone(gone: Edge[], colours: Colours): void {
    const c = this.context;
    const { width, height } = this.camera;
    c.beginPath();
    for (const [a, b] of gone) {
      const dx = this.px[b] - this.px[a];
      const dy = this.py[b] - this.py[a];
      const shift = 4.5 / (Math.hypot(dx, dy) || 1);
      const [ox, oy] = [-dy * shift, dx * shift];
      const cut = clipSegment(this.px[a] + ox, this.py[a] + oy, this.px[b] + ox, this.py[b] + oy, -50, -50, width + 50, height + 50);
      if (!cut) continue;
      c.moveTo(cut[0], cut[1]);
      c.lineTo(cut[2], cut[3]);
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

  private drawContact(frame: Frame, contact: ContactMarks, colours: Colours): void {
    const c = this.context;
    const size = frame.figures[contact.edge.body].size;
    const [ax, ay] = this.pixelOf(frame, contact.edge.body, contact.edge.index);
    const [bx, by] = this.pixelOf(frame, contact.edge.body, (contact.edge.index + 1) % size);
    const [x, y] = this.camera.pixel(contact.point[0], contact.point[1]);
    const tip: [number, number] = [x + 34 * contact.normal[0], y - 34 * contact.normal[1]];
    for (const [colour, width] of [[colours.paper, 6], [colours.contact, 3]] as [string, number][]) {
      c.strokeStyle = colour;
      c.lineWidth = width;
      c.beginPath();
      const cut = clipSegment(ax, ay, bx, by, -50, -50, this.camera.width + 50, this.camera.height + 50);
      if (cut) {
        c.moveTo(cut[0], cut[1]);
        c.lineTo(cut[2], cut[3]);
      }
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
    c.font = "600 13px system-ui, sans-serif";
    this.text("contact", x + 14, y + 18, colours.contact, colours.paper);
  }

  private drawFault(frame: Frame, fault: FaultMarks, colours: Colours): void {
    const c = this.context;
    const figure = frame.figures[fault.body];
    const wrap = (i: number) => ((i % figure.size) + figure.size) % figure.size;
    c.strokeStyle = colours.fault;
    c.lineWidth = 4;
    c.beginPath();
    for (const j of fault.edges) {
      c.moveTo(...this.pixelOf(frame, fault.body, wrap(j)));
      c.lineTo(...this.pixelOf(frame, fault.body, wrap(j + 1)));
    }
    for (const i of fault.vertices) {
      const [x, y] = this.pixelOf(frame, fault.body, wrap(i));
      c.moveTo(x + 10, y);
      c.arc(x, y, 10, 0, 2 * Math.PI);
    }
    c.stroke();
  }

  private drawNames(frame: Frame, colours: Colours): void {
    const c = this.context;
    c.font = "600 13px system-ui, sans-serif";
    let first: { x: number; y: number; width: number } | null = null;
    for (const b of [0, 1]) {
      let top: [number, number] = [0, Infinity];
      for (const i of frame.figures[b].outline(4 / this.camera.scale)) {
        const p = this.pixelOf(frame, b, i);
        if (p[1] < top[1]) top = p;
      }
      const width = c.measureText(frame.names[b]).width;
      const x = Math.min(Math.max(top[0] - width / 2, 10), Math.max(10, this.camera.width - width - 58));
      let y = Math.min(Math.max(top[1] - 9, 20 + 18 * b), this.camera.height - 40 - 18 * b);
      const meets = first && x < first.x + first.width + 8 && x + width + 8 > first.x && Math.abs(y - first.y) < 18;
      if (first && meets) y = first.y > 38 ? first.y - 18 : first.y + 18;
      first ??= { x, y, width };
      this.text(frame.names[b], x, y, colours.bodyLine[b], colours.paper);
    }
  }

  private drawScaleBar(colours: Colours): void {
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

/** Remembers segments by the pixels of their ends. It may forget one, which is then drawn twice. */
class SeenSegments {
  private readonly keys = new Float64Array(1 << 14);

  clear(): void {
    this.keys.fill(-1);
  }

  /** False if it is there already. */
  add(ax: number, ay: number, bx: number, by: number): boolean {
    const a = (Math.round(ax) & 0xfff) * 0x1000 + (Math.round(ay) & 0xfff);
    const b = (Math.round(bx) & 0xfff) * 0x1000 + (Math.round(by) & 0xfff);
    const key = Math.min(a, b) * 0x1000000 + Math.max(a, b);
    const slot = (Math.imul(a, 0x9e3779b1) ^ Math.imul(b, 0x85ebca6b)) >>> 18;
    const place = (slot ^ ((Math.imul(b, 0x9e3779b1) ^ Math.imul(a, 0x85ebca6b)) >>> 18)) & 0x3fff;
    if (this.keys[place] === key) return false;
    this.keys[place] = key;
    return true;
  }
}

/** Liang and Barsky: the part of a segment inside a box. */
export function clipSegment(
  ax: number, ay: number, bx: number, by: number,
  lowX: number, lowY: number, highX: number, highY: number,
): [number, number, number, number] | null {
  let from = 0;
  let to = 1;
  const dx = bx - ax;
  const dy = by - ay;
  for (const [p, q] of [[-dx, ax - lowX], [dx, highX - ax], [-dy, ay - lowY], [dy, highY - ay]]) {
    if (p === 0) {
      if (q < 0) return null;
    } else if (p < 0) from = Math.max(from, q / p);
    else to = Math.min(to, q / p);
  }
  if (from > to) return null;
  return [ax + from * dx, ay + from * dy, ax + to * dx, ay + to * dy];
}
