// What can be taken hold of in the picture, in each of the modes: where it is, and what lies below the pointer.
import type { Camera } from "./camera";
import type { Pose, Ring, Scene } from "./engine";
import { local, placed } from "./figure";
import { isJoined } from "./mechanisms";
import { poseOf, product, type Keyframe, type Velocity } from "./motions";
import { cornerAt, partsOf, ringsWithVertices, verticesIn, type Shape } from "./shapes";

export type Mode = "look" | "shape" | "keyframes" | "drive" | "way";

/** The radius on which handles that turn something lie, in pixels. */
export const spinRadius = 46;
/** How near a handle has to be, in pixels. */
const reachOfMouse = 12;
const reachOfFinger = 24;
/** Handles of more vertices than this in view would hide the body. */
const mostHandles = 300;

/** What is being edited, as it is now. */
export interface Edited {
  readonly mode: Mode;
  /** The chosen body. */
  readonly body: number;
  readonly scene: Scene;
  /** The chosen vertex, or -1. */
  readonly vertex: number;
  poses(): Pose[];
  shapes(): Shape[];
  /** Bodies, those first that lie on top. */
  topmost(): number[];
  keyframes(): Keyframe[] | null;
  pivot(): [number, number];
  /** Of the body's motion from now on, seen from its parent. */
  velocity(): Velocity;
  /** Where the chosen body's parent is at t, or now; without a parent, the world's own frame. */
  base(t?: number): Pose;
}

export interface Handle {
  kind: "body" | "vertex" | "ghost" | "turn" | "arrow" | "spin";
  /** Of the vertex or the keyframe. */
  index: number;
  body: number;
}

export class Handles {
  private reach = reachOfMouse;

  constructor(
    private readonly edited: Edited,
    readonly camera: Camera,
  ) {}

  use(pointer: PointerEvent): void {
    this.reach = pointer.pointerType === "touch" ? reachOfFinger : reachOfMouse;
  }

  pixel(body: number, index: number): [number, number] {
    const corner = cornerAt(this.edited.scene.bodies[body], index);
    const [u, v] = corner.ring[corner.index];
    return this.camera.pixel(...placed(this.edited.poses()[body], u, v));
  }

  verticesShown(): boolean {
    let inView = 0;
    const { scene, body } = this.edited;
    const length = verticesIn(scene.bodies[body]);
    for (let i = 0; i < length && inView <= mostHandles; ++i) {
      const [x, y] = this.pixel(body, i);
      if (x > 0 && y > 0 && x < this.camera.width && y < this.camera.height) ++inView;
    }
    return inView <= mostHandles;
  }

  base(t?: number): Pose {
    return this.edited.base(t);
  }

  /** In the world, where the body's parent is then. */
  ghostPose(k: Keyframe): Pose {
    return product(this.edited.base(k.t), poseOf(k, this.edited.pivot()));
  }

  /** Poses on the way: at the keyframes, and in between where the body is carried along meanwhile. */
  way(frames: Keyframe[]): Pose[] {
    const { scene, body } = this.edited;
    const steps = scene.bodies[body].relative_to === undefined ? 1 : 16;
    return frames.flatMap((k, i) => {
      const next = frames[i + 1];
      if (!next) return [this.ghostPose(k)];
      const mix = (a: number, b: number, share: number): number => a + share * (b - a);
      return Array.from({ length: steps }, (_, n) => {
        const share = n / steps;
        return this.ghostPose({
          t: mix(k.t, next.t, share),
          x: mix(k.x, next.x, share),
          y: mix(k.y, next.y, share),
          angle: mix(k.angle, next.angle, share),
        });
      });
    });
  }

  /** The handle that turns a ghost: beside the pivot, in the direction of its x axis. */
  turn(pose: Pose): [number, number] {
    const [x, y] = this.camera.pixel(...placed(pose, ...this.edited.pivot()));
    return [x + spinRadius * pose.c, y - spinRadius * pose.s];
  }

  /** Arrows start in the middle of the body, which is in view when its origin may not be. */
  anchor(body = this.edited.body): [number, number] {
    return placed(this.edited.poses()[body], ...this.edited.shapes()[body].outline.centre);
  }

  /** How long an arrow is that stands for velocity: what the body would cover in a fifth of the time. */
  arrowTime(): number {
    const [start, end] = this.edited.scene.time;
    return Math.max(end - start, 1e-9) / 5;
  }

  arrowTip(velocity: Velocity): [number, number] {
    const [x, y] = this.camera.pixel(...this.anchor());
    const time = this.arrowTime() * this.camera.scale;
    const { c, s } = this.edited.base();
    return [x + (c * velocity.x - s * velocity.y) * time, y - (s * velocity.x + c * velocity.y) * time];
  }

