// Lines and outlines in pixels, cut to the window: canvases compute with 24 bits.

export type Pixel = [number, number];

/** Where it is worth the while to cut. */
export const farAway = 20000;
/** How far beyond the window things are cut, so that the cut does not show. */
const margin = 50;

/** Sutherland and Hodgman: the part of a polygon in a window, with some room around it. */
export function clipPolygon(points: Pixel[], width: number, height: number): Pixel[] {
  const sides: [number, number, number][] = [
    [1, 0, margin],
    [-1, 0, width + margin],
    [0, 1, margin],
    [0, -1, height + margin],
  ];
  for (const [a, b, d] of sides) {
    const out: Pixel[] = [];
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

/** Remembers segments by the pixels of their ends. It may forget one, which is then drawn twice. */
export class SeenSegments {
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

/** Liang and Barsky: the part of a segment in a window, with some room around it. */
function clipSegment(
  ax: number,
  ay: number,
  bx: number,
  by: number,
  width: number,
  height: number,
): [number, number, number, number] | null {
  let from = 0;
  let to = 1;
  const dx = bx - ax;
  const dy = by - ay;
  const sides = [
    [-dx, ax + margin],
    [dx, width + margin - ax],
    [-dy, ay + margin],
    [dy, height + margin - ay],
  ];
  for (const [p, q] of sides) {
    if (p === 0) {
      if (q < 0) return null;
    } else if (p < 0) {
      from = Math.max(from, q / p);
    } else {
      to = Math.min(to, q / p);
    }
  }
  if (from > to) return null;
  return [ax + from * dx, ay + from * dy, ax + to * dx, ay + to * dy];
}

/** Adds what can be seen of a segment to the path; false if that is nothing. */
export function addSegment(
  c: CanvasPath,
  ax: number,
  ay: number,
  bx: number,
  by: number,
  size: { width: number; height: number },
): boolean {
  if (Math.abs(ax) + Math.abs(ay) + Math.abs(bx) + Math.abs(by) > farAway) {
    const cut = clipSegment(ax, ay, bx, by, size.width, size.height);
    if (!cut) return false;
    [ax, ay, bx, by] = cut;
  }
  c.moveTo(ax, ay);
  c.lineTo(bx, by);
  return true;
}
