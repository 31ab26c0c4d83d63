// The picture, drawn anew for every frame. Its cost is held down by leaving out what cannot be seen: outlines are
// simplified to a third of a pixel, tiling edges and faces come in falling size until they are too small or too many,
// and of lines that fall on the same pixels one is drawn.
import type { Camera } from "./camera";
import type { Figure } from "./figure";
import type { Frame, Layers, RegionMarks } from "./frame";
import { MapShape } from "./mapshape";
import { Marks, pixelOf, type VertexPixels } from "./marks";
import { addSegment, clipPolygon, farAway, SeenSegments } from "./pixels";
import type { Replay } from "./replay";
import { pairStyles, type Colours } from "./theme";
import { WorldPainter } from "./worlddrawing";

/** At full detail; see Painter.detail. */
const mostTilingEdges = 5000;
const mostFaceCorners = 14000;
const mostCorners = 1500;
const shades = 6;

/** A vertex of a ring of a part of a body. */
export interface Corner {
  body: number;
  part: number;
  ring: number;
  index: number;
}

export class Painter {
  private shape: MapShape | null = null;
  private shapeOf: { replay: Replay; version: number } | null = null;
  /** The share of small things that is drawn, from 0 to 1: less while frames are late. */
  detail = 1;
  private readonly seen = new SeenSegments();
  /** Of all vertices of the map, in the present frame. */
  private readonly at: VertexPixels = { px: new Float64Array(0), py: new Float64Array(0) };
  readonly marks: Marks;
  private readonly world: WorldPainter;
  /** Numbers of things drawn in the last frame. */
  readonly drawn = { vertices: 0, tilingEdges: 0, faceCorners: 0 };

  constructor(
    private readonly context: CanvasRenderingContext2D,
    private readonly camera: Camera,
  ) {
    this.marks = new Marks(context, camera, this.at);
    this.world = new WorldPainter(context, camera, this.marks);
  }

  draw(frame: Frame, layers: Layers, colours: Colours, ratio: number): void {
    const c = this.context;
    c.setTransform(ratio, 0, 0, ratio, 0, 0);
    c.fillStyle = colours.paper;
    c.fillRect(0, 0, this.camera.width, this.camera.height);
    c.lineJoin = "round";
    c.lineCap = "round";
    this.drawn.vertices = this.drawn.tilingEdges = this.drawn.faceCorners = 0;
    this.marks.labels.clear();
    if (frame.world) this.drawn.vertices = this.world.draw(frame, frame.world, layers, colours);
    else this.drawPair(frame, layers, colours);
    for (const contact of frame.contacts) this.marks.contact(frame, contact, colours);
    this.marks.contactNames(frame.contacts, colours);
    for (const fault of frame.faults) this.marks.fault(frame, fault, colours);
    this.marks.scaleBar(colours);
  }

  /** Over the bodies, which are seen through it. */
  region({ body, parts }: RegionMarks, frame: Frame, colours: Colours): void {
    const c = this.context;
    const path = new Path2D();
    for (const ring of parts.flat()) {
      ring.forEach((point, i) =>
        i === 0 ? path.moveTo(...this.camera.pixel(...point)) : path.lineTo(...this.camera.pixel(...point)),
      );
      path.closePath();
    }
    const styles = frame.world?.styles ?? pairStyles;
    c.save();
    c.fillStyle = c.strokeStyle = styles[Math.max(0, body) % styles.length][0];
    c.globalAlpha = 0.28;
    c.fill(path, "evenodd");
    c.globalAlpha = 1;
    c.strokeStyle = colours.worldLine || c.strokeStyle;
    c.lineWidth = 1.2;
    c.stroke(path);
    c.restore();
  }

  /** Two bodies and the tiling between them. */
  private drawPair(frame: Frame, layers: Layers, colours: Colours): void {
    const shape = layers.proof ? this.update(frame) : null;
    if (shape && layers.faces) this.drawFaces(shape, colours);
    for (const b of [0, 1]) this.drawBody(frame, b, layers, colours);
    if (shape) {
      if (layers.tiling) this.drawTiling(shape, colours);
      this.drawPq(shape, colours);
      if (layers.corners) this.drawCorners(shape, colours);
    }
    this.marks.names(frame, colours);
    if (shape && frame.event) this.marks.event(frame.event, colours);
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
    if (this.at.px.length !== n) {
      this.at.px = new Float64Array(n);
      this.at.py = new Float64Array(n);
    }
    const { px, py } = this.at;
    const placings = frame.poses.map((pose) => this.camera.placing(pose));
    for (let i = 0; i < n; ++i) {
      const body = replay.vertexBody[i];
      const figure = frame.figures[body];
      const u = figure.x[replay.vertexIndex[i]];
      const v = figure.y[replay.vertexIndex[i]];
      const { a, b, c, d, e, f } = placings[body];
      px[i] = e + a * u + b * v;
      py[i] = f + c * u + d * v;
    }
    return this.shape;
  }

