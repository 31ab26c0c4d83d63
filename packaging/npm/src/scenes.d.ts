// Scenes are as docs/scenes.md of taut has them. build.mjs puts the types of answers, objects and functions behind these.

export type Point = readonly [number, number];

/** Any value that JSON has. */
export type Id = string | number | boolean | null | object;

/** Three points or more; the last is joined to the first. */
export type Ring = readonly Point[];
/** The lowest and the highest height that a shape reaches through, null for no end; it meets only what is on a common layer. */
export type Layers = readonly [number | null, number | null];
/** An outline, minus its holes. */
export interface OutlineWithHoles {
  readonly outline: Ring;
  readonly holes?: readonly Ring[];
  readonly z?: Layers;
}
/** The data of an SVG path, y upwards: curves. */
export interface Path {
  readonly path: string;
  readonly "fill-rule"?: "nonzero" | "evenodd";
  readonly z?: Layers;
}
export type Polygon = Ring | OutlineWithHoles | Path;

/** The way from the keyframe before, about a centre, by so many degrees counterclockwise; instead of x, y and angle_deg. */
export interface Arc {
  readonly center: Point;
  readonly deg: number;
}
export interface Keyframe {
  readonly t: number;
  readonly x?: number;
  readonly y?: number;
  readonly angle_deg?: number;
  /** The body turns with it, like a car. */
  readonly turn?: Arc;
  /** The body does not turn. */
  readonly arc?: Arc;
}
export interface KeyframedMotion {
  readonly keyframes: readonly Keyframe[];
  readonly pivot?: Point;
}
/** Both are per unit of time; one of them is there. */
export type SteadyMotion =
  | {
      readonly velocity: Point;
      readonly spin_deg?: number;
      readonly pivot?: Point;
    }
  | {
      readonly velocity?: Point;
      readonly spin_deg: number;
      readonly pivot?: Point;
    };
/** An even turn over the scene's time; answers say at which angle. */
export interface SweepMotion {
  readonly sweep: {
    readonly pivot?: Point;
    readonly from_deg: number;
    readonly to_deg: number;
  };
}
/** Coefficients, the constant one first. */
export type Polynomial = readonly number[];
export type Rotation =
  | { readonly angle: Polynomial }
  | { readonly direction: { readonly a: Polynomial; readonly b: Polynomial } }
  | { readonly half_angle_tangent: Polynomial }
  | { readonly cosine: Polynomial };
/** Polynomials in the time since `origin`, which is 0 by default: the body's point (u, v) is at (x, y), plus (u, v) as it is rotated. */
export interface MotionPiece {
  readonly x?: Polynomial;
  readonly y?: Polynomial;
  readonly rotation?: Rotation | null;
  readonly pivot?: Point;
  readonly orbit?: { readonly center: Point; readonly angle: Polynomial };
  readonly origin?: number;
  readonly until?: number;
}
export type Motion = null | KeyframedMotion | SteadyMotion | SweepMotion | MotionPiece | readonly MotionPiece[];

interface AnyBody {
  readonly name: string;
  /** The body from whose frame the motion is seen. */
  readonly relative_to?: string;
  /** At rest without it. */
  readonly motion?: Motion;
  /** All layers without it. Parts may have layers of their own. */
  readonly z?: Layers;
  readonly id?: Id;
}
export interface BodyOfPolygon extends AnyBody {
  readonly polygon: Polygon;
  readonly parts?: undefined;
}
export interface BodyOfParts extends AnyBody {
  readonly polygon?: undefined;
  readonly parts: readonly Polygon[];
}
export type Body = BodyOfPolygon | BodyOfParts;

/** What a pair is to keep, for check_clearance(): a distance, or the coefficients of a polynomial in the time since
 * `origin`, in ascending powers. */
export interface PairClearance {
  /** Two names; "*" is every other body. */
  readonly pair: readonly [string, string];
  readonly margin: number | readonly number[];
  readonly origin?: number;
}

/** A scene in the format taut-scene/1. Scenes that name files cannot be read here. */
export interface SceneObject {
  readonly $schema?: string;
  readonly format: "taut-scene/1";
  readonly time: readonly [number, number];
  readonly bodies: readonly Body[];
  /** Pairs of names that are not tested; "*" is every other body. */
  readonly ignore?: readonly (readonly [string, string])[];
  /** What certain pairs are to keep instead of the clearance that is asked about. */
  readonly clearances?: readonly PairClearance[];
  /** Are pairs tested that do not move? "skip" is the default. */
  readonly at_rest?: "skip" | "test";
  readonly id?: Id;
}
/** A scene as an object, or as JSON text. */
export type Scene = string | SceneObject;
