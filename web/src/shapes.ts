// Bodies as they are drawn: their parts, each an outline and its holes.
import type { Body, Part, Ring, Scene } from "./engine";
import { Figure } from "./figure";

/** Of each part: its outline, then its holes. */
export function partsOf(body: Body): Ring[][] {
  if (body.polygon) return [[body.polygon]];
  return (body.parts ?? []).map((part) => (Array.isArray(part) ? [part] : [part.outline, ...(part.holes ?? [])]));
}

/** Vertices are counted on from ring to ring. */
export const verticesIn = (body: Body): number => partsOf(body).reduce((sum, rings) => sum + rings.flat().length, 0);

/** The ring that has the vertex of this number, and where; what is done to the ring is done to the body. */
export function cornerAt(body: Body, vertex: number): { ring: Ring; index: number } {
  for (const ring of partsOf(body).flat()) {
    if (vertex < ring.length) return { ring, index: vertex };
    vertex -= ring.length;
  }
  throw new RangeError("no such vertex");
}

/** Without the vertex; a hole goes with its third vertex from the end. False if the outline would. */
export function dropVertex(body: Body, vertex: number): boolean {
  const { ring, index } = cornerAt(body, vertex);
  if (ring.length > 3) return ring.splice(index, 1).length > 0;
  const { parts = [] } = body;
  const k = parts.findIndex((part) => !Array.isArray(part) && part.holes?.includes(ring));
  if (k < 0) return false;
  const part = parts[k] as Part;
  const holes = part.holes!.filter((hole) => hole !== ring);
  parts[k] = holes.length > 0 ? { ...part, holes } : part.outline;
  if (parts.length === 1 && Array.isArray(parts[0])) {
    body.polygon = parts[0];
    delete body.parts;
  }
  return true;
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
