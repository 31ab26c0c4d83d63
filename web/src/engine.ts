// The library in WebAssembly: texts in, JSON and flat arrays out (wasm/exports.cpp).

export interface Fault {
  kind: "input" | "undecided" | "internal";
  place: string;
  problem: string;
  hint: string;
  /** Position in the scene, or -1. */
  body: number;
  vertices: number[];
  edges: number[];
}

/** What the library refuses, with the parts at fault. */
export class TautError extends Error {
  constructor(readonly fault: Fault) {
    super((fault.place ? fault.place + ": " : "") + fault.problem);
  }
}

export interface Feature {
  body: string;
  index: number;
}

/** As `taut check --json` prints it. */
export interface Answer {
  outcome: "free" | "contact" | "overlap_at_start" | "undecided";
  t?: [number, number];
  /** Overlapping and touching cannot be told apart, all over t. */
  grazing?: boolean;
  contact?: { vertex: Feature; edge: Feature; point: [number, number]; normal: [number, number] };
  free_until?: number;
  reason?: string;
  events: number;
  certificates: { initial: number; max: number };
  scope: { bodies: string[]; time: [number, number]; touch: "open" | "closed" };
}

export interface Status {
  state: "running" | "finished" | "contact" | "overlap_at_start" | "undecided";
  /** Was the time asked for reached? Otherwise the milliseconds were over. */
  reached: boolean;
  time: number;
  freeUntil: number;
  initial: number;
  max: number;
  answer: Answer;
}

export interface Motion {
  x?: number[];
  y?: number[];
  rotation?: Record<string, unknown>;
  /** What the body turns about, in its own coordinates. */
  pivot?: [number, number];
  until?: number;
}

export interface Body {
  name: string;
  polygon: [number, number][];
  motion?: Motion | Motion[] | null;
}

export interface Scene {
  format: "taut-scene/1";
  time: [number, number];
  bodies: Body[];
}

/** A body's point (u, v) is at (x, y) + u (c, s) + v (-s, c). */
export interface Pose {
  x: number;
  y: number;
  c: number;
  s: number;
}

interface Module {
  HEAPU8: Uint8Array;
  HEAP32: Int32Array;
  HEAPF64: Float64Array;
  _malloc(size: number): number;
  _free(pointer: number): void;
  _taut_read_scene(text: number, name: number): number;
  _taut_read_outline(text: number, name: number): number;
  _taut_open(text: number, name: number, closed: number): number;
  _taut_advance(until: number, milliseconds: number): number;
  _taut_change_plan(text: number, body: number): number;
  _taut_poses(t: number): number;
  _taut_svg(t: number): number;
  _taut_array(which: number): number;
  _taut_array_size(which: number): number;
}

declare const TautModule: (options?: object) => Promise<Module>;

export type ArrayName = "vertices" | "start" | "changes" | "events";
const arrayNumbers: Record<ArrayName, number> = { vertices: 0, start: 1, changes: 2, events: 3 };

export class Engine {
  private constructor(private readonly module: Module) {}

  static async load(): Promise<Engine> {
    return new Engine(await TautModule());
  }

  readScene(text: string, name: string): Scene {
    return this.call<{ scene: Scene }>([text, name], (t, n) => this.module._taut_read_scene(t, n)).scene;
  }

  readOutline(text: string, name: string): [number, number][] {
    return this.call<{ polygon: [number, number][] }>([text, name], (t, n) => this.module._taut_read_outline(t, n))
      .polygon;
  }

  open(text: string, name: string, closed: boolean): Status {
    return this.call([text, name], (t, n) => this.module._taut_open(t, n, closed ? 1 : 0));
  }

  advance(until: number, milliseconds: number): Status {
    return this.call([], () => this.module._taut_advance(until, milliseconds));
  }

  changePlan(scene: string, body: number): Status {
    return this.call([scene], (t) => this.module._taut_change_plan(t, body));
  }

  svg(t: number): string {
    return this.call<{ svg: string }>([], () => this.module._taut_svg(t)).svg;
  }

  poses(t: number): [Pose, Pose] {
    const at = this.module._taut_poses(t) >> 3;
    const h = this.module.HEAPF64;
    const pose = (i: number): Pose => ({ x: h[i], y: h[i + 1], c: h[i + 2], s: h[i + 3] });
    return [pose(at), pose(at + 4)];
  }

  /** A view of memory that lasts until the next call. */
  integers(name: ArrayName): Int32Array {
    const which = arrayNumbers[name];
    const at = this.module._taut_array(which) >> 2;
    return this.module.HEAP32.subarray(at, at + this.module._taut_array_size(which));
  }

  times(): Float64Array {
    const at = this.module._taut_array(4) >> 3;
    return this.module.HEAPF64.subarray(at, at + this.module._taut_array_size(4));
  }

  private call<Result>(texts: string[], work: (...pointers: number[]) => number): Result {
    const pointers = texts.map((text) => this.put(text));
    try {
      const answer = JSON.parse(this.get(work(...pointers)));
      if (answer.error) throw new TautError(answer.error as Fault);
      return answer as Result;
    } finally {
      for (const pointer of pointers) this.module._free(pointer);
    }
  }

  private put(text: string): number {
    const bytes = new TextEncoder().encode(text);
    const pointer = this.module._malloc(bytes.length + 1);
    this.module.HEAPU8.set(bytes, pointer);
    this.module.HEAPU8[pointer + bytes.length] = 0;
    return pointer;
  }

  private get(pointer: number): string {
    const heap = this.module.HEAPU8;
    return new TextDecoder().decode(heap.subarray(pointer, heap.indexOf(0, pointer)));
  }
}
