// The library in WebAssembly: texts in, JSON and flat arrays out (wasm/exports.cpp).
import type { WhatFollows } from "./aftermath";
import type { FoundWay, ReadProblem } from "./wayproblem";

export interface Fault {
  kind: "input" | "undecided" | "internal";
  place: string;
  problem: string;
  hint: string;
  /** Position in the scene, or -1. */
  body: number;
  vertices: number[];
  edges: number[];
  /** Part and ring of each of them. */
  vertexRings: [number, number][];
  edgeRings: [number, number][];
}

/** What the library refuses, with the parts at fault. */
export class TautError extends Error {
  constructor(readonly fault: Fault) {
    super((fault.place ? fault.place + ": " : "") + fault.problem);
  }

  /** What the page itself refuses. */
  static input(problem: string, hint: string): TautError {
    const nothing = { body: -1, vertices: [], edges: [], vertexRings: [], edgeRings: [] };
    return new TautError({ kind: "input", place: "", problem, hint, ...nothing });
  }
}

export interface Feature {
  body: string;
  /** Of a vertex or an edge, or of the segment of a path. */
  index: number;
  /** Where on the segment, from 0 to 1. */
  at?: number;
  /** Left out where the body is one outline without holes; ring 0 is the outline, k the k-th hole. */
  part?: number;
  ring?: number;
}

export interface ContactAnswer {
  vertex: Feature;
  edge: Feature;
  point: [number, number];
  normal: [number, number];
}

/** Another pair that meets at the same time, as far as is known. */
export interface PairAnswer {
  bodies: [string, string];
  outcome: string;
  t?: [number, number];
  contact?: ContactAnswer;
}

/** Which pairs an answer is about: `pairs` is the sum of the others, the last four of which were not tested. */
export interface Coverage {
  pairs: number;
  tested: number;
  apart: number;
  ignored: number;
  moving_alike: number;
  at_rest: number;
  layers: number;
  not_reached: number;
}

/** Where a mechanism stops. */
export interface Lock {
  t: [number, number];
  kind: "dead point" | "change point" | "undecided";
  joints: string[];
  links: string[];
}

export type Outcome = "free" | "contact" | "overlap_at_start" | "undecided" | "untested" | "locked";

/** As `taut check --json` prints it. */
export interface Answer {
  outcome: Outcome;
  t?: [number, number];
  /** Overlapping and touching cannot be told apart, all over t. */
  grazing?: boolean;
  contact?: ContactAnswer;
  pair?: [string, string];
  also?: PairAnswer[];
  coverage: Coverage;
  free_until?: number;
  lock?: Lock;
  reason?: string;
  /** How well curves were known. */
  geometry?: { tolerance: number; segments: number };
  events: number;
  certificates: { initial: number; max: number };
  scope: { bodies: string[]; time: [number, number]; touch: "open" | "closed" };
}

/** What pictures need of bodies: see shapes_text() in wasm/world.hpp. */
export interface WorldStyles {
  /** Bodies, those first that are painted first. */
  order: number[];
  /** Of each body: x, y, how far from the boundary, and the part that it is in. */
  inner: [number, number, number, number][];
  /** Fill, line, and what is written on the fill; they come again after the last. */
  styles: [string, string, string][];
  /** The body that carries a joint, where, and along what a slide goes, in the coordinates of that body. */
  joints: [number, [number, number], [number, number]?][];
  /** Of each body, part and ring with curves; polygons have none. */
  bands?: Band[][][];
}

/** How wide at most, and the two walls, x and y in turn: the curve lies between them. */
export type Band = [number, number[], number[]];

export interface Status {
  state: "running" | "finished" | "contact" | "overlap_at_start" | "undecided" | "untested";
  /** Was the time asked for reached? Otherwise the milliseconds were over. */
  reached: boolean;
  time: number;
  freeUntil: number;
  initial: number;
  max: number;
  answer: Answer;
  /** Of more than two polygons, of which there is no tiling. */
  world?: WorldStyles;
}

export type Ring = [number, number][];
/** An outline minus its holes. */
export interface Part {
  outline: Ring;
  holes?: Ring[];
  /** Its own layers, in place of those of its body. */
  z?: Heights;
}
/** An outline with curves, as the data of an SVG path that the library has written: an outline, then its holes. */
export interface PathPart {
  path: string;
  "fill-rule"?: "nonzero" | "evenodd";
  z?: Heights;
}

