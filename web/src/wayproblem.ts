// Problems about ways: joints, a start and a goal, as `taut path` reads them; and such a problem made of a scene.
import type { Body, Feature, Heights, Part, Pose, Ring, Scene } from "./engine";
import { Figure, placed } from "./figure";
import { placementOf, type LinkedBody } from "./linkage";
import { product, seenFrom } from "./motions";
import { familyOf, isCurved, isPath, listOf, partsOf } from "./shapes";

export interface WayJoint {
  name: string;
  range: [number, number];
  periodic: boolean;
}

/** What the library reads in a problem: see problem_text() in wasm/problem.hpp. */
export interface ReadProblem {
  joints: WayJoint[];
  start: number[];
  goal: ([number, number] | null)[] | "outside";
  bodies: LinkedBody[];
  /** The bodies at rest at the start. */
  scene: Scene;
}

/** The text of a problem, as far as it is changed here. */
export interface ProblemFile {
  format: "taut-scene/1";
  joints: Record<string, [number, number]>;
  periodic?: string[];
  bodies: unknown[];
  ignore?: [string, string][];
  start: Record<string, number>;
  goal: Record<string, number | [number, number]> | "outside";
}

export const isProblem = (text: string): boolean => /"joints"\s*:/.test(text) && /"goal"\s*:/.test(text);

/** What `taut path --json` prints, as far as it is shown. */
export interface WayAnswer {
  outcome: "path" | "none" | "undecided" | "untested";
  waypoints?: Record<string, number>[];
  /** Of a way that was made short: its length, and what no way is shorter than. */
  length?: { way: number; shortest_at_least: number };
  tight?: {
    values: Record<string, number>;
    pair: [string, string];
    features: { vertex: Feature; edge: Feature; distance: number }[];
  };
  exact: boolean;
  cell_count: number;
  reason?: string;
}

export interface FoundWay {
  answer: WayAnswer;
  /** The bodies on their way. */
  scene: Scene | null;
}

/** One problem: where it starts and ends can be changed. */
export class WayProblem {
  readonly start: number[];
  /** Where the outline of the goal is drawn: of a goal that leaves room, one place in it. */
  readonly goal: number[];
  /** The goal as the problem has it, until it is moved. */
  private goalMoved = false;

  constructor(
    readonly file: ProblemFile,
    readonly read: ReadProblem,
    public outside = false,
  ) {
    this.outside ||= read.goal === "outside";
    this.start = [...read.start];
    this.goal = read.joints.map((_, k) => {
      const range = read.goal === "outside" ? null : read.goal[k];
      return range ? (range[0] + range[1]) / 2 : read.start[k];
    });
  }

  moveGoal(): void {
    this.goalMoved = true;
    this.outside = false;
  }

  /** For the library. */
  text(): string {
    const valuesOf = (values: number[]): Record<string, number> =>
      Object.fromEntries(this.read.joints.map(({ name }, k) => [name, values[k]]));
    const goal = this.outside
      ? "outside"
      : this.goalMoved || this.file.goal === "outside"
        ? valuesOf(this.goal)
        : this.file.goal;
    return JSON.stringify({ ...this.file, start: valuesOf(this.start), goal });
  }

  /** Bodies that follow joints, and those that hang on them. */
  movers(): number[] {
    const { bodies } = this.read;
    const moves = (b: number): boolean =>
      (bodies[b].motion?.length ?? 0) > 0 || (bodies[b].parent !== undefined && moves(bodies[b].parent!));
    return bodies.flatMap((_, b) => (moves(b) ? [b] : []));
  }

  /** Of these, those on which nothing hangs. */
  ends(): number[] {
    const { bodies } = this.read;
    return this.movers().filter((b) => !bodies.some(({ parent }) => parent === b));
  }

  pose(body: number, values: number[]): Pose {
    return placementOf(this.read.bodies, this.read.bodies[body], values, this.read.joints);
  }

  /** The joint that turns a body which also goes anywhere; -1 if it has none. */
  turnOf(body: number): number {
    const motion = this.read.bodies[body].motion ?? [];
    const turn = motion.find(({ pivot }) => pivot);
    return turn && motion.length > 1 ? turn.joint : -1;
  }

