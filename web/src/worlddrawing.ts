// Bodies of a world, each in a colour and with a number of its own. Holes are open, and parts that overlap are one.
import type { Camera } from "./camera";
import { addRing } from "./curvedrawing";
import type { Band, Pose, WorldStyles } from "./engine";
import type { Frame, Layers } from "./frame";
import { sheetsOf, type Sheet } from "./heights";
import { Labels } from "./labels";
import type { Marks } from "./marks";
import { clipPolygon, farAway, type Pixel } from "./pixels";
import { placed, type Figure } from "./figure";
import type { Shape } from "./shapes";
import type { Colours } from "./theme";

/** From so far on, in pixels, a number does not touch the boundary of its body. */
const roomForNumber = 8;
/** With more bodies, numbers are also drawn where another body lies over them: to look at each pair takes too long. */
const mostLookedThrough = 100;
/** Half the length of the rails of a slide, and how far they are from its middle, in pixels. */
const railHalf = 12;
const railGap = 8;
/** Bands that are thinner everywhere, in pixels, are not seen. */
const leastBand = 0.7;

export class WorldPainter {
  private readonly numbers = new Labels();
  private sorted: { shapes: Shape[]; order: number[]; sheets: Sheet[] } | null = null;

  constructor(
    private readonly context: CanvasRenderingContext2D,
    private readonly camera: Camera,
    private readonly marks: Marks,
  ) {}

  /** How many vertices were drawn. */
  draw(frame: Frame, world: WorldStyles, layers: Layers, colours: Colours): number {
    const shown = this.sheets(frame, world).filter(({ body, z }) => !frame.hidden.hides(body, z));
    let vertices = 0;
    if (layers.proof && layers.tiling && frame.tilings && !frame.hidden.any) this.tilings(frame.tilings(), colours);
    const painted = shown.map((sheet) => {
      const paths = sheet.parts.map((part) => this.partPath(frame, sheet.body, frame.shapes[sheet.body].parts[part]));
      vertices += this.sheet(frame, sheet, paths, world, layers, colours);
      return paths;
    });
    this.numbers.clear();
    const above = (k: number): Path2D[] => (shown.length > mostLookedThrough ? [] : painted.slice(k + 1).flat());
    shown.forEach((sheet, k) => this.number(frame, sheet, world, above(k)));
    const seen = new Set(shown.map(({ body }) => body));
    for (const joint of world.joints) if (seen.has(joint[0])) this.joint(frame, joint, colours);
    for (const pair of frame.overlaps) this.overlap(frame, pair, colours);
    return vertices;
  }

  /** Those that are painted first come first. */
  private sheets({ shapes }: Frame, { order }: WorldStyles): Sheet[] {
    if (this.sorted?.shapes !== shapes || this.sorted.order !== order) {
      const known = order.filter((b) => b < shapes.length);
      this.sorted = { shapes, order, sheets: sheetsOf(shapes, known) };
    }
    return this.sorted.sheets;
  }

  /** Below the bodies: each line lies between those of its pair. */
  private tilings(lines: number[], colours: Colours): void {
    const c = this.context;
    c.lineWidth = 1;
    for (const joins of [0, 1]) {
      c.strokeStyle = joins ? colours.pq : colours.tiling;
      c.beginPath();
      for (let i = 0; i < lines.length; i += 5) {
        if (lines[i + 4] !== joins) continue;
        c.moveTo(...this.camera.pixel(lines[i], lines[i + 1]));
        c.lineTo(...this.camera.pixel(lines[i + 2], lines[i + 3]));
      }
      c.stroke();
    }
  }

  private sheet(
    frame: Frame,
    sheet: Sheet,
    paths: Path2D[],
    world: WorldStyles,
    layers: Layers,
    colours: Colours,
  ): number {
    const c = this.context;
    const { body } = sheet;
    const parts = sheet.parts.map((part) => frame.shapes[body].parts[part]);
    const [fill, line] = world.styles[body % world.styles.length];
    c.fillStyle = fill;
    c.strokeStyle = colours.worldLine || line;
    // Half of the line is covered again where several parts are filled.
    c.lineWidth = parts.length > 1 ? 2.2 : 1.3;
    for (const path of paths) c.stroke(path);
    for (const path of paths) c.fill(path, "evenodd");
    if (parts.length === 1) c.stroke(paths[0]);
    const bands = world.bands?.[body];
    if (layers.bands && bands)
      this.bands(
        frame,
        body,
        sheet.parts.flatMap((part) => bands[part] ?? []),
        colours,
      );
    if (layers.vertices) this.vertices(frame, body, parts.flat(), colours.worldLine || line);
    return parts.reduce((sum, rings) => sum + rings.reduce((n, figure) => n + figure.size, 0), 0);
  }

