// The planar map at any event: each event's changes are applied forwards or taken back.
import type { Engine } from "./engine";

export const repairs = ["convex_flip", "convex_triangle", "reflex_a", "reflex_b", "reflex_c", "collision"] as const;
export type Repair = (typeof repairs)[number];

const halfedgeInts = 3;
const changeInts = 7;
const eventInts = 11;

export const enum FaceKind {
  node,
  root,
  infinite,
  interior,
}
export const faceKind = (code: number): FaceKind => code & 3;
export const faceBody = (code: number): number => (code >> 2) & 1;
export const faceDepth = (code: number): number => code >> 3;

export interface MapEvent {
  number: number;
  lo: number;
  hi: number;
  repair: Repair;
  bridging: boolean;
  pinchRule: boolean;
  threeCorners: boolean;
  /** Internal numbers of the corner's vertices u, v, w; the face is on the left of u -> v -> w. */
  corner: [number, number, number];
  certificates: number;
}

/** An edge by the internal numbers of its ends. */
export type Edge = [number, number];

export class Replay {
  origin = new Int32Array(0);
  next = new Int32Array(0);
  face = new Int32Array(0);
  slots = 0;
  /** Events applied so far. */
  applied = 0;
  /** Grows whenever the map changes. */
  version = 0;

  /** By internal vertex number. */
  vertexBody = new Int32Array(0);
  vertexIndex = new Int32Array(0);
  private numberOf: Int32Array[] = [];

  private changes = new Int32Array(0);
  private events = new Int32Array(0);
  private times = new Float64Array(0);
  /** By event: the latest of the times up to it, so that it never falls. */
  private ordered = new Float64Array(0);

  /** Starts with the map before all events. */
  open(engine: Engine): void {
    const vertices = engine.integers("vertices");
    const count = vertices.length / 2;
    this.vertexBody = new Int32Array(count);
    this.vertexIndex = new Int32Array(count);
    const sizes = [0, 0];
    for (let i = 0; i < count; ++i) sizes[(this.vertexBody[i] = vertices[2 * i])]++;
    this.numberOf = sizes.map((n) => new Int32Array(n));
    for (let i = 0; i < count; ++i) {
      this.vertexIndex[i] = vertices[2 * i + 1];
      this.numberOf[this.vertexBody[i]][this.vertexIndex[i]] = i;
    }
    const start = engine.integers("start");
    this.slots = start.length / halfedgeInts;
    const room = 4 * count + 64;
    this.origin = new Int32Array(room).fill(-1);
    this.next = new Int32Array(room).fill(-1);
    this.face = new Int32Array(room);
    for (let h = 0; h < this.slots; ++h) this.set(h, start, halfedgeInts * h);
    this.applied = 0;
    this.version++;
    this.changes = new Int32Array(0);
    this.events = new Int32Array(0);
    this.times = new Float64Array(0);
    this.ordered = new Float64Array(0);
  }

  /** Takes up events that the engine has found since. */
  update(engine: Engine): void {
    const events = engine.integers("events");
    if (events.length === this.events.length) return;
    const known = this.count;
    this.events = events.slice();
    this.changes = engine.integers("changes").slice();
    this.times = engine.times().slice();
    const ordered = new Float64Array(this.count);
    ordered.set(this.ordered);
    for (let k = known; k < ordered.length; ++k) {
      ordered[k] = Math.max(this.times[2 * k], k > 0 ? ordered[k - 1] : -Infinity);
    }
    this.ordered = ordered;
  }

  get count(): number {
    return this.events.length / eventInts;
  }

  vertex(body: number, index: number): number {
    return this.numberOf[body][index];
  }

  /** The time at which event k is shown: its failure time, made not to fall. */
  timeOf(k: number): number {
    return this.ordered[k];
  }

  certificatesAfter(k: number): number {
    return this.events[eventInts * k + 10];
  }

  event(k: number): MapEvent {
    const e = this.events.subarray(eventInts * k, eventInts * (k + 1));
    return {
      number: k + 1,
      lo: this.times[2 * k],
      hi: this.times[2 * k + 1],
      repair: repairs[e[2]],
      bridging: (e[3] & 1) !== 0,
      pinchRule: (e[3] & 2) !== 0,
      threeCorners: (e[3] & 4) !== 0,
      corner: [this.vertex(e[4], e[5]), this.vertex(e[6], e[7]), this.vertex(e[8], e[9])],
      certificates: e[10],
    };
  }

  /** How many events lie at or before t. */
  eventsUntil(t: number): number {
    let lo = 0;
    let hi = this.count;
    while (lo < hi) {
      const middle = (lo + hi) >> 1;
      if (this.ordered[middle] <= t) lo = middle + 1;
      else hi = middle;
    }
    return lo;
  }

  /** The map after the first k events. */
  goTo(k: number): void {
    if (k !== this.applied) this.version++;
    while (this.applied < k) this.apply(this.applied++, 4);
    while (this.applied > k) this.apply(--this.applied, 1);
  }

  /** The edges that event k takes away and adds; the map must stand right before or after it. */
  edgesOf(k: number): { gone: Edge[]; come: Edge[] } {
    const slots = new Map<number, { before: Edge; after: Edge }>();
    const current = (s: number): Edge => [this.origin[2 * s], this.origin[2 * s + 1]];
    this.eachChange(k, (at) => {
      const h = this.changes[at];
      const slot = h >> 1;
      if (!slots.has(slot)) slots.set(slot, { before: current(slot), after: current(slot) });
      slots.get(slot)!.before[h & 1] = this.changes[at + 1];
      slots.get(slot)!.after[h & 1] = this.changes[at + 4];
    });
    const gone: Edge[] = [];
    const come: Edge[] = [];
    for (const { before, after } of slots.values()) {
      if (before[0] === after[0] && before[1] === after[1]) continue;
      if (before[0] >= 0) gone.push(before);
      if (after[0] >= 0) come.push(after);
    }
    return { gone, come };
  }

  private eachChange(k: number, visit: (at: number) => void): void {
    const first = this.events[eventInts * k];
    const last = this.events[eventInts * k + 1];
    for (let i = first; i < last; ++i) visit(changeInts * i);
  }

  private apply(k: number, offset: number): void {
    this.eachChange(k, (at) => {
      const h = this.changes[at];
      this.slots = Math.max(this.slots, (h | 1) + 1);
      this.set(h, this.changes, at + offset);
    });
  }

  private set(h: number, from: Int32Array, at: number): void {
    this.origin[h] = from[at];
    this.next[h] = from[at + 1];
    this.face[h] = from[at + 2];
  }
}
