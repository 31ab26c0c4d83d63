// How questions are asked, and what has members of its own: workers, simulations, maps and drawings.

/** How far a question is, as far as it is known; which members there are differs from question to question. */
export interface Progress {
  /** What is counted, such as "pairs", how many of them are done, and of how many. */
  kind?: string;
  done?: number;
  all?: number;
  /** The share of the question that is decided, from 0 to 1. */
  share?: number;
  /** The scene has been searched up to this instant. */
  time?: number;
}

/** How and where a question is answered. */
export interface AskOptions {
  /** The question stops when it is aborted, and rejects with its reason. Such a question is answered in a worker. */
  signal?: AbortSignal;
  /** Called some ten times a second. Such a question is answered in a worker, and called back on this thread. */
  onProgress?: (progress: Progress) => void;
  /**
   * Whether it is answered in a worker, off this thread, so that several are answered at once. On this thread a signal
   * is seen only before the work begins. true with a signal or onProgress, false without.
   */
  worker?: boolean;
}

/** The settings of workers, for questions from now on. Ends those that are idle. Throws RangeError for a bad count. */
export function setWorkers(settings: {
  /** How many at most; the processors without it. */
  count?: number | null;
  /**
   * Makes a worker that runs the script taut2d/worker: a Worker of the browser, or one of node:worker_threads. Without
   * it, workers are made from text, which a page's policy may forbid (worker-src blob:).
   */
  create?: (() => unknown) | null;
}): void;
/** Ends the workers that are idle, which gives their memory back. */
export function stopWorkers(): void;

/** A picture. */
export interface Drawn {
  svg: string;
}

/** Cell [i, j] is the square from origin + resolution [i, j] to origin + resolution [i + 1, j + 1]. */
export interface CellsAnswer {
  body: string;
  resolution: number;
  origin: [number, number];
  lock?: Lock;
  cells: [number, number][];
}

export type SimulationState = "running" | "finished" | "locked" | "contact" | "overlap_at_start" | "undecided" | "untested";

export interface SimulationOptions {
  touch?: Touch;
  /** Of each call. Where it is reached, the state is "undecided" from then on. */
  maxSeconds?: number;
  maxEvents?: number;
  /**
   * The state becomes "undecided" where one pair comes into contact more often than this (1000) within `contactTime`
   * (a millionth of the scene's time), as a ball that bounces lower and lower does.
   */
  maxContactsPerTime?: number;
  contactTime?: number;
  /** Keep all motions, for record(). */
  record?: boolean;
}

/** How two bodies move at a contact, in the world: each number as a bracket that certainly contains it. */
export interface ContactMotion {
  normal: [Bracket, Bracket];
  /** Of the vertex, as the body of the edge sees it. */
  velocity: [Bracket, Bracket];
  /** Negative while the bodies approach. */
  along_normal: Bracket;
}

/** The planar map at one instant. Edges and faces name vertices by their places. */
export interface Tiling {
  time: number;
  vertices: Feature[];
  points: [number, number][];
  edges: { start: number; end: number; polygon: boolean; joins: boolean }[];
  faces: {
    kind: "node" | "root" | "infinite" | "polygon_interior";
    body?: string;
    depth: number;
    boundary: number[];
  }[];
}

/**
 * check() online: it has a current time up to which the motion is proved free, and proceeds from there, event by event;
 * the motion of a body after that time may be changed. A contact stops it; resume() goes on. Scenes have no curves:
 * flatten() makes polygons of these. Work is done on this thread, and calls return when it is done. All of them throw
 * TautError, as the Python package's do InputError and UndecidedError.
 */
export class Simulation {
  private constructor();
  static create(scene: Scene, options?: SimulationOptions): Promise<Simulation>;

  /**
   * "running": free up to `time`, and there may be more events; "finished": proved free to the end; "contact": resume()
   * goes on; "undecided": nothing is claimed beyond `time`, for the `reason` given.
   */
  readonly state: SimulationState;
  readonly reason: string;
  /** Up to when the motion is proved free. It never decreases. */
  readonly time: number;
  readonly events: number;
  /** The size of the active set, and the largest that it has been. */
  readonly certificates: number;
  readonly certificatesMax: number;
  readonly contact: TimedContact | null;
  /** Whether the contact is one from which the simulation was resumed: the same features, at the same time. */
  readonly contactAgain: boolean;
  /** How many there have been, without those that came again. */
  readonly contacts: number;
  /** The bodies of the contact, of the overlap, or of what is not decided. */
  readonly pair: Pair | null;
  /** Further contacts whose order with the contact is not decided. */
  readonly also: PairAnswer[];
  readonly overlapPoint: [number, number] | null;
  readonly coverage: Coverage;

