// Scenes are as docs/scenes.md of taut has them, answers as `taut check --json` and the like print them: docs/answers.md and
// docs/questions.md say more about each member. The functions and their options are appended by build.mjs.

export type Point = readonly [number, number];

/** Any value that JSON has. */
export type Id = string | number | boolean | null | object;

/** Three points or more; the last is joined to the first. */
export type Ring = readonly Point[];
/** The lowest and the highest height that a shape reaches through, null for no end; it meets only what is on a common layer. */
export type Layers = readonly [number | null, number | null];
/** An outline, minus its holes. */
export interface OutlineWithHoles {
  readonly outline: Ring;
  readonly holes?: readonly Ring[];
  readonly z?: Layers;
}
/** The data of an SVG path, y upwards: curves. */
export interface Path {
  readonly path: string;
  readonly "fill-rule"?: "nonzero" | "evenodd";
  readonly z?: Layers;
}
export type Polygon = Ring | OutlineWithHoles | Path;

/** The way from the keyframe before, about a centre, by so many degrees counterclockwise; instead of x, y and angle_deg. */
export interface Arc {
  readonly center: Point;
  readonly deg: number;
}
export interface Keyframe {
  readonly t: number;
  readonly x?: number;
  readonly y?: number;
  readonly angle_deg?: number;
  /** The body turns with it, like a car. */
  readonly turn?: Arc;
  /** The body does not turn. */
  readonly arc?: Arc;
}
export interface KeyframedMotion {
  readonly keyframes: readonly Keyframe[];
  readonly pivot?: Point;
}
/** Both are per unit of time; one of them is there. */
export type SteadyMotion =
  | {
      readonly velocity: Point;
      readonly spin_deg?: number;
      readonly pivot?: Point;
    }
  | {
      readonly velocity?: Point;
      readonly spin_deg: number;
      readonly pivot?: Point;
    };
/** An even turn over the scene's time; answers say at which angle. */
export interface SweepMotion {
  readonly sweep: {
    readonly pivot?: Point;
    readonly from_deg: number;
    readonly to_deg: number;
  };
}
/** Coefficients, the constant one first. */
export type Polynomial = readonly number[];
export type Rotation =
  | { readonly angle: Polynomial }
  | { readonly direction: { readonly a: Polynomial; readonly b: Polynomial } }
  | { readonly half_angle_tangent: Polynomial }
  | { readonly cosine: Polynomial };
/** Polynomials in the time since `origin`, which is 0 by default: the body's point (u, v) is at (x, y), plus (u, v) as it is rotated. */
export interface MotionPiece {
  readonly x?: Polynomial;
  readonly y?: Polynomial;
  readonly rotation?: Rotation | null;
  readonly pivot?: Point;
  readonly orbit?: { readonly center: Point; readonly angle: Polynomial };
  readonly origin?: number;
  readonly until?: number;
}
export type Motion = null | KeyframedMotion | SteadyMotion | SweepMotion | MotionPiece | readonly MotionPiece[];

interface AnyBody {
  readonly name: string;
  /** The body from whose frame the motion is seen. */
  readonly relative_to?: string;
  /** At rest without it. */
  readonly motion?: Motion;
  /** All layers without it. Parts may have layers of their own. */
  readonly z?: Layers;
  readonly id?: Id;
}
export interface BodyOfPolygon extends AnyBody {
  readonly polygon: Polygon;
  readonly parts?: undefined;
}
export interface BodyOfParts extends AnyBody {
  readonly polygon?: undefined;
  readonly parts: readonly Polygon[];
}
export type Body = BodyOfPolygon | BodyOfParts;

/** A scene in the format taut-scene/1. Scenes that name files cannot be read here. */
export interface SceneObject {
  readonly $schema?: string;
  readonly format: "taut-scene/1";
  readonly time: readonly [number, number];
  readonly bodies: readonly Body[];
  /** Pairs of names that are not tested; "*" is every other body. */
  readonly ignore?: readonly (readonly [string, string])[];
  /** Are pairs tested that do not move? "skip" is the default. */
  readonly at_rest?: "skip" | "test";
  readonly id?: Id;
}
/** A scene as an object, or as JSON text. */
export type Scene = string | SceneObject;

/** Two numbers that certainly enclose another one: an instant, an angle in degrees. */
export type Bracket = [number, number];
/** The names of two bodies, in the order of the scene. */
export type Pair = [string, string];
export type Touch = "open" | "closed";
/** "untested": no pair of bodies was tested, so there is no verdict. "locked": free before `free_until`, right before a mechanism locks. */
export type Outcome = "free" | "contact" | "overlap_at_start" | "undecided" | "untested" | "locked";