export interface Motion {
  x?: number[];
  y?: number[];
  rotation?: Record<string, unknown>;
  /** What the body turns about, in its own coordinates. */
  pivot?: [number, number];
  /** The place of the pivot goes around the centre. */
  orbit?: { center: [number, number]; angle: number[] };
  /** From when on polynomials count time; 0 by default. */
  origin?: number;
  until?: number;
}

/** An interval of heights across the plane; null is no end. */
export type Heights = [number | null, number | null];

/** One polygon, or parts. */
export interface Body {
  name: string;
  polygon?: Ring;
  parts?: (Ring | Part | PathPart)[];
  /** The body from whose frame the motion is seen. */
  relative_to?: string;
  motion?: Motion | Motion[] | null;
  /** The layers that it reaches through. */
  z?: Heights;
}

export interface Scene {
  format: "taut-scene/1";
  time: [number, number];
  bodies: Body[];
  /** Pairs that are not asked about; "*" is every other body. */
  ignore?: [string, string][];
  /** What certain pairs are to keep, at all times or as a polynomial in the time. */
  clearances?: { pair: [string, string]; margin: number | number[]; origin?: number }[];
  mechanism?: Mechanism;
}

/** Joints that move bodies; the library reads the rest of it. */
export interface Mechanism {
  ground: string;
  joints: Record<string, { revolute?: string[]; slide?: string[] }>;
}

/** As files have it: a polygon with holes, or a path, is one part here. */
export function inParts(scene: Scene): Scene {
  for (const body of scene.bodies) {
    const polygon = body.polygon as Ring | Part | PathPart | undefined;
    if (!polygon || Array.isArray(polygon)) continue;
    body.parts = [polygon];
    delete body.polygon;
  }
  return scene;
}

/** A body's point (u, v) is at (x, y) + u (c, s) + v (-s, c). */
export interface Pose {
  x: number;
  y: number;
  c: number;
  s: number;
}

export type OpenRings = "error" | "close" | "skip";
/** What becomes of closed contours of a drawing that cross. */
export type Crossing = "error" | "subtract" | "union" | "parts";
/** What a person says about a drawing that can be read in two ways. */
export interface Decisions {
  open: OpenRings;
  crossing: Crossing;
}

/** What became of a drawing, as `taut import --json` prints it. */
export interface DrawingReport {
  files: {
    format: string;
    units: string;
    tolerance: number;
    deviation: number;
    repeated: number;
    gaps: { width: number; from: [number, number]; place: string }[];
    open: { from: [number, number]; to: [number, number]; place: string }[];
    repairs: { what: string; size: number; at: [number, number]; place: string }[];
    crossings: { at: [number, number]; place: string }[];
    notes: string[];
    skipped: { what: string; place: string; layer: string; reason: string; times: number }[];
  }[];
  bodies: { name: string; parts: number; holes: number; area: number; box: [[number, number], [number, number]] }[];
  faults: { place: string; problem: string; hint: string }[];
}

export interface ReadDrawing {
  scene: Scene | null;
  report: DrawingReport;
  /** SVG, whose marks have ids: gap-0-K, open-0-K, repair-0-K and crossing-0-K. */
  picture: string;
}

interface Module {
  HEAPU8: Uint8Array;
  HEAP32: Int32Array;
  HEAPF64: Float64Array;
  _malloc(size: number): number;
  _free(pointer: number): void;
  _taut_read_scene(text: number, name: number): number;
  _taut_read_outline(text: number, name: number): number;
  _taut_read_drawing(text: number, name: number, open: number, crossing: number): number;
  _taut_shapes(text: number): number;
  _taut_open(text: number, name: number, closed: number): number;
  _taut_ask(question: number, text: number, options: number): number;
  _taut_read_problem(text: number, name: number): number;
  _taut_find_way(text: number, closed: number, clearance: number, shortest: number, seconds: number): number;
  _taut_go_on(text: number, closed: number, bounce: number): number;
  _taut_advance(until: number, milliseconds: number): number;
  _taut_change_plan(text: number, body: number): number;
  _taut_poses(t: number): number;
  _taut_tilings(t: number): number;
  _taut_svg(t: number, proof: number): number;
  _taut_array(which: number): number;
  _taut_array_size(which: number): number;
}