  private partPath(frame: Frame, body: number, rings: Figure[]): Path2D {
    const path = new Path2D();
    for (const figure of rings) {
      if (figure.curve) {
        addRing(path, figure, figure.curve, frame.poses[body], this.camera);
        continue;
      }
      let points: [number, number][] = [];
      for (const i of figure.outline(0.33 / this.camera.scale)) {
        points.push(this.camera.pixel(...placed(frame.poses[body], figure.x[i], figure.y[i])));
      }
      if (figure.diameter * this.camera.scale > farAway)
        points = clipPolygon(points, this.camera.width, this.camera.height);
      points.forEach(([x, y], i) => (i === 0 ? path.moveTo(x, y) : path.lineTo(x, y)));
      path.closePath();
    }
    return path;
  }

  /** What lies between the walls, where that can be seen. */
  private bands(frame: Frame, body: number, bands: Band[], colours: Colours): void {
    const c = this.context;
    for (const [width, ...walls] of bands) {
      if (width * this.camera.scale < leastBand) continue;
      const path = new Path2D();
      for (const wall of walls) this.addWall(path, frame.poses[body], wall);
      c.fillStyle = colours.band;
      c.fill(path, "evenodd");
      c.strokeStyle = colours.bandLine;
      c.lineWidth = 1;
      c.stroke(path);
    }
  }

  private addWall(path: Path2D, pose: Pose, wall: number[]): void {
    const points: Pixel[] = [];
    for (let i = 0; i < wall.length; i += 2) points.push(this.camera.pixel(...placed(pose, wall[i], wall[i + 1])));
    const seen = clipPolygon(points, this.camera.width, this.camera.height);
    seen.forEach(([x, y], i) => (i === 0 ? path.moveTo(x, y) : path.lineTo(x, y)));
    path.closePath();
  }

  private vertices(frame: Frame, body: number, figures: Figure[], colour: string): void {
    const c = this.context;
    c.fillStyle = colour;
    for (const figure of figures) {
      for (let i = 0; i < figure.corners; ++i) {
        const [x, y] = this.camera.pixel(...placed(frame.poses[body], ...figure.corner(i)));
        c.fillRect(x - 1.75, y - 1.75, 3.5, 3.5);
      }
    }
  }

  /** Of what lies over the body: a number below it would be read as its own. */
  private covers(paths: Path2D[], x: number, y: number): boolean {
    const c = this.context;
    const { a } = c.getTransform();
    return paths.some((path) => c.isPointInPath(path, x * a, y * a, "evenodd"));
  }

  private number(frame: Frame, { body, parts }: Sheet, world: WorldStyles, above: Path2D[]): void {
    const [u, v, room, part] = world.inner[body] ?? [0, 0, 0, 0];
    if (room * this.camera.scale < roomForNumber || !parts.includes(part)) return;
    const c = this.context;
    const [x, y] = this.camera.pixel(...placed(frame.poses[body], u, v));
    if (this.covers(above, x, y)) return;
    c.font = "600 11px system-ui, sans-serif";
    const text = String(body + 1);
    const { width } = c.measureText(text);
    if (!this.numbers.take({ x: x - width / 2, y: y + 4, width }, 11)) return;
    c.fillStyle = world.styles[body % world.styles.length][2];
    c.fillText(text, x - width / 2, y + 4);
  }

  /** A ring where links turn; a pair of rails, beside the number, where they slide. */
  private joint(frame: Frame, [body, at, along]: WorldStyles["joints"][number], colours: Colours): void {
    const pose = frame.poses[body];
    if (!pose) return;
    const [x, y] = this.camera.pixel(...placed(pose, ...at));
    const path = new Path2D();
    if (!along) path.arc(x, y, 4, 0, 2 * Math.PI);
    else {
      const [dx, dy] = [pose.c * along[0] - pose.s * along[1], -(pose.s * along[0] + pose.c * along[1])];
      for (const side of [-railGap, railGap]) {
        path.moveTo(x - side * dy - railHalf * dx, y + side * dx - railHalf * dy);
        path.lineTo(x - side * dy + railHalf * dx, y + side * dx + railHalf * dy);
      }
    }
    const c = this.context;
    c.fillStyle = c.strokeStyle = colours.paper;
    c.lineWidth = 4;
    if (along) c.stroke(path);
    else c.fill(path);
    c.strokeStyle = colours.ink;
    c.lineWidth = 1.8;
    c.stroke(path);
  }

  private overlap(frame: Frame, pair: [number, number], colours: Colours): void {
    const c = this.context;
    for (const body of pair) {
      for (const rings of frame.shapes[body].parts) {
        const path = this.partPath(frame, body, rings);
        c.strokeStyle = colours.paper;
        c.lineWidth = 5;
        c.stroke(path);
        c.strokeStyle = colours.contact;
        c.lineWidth = 2.5;
        c.stroke(path);
      }
    }
    const small = frame.shapes[pair[0]].outline.diameter < frame.shapes[pair[1]].outline.diameter ? pair[0] : pair[1];
    const [x, y] = this.camera.pixel(...placed(frame.poses[small], ...frame.shapes[small].outline.centre));
    c.font = "600 13px system-ui, sans-serif";
    const names = pair.map((b) => frame.names[b]).join(" x ");
    this.marks.beside(`overlap: ${names}`, x, y - 12, colours);
  }
}
