/** A scene in the format taut-scene/1, as an object or as JSON text: see docs/scenes.md of taut. Scenes that name files
 * cannot be read here. */
export type Scene = string | object;
/** Two numbers that certainly enclose an instant. */
export type Bracket = [number, number];
export type Outcome = "free" | "contact" | "overlap_at_start" | "undecided";

export interface Options {
  /** What counts as a collision: overlap ("open", the default), or touching, too. */
  touch?: "open" | "closed";
  engine?: "kinetic" | "spacetime" | "both" | "either" | "usual";
  /** Stop with "undecided" after so many seconds. */
  maxSeconds?: number;
  /** Stop with "undecided" after so many events of the kinetic engine. */
  maxEvents?: number;
  /** Every pair's own first contact. */
  allPairs?: boolean;
}

export interface Feature {
  body: string;
  index?: number;
  [more: string]: unknown;
}

/** As `taut check --json` prints it: see docs/answers.md of taut. */
export interface Answer {
  outcome: Outcome;
  /** Of a contact: when. */
  t?: Bracket;
  point?: [number, number];
  free_until?: number;
  reason?: string;
  [more: string]: unknown;
}

/** `valid` is null where maxSeconds ended the work. */
export interface Verified {
  valid: boolean | null;
  reason?: string;
  outcome?: Outcome;
  free_until?: number;
  t?: Bracket;
  touch?: "open" | "closed";
  /** Of what the proof is about. */
  scene_sha256?: string;
  [more: string]: unknown;
}

/** As `taut clearance --json`, `taut intervals --json`, `taut range --json` and the like print them. */
export interface Report {
  [key: string]: unknown;
}

/** The first contact, or that there is none. Throws TautError if the scene is not valid. */
export function check(scene: Scene, options?: Options): Promise<Answer>;
/** The same with a proof, which is null where nothing was proved. */
export function prove(scene: Scene, options?: Options): Promise<{ answer: Answer; log: Uint8Array | null }>;
/** Checks a proof, whoever made it. */
export function verify(scene: Scene, log: Uint8Array, options?: Pick<Options, "maxSeconds">): Promise<Verified>;
/** How close bodies come, as a certain bracket no wider than `tolerance` (1e-9) times the distance. */
export function clearance(
  scene: Scene,
  options?: Pick<Options, "maxSeconds" | "allPairs"> & { tolerance?: number },
): Promise<Report>;
/** All intervals of time in which bodies overlap. */
export function intervals(scene: Scene, options?: Pick<Options, "touch" | "maxSeconds">): Promise<Report>;
/** How far the bodies can go from the instant `from` without overlapping, both ways. */
export function range(scene: Scene, from: number, options?: Pick<Options, "touch" | "maxSeconds">): Promise<Report>;

/** Do bodies keep this distance, in the scene's units, and if not, when and where do they first come closer? */
export function checkClearance(
  scene: Scene,
  clearance: number,
  options?: Pick<Options, "maxSeconds" | "allPairs">,
): Promise<Report>;
/** The distance over time in certain brackets: at `instants` (101), between them, and the greatest. */
export function distanceProfile(
  scene: Scene,
  options?: Pick<Options, "maxSeconds" | "allPairs"> & { tolerance?: number; instants?: number },
): Promise<Report>;
/** In which directions bodies come apart, and in which order. */
export function separate(scene: Scene, options?: Pick<Options, "maxSeconds">): Promise<Report>;

/** What taut refuses, or cannot decide. */
export class TautError extends Error {
  kind: "input" | "undecided" | "internal";
  /** Where in the scene. */
  place: string;
  problem: string;
  /** What to do about it; may be empty. */
  hint: string;
}
