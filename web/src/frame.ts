// What one frame shows.
import type { Pose } from "./engine";
import type { Figure } from "./figure";
import type { Edge, MapEvent, Replay } from "./replay";

export interface Layers {
  faces: boolean;
  tiling: boolean;
  corners: boolean;
  vertices: boolean;
}

export interface EventMarks {
  event: MapEvent;
  gone: Edge[];
  come: Edge[];
}

export interface ContactMarks {
  point: [number, number];
  normal: [number, number];
  edge: { body: number; index: number };
}

export interface FaultMarks {
  body: number;
  vertices: number[];
  edges: number[];
}

export interface Frame {
  figures: [Figure, Figure];
  names: [string, string];
  poses: [Pose, Pose];
  /** Null where there is no map: bodies that overlap, or a scene that is being edited. */
  replay: Replay | null;
  event: EventMarks | null;
  contact: ContactMarks | null;
  faults: FaultMarks[];
}
