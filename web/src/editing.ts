// Editing by hand, in the picture: bodies and vertices, ghosts at the keyframes, and the motion from now on.
import type { Camera } from "./camera";
import type { Pose, Scene } from "./engine";
import type { FaultMarks, Frame } from "./frame";
import { Figure, local, placed } from "./figure";
import {
  continued,
  keyframesOf,
  motionOf,
  moved,
  pivotOf,
  poseOf,
  velocityAt,
  type Keyframe,
  type Velocity,
} from "./motions";
import type { Player } from "./player";
import type { Tool } from "./stage";
import type { Colours } from "./theme";

export type Mode = "look" | "shape" | "keyframes" | "drive";

/** How near a handle has to be, in pixels. */
const reachOfMouse = 12;
const reachOfFinger = 24;
const spinRadius = 46;
/** Handles of more vertices than this in view would hide the body. */
const mostHandles = 300;

interface Drag {
  kind: "body" | "vertex" | "ghost" | "turn" | "arrow" | "spin";
  /** Where the pointer was when it went down, in the world. */
  from: [number, number];
  index: number;
  before: Scene;
  /** The instant shown and the poses when the drag began: they stay. */
  t: number;
  posesBefore: [Pose, Pose];
  poses: [Pose, Pose];
  /** Of the body's motion from now on. */
  velocity: Velocity;
}

export interface EditorHost {
  /** A drag begins. */
  begun(): void;
  /** A changed scene: `final` when the pointer was let go. */
  edited(scene: Scene, final: boolean, driven: boolean): void;
  redraw(): void;
}

export class Editor implements Tool {
  mode: Mode = "look";
  body = 1;
  /** The scene as it is being edited; it may be invalid, unlike the player's. */
  scene!: Scene;
  faults: FaultMarks[] = [];
  vertex = -1;
  /** The map is that of an older scene: it is not drawn. */
  stale = false;
  private reach = reachOfMouse;
  private drag: Drag | null = null;
  private figures: [Figure, Figure] | null = null;

  constructor(
    private readonly player: Player,
    private readonly camera: Camera,
    private readonly host: EditorHost,
  ) {}

  /** Takes up a scene from elsewhere. */
  adopt(scene: Scene): void {
    this.scene = structuredClone(scene);
    this.figures = null;
    this.vertex = -1;
  }

  get dragging(): boolean {
    return this.drag !== null;
  }

  keyframes(body = this.body): Keyframe[] | null {
    return keyframesOf(this.scene.bodies[body], this.scene.time[0], this.scene.time[1]);
  }

  /** How long an arrow is that stands for velocity: what the body would cover in a fifth of the time. */
  private arrowTime(): number {
    return Math.max(this.scene.time[1] - this.scene.time[0], 1e-9) / 5;
  }

  private poses(): [Pose, Pose] {
    return this.drag?.poses ?? this.player.poses();
  }

  private pixel(body: number, index: number): [number, number] {
    const [u, v] = this.scene.bodies[body].polygon[index];
    return this.camera.pixel(...placed(this.poses()[body], u, v));
  }

  private handlesShown(): boolean {
    let inView = 0;
    const { length } = this.scene.bodies[this.body].polygon;
    for (let i = 0; i < length && inView <= mostHandles; ++i) {
      const [x, y] = this.pixel(this.body, i);
      if (x > 0 && y > 0 && x < this.camera.width && y < this.camera.height) ++inView;
    }
    return inView <= mostHandles;
  }

  private near(a: [number, number], b: [number, number]): boolean {
    return Math.hypot(a[0] - b[0], a[1] - b[1]) <= this.reach;
  }

  private inside(body: number, pose: Pose, x: number, y: number): boolean {
    const [u, v] = local(pose, ...this.camera.world(x, y));
    const points = this.scene.bodies[body].polygon;
    let odd = false;
    for (let i = 0, j = points.length - 1; i < points.length; j = i++) {
      const [ax, ay] = points[i];
      const [bx, by] = points[j];
      if (ay > v !== by > v && u < ((bx - ax) * (v - ay)) / (by - ay) + ax) odd = !odd;
    }
    return odd;
  }

  private pivot(): [number, number] {
    return pivotOf(this.scene.bodies[this.body]) ?? [0, 0];
  }

  private ghostPose(k: Keyframe): Pose {
    return poseOf(k, this.pivot());
  }

  /** The handle that turns a ghost: beside the pivot, in the direction of its x axis. */
  private turnHandle(pose: Pose): [number, number] {
    const [x, y] = this.camera.pixel(...placed(pose, ...this.pivot()));
    return [x + spinRadius * pose.c, y - spinRadius * pose.s];
  }

