// The handles of each mode, drawn: vertices, ghosts at the keyframes, and the arrow of the motion from now on.
import { addRing } from "./curvedrawing";
import { placed } from "./figure";
import { spinRadius, type Edited, type Handles } from "./handles";
import { isJoined } from "./mechanisms";
import type { Keyframe } from "./motions";
import { verticesIn } from "./shapes";
import { lineOf, type Colours } from "./theme";

export function drawHandles(c: CanvasRenderingContext2D, edited: Edited, handles: Handles, colours: Colours): void {
  if (edited.mode === "shape") drawVertices(c, edited, handles, colours);
  if (edited.mode === "keyframes") drawGhosts(c, edited, handles, colours);
  if (edited.mode === "drive" && !isJoined(edited.scene, edited.body)) drawArrow(c, edited, handles, colours);
}

function drawVertices(c: CanvasRenderingContext2D, edited: Edited, handles: Handles, colours: Colours): void {
  if (!handles.verticesShown()) return;
  const { scene, body, vertex } = edited;
  for (let i = 0; i < verticesIn(scene.bodies[body]); ++i) {
    knob(c, handles.pixel(body, i), i === vertex ? colours.come : lineOf(colours, body), colours.paper, 4.5);
  }
}

function drawGhosts(c: CanvasRenderingContext2D, edited: Edited, handles: Handles, colours: Colours): void {
  const frames = edited.keyframes() ?? [];
  c.setLineDash([6, 4]);
  c.strokeStyle = lineOf(colours, edited.body);
  c.lineWidth = 1.5;
  drawPath(c, frames, edited, handles);
  drawOutlines(c, frames, edited, handles);
  c.setLineDash([]);
  frames.forEach((k, i) => {
    const label = frames.length === 1 ? "at rest" : `${i + 1}: t = ${Number(k.t.toPrecision(5))}`;
    drawGhostHandles(c, k, label, edited, handles, colours);
  });
}

/** The way of the pivot. */
function drawPath(c: CanvasRenderingContext2D, frames: Keyframe[], edited: Edited, handles: Handles): void {
  c.beginPath();
  for (const pose of handles.way(frames)) c.lineTo(...handles.camera.pixel(...placed(pose, ...edited.pivot())));
  c.stroke();
}

function drawOutlines(c: CanvasRenderingContext2D, frames: Keyframe[], edited: Edited, handles: Handles): void {
  for (const k of frames) {
    const pose = handles.ghostPose(k);
    for (const figure of edited.shapes()[edited.body].parts.flat()) {
      c.beginPath();
      if (figure.curve) addRing(c, figure, figure.curve, pose, handles.camera);
      else {
        for (const i of figure.outline(0.7 / handles.camera.scale))
          c.lineTo(...handles.camera.pixel(...placed(pose, figure.x[i], figure.y[i])));
        c.closePath();
      }
      c.stroke();
    }
  }
}

function drawGhostHandles(
  c: CanvasRenderingContext2D,
  k: Keyframe,
  text: string,
  edited: Edited,
  handles: Handles,
  colours: Colours,
): void {
  const colour = lineOf(colours, edited.body);
  const pose = handles.ghostPose(k);
  const origin = handles.camera.pixel(...placed(pose, ...edited.pivot()));
  const turn = handles.turn(pose);
  c.strokeStyle = colour;
  c.lineWidth = 1;
  c.beginPath();
  c.moveTo(...origin);
  c.lineTo(...turn);
  c.stroke();
  knob(c, origin, colour, colours.paper, 3);
  knob(c, turn, colour, colours.paper, 6);
  label(c, text, [origin[0] + 8, origin[1] - 8], colours);
}

function drawArrow(c: CanvasRenderingContext2D, edited: Edited, handles: Handles, colours: Colours): void {
  const velocity = edited.velocity();
  const pivot = handles.camera.pixel(...placed(edited.poses()[edited.body], ...edited.pivot()));
  knob(c, pivot, colours.come, colours.paper, 2.5);
  const from = handles.camera.pixel(...handles.anchor());
  const tip = handles.arrowTip(velocity);
  const spin = handles.spin(velocity);
  const turned = velocity.spin * handles.arrowTime();
  for (const [colour, width] of [
    [colours.paper, 6],
    [colours.come, 3],
  ] as [string, number][]) {
    c.strokeStyle = colour;
    c.lineWidth = width;
    c.beginPath();
    c.moveTo(...from);
    c.lineTo(...tip);
    c.stroke();
    c.lineWidth = width / 2;
    c.beginPath();
    c.arc(from[0], from[1], spinRadius, -Math.PI / 2, -Math.PI / 2 - turned, turned > 0);
    c.stroke();
  }
  knob(c, tip, colours.come, colours.paper, 7);
  knob(c, spin, colours.come, colours.paper, 6);
  for (const [text, [x, y]] of [
    ["velocity", tip],
    ["spin", spin],
    ["pivot", pivot],
  ] as [string, [number, number]][]) {
    label(c, text, [x + 10, y - 8], colours);
  }
}

function knob(c: CanvasRenderingContext2D, [x, y]: [number, number], line: string, fill: string, radius: number): void {
  c.beginPath();
  c.arc(x, y, radius, 0, 2 * Math.PI);
  c.fillStyle = fill;
  c.fill();
  c.strokeStyle = line;
  c.lineWidth = 2;
  c.stroke();
}

function label(c: CanvasRenderingContext2D, text: string, [x, y]: [number, number], colours: Colours): void {
  c.font = "600 12px system-ui, sans-serif";
  c.strokeStyle = colours.paper;
  c.lineWidth = 3.5;
  c.strokeText(text, x, y);
  c.fillStyle = colours.ink;
  c.fillText(text, x, y);
}
