// Answers are as `taut check --json` and the like print them: docs/answers.md and docs/questions.md of taut say more about
// each member.

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
  /** "open": no way without overlap. "closed": none without touching. */
  touch: Touch;
  /** Ways that keep this distance are meant. */
  clearance?: number;
  /** Of translations: the number of edges of a closed polygon that no way crosses. There is no partition then. */
  barrier?: number;
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
  /** Of a scene with clearances: what the pair is to keep, as in the scene. */
  margin?: number | number[];
  origin?: number;
  /** What a margin that changes is at the end of `t`, or at `free_until`. */
  margin_at?: number;
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
  /** Those of the scene, for which `clearance` does not count. */
  clearances?: PairClearance[];
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
  /** Of an undecided cell, instead of the pair: a mechanism may lock in it, or does not get there. */
  may_lock?: boolean;
  /** Where there is no way: cells that were not shown to collide lead here from the start. */
  reached?: boolean;
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
  /** That share of `undecided` at which a mechanism may lock, or to which it does not get; if there is one. */
  may_lock?: number;
  /**
   * Cells are decided for one pose of the mechanism. Other ways without a lock, through undecided cells, may lead to
   * another pose at the same values; of several loops that several drives move together.
   */
  other_poses?: boolean;
  tolerance: number;
  reason?: string;
  cells?: EnvelopeCell[];
  coverage: Coverage;
}

/** Values of joints by their names. */
export type JointValues = Record<string, number>;
/** A vertex and an edge that come together where it is tight; their distance is rounded. */
export interface TightFeatures {
  vertex: Feature;
  edge: Feature;
  distance: number;
}
export interface PathAnswer {
  id?: Id;
  outcome: "path" | "none" | "undecided" | "untested";
  /** Of a path: from the start to the goal; all joints move evenly between two of them. */
  waypoints?: JointValues[];
  /**
   * Of an undecided answer: values in a cell that would connect the start and the goal, at which the bodies are likely to
   * have most room, and the sides of the cell. Of the pair, the vertex and the edge that are nearest to each other there,
   * and the nearest ones that push the other way, if there are some.
   */
  /** Of a path, if it was to be short: no way is shorter than shortest_at_least. Without weights: of what moves itself. */
  length?: { way: number; shortest_at_least: number; weights?: JointValues };
  tight?: { values: JointValues; size: JointValues; pair: Pair; features: TightFeatures[] };
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

/** A stretch of the time of a follower's contacts. */
export interface FollowStretch {
  t: [number, number];
  /**
   * "carried": `touching` holds the follower, all of it, and nothing else does, at all instants. "low": the lift is below
   * 0 at all of them. "change": contacts change here, in no longer than the tolerance. "open": longer, and not decided.
   */
  state: "carried" | "low" | "change" | "open";
  /** Encloses the lifts; 0 stands for lower ones. */
  lift: [number, number];
  /** It is proved to be one change, of the contacts before to those after. */
  once?: true;
  /** The lift is proved to jump here. */
  jumps?: true;
  /** Of "change" and "open": all that may touch. */
  touching: { vertex: Feature; edge: Feature }[];
}

/** Of follow(): instants at which nothing reaches up to where the scene has the follower are left out. */
export interface FollowAnswer {
  body: string;
  instants: number;
  lifts: { t: [number, number]; lift: [number, number]; vertex: Feature; edge: Feature }[];
  /** With contacts: how long a change may be, as a share of the scene's time. */
  tolerance?: number;
  /** With contacts: stretches of time in order, from the scene's start to its end. */
  contacts?: FollowStretch[];
  /** Why the first open one of these is. */
  contacts_reason?: string;
  /** Stretches of time whose instants are not decided; absent if there are none. */
  undecided?: [number, number][];
  /** Why the first of these is not. */
  reason?: string;
  geometry?: { tolerance: number; segments: number };
  /** Of pairs with the follower. */
  coverage: Coverage;
  scope: { time: [number, number]; touch: Touch };
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