  /** Arrows start in the middle of the body, which is in view when its origin may not be. */
  private anchor(body: number): [number, number] {
    return placed(this.poses()[body], ...this.currentFigures()[body].centre);
  }

  private velocity(): Velocity {
    if (this.drag) return this.drag.velocity;
    const poses = (t: number): Pose => this.player.engine.poses(t)[this.body];
    return velocityAt(poses, this.pivot(), this.player.t, this.scene.time[1]);
  }

  private arrowTip(velocity: Velocity): [number, number] {
    const [x, y] = this.camera.pixel(...this.anchor(this.body));
    const time = this.arrowTime() * this.camera.scale;
    return [x + velocity.x * time, y - velocity.y * time];
  }

  private spinHandle(velocity: Velocity): [number, number] {
    const [x, y] = this.camera.pixel(...this.anchor(this.body));
    const angle = Math.PI / 2 + velocity.spin * this.arrowTime();
    return [x + spinRadius * Math.cos(angle), y - spinRadius * Math.sin(angle)];
  }

  /** What lies below the pointer. */
  private find(x: number, y: number): { kind: Drag["kind"]; index: number; body: number } | null {
    const at: [number, number] = [x, y];
    const none = { index: -1, body: this.body };
    if (this.mode === "look") return null;
    if (this.mode === "drive") {
      const velocity = this.velocity();
      if (this.near(at, this.arrowTip(velocity))) return { kind: "arrow", ...none };
      if (this.near(at, this.spinHandle(velocity))) return { kind: "spin", ...none };
    } else if (this.mode === "shape") {
      if (this.handlesShown()) {
        for (let i = 0; i < this.scene.bodies[this.body].polygon.length; ++i) {
          if (this.near(at, this.pixel(this.body, i))) return { kind: "vertex", index: i, body: this.body };
        }
      }
      for (const body of [this.body, 1 - this.body]) {
        if (this.inside(body, this.poses()[body], x, y)) return { kind: "body", index: -1, body };
      }
    } else {
      const frames = this.keyframes() ?? [];
      for (let i = frames.length; i-- > 0;) {
        if (this.near(at, this.turnHandle(this.ghostPose(frames[i]))))
          return { kind: "turn", index: i, body: this.body };
      }
      // The last ghost first: where all lie on one another, it is the one that sets a body in motion.
      for (let i = frames.length; i-- > 0;) {
        if (this.inside(this.body, this.ghostPose(frames[i]), x, y))
          return { kind: "ghost", index: i, body: this.body };
      }
    }
    return null;
  }

  hover(x: number, y: number): string {
    return this.find(x, y) ? "move" : "";
  }

  down(x: number, y: number, e: PointerEvent): boolean {
    this.reach = e.pointerType === "touch" ? reachOfFinger : reachOfMouse;
    const found = this.find(x, y);
    if (!found) {
      // In the other modes a click chooses the body.
      const other = 1 - this.body;
      if (this.mode !== "look" && this.inside(other, this.poses()[other], x, y)) this.choose(other);
      return false;
    }
    if (found.body !== this.body) this.choose(found.body);
    if (found.kind === "vertex") this.vertex = found.index;
    this.host.begun();
    const poses = this.player.poses();
    this.drag = {
      kind: found.kind,
      index: found.index,
      from: this.camera.world(x, y),
      before: structuredClone(this.scene),
      t: this.player.t,
      posesBefore: poses,
      poses,
      velocity: this.velocity(),
    };
    this.host.redraw();
    return true;
  }

  onChoose: (body: number) => void = () => {};

  choose(body: number): void {
    this.body = body;
    this.vertex = -1;
    this.onChoose(body);
    this.host.redraw();
  }

  move(x: number, y: number): void {
    const drag = this.drag;
    if (!drag) return;
    const at = this.camera.world(x, y);
    const dx = at[0] - drag.from[0];
    const dy = at[1] - drag.from[1];
    const old = drag.before.bodies[this.body];
    const body = this.scene.bodies[this.body];
    const round = (v: number): number => this.rounded(v);
    if (drag.kind === "body") {
      body.motion = moved(old, round(dx), round(dy));
      drag.poses = [...drag.posesBefore];
      const pose = drag.poses[this.body];
      drag.poses[this.body] = { ...pose, x: pose.x + round(dx), y: pose.y + round(dy) };
    } else if (drag.kind === "vertex") {
      const [u, v] = local(drag.poses[this.body], ...at);
      body.polygon[drag.index] = [round(u), round(v)];
      this.figures = null;
    } else if (drag.kind === "ghost" || drag.kind === "turn") {
      this.moveGhost(drag, x, y, dx, dy);
    } else {
      this.drive(drag, x, y);
    }
    this.host.edited(this.scene, false, drag.kind === "arrow" || drag.kind === "spin");
  }

