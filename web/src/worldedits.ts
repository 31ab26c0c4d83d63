// Changes to which bodies a scene has, and how they belong together. Each gives a new scene.
import type { Heights, Part, Pose, Ring, Scene } from "./engine";
import { freshName, renamed } from "./importing";
import { carried, keyframesOf, motionOf, pivotOf, seenFrom } from "./motions";

const atRest: Pose = { x: 0, y: 0, c: 1, s: 0 };

function regular(sides: number, radius: number, [x, y]: [number, number] = [0, 0]): Ring {
  return Array.from({ length: sides }, (_, k) => {
    const angle = (2 * Math.PI * (k + 0.5)) / sides;
    const tidy = (v: number): number => Number(v.toPrecision(6));
    return [tidy(x + radius * Math.cos(angle)), tidy(y + radius * Math.sin(angle))];
  });
}

/** One more body, a hexagon of this radius at rest; it is the last. */
export function withBody(scene: Scene, [x, y]: [number, number], radius: number): Scene {
  const out = structuredClone(scene);
  const name = freshName(out, `body ${out.bodies.length + 1}`);
  out.bodies.push({
    name,
    polygon: regular(6, radius),
    motion: motionOf([{ t: out.time[0], x: Number(x.toPrecision(6)), y: Number(y.toPrecision(6)), angle: 0 }]),
  });
  return out;
}

/** A body gets another name, or one like it that is free, wherever it is named. */
export function withName(scene: Scene, index: number, name: string): Scene {
  const out = structuredClone(scene);
  const before = out.bodies[index].name;
  const after = freshName(out, name, index);
  out.bodies[index].name = after;
  renamed(out, before, after);
  return out;
}

/** Without a body and what was said of it. Bodies that moved with it are seen from its parent. */
export function withoutBody(scene: Scene, index: number): Scene {
  const out = structuredClone(scene);
  const [gone] = out.bodies.splice(index, 1);
  for (const body of out.bodies) {
    if (body.relative_to !== gone.name) continue;
    if (gone.relative_to === undefined) delete body.relative_to;
    else body.relative_to = gone.relative_to;
  }
  if (out.ignore)
    setIgnored(
      out,
      out.ignore.filter((pair) => !pair.includes(gone.name)),
    );
  if (out.clearances) out.clearances = out.clearances.filter((own) => !own.pair.includes(gone.name));
  return out;
}

/** Where there is most room in a body, x, y, how much of it, and the part: there it gets a hole of eight corners. */
export function withHole(scene: Scene, index: number, [x, y, room, part]: [number, number, number, number]): Scene {
  const out = structuredClone(scene);
  const body = out.bodies[index];
  body.parts ??= [body.polygon!];
  delete body.polygon;
  const before = body.parts[part];
  const hole = regular(8, 0.6 * room, [x, y]);
  if ("path" in before) {
    // Its rings are those of an outline and its holes: by this rule one more subpath within is one more hole.
    body.parts[part] = {
      ...before,
      path: `${before.path} M ${hole.map((p) => p.join(" ")).join(" L ")} Z`,
      "fill-rule": "evenodd",
    };
    return out;
  }
  const whole: Part = Array.isArray(before) ? { outline: before } : before;
  body.parts[part] = { ...whole, holes: [...(whole.holes ?? []), hole] };
  return out;
}

/**
 * The body's motion is seen from `parent`, or from the world. At the start it stays where `poses` has it; if its motion
 * is a formula it cannot be carried over so, and `stays` is false.
 */
export function withParent(
  scene: Scene,
  index: number,
  parent: string | null,
  poses: Pose[],
): { scene: Scene; stays: boolean } {
  const out = structuredClone(scene);
  const body = out.bodies[index];
  const poseOfNamed = (name: string | undefined): Pose =>
    poses[scene.bodies.findIndex((other) => other.name === name)] ?? atRest;
  const before = poseOfNamed(body.relative_to);
  const after = poseOfNamed(parent ?? undefined);
  if (parent === null) delete body.relative_to;
  else body.relative_to = parent;
  // What was in the old parent's frame is in the new one's: the old pose, seen from the new.
  const by = seenFrom(after, before);
  if (Math.hypot(by.x, by.y) + Math.abs(by.s) + Math.abs(1 - by.c) < 1e-12) return { scene: out, stays: true };
  const frames = keyframesOf(body, ...out.time);
  if (!frames) return { scene: out, stays: false };
  const pivot = pivotOf(body) ?? [0, 0];
  body.motion = motionOf(carried(frames, pivot, by), pivot);
  return { scene: out, stays: true };
}

/** The body reaches through these layers; parts that have layers of their own keep them. */
export function withHeights(scene: Scene, index: number, z: Heights): Scene {
  const out = structuredClone(scene);
  const body = out.bodies[index];
  if (z[0] === null && z[1] === null) delete body.z;
  else body.z = z;
  return out;
}

export function withIgnored(scene: Scene, a: string, b: string): Scene {
  const out = structuredClone(scene);
  const there = (out.ignore ?? []).some((pair) => (pair[0] === a && pair[1] === b) || (pair[0] === b && pair[1] === a));
  if (!there) setIgnored(out, [...(out.ignore ?? []), [a, b]]);
  return out;
}

export function withoutIgnored(scene: Scene, index: number): Scene {
  const out = structuredClone(scene);
  setIgnored(
    out,
    (out.ignore ?? []).filter((_, k) => k !== index),
  );
  return out;
}

function setIgnored(scene: Scene, pairs: [string, string][]): void {
  if (pairs.length > 0) scene.ignore = pairs;
  else delete scene.ignore;
}
