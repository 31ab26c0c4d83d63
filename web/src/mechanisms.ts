// Mechanisms in scenes, and what moving them by hand asks of the time.
import type { Pose, Scene } from "./engine";
import { local, placed } from "./figure";

/** Do joints say how the body moves? */
export function isJoined(scene: Scene, body: number): boolean {
  const { name } = scene.bodies[body];
  return Object.values(scene.mechanism?.joints ?? {}).some((joint) =>
    (joint.revolute ?? joint.slide ?? []).includes(name),
  );
}

/** Where a joint names the body, it names it anew. */
export function renamedInJoints(scene: Scene, before: string, after: string): void {
  if (!scene.mechanism) return;
  const name = (n: string): string => (n === before ? after : n);
  scene.mechanism.ground = name(scene.mechanism.ground);
  for (const joint of Object.values(scene.mechanism.joints)) {
    if (joint.revolute) joint.revolute = joint.revolute.map(name);
    if (joint.slide) joint.slide = joint.slide.map(name);
  }
}

/** Instants at which a dragged point is looked at first. */
const samples = 180;

/** The poses of all bodies over a time, made once. */
export class SampledMotion {
  private readonly poses: Pose[][];

  constructor(
    readonly posesAt: (t: number) => Pose[],
    readonly start: number,
    readonly end: number,
  ) {
    this.poses = Array.from({ length: samples + 1 }, (_, k) => posesAt(this.instant(k)));
  }

  instant(k: number): number {
    if (k >= samples) return this.end;
    return this.start + ((this.end - this.start) * Math.max(0, k)) / samples;
  }

  /** The sample that is nearest to the instant. */
  sampleAt(t: number): number {
    const share = this.end > this.start ? (t - this.start) / (this.end - this.start) : 0;
    return Math.round(samples * Math.min(1, Math.max(0, share)));
  }

  /** Where the samples have a point of a body. */
  pathOf(body: number, [u, v]: [number, number]): [number, number][] {
    return this.poses.map((poses) => placed(poses[body], u, v));
  }
}

/** A point of a body is dragged: which instant brings it nearest to the pointer? */
export class LinkDrag {
  private readonly point: [number, number];
  private readonly path: [number, number][];

  /** The point is at `from` in the world at time `now`; an instant is known when it is so to `fine` of the way. */
  constructor(
    private readonly motion: SampledMotion,
    private readonly body: number,
    from: [number, number],
    now: number,
    private readonly fine: number,
  ) {
    this.point = local(motion.posesAt(now)[body], ...from);
    this.path = motion.pathOf(body, this.point);
  }

  /** How far from its first place the point comes. */
  get reach(): number {
    return Math.max(...this.path.map((p) => distance(p, this.path[0])));
  }

  /**
   * The instant for the pointer at `to`. Of the places where the way of the point is near, the one that is reached from
   * `now` without going away from the pointer counts, unless another one is nearer by `slack`.
   */
  nearest(to: [number, number], now: number, slack: number): number {
    const far = this.path.map((p) => distance(p, to));
    let near = this.motion.sampleAt(now);
    for (const step of [1, -1]) while (far[near + step] < far[near]) near += step;
    const best = far.indexOf(Math.min(...far));
    return this.refined(to, far[near] <= far[best] + slack ? near : best);
  }

  /** Around sample k the distance has one minimum, as far as samples show: golden sections close in on it. */
  private refined(to: [number, number], k: number): number {
    const at = (t: number): { t: number; place: [number, number]; far: number } => {
      const place = placed(this.motion.posesAt(t)[this.body], ...this.point);
      return { t, place, far: distance(place, to) };
    };
    const golden = (Math.sqrt(5) - 1) / 2;
    const between = (a: number, b: number): ReturnType<typeof at> => at(b - golden * (b - a));
    // The minimum may be at an end of the time.
    let [lo, hi] = [at(this.motion.instant(k - 1)), at(this.motion.instant(k + 1))];
    let [a, b] = [between(lo.t, hi.t), between(hi.t, lo.t)];
    while (distance(lo.place, hi.place) > this.fine && lo.t < a.t && a.t < b.t && b.t < hi.t) {
      if (a.far <= b.far) {
        [b, hi] = [a, b];
        a = between(lo.t, hi.t);
      } else {
        [lo, a] = [a, b];
        b = between(hi.t, lo.t);
      }
    }
    return [lo, a, b, hi].reduce((best, next) => (next.far < best.far ? next : best)).t;
  }
}

const distance = (a: [number, number], b: [number, number]): number => Math.hypot(a[0] - b[0], a[1] - b[1]);
