// Outlines from elsewhere become bodies of the scene.
import type { Pose, Scene } from "./engine";
import { Figure, placed } from "./figure";
import { motionOf, moved } from "./motions";

/** Body `index` gets this outline, at rest where the file has it. It turns about the outline's middle. */
export function withOutline(scene: Scene, index: number, polygon: [number, number][], name: string): Scene {
  const out = structuredClone(scene);
  const [x, y] = new Figure(polygon).centre;
  out.bodies[index] = {
    name: name === out.bodies[1 - index].name ? `${name} 2` : name,
    polygon: polygon.map(([u, v]) => [u - x, v - y]),
    motion: motionOf([{ t: out.time[0], x, y, angle: 0 }]),
  };
  return out;
}

/** Outlines from two places may lie on one another: body `index` goes to the right of the other. */
export function besideOther(scene: Scene, index: number, poses: [Pose, Pose]): Scene {
  const out = structuredClone(scene);
  const ends = out.bodies.map((body, b) => {
    let low = Infinity;
    let high = -Infinity;
    for (const [u, v] of body.polygon) {
      const [x] = placed(poses[b], u, v);
      low = Math.min(low, x);
      high = Math.max(high, x);
    }
    return { low, high };
  });
  const gap = 0.05 * (ends[0].high - ends[0].low + ends[1].high - ends[1].low);
  out.bodies[index].motion = moved(out.bodies[index], ends[1 - index].high + gap - ends[index].low, 0);
  return out;
}
