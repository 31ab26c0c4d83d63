// Bodies as they are drawn: their parts, each an outline and its holes.
import type { Body, Ring, Scene } from "./engine";
import { Figure } from "./figure";

/** Of a body that is one polygon without holes; empty for others. */
export const ringOf = (body: Body): Ring => body.polygon ?? [];

/** Of each part: its outline, then its holes. */
export function partsOf(body: Body): Ring[][] {
  if (body.polygon) return [[body.polygon]];
  return (body.parts ?? []).map((part) => (Array.isArray(part) ? [part] : [part.outline, ...(part.holes ?? [])]));
}

export class Shape {
  readonly parts: Figure[][];

  constructor(body: Body) {
    this.parts = partsOf(body).map((rings) => rings.map((ring) => new Figure(ring)));
  }

  /** The outline of the first part: all there is of a plain body. */
  get outline(): Figure {
    return this.parts[0][0];
  }
}

export interface Branch {
  body: number;
  children: Branch[];
}

/** Bodies below their parents. */
export function treeOf(scene: Scene): Branch[] {
  const branches = scene.bodies.map((_, body): Branch => ({ body, children: [] }));
  const roots: Branch[] = [];
  scene.bodies.forEach((body, b) => {
    const parent = scene.bodies.findIndex((other) => other.name === body.relative_to);
    (parent < 0 ? roots : branches[parent].children).push(branches[b]);
  });
  return roots;
}

/** A body and all that move with it. */
export function familyOf(scene: Scene, body: number): Set<number> {
  const family = new Set([body]);
  for (let grown = true; grown;) {
    grown = false;
    scene.bodies.forEach(({ relative_to }, b) => {
      const parent = scene.bodies.findIndex((other) => other.name === relative_to);
      if (parent < 0 || family.has(b) || !family.has(parent)) return;
      family.add(b);
      grown = true;
    });
  }
  return family;
}
