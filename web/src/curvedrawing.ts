// Curves as curves: ellipses and Bezier curves of the canvas, and where these are too large for its 24 bits, as many
// short lines as the window shows.
import type { Camera } from "./camera";
import type { Pose } from "./engine";
import { placed, type Figure } from "./figure";
import { pointAt, bendOf, type Arc, type CurvedRing, type Segment } from "./paths";
import { addSegment, clipPolygon, farAway, type Pixel } from "./pixels";

/** No line is farther from its curve, in pixels. */
const chordError = 0.1;

/** Adds the ring, closed, to a path. */
export function addRing(path: CanvasPath, figure: Figure, ring: CurvedRing, pose: Pose, camera: Camera): void {
  if (figure.diameter * camera.scale > farAway) {
    const points = clipPolygon(
      ring.flatMap((segment) => inView(segment, pose, camera)),
      camera.width,
      camera.height,
    );
    points.forEach(([x, y], i) => (i === 0 ? path.moveTo(x, y) : path.lineTo(x, y)));
  } else {
    path.moveTo(...camera.pixel(...placed(pose, ...ring[0].from)));
    for (const segment of ring) addNative(path, segment, pose, camera);
  }
  path.closePath();
}

/** Adds one segment, from its start. */
export function addSegmentOf(path: CanvasPath, figure: Figure, segment: Segment, pose: Pose, camera: Camera): void {
  if (figure.diameter * camera.scale <= farAway) {
    path.moveTo(...camera.pixel(...placed(pose, ...segment.from)));
    return addNative(path, segment, pose, camera);
  }
  const points = [camera.pixel(...placed(pose, ...segment.from)), ...inView(segment, pose, camera)];
  for (let i = 1; i < points.length; ++i) addSegment(path, ...points[i - 1], ...points[i], camera);
}

function addNative(path: CanvasPath, segment: Segment, pose: Pose, camera: Camera): void {
  const pixel = (p: [number, number]): Pixel => camera.pixel(...placed(pose, ...p));
  if (segment.kind === "arc") return addArc(path, segment, pose, camera);
  if (segment.kind === "line") return path.lineTo(...pixel(segment.to));
  const [, a, b, c] = segment.points.map(pixel);
  if (c) path.bezierCurveTo(...a, ...b, ...c);
  else path.quadraticCurveTo(...a, ...b);
}

/** On the screen y points down: angles are the other way round. */
function addArc(path: CanvasPath, arc: Arc, pose: Pose, camera: Camera): void {
  const [x, y] = camera.pixel(...placed(pose, ...arc.centre));
  const k = camera.scale;
  const turned = -(arc.rotation + Math.atan2(pose.s, pose.c));
  path.ellipse(x, y, k * arc.rx, k * arc.ry, turned, -arc.start, -arc.start - arc.sweep, arc.sweep > 0);
}

/** Pixels along the segment, its end the last: close together in the window, few outside. */
function inView(segment: Segment, pose: Pose, camera: Camera): Pixel[] {
  const pixel = (p: [number, number]): Pixel => camera.pixel(...placed(pose, ...p));
  const bend = (bendOf(segment) * camera.scale) / 8;
  const out: Pixel[] = [];
  const add = (from: number, to: number, a: Pixel, b: Pixel, depth: number): void => {
    const off = bend * (to - from) ** 2;
    if (off < chordError || depth === 0 || outside(a, b, off + 60, camera)) {
      out.push(b);
      return;
    }
    const middle = (from + to) / 2;
    const m = pixel(pointAt(segment, middle));
    add(from, middle, a, m, depth - 1);
    add(middle, to, m, b, depth - 1);
  };
  add(0, 1, pixel(segment.from), pixel(segment.to), 44);
  return out;
}

function outside([ax, ay]: Pixel, [bx, by]: Pixel, room: number, { width, height }: Camera): boolean {
  return (
    Math.max(ax, bx) < -room ||
    Math.max(ay, by) < -room ||
    Math.min(ax, bx) > width + room ||
    Math.min(ay, by) > height + room
  );
}