  /** What the body turns about, in its own coordinates. */
  pivotOf(body: number): [number, number] {
    return this.read.bodies[body].motion?.find(({ pivot }) => pivot)?.pivot ?? [0, 0];
  }

  /** Joints that a drag changes: of a body that goes anywhere, those along which it goes; else all that move it. */
  dragged(body: number): number[] {
    const { bodies } = this.read;
    const all = [];
    for (let b: number | undefined = body; b !== undefined; b = bodies[b].parent) all.push(...(bodies[b].motion ?? []));
    const slides = all.filter(({ direction }) => direction);
    const used = slides.length > 1 ? slides : all;
    return [...new Set(used.map(({ joint }) => joint))];
  }

  /** Values at which the body's point (u, v) is as near to a place as it comes, from these values on. */
  reaching(body: number, [u, v]: [number, number], to: [number, number], values: number[]): number[] {
    const joints = this.dragged(body);
    let now = [...values];
    const at = (those: number[]): [number, number] => placed(this.pose(body, those), u, v);
    const far = (those: number[]): number => Math.hypot(at(those)[0] - to[0], at(those)[1] - to[1]);
    for (let round = 0; round < 12; ++round) {
      const next = this.step(joints, now, at, to);
      if (!(far(next) < far(now))) break;
      now = next;
    }
    for (const k of joints) now[k] = this.rounded(k, now[k]);
    return now;
  }

  /** To about a millionth of the range, and within it: short numbers in files. */
  private rounded(joint: number, value: number): number {
    const [lo, hi] = this.read.joints[joint].range;
    const unit = 10 ** Math.floor(Math.log10(hi - lo) - 5);
    return Math.min(hi, Math.max(lo, tidy(Math.round(value / unit) * unit)));
  }

  /** A step of Gauss and Newton, damped (Levenberg), with the values kept within their ranges. */
  private step(
    joints: number[],
    values: number[],
    at: (v: number[]) => [number, number],
    to: [number, number],
  ): number[] {
    const [x, y] = at(values);
    const columns = joints.map((k) => {
      const [lo, hi] = this.read.joints[k].range;
      const h = (hi - lo) * 1e-6;
      const [px, py] = at(values.map((value, j) => (j === k ? value + h : value)));
      return [((px - x) / h) * (hi - lo), ((py - y) / h) * (hi - lo)];
    });
    // In shares of the ranges, so that lengths and angles weigh alike: J^T (J J^T + d)^-1 r has a matrix of 2 by 2.
    const sum = (a: number, b: number): number => columns.reduce((s, c) => s + c[a] * c[b], 0);
    const damping = 1e-6 * (sum(0, 0) + sum(1, 1)) + 1e-300;
    const [a, b, d] = [sum(0, 0) + damping, sum(0, 1), sum(1, 1) + damping];
    const [rx, ry] = [to[0] - x, to[1] - y];
    const det = a * d - b * b;
    const [wx, wy] = [(d * rx - b * ry) / det, (a * ry - b * rx) / det];
    const out = [...values];
    joints.forEach((k, i) => {
      const [lo, hi] = this.read.joints[k].range;
      out[k] = Math.min(hi, Math.max(lo, values[k] + (columns[i][0] * wx + columns[i][1] * wy) * (hi - lo)));
    });
    return out;
  }
}

type AnyPart = Ring | Part;

/** The body as it is where `pose` has it. */
function movedBody(body: Body, pose: Pose): Omit<Body, "motion" | "relative_to"> {
  const still = pose.x === 0 && pose.y === 0 && pose.c === 1 && pose.s === 0;
  const ringOf = (ring: Ring): Ring => (still ? ring : ring.map(([u, v]) => placed(pose, u, v)));
  const parts = listOf(body).map((part): AnyPart => {
    if (isPath(part)) throw new Error("curves");
    if (Array.isArray(part)) return ringOf(part);
    return { ...part, outline: ringOf(part.outline), ...(part.holes ? { holes: part.holes.map(ringOf) } : {}) };
  });
  const z: { z?: Heights } = body.z ? { z: body.z } : {};
  return parts.length === 1 && Array.isArray(parts[0])
    ? { name: body.name, polygon: parts[0], ...z }
    : { name: body.name, parts, ...z };
}

