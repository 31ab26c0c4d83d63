// Outlines from elsewhere become bodies of the scene.
import type { Part, Pose, Ring, Scene } from "./engine";
import { Figure, placed } from "./figure";
import { renamedInJoints } from "./mechanisms";
import { motionOf, moved } from "./motions";
import { partsOf } from "./shapes";

/** A name that no other body has. */
export function freshName(scene: Scene, wanted: string, index = -1): string {
  const taken = new Set(scene.bodies.filter((_, b) => b !== index).map((body) => body.name));
  if (!taken.has(wanted)) return wanted;
  let n = 2;
  while (taken.has(`${wanted} ${n}`)) ++n;
  return `${wanted} ${n}`;
}

/**
 * Body `index` gets these parts, with their holes, at rest where the file has them. It turns about the middle of the
 * first one's outline.
 */
export function withOutline(scene: Scene, index: number, parts: Part[], name: string): Scene {
  const out = structuredClone(scene);
  const [x, y] = new Figure(parts[0].outline).centre;
  const about = (ring: Ring): Ring => ring.map(([u, v]) => [u - x, v - y]);
  const placedParts = parts.map(({ outline, holes, ...rest }) => ({
    ...rest,
    outline: about(outline),
    holes: (holes ?? []).map(about),
  }));
  const plain = parts.length === 1 && placedParts[0].holes.length === 0 && !parts[0].z;
  const { z } = scene.bodies[index];
  out.bodies[index] = {
    name: freshName(out, name, index),
    ...(plain ? { polygon: placedParts[0].outline } : { parts: placedParts }),
    ...(z ? { z } : {}),
    motion: motionOf([{ t: out.time[0], x, y, angle: 0 }]),
  };
  renamed(out, scene.bodies[index].name, out.bodies[index].name);
  return out;
}

/** Where a body was named, it is named anew. */
export function renamed(scene: Scene, before: string, after: string): void {
  for (const body of scene.bodies) if (body.relative_to === before) body.relative_to = after;
  const name = (n: string): string => (n === before ? after : n);
  renamedInJoints(scene, before, after);
  if (scene.ignore) scene.ignore = scene.ignore.map(([a, b]) => [name(a), name(b)]);
  for (const own of scene.clearances ?? []) own.pair = [name(own.pair[0]), name(own.pair[1])];
}

/** Outlines from two places may lie on one another: body `index` goes to the right of the others. */
export function besideOthers(scene: Scene, index: number, poses: Pose[]): Scene {
  const out = structuredClone(scene);
  const own = { low: Infinity, high: -Infinity };
  const others = { low: Infinity, high: -Infinity };
  out.bodies.forEach((body, b) => {
    const range = b === index ? own : others;
    for (const [u, v] of partsOf(body).flat(2)) {
      const [x] = placed(poses[b], u, v);
      range.low = Math.min(range.low, x);
      range.high = Math.max(range.high, x);
    }
  });
  const gap = 0.05 * (own.high - own.low + others.high - others.low);
  out.bodies[index].motion = moved(out.bodies[index], others.high + gap - own.low, 0);
  return out;
}