/** Where a mechanism cannot go on as it is driven. */
export interface Lock {
  /** An interval of time that contains the lock. */
  t: [number, number];
  kind: "dead point" | "change point" | "undecided";
  /** Joints that could move there while the driven ones are held, and the bodies that move with them. */
  joints: string[];
  links: string[];
}
/** Of checkClearance(). */
export type MarginOutcome = Outcome | "closer_at_start";

/** Which pairs an answer is about: `pairs` is the sum of the others, the last four of which were not tested. */
export interface Coverage {
  pairs: number;
  tested: number;
  /** Kept apart by their bounding boxes. */
  apart: number;
  ignored: number;
  moving_alike: number;
  at_rest: number;
  /** The bodies have no layer in common, and never meet. */
  layers: number;
  /** A limit or an interruption came first. */
  not_reached: number;
}

/** What every answer has. */
interface Verdict {
  /** The scene's. */
  id?: Id;
  outcome: Outcome;
  /** Why it is undecided or untested. */
  reason?: string;
  /** How well curves were known, and the number of segments that stood for them. */
  geometry?: { tolerance: number; segments: number };
  coverage: Coverage;
  /** Where the scene's mechanism locks, up to which the answer holds. */
  lock?: Lock;
}

/** A vertex, or the edge from it to the next, by the indices of the scene. */
export interface Feature {
  body: string;
  /** The body's. */
  id?: Id;
  /** Of bodies with parts or holes: ring 0 is the part's outline, ring k its k-th hole. */
  part?: number;
  ring?: number;
  index: number;
  /** Of curves: where on the segment, from 0 to 1. */
  at?: number;
}

/** Where bodies meet. */
export interface Contact {
  vertex: Feature;
  edge: Feature;
  point: [number, number];
  /** Of the edge, out of its body; of length 1. */
  normal: [number, number];
  /** Of a sweep. */
  angle_deg?: Bracket;
}

/** A contact and its time. */
export interface TimedContact {
  t: Bracket;
  /** Overlapping and touching cannot be told apart, all over `t`. */
  grazing?: true;
  contact: Contact;
}

/** One pair's own answer. */
export interface PairAnswer {
  bodies: Pair;
  outcome: Outcome;
  t?: Bracket;
  grazing?: true;
  contact?: Contact;
  free_until?: number;
  reason?: string;
}

interface AnyAnswer extends Verdict {
  t?: Bracket;
  grazing?: true;
  contact?: Contact;
  /** Of "free" with open touching: the first touch. */
  touching?: TimedContact;
  /** Why it is not known whether they touch. */
  touching_undecided?: string;
  /** A point that lies inside both bodies, where one was found. */
  overlap?: { point: [number, number] };
  /** Up to then the motion is proved free. */
  free_until?: number;
  /** Which bodies the outcome is about. */
  pair?: Pair;
  /** Other pairs that meet at the same time. */
  also?: PairAnswer[];
  /** With pairs: "all": each tested pair's own. */
  pairs?: PairAnswer[];
  engine: "kinetic" | "spacetime" | "both";
  /** Of the kinetic engine, like the size of its active set. */
  events: number;
  certificates: { initial: number; max: number };
  scope: {
    bodies: string[];
    time: [number, number];
    touch: Touch;
    at_rest?: "test";
  };
}
export interface FreeAnswer extends AnyAnswer {
  outcome: "free";
}
export interface ContactAnswer extends AnyAnswer {
  outcome: "contact";
  t: Bracket;
  contact: Contact;
  pair: Pair;
}
export interface OverlapAnswer extends AnyAnswer {
  outcome: "overlap_at_start";
  pair: Pair;
}
export interface UndecidedAnswer extends AnyAnswer {
  outcome: "undecided";
  free_until: number;
  reason: string;
}
export interface UntestedAnswer extends AnyAnswer {
  outcome: "untested";
  reason: string;
}
/** The first contact, or that there is none. */
export type Answer = FreeAnswer | ContactAnswer | OverlapAnswer | UndecidedAnswer | UntestedAnswer;

/** What a valid proof shows. */
export interface ValidProof {
  valid: true;
  outcome: Outcome;
  free_until: number;
  t?: Bracket;
  grazing?: true;
  contact?: Contact;
  /** The contact is at the start, where two pieces of a motion join, or in between. */
  contact_at?: "start" | "joint" | "motion";
  /** Of a proof about a clearance. */
  clearance?: number;
  closer?: {
    t: Bracket;
    vertex: Feature;
    edge?: Feature;
    other_vertex?: Feature;
  };
  touch: Touch;
  events: number;
  separations: number;
  /** Of curves: the segments of the polygons that stand for them. */
  segments?: number;
  coverage: Coverage;
  /** Of what the proof is about. */
  scene_sha256: string;
}
/** `valid` is null where maxSeconds ended the work. */
export interface InvalidProof {
  valid: false | null;
  reason: string;
}
export type Verified = ValidProof | InvalidProof;
/** That no way leads from the start to the goal. */
export interface ValidPathProof {
  valid: true;
  outcome: "none";
  /** Ways that keep this distance are meant. */
  clearance?: number;
  /** Of the partition of all joint values: all, those shown to collide, and those that the start reaches. */
  cells: number;
  colliding: number;
  reached: number;
  scene_sha256: string;
}
export type VerifiedPath = ValidPathProof | InvalidProof;