/**
 * May body `mover` get from where it is among `start` to where it is among `goal`, while the others stay as at the
 * start? It may go as far as there is anything, and around that, and turn as it likes, if it may. Bodies that hang on it go
 * along. Null if a body has curves, which ways have none of.
 */
export function problemOf(scene: Scene, mover: number, start: Pose[], goal: Pose, turns: boolean): ProblemFile | null {
  if (scene.bodies.some(isCurved)) return null;
  const family = familyOf(scene, mover);
  const { name } = scene.bodies[mover];
  const pivot = new Figure(partsOf(scene.bodies[mover])[0][0]).centre;
  // Its own outline turns with it: without turns it is as it is at the start.
  const own: Pose = { x: 0, y: 0, c: start[mover].c, s: start[mover].s };
  const base = turns ? { x: 0, y: 0, c: 1, s: 0 } : own;
  const bodies = scene.bodies.map((body, b) => {
    if (b === mover) return { ...movedBody(body, base), motion: { free: freeMotion(turns, pivot) } };
    if (!family.has(b)) return movedBody(body, start[b]);
    return { ...movedBody(body, product(base, seenFrom(start[mover], start[b]))), relative_to: name };
  });
  const values = (pose: Pose): Record<string, number> => {
    const of = turns ? pose : { ...pose, c: own.c, s: own.s };
    const [px, py] = placed(of, ...pivot);
    const [qx, qy] = turns ? pivot : placed(own, ...pivot);
    const deg = (Math.atan2(pose.s, pose.c) * 180) / Math.PI;
    return { x: tidy(px - qx), y: tidy(py - qy), ...(turns ? { turn: tidy(deg) } : {}) };
  };
  const [from, to] = [values(start[mover]), values(goal)];
  return {
    format: "taut-scene/1",
    joints: { ...room(scene, mover, family, start, [from, to]), ...(turns ? { turn: [-180, 180] } : {}) },
    ...(turns ? { periodic: ["turn"] } : {}),
    bodies,
    ...(scene.ignore ? { ignore: scene.ignore } : {}),
    start: from,
    goal: to,
  };
}

const freeMotion = (turns: boolean, pivot: [number, number]): Record<string, unknown> =>
  turns ? { x: "x", y: "y", deg: "turn", pivot } : { x: "x", y: "y" };

const tidy = (v: number): number => Number(v.toPrecision(12));

/** Ranges of x and y in which the body gets around all others, and which hold what is there already. */
function room(
  scene: Scene,
  mover: number,
  family: Set<number>,
  start: Pose[],
  ends: Record<string, number>[],
): Record<string, [number, number]> {
  const all: [number, number][] = [];
  let reach = 0;
  scene.bodies.forEach((body, b) => {
    const points = partsOf(body)
      .flat(2)
      .map(([u, v]) => placed(start[b], u, v));
    if (!family.has(b)) return all.push(...points);
    const [cx, cy] = placed(start[mover], ...new Figure(partsOf(scene.bodies[mover])[0][0]).centre);
    return (reach = points.reduce((most, [x, y]) => Math.max(most, Math.hypot(x - cx, y - cy)), reach));
  });
  const centre = placed(start[mover], ...new Figure(partsOf(scene.bodies[mover])[0][0]).centre);
  const range = (axis: 0 | 1, name: "x" | "y"): [number, number] => {
    const shift = ends[0][name] - centre[axis];
    const values = [...all.map((p) => p[axis] + shift), ...ends.map((end) => end[name])];
    const [lo, hi] = values.reduce(([a, b], v) => [Math.min(a, v), Math.max(b, v)], [Infinity, -Infinity]);
    const unit = 10 ** Math.floor(Math.log10(Math.max(hi - lo, reach, 1e-9)) - 1);
    return [tidy(Math.floor((lo - 1.1 * reach) / unit) * unit), tidy(Math.ceil((hi + 1.1 * reach) / unit) * unit)];
  };
  return { x: range(0, "x"), y: range(1, "y") };
}