  spin(velocity: Velocity): [number, number] {
    const [x, y] = this.camera.pixel(...this.anchor());
    const angle = Math.PI / 2 + velocity.spin * this.arrowTime();
    return [x + spinRadius * Math.cos(angle), y - spinRadius * Math.sin(angle)];
  }

  /** What lies below the pointer. */
  find(x: number, y: number): Handle | null {
    switch (this.edited.mode) {
      case "look":
      case "way":
        return null;
      case "shape":
        return this.findShape(x, y);
      case "keyframes":
        return this.findGhost(x, y);
      case "drive":
        return this.findArrow(x, y);
    }
  }

  /** Is the pixel within the body where it is shown? */
  covers(body: number, x: number, y: number): boolean {
    return this.inside(body, this.edited.poses()[body], x, y);
  }

  /** The edge of the chosen body that is nearest to the pixel, or -1 if none is near. */
  edgeAt(x: number, y: number): number {
    const { scene, body } = this.edited;
    let best = -1;
    let distance = this.reach;
    let first = 0;
    for (const { length } of ringsWithVertices(scene.bodies[body])) {
      for (let i = 0; i < length; ++i) {
        const ends = [i, (i + 1) % length].map((k) => this.pixel(body, first + k));
        const d = distanceToSegment([x, y], ends[0], ends[1]);
        if (d >= distance) continue;
        distance = d;
        best = first + i;
      }
      first += length;
    }
    return best;
  }

  /** To a hundredth of a pixel or so: short numbers in files. */
  rounded(v: number): number {
    const unit = 10 ** Math.floor(Math.log10(0.2 / this.camera.scale));
    return Number((Math.round(v / unit) * unit).toPrecision(12));
  }

  private findShape(x: number, y: number): Handle | null {
    const { scene, body } = this.edited;
    if (this.verticesShown()) {
      for (let i = 0; i < verticesIn(scene.bodies[body]); ++i) {
        if (this.near([x, y], this.pixel(body, i))) return { kind: "vertex", index: i, body };
      }
    }
    const below = [body, ...this.edited.topmost()].find((b) => this.covers(b, x, y));
    return below === undefined ? null : { kind: "body", index: -1, body: below };
  }

  private findGhost(x: number, y: number): Handle | null {
    const { body } = this.edited;
    const poses = (this.edited.keyframes() ?? []).map((k) => this.ghostPose(k));
    for (let i = poses.length; i-- > 0;) {
      if (this.near([x, y], this.turn(poses[i]))) return { kind: "turn", index: i, body };
    }
    // The last ghost first: where all lie on one another, it is the one that sets a body in motion.
    for (let i = poses.length; i-- > 0;) {
      if (this.inside(body, poses[i], x, y)) return { kind: "ghost", index: i, body };
    }
    return null;
  }

  private findArrow(x: number, y: number): Handle | null {
    const { scene, body } = this.edited;
    if (isJoined(scene, body)) return null;
    const velocity = this.edited.velocity();
    if (this.near([x, y], this.arrowTip(velocity))) return { kind: "arrow", index: -1, body };
    if (this.near([x, y], this.spin(velocity))) return { kind: "spin", index: -1, body };
    return null;
  }

  private near(a: [number, number], b: [number, number]): boolean {
    return Math.hypot(a[0] - b[0], a[1] - b[1]) <= this.reach;
  }

  private inside(body: number, pose: Pose, x: number, y: number): boolean {
    const [u, v] = local(pose, ...this.camera.world(x, y));
    return partsOf(this.edited.scene.bodies[body]).some((rings) => insidePart(rings, u, v));
  }
}

export function insidePart(rings: Ring[], u: number, v: number): boolean {
  let odd = false;
  for (const points of rings) {
    for (let i = 0, j = points.length - 1; i < points.length; j = i++) {
      const [ax, ay] = points[i];
      const [bx, by] = points[j];
      if (ay > v !== by > v && u < ((bx - ax) * (v - ay)) / (by - ay) + ax) odd = !odd;
    }
  }
  return odd;
}

function distanceToSegment([x, y]: [number, number], a: [number, number], b: [number, number]): number {
  const length = (b[0] - a[0]) ** 2 + (b[1] - a[1]) ** 2 || 1;
  const share = Math.min(1, Math.max(0, ((x - a[0]) * (b[0] - a[0]) + (y - a[1]) * (b[1] - a[1])) / length));
  return Math.hypot(x - a[0] - share * (b[0] - a[0]), y - a[1] - share * (b[1] - a[1]));
}