/** A distance in [lo, hi], and where it is: not where the bodies touch. */
export interface Nearest {
  lo: number;
  hi: number;
  t: Bracket;
  pair: Pair;
  /** Of a sweep. */
  angle_deg?: Bracket;
  points?: [[number, number], [number, number]];
  edges?: [Feature, Feature];
}
export interface ClearanceAnswer extends Verdict {
  /** Null where nothing was decided. */
  clearance: Nearest | null;
  /** With pairs: "all". */
  pairs?: Nearest[];
  /** Why the bracket is wider than was asked for. */
  wide?: string;
  scope: { time: [number, number] };
}

/** What meets where an overlap begins or ends. */
export interface Meeting {
  vertex: Feature;
  edge: Feature;
  point: [number, number];
  grazing?: true;
}
export interface OverlapInterval {
  pair: Pair;
  from: Bracket;
  to: Bracket;
  /** Of a sweep. */
  from_deg?: Bracket;
  to_deg?: Bracket;
  /** Left out where the overlap is there at the start, or at the end. */
  enter?: Meeting;
  exit?: Meeting;
}
export interface IntervalsAnswer extends Verdict {
  intervals: OverlapInterval[];
  undecided: PairAnswer[];
  scope: { time: [number, number]; touch: Touch };
}

export interface RangeAnswer extends Verdict {
  /** An end is null where it is the scene's own; all of it is null where there is none. */
  range: {
    from: Bracket | null;
    to: Bracket | null;
    from_deg?: Bracket;
    to_deg?: Bracket;
  } | null;
  around: number;
  /** The overlaps that end the range. */
  before?: OverlapInterval;
  after?: OverlapInterval;
  scope: { time: [number, number]; touch: Touch };
}

/** One pair's first instant closer than the clearance: a vertex and an edge, or two vertices. */
export interface PairMargin {
  bodies: Pair;
  outcome: MarginOutcome;
  t?: Bracket;
  grazing?: true;
  vertex?: Feature;
  edge?: Feature;
  other_vertex?: Feature;
  /** Between these points, on these edges. */
  distance?: number;
  points?: [[number, number], [number, number]];
  edges?: [Feature, Feature];
  free_until?: number;
  reason?: string;
}
/** "contact": closer than the clearance from `t` on; "closer_at_start", "overlap_at_start": closer, or
 * overlapping, at the start. */
export interface MarginAnswer extends Omit<Verdict, "outcome"> {
  outcome: MarginOutcome;
  clearance: number;
  t?: Bracket;
  pair?: Pair;
  /** Of `pair`. */
  first?: PairMargin;
  also?: PairMargin[];
  /** With pairs: "all". */
  pairs?: PairMargin[];
  free_until?: number;
  scope: { time: [number, number]; touch: Touch };
}

export interface DistanceCurve {
  /** Null: the least distance of all pairs. */
  pair: Pair | null;
  /** `settled`: the bracket is as narrow as was asked for, or of curves, as can be; `wide`: why it is wider. */
  largest: {
    lo: number;
    hi: number;
    t: number;
    settled: boolean;
    wide?: string;
  };
  /** Instant, and the bracket of the distance. */
  instants: [t: number, lo: number, hi: number][];
  /** From, to, and the bracket that the distance does not leave meanwhile. */
  stretches: [from: number, to: number, lo: number, hi: number][];
}
export interface ProfileAnswer extends Verdict {
  profile: DistanceCurve[];
  scope: { time: [number, number] };
}