  /** The vertex that was drawn nearest to a pixel, within `reach` of it. */
  nearestVertex(frame: Frame, x: number, y: number, reach: number): Corner | null {
    let best: Corner | null = null;
    let least = reach * reach;
    const look = (figure: Figure, body: number, part: number, ring: number): void => {
      const { a, b, c, d, e, f } = this.camera.placing(frame.poses[body]);
      for (let index = 0; index < figure.corners; ++index) {
        const [u, v] = figure.corner(index);
        const dx = e + a * u + b * v - x;
        const dy = f + c * u + d * v - y;
        const distance = dx * dx + dy * dy;
        if (distance >= least) continue;
        least = distance;
        best = { body, part, ring, index };
      }
    };
    frame.shapes.forEach(({ parts, heights }, body) => {
      parts.forEach((rings, p) => {
        if (!frame.hidden.hides(body, heights[p])) rings.forEach((figure, r) => look(figure, body, p, r));
      });
    });
    return best;
  }

  private drawBody(frame: Frame, body: number, layers: Layers, colours: Colours): void {
    const c = this.context;
    const figure = frame.figures[body];
    const kept = figure.outline(0.33 / this.camera.scale);
    this.drawn.vertices += kept.length;
    const large = figure.diameter * this.camera.scale > farAway;
    const outline = large || layers.vertices ? this.outlineOf(frame, body, kept) : [];
    c.beginPath();
    if (large) {
      clipPolygon(outline, this.camera.width, this.camera.height).forEach(([x, y], i) =>
        i === 0 ? c.moveTo(x, y) : c.lineTo(x, y),
      );
    } else {
      const place = this.camera.placing(frame.poses[body]);
      for (let n = 0; n < kept.length; ++n) {
        const u = figure.x[kept[n]];
        const v = figure.y[kept[n]];
        c.lineTo(place.e + place.a * u + place.b * v, place.f + place.c * u + place.d * v);
      }
    }
    c.closePath();
    c.fillStyle = colours.bodyFill[body];
    c.fill();
    c.strokeStyle = colours.worldLine || colours.bodyLine[body];
    c.lineWidth = kept.length > 1500 ? 0.8 : 1.3;
    c.stroke();
    if (layers.vertices && kept.length === figure.size) this.drawVertices(outline, colours.bodyLine[body]);
  }

  private outlineOf(frame: Frame, body: number, kept: Int32Array): [number, number][] {
    const outline: [number, number][] = [];
    for (const i of kept) outline.push(pixelOf(this.camera, frame, body, i));
    return outline;
  }

  private drawVertices(points: [number, number][], colour: string): void {
    const c = this.context;
    c.fillStyle = colour;
    for (const [x, y] of points) if (this.inWindow(x, y, 4)) c.fillRect(x - 1.75, y - 1.75, 3.5, 3.5);
  }

  private inWindow(x: number, y: number, margin: number): boolean {
    return x > -margin && y > -margin && x < this.camera.width + margin && y < this.camera.height + margin;
  }

  private outside(ax: number, ay: number, bx: number, by: number): boolean {
    const { width, height } = this.camera;
    return (ax < 0 && bx < 0) || (ay < 0 && by < 0) || (ax > width && bx > width) || (ay > height && by > height);
  }

  /** Adds a segment to the path, unless it is outside, or one between the same pixels is there. */
  private freshSegment(a: number, b: number): boolean {
    const { px, py } = this.at;
    if (this.outside(px[a], py[a], px[b], py[b]) || !this.seen.add(px[a], py[a], px[b], py[b])) return false;
    return addSegment(this.context, px[a], py[a], px[b], py[b], this.camera);
  }

  private drawTiling(shape: MapShape, colours: Colours): void {
    const c = this.context;
    const { px, py } = this.at;
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

  private facePath(shape: MapShape, face: number): void {
    const { px, py } = this.at;
    const from = shape.faceBegin[face];
    const to = shape.faceBegin[face + 1];
    let lowX = Infinity,
      lowY = Infinity,
      highX = -Infinity,
      highY = -Infinity;
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
      outline = clipPolygon(outline, this.camera.width, this.camera.height);
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
      c.fillStyle =
        i === 2 * shades ? colours.root : `rgba(${colours.faceTint[i < shades ? 0 : 1]},${strength.toFixed(2)})`;
      c.fill();
    });
  }

  /** Arcs at the corners whose certificates are active; smaller ones where there are many. */
  private drawCorners(shape: MapShape, colours: Colours): void {
    const c = this.context;
    const { px, py } = this.at;
    const count = shape.corners.length / 3;
    const largest = count > 600 ? 5 : 10;
    const least = count > 600 ? 2 : 0.8;
    const most = mostCorners * this.detail;
    let drawn = 0;
    for (const convex of [true, false]) {
      this.seen.clear();
      c.beginPath();
      for (let i = 0; i < shape.corners.length && drawn < most; i += 3) {
        const u = shape.corners[i],
          v = shape.corners[i + 1],
          w = shape.corners[i + 2];
        if (!this.inWindow(px[v], py[v], 12)) continue;
        const ux = px[u] - px[v],
          uy = py[u] - py[v],
          wx = px[w] - px[v],
          wy = py[w] - py[v];
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
}
