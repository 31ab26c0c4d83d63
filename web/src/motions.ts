// Motions as people handle them: poses at certain instants, with steady motion in between; and cutting a motion short
// to go on differently.
import type { Body, Motion, Pose } from "./engine";
import { local, placed } from "./figure";

/** The body is moved by (x, y) and turned by `angle` radians about its pivot, at time t. */
export interface Keyframe {
  t: number;
  x: number;
  y: number;
  angle: number;
}

/** Steady motion from an instant on. */
export interface Velocity {
  x: number;
  y: number;
  /** Radians per unit of time. */
  spin: number;
}

export function piecesOf(body: Body): Motion[] {
  if (!body.motion) return [];
  return Array.isArray(body.motion) ? body.motion : [body.motion];
}

/** What all pieces of the motion turn about, in the body's coordinates; null if they differ in it. */
export function pivotOf(body: Body): [number, number] | null {
  const turning = piecesOf(body).filter((piece) => piece.rotation);
  const [x, y] = turning[0]?.pivot ?? [0, 0];
  return turning.every(({ pivot = [0, 0] }) => pivot[0] === x && pivot[1] === y) ? [x, y] : null;
}

/** By how much a pose moves the pivot. */
function shift(pose: Pose, [u, v]: [number, number]): [number, number] {
  const [x, y] = placed(pose, u, v);
  return [x - u, y - v];
}

/** The pose of a keyframe. */
export function poseOf(k: Keyframe, [u, v]: [number, number]): Pose {
  const c = Math.cos(k.angle);
  const s = Math.sin(k.angle);
  return { x: k.x + u - (c * u - s * v), y: k.y + v - (s * u + c * v), c, s };
}

const value = (coefficients: number[] | undefined, t: number): number =>
  (coefficients ?? []).reduceRight((sum, c) => sum * t + c, 0);

function angleOf(piece: Motion): number[] | null {
  if (!piece.rotation) return [];
  const { angle } = piece.rotation as { angle?: number[] };
  return Array.isArray(angle) ? angle : null;
}

/** Where a parent at `parent` has a body that is at `pose` in the world. */
export function seenFrom(parent: Pose, pose: Pose): Pose {
  const [x, y] = local(parent, pose.x, pose.y);
  return { x, y, c: parent.c * pose.c + parent.s * pose.s, s: parent.c * pose.s - parent.s * pose.c };
}

/** Where a body is in the world that a parent at `parent` has at `own`. */
export function product(parent: Pose, own: Pose): Pose {
  const [x, y] = placed(parent, own.x, own.y);
  return { x, y, c: parent.c * own.c - parent.s * own.s, s: parent.c * own.s + parent.s * own.c };
}

/** The keyframes of a motion that is carried along by `by`: each pose is multiplied by it. */
export function carried(frames: Keyframe[], pivot: [number, number], by: Pose): Keyframe[] {
  const turn = Math.atan2(by.s, by.c);
  return frames.map((k) => {
    const [dx, dy] = shift(product(by, poseOf(k, pivot)), pivot);
    return { t: k.t, x: tidy(dx), y: tidy(dy), angle: tidy(k.angle + turn) };
  });
}

/** Without the noise of rounding, for files. */
const tidy = (v: number): number => Number(v.toPrecision(12));

/** The motion as keyframes at its joints, or null if it is not steady between them, or jumps. */
export function keyframesOf(body: Body, start: number, end: number): Keyframe[] | null {
  const pieces = piecesOf(body);
  if (pieces.length === 0) return [{ t: start, x: 0, y: 0, angle: 0 }];
  if (!pivotOf(body)) return null;
  const out: Keyframe[] = [];
  let from = start;
  for (let i = 0; i < pieces.length; ++i) {
    const piece = pieces[i];
    const angle = angleOf(piece);
    if (!angle || piece.orbit || [piece.x, piece.y, angle].some((c) => (c?.length ?? 0) > 2)) return null;
    const to = i + 1 < pieces.length ? Math.min(piece.until ?? end, end) : end;
    if (to <= from && !(i === 0 && start === end)) continue;
    const at = (t: number): Keyframe => {
      const since = t - (piece.origin ?? 0);
      return { t, x: value(piece.x, since), y: value(piece.y, since), angle: value(angle, since) };
    };
    const first = at(from);
    const last = out[out.length - 1];
    const size = Math.abs(first.x) + Math.abs(first.y) + 1;
    if (last && Math.hypot(last.x - first.x, last.y - first.y) > 1e-6 * size) return null;
    if (last && Math.abs(last.angle - first.angle) > 1e-6) return null;
    if (!last) out.push(first);
    const rests = [piece.x, piece.y, angle].every((c) => (c?.length ?? 0) < 2);
    if (!(rests && pieces.length === 1)) out.push(at(to));
    from = to;
  }
  return out;
}

/** Without trailing zeros; undefined if nothing is left. */
function trimmed(coefficients: number[]): number[] | undefined {
  const out = [...coefficients];
  while (out.length > 0 && out[out.length - 1] === 0) out.pop();
  return out.length > 0 ? out.map((c) => (Object.is(c, -0) ? 0 : c)) : undefined;
}