/** A vertex that reaches an edge at the end of the travel. */
export interface Reach {
  vertex: Feature;
  edge: Feature;
}
/** Directions from one bound to the other, counterclockwise; `point`: one direction only. */
export interface DirectionArc {
  from_deg: Bracket;
  to_deg: Bracket;
  point: boolean;
  /** What bounds the arc: two vertices in line, or what the travel reaches. */
  from_vertices?: [Feature, Feature];
  to_vertices?: [Feature, Feature];
  from_reach?: Reach;
  to_reach?: Reach;
}
export interface FreeDirections {
  body: string;
  /** Every direction is free. */
  all: boolean;
  directions: DirectionArc[];
}
export interface RemovalStep {
  body: string;
  direction_deg: number;
  within: DirectionArc;
}
/** A point p of the body, where it stands at the start, is at R (p - pivot) + pivot + (x, y), R the turn by `deg`. */
export interface WayPoint {
  x: number;
  y: number;
  deg: number;
}
/** One body taken away along a way on which it may turn; between two points, all three numbers change evenly. */
export interface RemovalWay {
  body: string;
  pivot: Point;
  points: WayPoint[];
}
interface AnySeparation extends Omit<Verdict, "outcome"> {
  outcome: "free" | "locked" | "overlap_at_start" | "undecided" | "untested";
  /** Bodies that overlap at the start. */
  pair?: Pair;
  /** Why ends are enclosed less narrowly than to 1e-7 degrees. */
  wide?: string;
  /** With `turns`: in which order bodies leave along which ways, all proved free. */
  ways?: RemovalWay[];
  /** With `turns`: bodies that are left, and of which it is not known whether there is a way. */
  unsure?: string[];
  /** With `turns`: boundaries lie within this of those meant; 0 if bodies are drawn where they stand. */
  rounded?: number;
  /** With `turns` and `scene`: the bodies as they leave. */
  scene?: Scene;
}
/** In which directions the second body leaves the first one. */
export interface SeparationOfTwo extends AnySeparation, FreeDirections {
  bodies?: undefined;
  order?: undefined;
  /** With `turns`: bodies that no way leads out, of any shape. */
  stuck?: string[];
}
export interface SeparationOfMany extends AnySeparation {
  body?: undefined;
  all?: undefined;
  directions?: undefined;
  bodies: FreeDirections[];
  /** In which they come apart, one after the other. */
  order: RemovalStep[];
  /** Bodies that are left; with `turns`, those that no way leads out, of any shape. */
  stuck: string[];
}
export type SeparationAnswer = SeparationOfTwo | SeparationOfMany;

export interface EnvelopeCell {
  state: "free" | "colliding" | "undecided";
  /** By joint. */
  lo: number[];
  hi: number[];
  pair?: Pair;
}
export interface EnvelopeAnswer {
  id?: Id;
  outcome: Outcome;
  joints: { name: string; range: Bracket }[];
  /** A combination at which bodies overlap. */
  witness: { values: Record<string, number>; pair: Pair } | null;
  /** Shares of all combinations. */
  free: number;
  colliding: number;
  undecided: number;
  tolerance: number;
  reason?: string;
  cells?: EnvelopeCell[];
  coverage: Coverage;
}

/** Values of joints by their names. */
export type JointValues = Record<string, number>;
export interface PathAnswer {
  id?: Id;
  outcome: "path" | "none" | "undecided" | "untested";
  /** Of a path: from the start to the goal; all joints move evenly between two of them. */
  waypoints?: JointValues[];
  /** Of an undecided answer: the middle of a cell that would connect the start and the goal, and its sides. */
  tight?: { values: JointValues; size: JointValues; pair: Pair };
  /** Only translations were left, and exact signs decided. */
  exact: boolean;
  touch: "open" | "closed";
  clearance?: number;
  tolerance: number;
  cell_count: number;
  reason?: string;
  cells?: EnvelopeCell[];
  coverage: Coverage;
}

/** What taut refuses, or cannot decide. */
export class TautError extends Error {
  kind: "input" | "undecided" | "internal";
  /** Where in the scene. */
  place: string;
  problem: string;
  /** What to do about it; may be empty. */
  hint: string;
}

/** An extreme of a function of time: in [lo, hi], and taken at t. */
export interface Extreme {
  lo: number;
  hi: number;
  t: number;
}

/** What a joint of a mechanism does; values are 0 in the drawn pose. */
export interface JointRange {
  joint: string;
  bodies: [string, string];
  unit: "degrees" | "length";
  least: Extreme;
  greatest: Extreme;
}

/** The angle at which two links meet at a pin, in degrees, at most 90. */
export interface TransmissionAngle {
  joint: string;
  links: [string, string];
  least: Extreme;
  greatest: Extreme;
}

/** Of swept(): rings of [x, y], outlines counterclockwise, holes clockwise. */
export interface SweptRegion {
  body: string;
  tolerance: number;
  area: number;
  lock?: Lock;
  parts: { outline: [number, number][]; holes?: [number, number][][] }[];
}

export interface MechanismAnswer {
  outcome: "moves" | "locked" | "undecided";
  reason?: string;
  mobility: number;
  loops: number;
  joints: JointRange[];
  transmission: TransmissionAngle[];
  lock?: Lock;
  /** All joints' values, each as [lo, hi], at the instants that were asked for. */
  instants?: { t: number; values: [number, number][] }[];
  scope: { time: [number, number] };
}

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