  private moveGhost(drag: Drag, x: number, y: number, dx: number, dy: number): void {
    const [start, end] = this.scene.time;
    let frames = keyframesOf(drag.before.bodies[this.body], start, end);
    if (!frames) return;
    let index = drag.index;
    // A body at rest has one keyframe: dragging its ghost sets it in motion, by a second one at the end.
    if (frames.length === 1 && end > start) {
      frames = [frames[0], { ...frames[0], t: end }];
      index = 1;
    }
    const k = frames[index];
    if (drag.kind === "ghost") {
      frames[index] = { ...k, x: this.rounded(k.x + dx), y: this.rounded(k.y + dy) };
    } else {
      const [u, v] = this.pivot();
      const [ox, oy] = this.camera.pixel(k.x + u, k.y + v);
      const angle = Math.atan2(oy - y, x - ox);
      const turn = angle - k.angle;
      const nearest = turn - 2 * Math.PI * Math.round(turn / (2 * Math.PI));
      frames[index] = { ...k, angle: Number((k.angle + nearest).toFixed(4)) };
    }
    this.scene.bodies[this.body].motion = motionOf(frames, this.pivot());
  }

  private drive(drag: Drag, x: number, y: number): void {
    const [ax, ay] = this.camera.pixel(...this.anchor(this.body));
    const time = this.arrowTime();
    const pose = drag.poses[this.body];
    if (drag.kind === "arrow") {
      drag.velocity = {
        ...drag.velocity,
        x: (x - ax) / time / this.camera.scale,
        y: (ay - y) / time / this.camera.scale,
      };
    } else {
      const angle = Math.atan2(ay - y, x - ax) - Math.PI / 2;
      const turn = angle - 2 * Math.PI * Math.round(angle / (2 * Math.PI));
      drag.velocity = { ...drag.velocity, spin: turn / time };
    }
    const old = drag.before.bodies[this.body];
    this.scene.bodies[this.body].motion = continued(old, pose, drag.t, this.scene.time[0], drag.velocity);
  }

  up(): void {
    const drag = this.drag;
    this.drag = null;
    this.stale = false;
    if (drag) this.host.edited(this.scene, true, drag.kind === "arrow" || drag.kind === "spin");
    this.host.redraw();
  }

  /** To a hundredth of a pixel or so: short numbers in files. */
  private rounded(v: number): number {
    const unit = 10 ** Math.floor(Math.log10(0.2 / this.camera.scale));
    return Number((Math.round(v / unit) * unit).toPrecision(12));
  }

  /** A new vertex on the edge that is nearest to the pixel, if one is near. */
  addVertex(x: number, y: number): boolean {
    if (this.mode !== "shape") return false;
    const { polygon } = this.scene.bodies[this.body];
    let best = -1;
    let distance = this.reach;
    for (let i = 0; i < polygon.length; ++i) {
      const a = this.pixel(this.body, i);
      const b = this.pixel(this.body, (i + 1) % polygon.length);
      const length = (b[0] - a[0]) ** 2 + (b[1] - a[1]) ** 2 || 1;
      const share = Math.min(1, Math.max(0, ((x - a[0]) * (b[0] - a[0]) + (y - a[1]) * (b[1] - a[1])) / length));
      const d = Math.hypot(x - a[0] - share * (b[0] - a[0]), y - a[1] - share * (b[1] - a[1]));
      if (d < distance) {
        distance = d;
        best = i;
      }
    }
    if (best < 0) return false;
    const [u, v] = local(this.poses()[this.body], ...this.camera.world(x, y));
    polygon.splice(best + 1, 0, [this.rounded(u), this.rounded(v)]);
    this.vertex = best + 1;
    this.figures = null;
    this.host.edited(this.scene, true, false);
    return true;
  }

  removeVertex(): boolean {
    const { polygon } = this.scene.bodies[this.body];
    if (this.mode !== "shape" || this.vertex < 0 || polygon.length <= 3) return false;
    polygon.splice(this.vertex, 1);
    this.vertex = -1;
    this.figures = null;
    this.host.edited(this.scene, true, false);
    return true;
  }

  private currentFigures(): [Figure, Figure] {
    this.figures ??= [new Figure(this.scene.bodies[0].polygon), new Figure(this.scene.bodies[1].polygon)];
    return this.figures;
  }

