// The heights across the plane between which bodies and their parts lie, as the scene's layers state them.
import type { Body, Heights } from "./engine";
import { listOf, type Shape } from "./shapes";

const everywhere: Heights = [null, null];

/** Of each part. */
export const heightsOf = (body: Body): Heights[] =>
  listOf(body).map((part) => ("z" in part ? part.z : undefined) ?? body.z ?? everywhere);

const isEverywhere = ([lo, hi]: Heights): boolean => lo === null && hi === null;

/** Two intervals are the same one if their texts are. */
export const heightsText = (z: Heights): string => (isEverywhere(z) ? "all layers" : `z ${z[0] ?? ""}..${z[1] ?? ""}`);

function byHeight([a, b]: Heights, [c, d]: Heights): number {
  const order = (u: number, v: number): number => (u < v ? -1 : u > v ? 1 : 0);
  return order(a ?? -Infinity, c ?? -Infinity) || order(b ?? Infinity, d ?? Infinity);
}

/** Each interval once, the lowest one first. */
export function distinct(heights: Heights[]): Heights[] {
  const byText = new Map(heights.map((z) => [heightsText(z), z]));
  return [...byText.values()].sort(byHeight);
}

/** The layers of a body in words; empty if it reaches through all of them. */
export function layersText(body: Body): string {
  const heights = distinct(heightsOf(body));
  return heights.every(isEverywhere) ? "" : heights.map(heightsText).join(", ");
}

/** The layers of a scene; none if all bodies reach through everything. */
export function layersOf(bodies: Body[]): Heights[] {
  const heights = distinct(bodies.flatMap(heightsOf));
  return heights.every(isEverywhere) ? [] : heights;
}

/** What is painted at once: the parts of a body on one layer. */
export interface Sheet {
  body: number;
  parts: number[];
  z: Heights;
}

/** Higher layers over lower ones; bodies on the same layer in the given order. */
export function sheetsOf(shapes: Shape[], order: number[]): Sheet[] {
  const sheets = order.flatMap((body) => {
    const { heights } = shapes[body];
    return distinct(heights).map((z) => ({
      body,
      parts: heights.flatMap((other, part) => (heightsText(other) === heightsText(z) ? [part] : [])),
      z,
    }));
  });
  return sheets.sort((a, b) => byHeight(a.z, b.z));
}

/** Bodies and layers that are not to be seen; layers by their texts. */
export class Hidden {
  readonly bodies = new Set<number>();
  readonly layers = new Set<string>();

  get any(): boolean {
    return this.bodies.size + this.layers.size > 0;
  }

  clear(): void {
    this.bodies.clear();
    this.layers.clear();
  }

  hides(body: number, z: Heights): boolean {
    return this.bodies.has(body) || (this.layers.size > 0 && this.layers.has(heightsText(z)));
  }
}
