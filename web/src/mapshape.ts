// What there is to draw of a map, sorted so that the large things come first. Made anew when the map changes; all
// positions are looked up when drawing.
import type { Figure } from "./figure";
import { faceBody, faceDepth, faceKind, FaceKind, type Replay } from "./replay";

/** Things in classes of falling size, each class a power of two. */
export class BySize<Item> {
  private readonly classes: { size: number; items: Item[] }[] = [];
  private readonly index = new Map<number, Item[]>();

  add(size: number, item: Item): void {
    const level = size > 0 ? Math.ceil(Math.log2(size)) : -1000;
    let items = this.index.get(level);
    if (!items) {
      items = [];
      this.index.set(level, items);
      this.classes.push({ size: 2 ** level, items });
      this.classes.sort((a, b) => b.size - a.size);
    }
    items.push(item);
  }

  /** Visits things that may be of at least this size, large ones first, until `visit` has had enough. */
  each(least: number, visit: (item: Item) => boolean): void {
    for (const { size, items } of this.classes) {
      if (size < least) return;
      for (const item of items) if (!visit(item)) return;
    }
  }
}

export interface Face {
  body: number;
  /** -1: the root's face; else the depth in the tree. */
  depth: number;
  boundary: Int32Array;
}

export class MapShape {
  /** Tiling edges within one body, as pairs of vertices. */
  readonly rigid = new BySize<[number, number]>();
  readonly pq: [number, number][] = [];
  readonly rigidFaces = new BySize<Face>();
  /** Faces between the bodies, whose size changes with time. */
  readonly mixedFaces: Face[] = [];
  /** u, v, w of each active corner. */
  readonly corners: [number, number, number][] = [];
  deepest = 1;

  constructor(
    replay: Replay,
    private readonly figures: [Figure, Figure],
  ) {
    this.findEdges(replay);
    this.findFaces(replay);
  }

  private findEdges(replay: Replay): void {
    const { origin, vertexBody } = replay;
    for (let h = 2 * vertexBody.length; h < replay.slots; h += 2) {
      const a = origin[h];
      if (a < 0) continue;
      const b = origin[h + 1];
      if (vertexBody[a] !== vertexBody[b]) this.pq.push([a, b]);
      else this.rigid.add(this.distance(replay, a, b), [a, b]);
    }
    for (let h = 0; h < replay.slots; ++h) {
      if (origin[h] < 0 || faceKind(replay.face[h]) === FaceKind.interior) continue;
      const v = origin[h ^ 1];
      const w = origin[replay.next[h] ^ 1];
      const u = origin[h];
      if (u === w || (vertexBody[u] === vertexBody[v] && vertexBody[v] === vertexBody[w])) continue;
      this.corners.push([u, v, w]);
    }
  }

  private findFaces(replay: Replay): void {
    const seen = new Uint8Array(replay.slots);
    const boundary: number[] = [];
    for (let start = 0; start < replay.slots; ++start) {
      if (seen[start] || replay.origin[start] < 0) continue;
      const kind = faceKind(replay.face[start]);
      if (kind === FaceKind.interior || kind === FaceKind.infinite) continue;
      boundary.length = 0;
      let h = start;
      let mixed = false;
      const body = replay.vertexBody[replay.origin[start]];
      do {
        seen[h] = 1;
        boundary.push(replay.origin[h]);
        if (replay.vertexBody[replay.origin[h]] !== body) mixed = true;
        h = replay.next[h];
      } while (h !== start);
      const code = replay.face[start];
      const depth = kind === FaceKind.root ? -1 : faceDepth(code);
      this.deepest = Math.max(this.deepest, depth);
      const face = { body: faceBody(code), depth, boundary: Int32Array.from(boundary) };
      if (mixed) this.mixedFaces.push(face);
      else this.rigidFaces.add(this.extent(replay, face.boundary), face);
    }
  }

  private distance(replay: Replay, a: number, b: number): number {
    const figure = this.figures[replay.vertexBody[a]];
    const i = replay.vertexIndex[a];
    const j = replay.vertexIndex[b];
    return Math.hypot(figure.x[i] - figure.x[j], figure.y[i] - figure.y[j]);
  }

  private extent(replay: Replay, boundary: Int32Array): number {
    let most = 0;
    for (const v of boundary) most = Math.max(most, this.distance(replay, boundary[0], v));
    return most;
  }
}