declare const TautModule: (options?: object) => Promise<Module>;

export type ArrayName = "vertices" | "start" | "changes" | "events";
const arrayNumbers: Record<ArrayName, number> = { vertices: 0, start: 1, changes: 2, events: 3 };

export class Engine {
  /** Of the scene that is open. */
  private bodies = 0;

  private constructor(private readonly module: Module) {}

  static async load(): Promise<Engine> {
    return new Engine(await TautModule());
  }

  readScene(text: string, name: string): Scene {
    return inParts(this.call<{ scene: Scene }>([text, name], (t, n) => this.module._taut_read_scene(t, n)).scene);
  }

  /** What pictures need of the bodies of any valid scene. */
  shapes(scene: string): WorldStyles {
    return this.call<{ shapes: WorldStyles }>([scene], (t) => this.module._taut_shapes(t)).shapes;
  }

  readOutline(text: string, name: string): Part[] {
    return this.call<{ parts: Part[] }>([text, name], (t, n) => this.module._taut_read_outline(t, n)).parts;
  }

  /** A drawing as a scene, with the report. What is not decided, and matters, is a fault. */
  readDrawing(text: string, name: string, { open, crossing }: Decisions): ReadDrawing {
    const ends = { error: 0, close: 1, skip: 2 }[open];
    const contours = { error: 0, parts: 1, union: 2, subtract: 3 }[crossing];
    const drawing = this.call<ReadDrawing>([text, name], (t, n) =>
      this.module._taut_read_drawing(t, n, ends, contours),
    );
    return { ...drawing, scene: drawing.scene && inParts(drawing.scene) };
  }

  open(scene: Scene, name: string, closed: boolean): Status {
    const status = this.call<Status>([JSON.stringify(scene), name], (t, n) =>
      this.module._taut_open(t, n, closed ? 1 : 0),
    );
    this.bodies = scene.bodies.length;
    return status;
  }

  /** A question by its name in the library, about any valid scene. */
  ask<Result>(question: string, scene: Scene, options: Record<string, unknown>): Result {
    return this.call<{ answer: Result }>([question, JSON.stringify(scene), JSON.stringify(options)], (q, t, o) =>
      this.module._taut_ask(q, t, o),
    ).answer;
  }

  /** Joints, a start and a goal. */
  readProblem(text: string, name: string): ReadProblem {
    return this.call<ReadProblem>([text, name], (t, n) => this.module._taut_read_problem(t, n));
  }

  /** Takes as long as it takes: to be called where nobody waits. */
  findWay(text: string, closed: boolean, clearance: number, shortest: boolean): FoundWay {
    return this.call<FoundWay>([text], (t) =>
      this.module._taut_find_way(t, closed ? 1 : 0, clearance, shortest ? 1 : 0, Infinity),
    );
  }

  /** The scene with what comes after its contacts, where bodies bounce or stop. */
  goOn(scene: Scene, closed: boolean, bounce: boolean): WhatFollows {
    const text = JSON.stringify(scene);
    return this.call<WhatFollows>([text], (t) => this.module._taut_go_on(t, closed ? 1 : 0, bounce ? 1 : 0));
  }

  advance(until: number, milliseconds: number): Status {
    return this.call([], () => this.module._taut_advance(until, milliseconds));
  }

  changePlan(scene: string, body: number): Status {
    return this.call([scene], (t) => this.module._taut_change_plan(t, body));
  }

  /** Of a world, the tilings of the pairs that are near: of each line its ends, and 1 if it joins two bodies. */
  tilings(t: number): number[] {
    return this.call<{ lines: number[] }>([], () => this.module._taut_tilings(t)).lines;
  }

  /** The picture of an instant: the bodies, with the tilings between them if the proof is wanted. */
  svg(t: number, proof: boolean): string {
    return this.call<{ svg: string }>([], () => this.module._taut_svg(t, proof ? 1 : 0)).svg;
  }

  /** Of every body of the scene that is open, parents included. */
  poses(t: number): Pose[] {
    const at = this.module._taut_poses(t) >> 3;
    const h = this.module.HEAPF64;
    const pose = (i: number): Pose => ({ x: h[i], y: h[i + 1], c: h[i + 2], s: h[i + 3] });
    return Array.from({ length: this.bodies }, (_, b) => pose(at + 4 * b));
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
