// A body's outline with a measure of how much each of its vertices matters, so that small pictures draw few of them.
import type { Pose } from "./engine";
import type { CurvedRing } from "./paths";

export class Figure {
  readonly x: Float64Array;
  readonly y: Float64Array;
  readonly diameter: number;
  readonly centre: [number, number];
  private readonly importance: Float64Array;
  private readonly levels = new Map<number, Int32Array>();

  /** Of an outline with curves, `polygon` is a sketch: `curve` is what is drawn. */
  constructor(
    polygon: [number, number][],
    readonly curve: CurvedRing | null = null,
  ) {
    this.x = Float64Array.from(polygon, (p) => p[0]);
    this.y = Float64Array.from(polygon, (p) => p[1]);
    const [lowX, highX] = range(this.x);
    const [lowY, highY] = range(this.y);
    this.diameter = Math.hypot(highX - lowX, highY - lowY);
    this.centre = [(lowX + highX) / 2, (lowY + highY) / 2];
    this.importance = importances(this.x, this.y);
  }

  get size(): number {
    return this.x.length;
  }

  /** What features name: vertices of a polygon, ends of segments of a curve. */
  get corners(): number {
    return this.curve?.length ?? this.size;
  }

  corner(i: number): [number, number] {
    return this.curve?.[i].from ?? [this.x[i], this.y[i]];
  }

  /** Vertices of an outline that differs from the true one by at most about `tolerance`. */
  outline(tolerance: number): Int32Array {
    const level = tolerance > 0 ? Math.floor(Math.log2(tolerance / this.diameter)) : -60;
    const key = Math.max(level, -60);
    let kept = this.levels.get(key);
    if (!kept) {
      const least = key === -60 ? -1 : this.diameter * 2 ** key;
      const indices: number[] = [];
      for (let i = 0; i < this.size; ++i) if (this.importance[i] > least) indices.push(i);
      kept = Int32Array.from(indices.length >= 3 ? indices : this.x.keys());
      this.levels.set(key, kept);
    }
    return kept;
  }
}

export function placed(pose: Pose, u: number, v: number): [number, number] {
  return [pose.x + pose.c * u - pose.s * v, pose.y + pose.s * u + pose.c * v];
}

/** The inverse of placed(). */
export function local(pose: Pose, x: number, y: number): [number, number] {
  const dx = x - pose.x;
  const dy = y - pose.y;
  return [pose.c * dx + pose.s * dy, pose.c * dy - pose.s * dx];
}

function range(values: Float64Array): [number, number] {
  let lo = Infinity;
  let hi = -Infinity;
  for (const value of values) {
    lo = Math.min(lo, value);
    hi = Math.max(hi, value);
  }
  return [lo, hi];
}

/** Douglas and Peucker's measure: the largest tolerance at which a vertex is kept. */
function importances(x: Float64Array, y: Float64Array): Float64Array {
  const n = x.length;
  const out = new Float64Array(n);
  let far = 0;
  for (let i = 1; i < n; ++i) {
    if (Math.hypot(x[i] - x[0], y[i] - y[0]) > Math.hypot(x[far] - x[0], y[far] - y[0])) far = i;
  }
  out[0] = out[far] = Infinity;
  const stack: [number, number, number][] = [
    [0, far, Infinity],
    [far, n, Infinity],
  ];
  while (stack.length > 0) {
    const [from, to, limit] = stack.pop()!;
    const end = to % n;
    const ex = x[end] - x[from];
    const ey = y[end] - y[from];
    const length = Math.hypot(ex, ey);
    let best = -1;
    let distance = -1;
    for (let i = from + 1; i < to; ++i) {
      const dx = x[i] - x[from];
      const dy = y[i] - y[from];
      const share = length > 0 ? Math.min(1, Math.max(0, (dx * ex + dy * ey) / (length * length))) : 0;
      const d = Math.hypot(dx - share * ex, dy - share * ey);
      if (d > distance) {
        distance = d;
        best = i;
      }
    }
    if (best < 0) continue;
    out[best] = Math.min(limit, distance);
    stack.push([from, best, out[best]], [best, to, out[best]]);
  }
  return out;
}
