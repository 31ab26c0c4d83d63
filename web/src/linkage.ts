// Bodies that follow joints, and the partition of all combinations of their values, as `taut envelope --html` writes them.

export type CellState = "free" | "colliding" | "undecided";

export interface Cell {
  state: CellState;
  lo: number[];
  hi: number[];
  /** Names of the two bodies; of cells that are not free. */
  pair?: [string, string];
  /** Instead of the pair: a mechanism may lock there, or does not get there. */
  may_lock?: boolean;
}

export interface Joint {
  name: string;
  range: [number, number];
}

/** How a body follows a joint: by times * value + plus, in degrees about the pivot, or along the direction. */
export interface JointMotion {
  joint: number;
  times?: number;
  plus?: number;
  /** Of a link of a mechanism, instead of times and plus: evenly over the joint's range. */
  values?: (number | null)[];
  /** Of a link that several joints move: these, with values evenly over all their ranges, in which the first one varies
   * fastest; null where the mechanism may lock. */
  joints?: number[];
  pivot?: [number, number];
  direction?: [number, number];
}

export interface LinkedBody {
  name: string;
  /** Of each part the outline, then its holes. */
  parts: [number, number][][][];
  /** Whose frame it is in, by its place among the bodies. */
  parent?: number;
  /** The outermost first: a body that moves freely has several. */
  motion?: JointMotion[];
}

export interface EnvelopePage {
  title?: string;
  envelope: {
    outcome: string;
    joints: Joint[];
    witness: { values: Record<string, number>; pair: [string, string] } | null;
    free: number;
    colliding: number;
    undecided: number;
    /** Other ways without a lock may lead to another pose than the one that cells are about. */
    other_poses?: boolean;
    cells: Cell[];
  };
  bodies: LinkedBody[];
  /** Those of bodies in all pictures; they come again after the last. */
  colours: string[];
}

/** The point (u, v) of the body is at (x + c u - s v, y + s u + c v). */
export interface Placement {
  x: number;
  y: number;
  c: number;
  s: number;
}

const origin: Placement = { x: 0, y: 0, c: 1, s: 0 };

function within(parent: Placement, child: Placement): Placement {
  return {
    x: parent.x + parent.c * child.x - parent.s * child.y,
    y: parent.y + parent.s * child.x + parent.c * child.y,
    c: parent.c * child.c - parent.s * child.s,
    s: parent.s * child.c + parent.c * child.s,
  };
}

/** By linear interpolation between the values of a table, and beyond its ends; of several joints, between those of the
 * corners around that are known, and 0 if there are none. */
function followed(table: (number | null)[], values: number[], ranges: [number, number][]): number {
  const count = Math.round(table.length ** (1 / ranges.length));
  const corners = ranges.reduce(
    (all, [lo, hi], i) => {
      const place = hi > lo ? ((values[i]! - lo) / (hi - lo)) * (count - 1) : 0;
      const k = Math.min(Math.max(Math.floor(place), 0), count - 2);
      const step = count ** i;
      return all.flatMap(({ at, weight }) => [
        { at: at + k * step, weight: weight * (k + 1 - place) },
        { at: at + (k + 1) * step, weight: weight * (place - k) },
      ]);
    },
    [{ at: 0, weight: 1 }],
  );
  const known = corners.filter(({ at, weight }) => table[at] !== null && weight !== 0);
  const sum = known.reduce((all, { weight }) => all + weight, 0);
  return sum === 0 ? 0 : known.reduce((all, { at, weight }) => all + weight * table[at]!, 0) / sum;
}

function singlePlacement(motion: JointMotion, values: number[], joints: Joint[]): Placement {
  const driving = motion.joints ?? [motion.joint];
  const value = motion.values
    ? followed(
        motion.values,
        driving.map((k) => values[k]!),
        driving.map((k) => joints[k]!.range),
      )
    : (motion.times ?? 1) * values[motion.joint]! + (motion.plus ?? 0);
  if (motion.direction) return { ...origin, x: motion.direction[0] * value, y: motion.direction[1] * value };
  const c = Math.cos((value * Math.PI) / 180);
  const s = Math.sin((value * Math.PI) / 180);
  const [px, py] = motion.pivot!;
  return { x: px - c * px + s * py, y: py - s * px - c * py, c, s };
}

function ownPlacement(motion: JointMotion[] | undefined, values: number[], joints: Joint[]): Placement {
  return (motion ?? []).reduce((outer, single) => within(outer, singlePlacement(single, values, joints)), origin);
}

/** Where a body is for these joint values. */
export function placementOf(bodies: LinkedBody[], body: LinkedBody, values: number[], joints: Joint[]): Placement {
  const own = ownPlacement(body.motion, values, joints);
  return body.parent === undefined ? own : within(placementOf(bodies, bodies[body.parent]!, values, joints), own);
}

/** Cells by a coarse grid over the first two joints, so that the one under the pointer is found at once. */
export class CellIndex {
  private static readonly side = 64;
  private readonly buckets = new Map<number, Cell[]>();

  constructor(
    cells: Cell[],
    private readonly joints: Joint[],
  ) {
    for (const cell of cells) {
      const [x0, x1] = this.span(cell, 0);
      const [y0, y1] = this.span(cell, 1);
      for (let y = y0; y <= y1; ++y) {
        for (let x = x0; x <= x1; ++x) {
          const key = y * CellIndex.side + x;
          const bucket = this.buckets.get(key);
          if (bucket) bucket.push(cell);
          else this.buckets.set(key, [cell]);
        }
      }
    }
  }

  /** The cell that holds these values; cells share their borders, of which the first one found is given. */
  at(values: number[]): Cell | undefined {
    const key = this.place(values[1] ?? 0, 1) * CellIndex.side + this.place(values[0]!, 0);
    const holds = (cell: Cell) => this.joints.every((_, k) => cell.lo[k]! <= values[k]! && values[k]! <= cell.hi[k]!);
    return this.buckets.get(key)?.find(holds);
  }

  private place(value: number, k: number): number {
    const joint = this.joints[k];
    if (!joint) return 0;
    const share = (value - joint.range[0]) / (joint.range[1] - joint.range[0]);
    return Math.min(CellIndex.side - 1, Math.max(0, Math.floor(share * CellIndex.side)));
  }
  private span(cell: Cell, k: number): [number, number] {
    return this.joints[k] ? [this.place(cell.lo[k]!, k), this.place(cell.hi[k]!, k)] : [0, 0];
  }
}