  /** A bracket of the time of the next event; null if none is left before the end. */
  nextEvent(): Bracket | null;
  /** Processes one event. False if there is none before the end, after a contact, or if it is undecided. */
  step(): boolean;
  /** Processes all events before `t`, and stands there, unless a contact comes first. */
  advanceTo(t: number): SimulationState;
  /** Like advanceTo(), but calls the function for every contact, and goes on unless that returns false. */
  advanceMany(t: number, onContact: (contact: TimedContact) => unknown): SimulationState;
  /** Goes on after a contact, usually with other motions. */
  resume(): SimulationState;
  /**
   * At a contact: one of its bodies rests from now on, moved off the contact by `gap`, which covers rounding (2^-44 of the
   * largest coordinate).
   */
  stop(name: string, options?: { gap?: number }): void;
  /**
   * At a contact: the other body pushes this one, which turns about the hinge or slides along the direction, as its parent
   * sees them, for the time `step`, a sixteenth faster than it is pushed, and then rests until it is caught up with.
   */
  push(
    name: string,
    guide: { step: number; hinge: [number, number]; gap?: number } | { step: number; direction: [number, number]; gap?: number },
  ): void;
  /** Replaces a body's motion from `time` on; null: it rests. It must have the body where it is, up to rounding. */
  setMotion(name: string, motion: Motion): void;
  /** Adds a body from `time` on, which other bodies must not overlap. */
  addBody(body: Body): void;
  removeBody(name: string): void;
  /** The pair is not tested from `time` on. */
  ignore(a: string, b: string): void;
  /** From `time` on the body is attached to `parent`, or to none, and moves as seen from there. */
  setParent(name: string, parent: string | null, motion: Motion): void;
  /** Of the contact, or of `also[which - 1]`. */
  relativeVelocity(which?: number): ContactMotion;
  /** All that was done until `time`, as ordinary scenes. With the option `record`. */
  record(): SceneObject[];
  /** Of two bodies of one ring each. */
  tiling(): Tiling;
  /** Gives its memory back at once; otherwise that happens some time after it is out of reach. */
  free(): void;
}

/** A shape that moves among the bodies of a map. */
export interface Mover {
  readonly name: string;
  readonly map: StaticMap;
}

/**
 * Bodies at rest, prepared for questions about bodies that move among them: a floor plan, the obstacles of a planner.
 * What is far away costs next to nothing. Work is done on this thread, and calls return when it is done.
 */
export class StaticMap {
  private constructor();
  /** Bodies have no motion, no parent and no curves. `reach`: shapes of movers may have coordinates up to this. */
  static create(bodies: readonly Body[], options?: { reach?: number }): Promise<StaticMap>;
  /** Prepares a shape once; its motion and its parent are not looked at. */
  prepare(body: Body): Mover;
  /**
   * The answer of check() about the scene of the map's bodies and the mover with this motion: what it first meets on
   * [start, end], and when.
   */
  check(
    mover: Mover,
    motion: Motion,
    time: readonly [number, number],
    options?: { touch?: Touch; maxSeconds?: number },
  ): Answer;
  /** The name of the first body of the map that the mover overlaps where its motion has it at `t`; null if none. */
  overlapped(mover: Mover, motion: Motion, t?: number, options?: { touch?: Touch; maxSeconds?: number }): string | null;
  /** Gives its memory back at once; otherwise that happens some time after it is out of reach. */
  free(): void;
}

/** Lengths are in units of the scene. */
export interface DrawingOptions extends AskOptions {
  /** Chords are nowhere farther from their curves. 0.01 mm without it, in proportion for small and large drawings. */
  tolerance?: number;
  /** Ends of lines that are at most so far from another end or line meet it. 0.02 mm without it. */
  join?: number;
  /** Loops up to this size are cut off. 0.1 mm without it. */
  repair?: number;
  /** Drills of a board that are at least so wide are holes in it. */
  drills?: number;
  /** All lengths are multiplied by it. */
  scale?: number;
  /** What a drawing is in that does not say so. */
  unit?: "mm" | "cm" | "m" | "um" | "in" | "ft" | "mil" | "pt" | "px";
  /** What becomes of outlines that stay open. */
  open?: "error" | "close" | "skip";
  /** What becomes of closed contours around material that cross each other. */
  crossing?: "error" | "subtract" | "union" | "parts";
  /** What becomes a body. */
  by?: "auto" | "layer" | "color" | "group" | "nesting";
  /** All layers are one. */
  mergeLayers?: boolean;
  /** Arcs and Bezier curves stay what they are. */
  curves?: boolean;
  /** A body for each part. */
  split?: boolean;
  /** What is not read is an error. */
  strict?: boolean;
}

/** What was read, as `taut import --json` says it; docs/import.md explains more of its members. */
export interface DrawingReport {
  files: { file: string; format: string; units: string; tolerance: number; [more: string]: unknown }[];
  bodies: { name: string; parts: number; holes: number; vertices: number; area: number; [more: string]: unknown }[];
  /** Why the scene is not what was drawn, or may not be. */
  faults: { place: string; problem: string; hint: string }[];
  [more: string]: unknown;
}

/** `scene`: bodies that rest, over the time [0, 1]; null if there are faults. `svg`: a picture, open lines red. */
export interface ReadDrawing {
  scene: SceneObject | null;
  report: DrawingReport;
  svg: string;
}

/** A scene of a drawing: SVG, DXF, a board of KiCad, WKT or GeoJSON, by the ending of `name`. */
export function readDrawing(text: string, name: string, options?: DrawingOptions): Promise<ReadDrawing>;