  /** While something is dragged, or the scene is not valid, bodies are shown as they are being edited. */
  frame(): Frame | null {
    if (!this.drag && this.faults.length === 0) return null;
    const { player } = this;
    const valid =
      this.faults.length === 0 && !this.stale && (!this.drag || (player.t === this.drag.t && !player.overlapping));
    return {
      figures: this.currentFigures(),
      names: [this.scene.bodies[0].name, this.scene.bodies[1].name],
      poses: this.poses(),
      replay: valid ? player.replay : null,
      event: null,
      contact: null,
      faults: this.faults,
    };
  }

  draw(c: CanvasRenderingContext2D, camera: Camera, colours: Colours): void {
    const colour = colours.bodyLine[this.body];
    c.lineWidth = 2;
    if (this.mode === "shape" && this.handlesShown()) {
      for (let i = 0; i < this.scene.bodies[this.body].polygon.length; ++i) {
        this.handle(c, this.pixel(this.body, i), i === this.vertex ? colours.come : colour, colours.paper, 4.5);
      }
    }
    if (this.mode === "keyframes") this.drawGhosts(c, camera, colours);
    if (this.mode === "drive") this.drawArrow(c, colours);
  }

  private handle(
    c: CanvasRenderingContext2D,
    [x, y]: [number, number],
    line: string,
    fill: string,
    radius: number,
  ): void {
    c.beginPath();
    c.arc(x, y, radius, 0, 2 * Math.PI);
    c.fillStyle = fill;
    c.fill();
    c.strokeStyle = line;
    c.lineWidth = 2;
    c.stroke();
  }

  private drawGhosts(c: CanvasRenderingContext2D, camera: Camera, colours: Colours): void {
    const frames = this.keyframes() ?? [];
    const figure = this.currentFigures()[this.body];
    const kept = figure.outline(0.7 / camera.scale);
    const colour = colours.bodyLine[this.body];
    c.setLineDash([6, 4]);
    c.strokeStyle = colour;
    c.lineWidth = 1.5;
    c.beginPath();
    frames.forEach((k, i) => {
      const [x, y] = camera.pixel(...placed(this.ghostPose(k), ...this.pivot()));
      if (i === 0) c.moveTo(x, y);
      else c.lineTo(x, y);
    });
    c.stroke();
    for (const k of frames) {
      const pose = this.ghostPose(k);
      c.beginPath();
      kept.forEach((i, n) => {
        const [x, y] = camera.pixel(...placed(pose, figure.x[i], figure.y[i]));
        if (n === 0) c.moveTo(x, y);
        else c.lineTo(x, y);
      });
      c.closePath();
      c.stroke();
    }
    c.setLineDash([]);
    c.font = "600 12px system-ui, sans-serif";
    frames.forEach((k, i) => {
      const pose = this.ghostPose(k);
      const origin = camera.pixel(...placed(pose, ...this.pivot()));
      const turn = this.turnHandle(pose);
      c.strokeStyle = colour;
      c.lineWidth = 1;
      c.beginPath();
      c.moveTo(...origin);
      c.lineTo(...turn);
      c.stroke();
      this.handle(c, origin, colour, colours.paper, 3);
      this.handle(c, turn, colour, colours.paper, 6);
      const label = frames.length === 1 ? "at rest" : `${i + 1}: t = ${Number(k.t.toPrecision(5))}`;
      c.strokeStyle = colours.paper;
      c.lineWidth = 3.5;
      c.strokeText(label, origin[0] + 8, origin[1] - 8);
      c.fillStyle = colours.ink;
      c.fillText(label, origin[0] + 8, origin[1] - 8);
    });
  }

  private drawArrow(c: CanvasRenderingContext2D, colours: Colours): void {
    const velocity = this.velocity();
    const pose = this.poses()[this.body];
    const pivot = this.camera.pixel(...placed(pose, ...this.pivot()));
    this.handle(c, pivot, colours.come, colours.paper, 2.5);
    const from = this.camera.pixel(...this.anchor(this.body));
    const tip = this.arrowTip(velocity);
    const spin = this.spinHandle(velocity);
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
      const turned = velocity.spin * this.arrowTime();
      c.arc(from[0], from[1], spinRadius, -Math.PI / 2, -Math.PI / 2 - turned, turned > 0);
      c.stroke();
    }
    this.handle(c, tip, colours.come, colours.paper, 7);
    this.handle(c, spin, colours.come, colours.paper, 6);
    c.font = "600 12px system-ui, sans-serif";
    for (const [label, at] of [
      ["velocity", tip],
      ["spin", spin],
      ["pivot", pivot],
    ] as [string, [number, number]][]) {
      c.strokeStyle = colours.paper;
      c.lineWidth = 3.5;
      c.strokeText(label, at[0] + 10, at[1] - 8);
      c.fillStyle = colours.ink;
      c.fillText(label, at[0] + 10, at[1] - 8);
    }
  }
}
