// What dragging a handle does to the scene.
import type { Pose, Scene } from "./engine";
import { local, placed } from "./figure";
import type { Handle, Handles } from "./handles";
import { continued, keyframesOf, motionOf, moved, pivotOf, seenFrom, type Velocity } from "./motions";
import { cornerAt, familyOf } from "./shapes";

export interface Drag extends Handle {
  /** Where the pointer was when it went down, in the world. */
  from: [number, number];
  before: Scene;
  /** The instant shown and the poses when the drag began: they stay. */
  t: number;
  posesBefore: Pose[];
  poses: Pose[];
  /** Of the body's motion from now on. */
  velocity: Velocity;
}

/** Is it the plan from now on that changes? */
export const drives = (drag: Drag): boolean => drag.kind === "arrow" || drag.kind === "spin";

/** The pointer is at pixel (x, y): changes the body, and what the drag knows of it. */
export function follow(drag: Drag, scene: Scene, handles: Handles, x: number, y: number): void {
  const body = scene.bodies[drag.body];
  const at = handles.camera.world(x, y);
  const by: [number, number] = [at[0] - drag.from[0], at[1] - drag.from[1]];
  switch (drag.kind) {
    case "body":
      return moveBody(drag, scene, handles.rounded(by[0]), handles.rounded(by[1]));
    case "vertex": {
      const [u, v] = local(drag.poses[drag.body], ...at);
      const corner = cornerAt(body, drag.index);
      corner.ring[corner.index] = [handles.rounded(u), handles.rounded(v)];
      return;
    }
    case "ghost":
    case "turn":
      return moveGhost(drag, scene, handles, [x, y], by);
    case "arrow":
    case "spin":
      drag.velocity = { ...drag.velocity, ...velocityTo(drag, handles, x, y) };
      body.motion = continued(
        drag.before.bodies[drag.body],
        seenFrom(handles.base(), drag.poses[drag.body]),
        drag.t,
        scene.time[0],
        drag.velocity,
      );
  }
}

/** And all that move with it. A body that moves with another one is moved in that one's frame. */
function moveBody(drag: Drag, scene: Scene, dx: number, dy: number): void {
  const body = scene.bodies[drag.body];
  const parent = drag.posesBefore[scene.bodies.findIndex((other) => other.name === body.relative_to)];
  const own: [number, number] = parent ? turnedBack(parent, [dx, dy]) : [dx, dy];
  body.motion = moved(drag.before.bodies[drag.body], ...own);
  const family = familyOf(scene, drag.body);
  drag.poses = drag.posesBefore.map((pose, b) => (family.has(b) ? { ...pose, x: pose.x + dx, y: pose.y + dy } : pose));
}

function moveGhost(drag: Drag, scene: Scene, handles: Handles, pixel: [number, number], by: [number, number]): void {
  const [start, end] = scene.time;
  let frames = keyframesOf(drag.before.bodies[drag.body], start, end);
  if (!frames) return;
  let { index } = drag;
  // A body at rest has one keyframe: dragging its ghost sets it in motion, by a second one at the end.
  if (frames.length === 1 && end > start) {
    frames = [frames[0], { ...frames[0], t: end }];
    index = 1;
  }
  const pivot = pivotOf(scene.bodies[drag.body]) ?? [0, 0];
  const k = frames[index];
  const base = handles.base(k.t);
  if (drag.kind === "ghost") {
    const [dx, dy] = turnedBack(base, by);
    frames[index] = { ...k, x: handles.rounded(k.x + dx), y: handles.rounded(k.y + dy) };
  } else {
    const [ox, oy] = handles.camera.pixel(...placed(base, k.x + pivot[0], k.y + pivot[1]));
    const turn = nearest(Math.atan2(oy - pixel[1], pixel[0] - ox) - Math.atan2(base.s, base.c) - k.angle);
    frames[index] = { ...k, angle: Number((k.angle + turn).toFixed(4)) };
  }
  scene.bodies[drag.body].motion = motionOf(frames, pivot);
}

/** What the arrow's tip, or the spin's handle, at this pixel stands for. */
function velocityTo(drag: Drag, handles: Handles, x: number, y: number): Partial<Velocity> {
  const { scale } = handles.camera;
  const [ax, ay] = handles.camera.pixel(...handles.anchor(drag.body));
  const time = handles.arrowTime();
  if (drag.kind === "arrow") {
    const [vx, vy] = turnedBack(handles.base(), [x - ax, ay - y]);
    return { x: vx / time / scale, y: vy / time / scale };
  }
  return { spin: nearest(Math.atan2(ay - y, x - ax) - Math.PI / 2) / time };
}

/** A direction of the world, seen from a frame. */
const turnedBack = ({ c, s }: Pose, [x, y]: [number, number]): [number, number] => [c * x + s * y, c * y - s * x];

/** The same angle within half a turn. */
const nearest = (angle: number): number => angle - 2 * Math.PI * Math.round(angle / (2 * Math.PI));
