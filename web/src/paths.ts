// Outlines with curves: the data of SVG paths as the library writes it, capitals M L A Q C Z only, y upwards.

export type Point = [number, number];

interface Line {
  kind: "line";
  from: Point;
  to: Point;
}
/** centre + rotated (rx cos t, ry sin t) for t from `start` to `start + sweep`. */
export interface Arc {
  kind: "arc";
  from: Point;
  to: Point;
  centre: Point;
  rx: number;
  ry: number;
  rotation: number;
  start: number;
  sweep: number;
}
export interface Bezier {
  kind: "bezier";
  /** All control points, three or four of them, the ends included. */
  points: Point[];
  from: Point;
  to: Point;
}
export type Segment = Line | Arc | Bezier;
/** A closed curve: each segment begins where the one before ends. */
export type CurvedRing = Segment[];

const numbersOf: Record<string, number> = { M: 2, L: 2, Q: 4, C: 6, A: 7, Z: 0 };

/** The rings of a path, each closed by a line where it needs one. */
export function ringsOfPath(path: string): CurvedRing[] {
  const rings: CurvedRing[] = [];
  let at: Point = [0, 0];
  for (const [, letter, text] of path.matchAll(/([A-Za-z])([^A-Za-z]*(?:[eE][-+]?\d[^A-Za-z]*)*)/g)) {
    const n = (text.match(/[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?/g) ?? []).map(Number);
    if (n.length !== numbersOf[letter])
      throw new RangeError(`a path as the library writes it has no "${letter}${text}"`);
    const to = n.slice(-2) as Point;
    if (letter === "M") rings.push([]);
    const ring = rings[rings.length - 1];
    if (letter === "L") ring.push({ kind: "line", from: at, to });
    else if (letter === "A") ring.push(arcOf(at, n, to));
    else if (letter === "Q" || letter === "C") ring.push({ kind: "bezier", from: at, to, points: [at, ...pairs(n)] });
    if (letter !== "Z") at = to;
    else if (ring.length > 0 && (ring[0].from[0] !== at[0] || ring[0].from[1] !== at[1]))
      ring.push({ kind: "line", from: at, to: ring[0].from });
  }
  return rings;
}

const pairs = (n: number[]): Point[] => n.flatMap((x, i) => (i % 2 === 0 ? [[x, n[i + 1]] as Point] : []));

/** Appendix B.2.4 of SVG 2: from ends to centre. */
function arcOf(from: Point, [rx0, ry0, degrees, large, sweepFlag]: number[], to: Point): Arc {
  const rotation = (degrees * Math.PI) / 180;
  const [c, s] = [Math.cos(rotation), Math.sin(rotation)];
  const [hx, hy] = [(from[0] - to[0]) / 2, (from[1] - to[1]) / 2];
  const [ux, uy] = [c * hx + s * hy, c * hy - s * hx];
  const grow = Math.max(1, Math.hypot(ux / rx0, uy / ry0));
  const [rx, ry] = [rx0 * grow, ry0 * grow];
  const q = (ux / rx) ** 2 + (uy / ry) ** 2;
  const k = Math.sqrt(Math.max(0, (1 - q) / q)) * (large === sweepFlag ? -1 : 1);
  const [vx, vy] = [(k * rx * uy) / ry, (-k * ry * ux) / rx];
  const centre: Point = [c * vx - s * vy + (from[0] + to[0]) / 2, s * vx + c * vy + (from[1] + to[1]) / 2];
  const start = Math.atan2((uy - vy) / ry, (ux - vx) / rx);
  let sweep = Math.atan2((-uy - vy) / ry, (-ux - vx) / rx) - start;
  if (sweepFlag === 1 && sweep <= 0) sweep += 2 * Math.PI;
  if (sweepFlag === 0 && sweep >= 0) sweep -= 2 * Math.PI;
  return { kind: "arc", from, to, centre, rx, ry, rotation, start, sweep };
}

/** The point at a share of the parameter: of Bezier curves their own, of arcs the angle. */
export function pointAt(segment: Segment, share: number): Point {
  const { from, to } = segment;
  if (share <= 0) return from;
  if (share >= 1) return to;
  if (segment.kind === "arc") {
    const { centre, rx, ry, rotation, start, sweep } = segment;
    const [x, y] = [rx * Math.cos(start + share * sweep), ry * Math.sin(start + share * sweep)];
    const [c, s] = [Math.cos(rotation), Math.sin(rotation)];
    return [centre[0] + c * x - s * y, centre[1] + s * x + c * y];
  }
  let points = segment.kind === "line" ? [from, to] : segment.points;
  while (points.length > 1)
    points = points.slice(1).map(([x, y], i) => {
      const [px, py] = points[i];
      return [px + share * (x - px), py + share * (y - py)];
    });
  return points[0];
}

/** A bound of the second derivative by the parameter: how far from its chord a stretch of length h is, times 8 / h². */
export function bendOf(segment: Segment): number {
  if (segment.kind === "line") return 0;
  if (segment.kind === "arc") return Math.max(segment.rx, segment.ry) * segment.sweep ** 2;
  const p = segment.points;
  const second = p
    .slice(2)
    .map((_, i) => Math.hypot(p[i][0] - 2 * p[i + 1][0] + p[i + 2][0], p[i][1] - 2 * p[i + 1][1] + p[i + 2][1]));
  return (p.length - 1) * (p.length - 2) * Math.max(...second);
}

const sketches = new Map<string, Point[][]>();

/** The rings of a path as polygons, near enough for measuring and for finding what lies below the pointer. */
export function sketched(path: string): Point[][] {
  let rings = sketches.get(path);
  if (!rings) {
    if (sketches.size > 1000) sketches.clear();
    rings = ringsOfPath(path).map((ring) => ring.flatMap(sketchedSegment));
    sketches.set(path, rings);
  }
  return rings;
}

function sketchedSegment(segment: Segment): Point[] {
  const steps = segment.kind === "line" ? 1 : segment.kind === "arc" ? 2 + Math.ceil(8 * Math.abs(segment.sweep)) : 16;
  return Array.from({ length: steps }, (_, k) => pointAt(segment, k / steps));
}
