// Bodies that follow joints, and the partition of all combinations of their values, as `taut envelope --html` writes them.

export type CellState = "free" | "colliding" | "undecided";

export interface Cell {
  state: CellState;
  lo: number[];
  hi: number[];
  /** Names of the two bodies; of cells that are not free. */
  pair?: [string, string];
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
  values?: number[];
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

/** By linear interpolation between the values of a table, and beyond its ends. */
function followed(table: number[], value: number, [lo, hi]: [number, number]): number {
  const last = table.length - 1;
  const place = hi > lo ? ((value - lo) / (hi - lo)) * last : 0;
  const k = Math.min(Math.max(Math.floor(place), 0), last - 1);
  return table[k]! + (place - k) * (table[k + 1]! - table[k]!);
}

function singlePlacement(motion: JointMotion, values: number[], joints: Joint[]): Placement {
  const driving = values[motion.joint]!;
  const value = motion.values
    ? followed(motion.values, driving, joints[motion.joint]!.range)
    : (motion.times ?? 1) * driving + (motion.plus ?? 0);
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