function steady(at: Keyframe, velocity: Velocity, pivot: [number, number], until?: number): Motion {
  const piece: Motion = {};
  const x = trimmed([at.x, velocity.x]);
  const y = trimmed([at.y, velocity.y]);
  const angle = trimmed([at.angle, velocity.spin]);
  if (x) piece.x = x;
  if (y) piece.y = y;
  if (angle) piece.rotation = { angle };
  if (angle && (pivot[0] !== 0 || pivot[1] !== 0)) piece.pivot = pivot;
  if (at.t !== 0 && [x, y, angle].some((c) => (c?.length ?? 0) > 1)) piece.origin = at.t;
  if (until !== undefined) piece.until = until;
  return piece;
}

export function velocityBetween(a: Keyframe, b: Keyframe): Velocity {
  const d = b.t - a.t;
  return d > 0 ? { x: (b.x - a.x) / d, y: (b.y - a.y) / d, spin: (b.angle - a.angle) / d } : { x: 0, y: 0, spin: 0 };
}

export function motionOf(keyframes: Keyframe[], pivot: [number, number] = [0, 0]): Body["motion"] {
  if (keyframes.length === 1) {
    const piece = steady(keyframes[0], { x: 0, y: 0, spin: 0 }, pivot);
    return Object.keys(piece).length > 0 ? piece : null;
  }
  const pieces: Motion[] = [];
  for (let i = 0; i + 1 < keyframes.length; ++i) {
    const last = i + 2 === keyframes.length;
    const velocity = velocityBetween(keyframes[i], keyframes[i + 1]);
    pieces.push(steady(keyframes[i], velocity, pivot, last ? undefined : keyframes[i + 1].t));
  }
  return pieces.length === 1 ? pieces[0] : pieces;
}

/** The velocity of the pivot, and the spin, right after t, by differences. */
export function velocityAt(poses: (t: number) => Pose, pivot: [number, number], t: number, end: number): Velocity {
  const d = (end - t || Math.abs(t) || 1) * 1e-6;
  const a = poses(t);
  const b = poses(t + d);
  const from = shift(a, pivot);
  const to = shift(b, pivot);
  const turn = Math.atan2(a.c * b.s - a.s * b.c, a.c * b.c + a.s * b.s);
  return { x: (to[0] - from[0]) / d, y: (to[1] - from[1]) / d, spin: turn / d };
}

/** As before until t, where the body is at `pose`, and steadily on from there. */
export function continued(body: Body, pose: Pose, t: number, start: number, velocity: Velocity): Body["motion"] {
  const before = piecesOf(body).filter((_, i, all) => i === 0 || (all[i - 1].until ?? Infinity) < t);
  const angle = unwound(body, pose, t);
  const pivot = pivotOf(body) ?? [0, 0];
  const [x, y] = shift(pose, pivot);
  const next = steady({ t, x, y, angle }, velocity, pivot);
  if (t <= start) return next;
  if (before.length === 0) before.push({});
  before[before.length - 1] = { ...before[before.length - 1], until: t };
  return [...before, next];
}

/** The angle of a pose, with the full turns that the motion has made by then, if it tells them. */
function unwound(body: Body, pose: Pose, t: number): number {
  const angle = Math.atan2(pose.s, pose.c);
  const piece = piecesOf(body).find((p) => t < (p.until ?? Infinity)) ?? piecesOf(body).at(-1);
  const counted = piece && angleOf(piece);
  if (!counted || counted.length === 0) return angle;
  return angle + 2 * Math.PI * Math.round((value(counted, t - (piece.origin ?? 0)) - angle) / (2 * Math.PI));
}

/** The whole motion moved by (dx, dy). */
export function moved(body: Body, dx: number, dy: number): Body["motion"] {
  const pieces = piecesOf(body);
  const plus = (c: number[] | undefined, d: number): number[] => [(c?.[0] ?? 0) + d, ...(c ?? []).slice(1)];
  const all: Motion[] = pieces.length > 0 ? pieces : [{}];
  const out = all.map((p) => {
    const piece: Motion = { ...p, x: plus(p.x, dx), y: plus(p.y, dy) };
    if (p.orbit) piece.orbit = { ...p.orbit, center: [p.orbit.center[0] + dx, p.orbit.center[1] + dy] };
    return piece;
  });
  return out.length === 1 ? out[0] : out;
}

/** One more keyframe at t, on the way between its neighbours; null if there is one, or t is at an end. */
export function withKeyframe(frames: Keyframe[], t: number, start: number, end: number): Keyframe[] | null {
  const all = frames.length === 1 ? [frames[0], { ...frames[0], t: end }] : [...frames];
  const after = all.findIndex((k) => k.t > t);
  if (after < 1 || t <= start || all.some((k) => k.t === t)) return null;
  const a = all[after - 1];
  const b = all[after];
  const share = (t - a.t) / (b.t - a.t);
  const between = (x: number, y: number): number => x + share * (y - x);
  all.splice(after, 0, { t, x: between(a.x, b.x), y: between(a.y, b.y), angle: between(a.angle, b.angle) });
  return all;
}

/** Eight keyframes on a motion of any form. */
export function sampled(poses: (t: number) => Pose, pivot: [number, number], start: number, end: number): Keyframe[] {
  const frames: Keyframe[] = [];
  let last = 0;
  for (let i = 0; i < 8; ++i) {
    const t = start + ((end - start) * i) / 7;
    const pose = poses(t);
    const angle = Math.atan2(pose.s, pose.c);
    // The nearest of the angles that differ by full turns.
    last = i === 0 ? angle : angle + 2 * Math.PI * Math.round((last - angle) / (2 * Math.PI));
    const [x, y] = shift(pose, pivot);
    frames.push({ t, x, y, angle: last });
  }
  return frames;
}
