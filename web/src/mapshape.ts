// What there is to draw of a map, in flat arrays, sorted so that large things come first. Made anew when the map
// changes; all positions are looked up when drawing.
import type { Figure } from "./figure";
import { faceBody, faceDepth, faceKind, FaceKind, type Replay } from "./replay";

/** Size classes are powers of two: class k holds what is larger than diameter / 2^(k + 1). */
const classes = 48;

/** Things by number in order of falling size class. */
class Order {
  readonly items: Int32Array;
  /** Where each class begins, and the end. */
  readonly begin = new Int32Array(classes + 1);

  constructor(classOf: Uint8Array, count: number) {
    for (let i = 0; i < count; ++i) this.begin[classOf[i] + 1]++;
    for (let k = 0; k < classes; ++k) this.begin[k + 1] += this.begin[k];
    const at = this.begin.slice();
    this.items = new Int32Array(count);
    for (let i = 0; i < count; ++i) this.items[at[classOf[i]]++] = i;
  }
}

export class MapShape {
  /** Tiling edges within one body: two vertices each. */
  readonly rigid: Int32Array;
  readonly rigidOrder: Order;
  /** Edges between the bodies: two vertices each. */
  readonly pq: Int32Array;
  /** Active corners: u, v, w each. */
  readonly corners: Int32Array;
  /** Boundaries of all faces, one after the other. */
  readonly boundary: Int32Array;
  readonly faceBegin: Int32Array;
  readonly faceBody: Uint8Array;
  /** -1: the root's face; else the depth in the tree. */
  readonly faceDepth: Int8Array;
  /** Faces between the bodies, whose size changes with time, are in the first class. */
  readonly faceOrder: Order;
  readonly faceCount: number;
  deepest = 1;
  private readonly scale: number;

  constructor(
    private readonly replay: Replay,
    private readonly figures: Figure[],
  ) {
    this.scale = Math.max(figures[0].diameter, figures[1].diameter);
    const { slots, origin, next, face, vertexBody } = replay;
    const rigid = new Int32Array(slots);
    const rigidClass = new Uint8Array(slots);
    const pq: number[] = [];
    let count = 0;
    for (let h = 2 * vertexBody.length; h < slots; h += 2) {
      const a = origin[h];
      if (a < 0) continue;
      const b = origin[h + 1];
      if (vertexBody[a] !== vertexBody[b]) {
        pq.push(a, b);
        continue;
      }
      rigid[2 * count] = a;
      rigid[2 * count + 1] = b;
      rigidClass[count++] = this.classOf(this.distance(a, b));
    }
    this.rigid = rigid;
    this.rigidOrder = new Order(rigidClass, count);
    this.pq = Int32Array.from(pq);
    this.corners = findCorners(replay);

    this.boundary = new Int32Array(slots);
    this.faceBegin = new Int32Array(slots + 1);
    this.faceBody = new Uint8Array(slots);
    this.faceDepth = new Int8Array(slots);
    const faceClass = new Uint8Array(slots);
    const seen = new Uint8Array(slots);
    let faces = 0;
    let end = 0;
    for (let start = 0; start < slots; ++start) {
      if (seen[start] || origin[start] < 0) continue;
      const kind = faceKind(face[start]);
      if (kind === FaceKind.interior || kind === FaceKind.infinite) continue;
      const first = origin[start];
      let mixed = false;
      let extent = 0;
      let h = start;
      this.faceBegin[faces] = end;
      do {
        seen[h] = 1;
        const v = origin[h];
        this.boundary[end++] = v;
        if (vertexBody[v] !== vertexBody[first]) mixed = true;
        else if (!mixed) extent = Math.max(extent, this.distance(first, v));
        h = next[h];
      } while (h !== start);
      const depth = kind === FaceKind.root ? -1 : faceDepth(face[start]);
      this.deepest = Math.max(this.deepest, depth);
      this.faceBody[faces] = faceBody(face[start]);
      this.faceDepth[faces] = depth;
      faceClass[faces++] = mixed ? 0 : this.classOf(extent);
    }
    this.faceBegin[faces] = end;
    this.faceCount = faces;
    this.faceOrder = new Order(faceClass, faces);
  }

  /** The end of the things in `order` that may be as large as `least`. */
  endOf(order: Order, least: number): number {
    return order.begin[Math.min(classes - 1, this.classOf(least)) + 1];
  }

  private classOf(size: number): number {
    if (!(size > 0)) return classes - 1;
    return Math.min(classes - 1, Math.max(1, Math.ceil(-Math.log2(size / this.scale))));
  }

  private distance(a: number, b: number): number {
    const { vertexBody, vertexIndex } = this.replay;
    const figure = this.figures[vertexBody[a]];
    const dx = figure.x[vertexIndex[a]] - figure.x[vertexIndex[b]];
    const dy = figure.y[vertexIndex[a]] - figure.y[vertexIndex[b]];
    return Math.sqrt(dx * dx + dy * dy);
  }
}

function findCorners({ slots, origin, next, face, vertexBody }: Replay): Int32Array {
  const corners: number[] = [];
  for (let h = 0; h < slots; ++h) {
    const u = origin[h];
    if (u < 0) continue;
    const v = origin[h ^ 1];
    const w = origin[next[h] ^ 1];
    if (vertexBody[u] === vertexBody[v] && vertexBody[v] === vertexBody[w]) continue;
    if (u !== w && faceKind(face[h]) !== FaceKind.interior) corners.push(u, v, w);
  }
  return Int32Array.from(corners);
}
