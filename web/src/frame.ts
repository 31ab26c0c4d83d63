// What one frame shows.
import type { Pose, WorldStyles } from "./engine";
import type { Figure } from "./figure";
import type { Hidden } from "./heights";
import type { Edge, MapEvent, Replay } from "./replay";
import type { Shape } from "./shapes";

export interface Layers {
  /** The map of the space between the bodies: all of what is below, but vertices and bands. */
  proof: boolean;
  faces: boolean;
  tiling: boolean;
  corners: boolean;
  vertices: boolean;
  /** Of curves: what the polygons that decided leave between them. */
  bands: boolean;
}

export interface EventMarks {
  event: MapEvent;
  gone: Edge[];
  come: Edge[];
}

export interface ContactMarks {
  point: [number, number];
  normal: [number, number];
  /** What is marked: the edge, or both segments where curves meet. */
  features: (Culprit & { body: number })[];
  label: string;
}

/** Two points in the world, one on each of two bodies, and what is written beside them. */
export interface NearestMarks {
  points: [[number, number], [number, number]];
  label: string;
}

/** What a body passes over: of each part the outline, then its holes. */
export interface RegionMarks {
  body: number;
  parts: [number, number][][][];
}

/** A vertex, or the edge from it on. */
export interface Culprit {
  part: number;
  ring: number;
  index: number;
}

export interface FaultMarks {
  body: number;
  vertices: Culprit[];
  edges: Culprit[];
}

export interface Frame {
  shapes: Shape[];
  /** The outlines of the bodies' first parts. */
  figures: Figure[];
  names: string[];
  poses: Pose[];
  /** How bodies look that are more than two polygons. */
  world: WorldStyles | null;
  hidden: Hidden;
  /** Null where there is no map: bodies that overlap, or a scene that is being edited. */
  replay: Replay | null;
  /** Of a world, the tilings of the pairs that are near, five numbers a line; asked for where they are drawn. */
  tilings: (() => number[]) | null;
  event: EventMarks | null;
  contacts: ContactMarks[];
  /** Bodies that overlap. */
  overlaps: [number, number][];
  faults: FaultMarks[];
}
