// Bodies as they are drawn: their parts, each an outline and its holes.
import type { Body, Heights, Part, PathPart, Ring, Scene } from "./engine";
import { Figure } from "./figure";
import { heightsOf } from "./heights";
import { ringsOfPath, sketched } from "./paths";

type AnyPart = Ring | Part | PathPart;

export const isPath = (part: AnyPart): part is PathPart => "path" in part;

/** Is the body bounded by curves? Then its parts are paths. */
export const isCurved = (body: Body): boolean => (body.parts ?? []).some(isPath);

export const listOf = (body: Body): AnyPart[] => (body.polygon ? [body.polygon] : (body.parts ?? []));

/** Of each part: its outline, then its holes; sketches of those that are paths. */
export function partsOf(body: Body): Ring[][] {
  return listOf(body).map((part) => (isPath(part) ? sketched(part.path) : ringsOf(part)));
}

const ringsOf = (part: Ring | Part): Ring[] => (Array.isArray(part) ? [part] : [part.outline, ...(part.holes ?? [])]);

/** Those that have vertices which can be taken hold of. */
export const ringsWithVertices = (body: Body): Ring[] =>
  listOf(body).flatMap((part) => (isPath(part) ? [] : ringsOf(part)));

/** Vertices are counted on from ring to ring. */
export const verticesIn = (body: Body): number => ringsWithVertices(body).reduce((sum, ring) => sum + ring.length, 0);

/** The ring that has the vertex of this number, and where; what is done to the ring is done to the body. */
export function cornerAt(body: Body, vertex: number): { ring: Ring; index: number } {
  for (const ring of ringsWithVertices(body)) {
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
  const k = parts.findIndex((part) => "outline" in part && part.holes?.includes(ring));
  if (k < 0) return false;
  const part = parts[k] as Part;
  const { holes: before, ...rest } = part;
  const holes = before!.filter((hole) => hole !== ring);
  parts[k] = holes.length > 0 ? { ...rest, holes } : part.z ? rest : part.outline;
  const [first] = parts;
  if (parts.length === 1 && Array.isArray(first)) {
    body.polygon = first;
    delete body.parts;
  }
  return true;
}

export class Shape {
  readonly parts: Figure[][];
  /** The layers of each part. */
  readonly heights: Heights[];

  constructor(body: Body) {
    this.heights = heightsOf(body);
    this.parts = listOf(body).map((part) => {
      if (!isPath(part)) return ringsOf(part).map((ring) => new Figure(ring));
      const curves = ringsOfPath(part.path);
      return sketched(part.path).map((ring, k) => new Figure(ring, curves[k]));
    });
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
