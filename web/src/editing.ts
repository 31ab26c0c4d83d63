// Editing by hand, in the picture: bodies and vertices, ghosts at the keyframes, and the motion from now on.
import type { Camera } from "./camera";
import { drives, follow, type Drag } from "./drags";
import type { Pose, Scene } from "./engine";
import { local } from "./figure";
import type { FaultMarks, Frame } from "./frame";
import { drawHandles } from "./handlemarks";
import { Handles, type Edited, type Handle, type Mode } from "./handles";
import { sheetsOf, type Hidden } from "./heights";
import { isJoined, LinkDrag, SampledMotion } from "./mechanisms";
import { keyframesOf, pivotOf, seenFrom, velocityAt, type Keyframe, type Velocity } from "./motions";
import type { Player } from "./player";
import { cornerAt, dropVertex, isCurved, Shape } from "./shapes";
import type { Tool } from "./stage";
import type { Colours } from "./theme";

/** A dragged link passes to another place of its way only if that is nearer by so many pixels. */
const slackOfLinks = 12;
/** It is put to its place as finely as this, in pixels. */
const fineOfLinks = 0.1;

export interface EditorHost {
  /** A drag begins. */
  begun(): void;
  /** A changed scene: `final` when the pointer was let go. */
  edited(scene: Scene, final: boolean, driven: boolean): void;
  redraw(): void;
  /** What is to be known, in words. */
  say(note: string): void;
  /** Bodies that are not to be seen. */
  readonly hidden: Hidden;
}

export class Editor implements Tool, Edited {
  mode: Mode = "look";
  body = 1;
  /** The scene as it is being edited; it may be invalid, unlike the player's. */
  scene!: Scene;
  faults: FaultMarks[] = [];
  vertex = -1;
  /** The map is that of an older scene: it is not drawn. */
  stale = false;
  readonly handles: Handles;
  private drag: Drag | null = null;
  /** Of a mechanism, whose time follows the pointer. */
  private link: LinkDrag | null = null;
  private sampled: { opened: number; motion: SampledMotion } | null = null;
  private ownShapes: Shape[] | null = null;

  constructor(
    private readonly player: Player,
    camera: Camera,
    private readonly host: EditorHost,
  ) {
    this.handles = new Handles(this, camera);
  }

  /** Takes up a scene from elsewhere. */
  adopt(scene: Scene): void {
    this.scene = structuredClone(scene);
    this.ownShapes = null;
    this.vertex = -1;
    this.body = Math.min(this.body, scene.bodies.length - 1);
  }

  get dragging(): boolean {
    return this.drag !== null;
  }

  keyframes(body = this.body): Keyframe[] | null {
    if (isJoined(this.scene, body)) return null;
    return keyframesOf(this.scene.bodies[body], this.scene.time[0], this.scene.time[1]);
  }

  pivot(): [number, number] {
    return pivotOf(this.scene.bodies[this.body]) ?? [0, 0];
  }

  poses(): Pose[] {
    return this.drag?.poses ?? this.player.poses();
  }

  velocity(): Velocity {
    if (this.drag) return this.drag.velocity;
    return velocityAt((t) => this.ownPose(t), this.pivot(), this.player.t, this.scene.time[1]);
  }

  base(t = this.drag?.t ?? this.player.t): Pose {
    const parent = this.scene.bodies[this.body].relative_to;
    const index = this.scene.bodies.findIndex((body) => body.name === parent);
    return this.player.engine.poses(t)[index] ?? { x: 0, y: 0, c: 1, s: 0 };
  }

  /** Of the chosen body, as its motion has it: seen from its parent. */
  ownPose(t: number): Pose {
    return seenFrom(this.base(t), this.player.engine.poses(t)[this.body]);
  }

  shapes(): Shape[] {
    this.ownShapes ??= this.scene.bodies.map((body) => new Shape(body));
    return this.ownShapes;
  }

  topmost(): number[] {
    const all = this.scene.bodies.map((_, b) => b);
    const painted = this.player.world?.order.filter((b) => b < all.length) ?? all;
    const seen = sheetsOf(this.shapes(), painted).filter(({ body, z }) => !this.host.hidden.hides(body, z));
    return [...new Set(seen.reverse().map(({ body }) => body))];
  }

  onChoose: (body: number) => void = () => {};

  choose(body: number): void {
    this.body = body;
    this.vertex = -1;
    this.onChoose(body);
    this.host.redraw();
  }

  hover(x: number, y: number): string {
    return this.handles.find(x, y) || this.linkBelow(x, y) >= 0 ? "move" : "";
  }

  down(x: number, y: number, e: PointerEvent): boolean {
    this.handles.use(e);
    const found = this.handles.find(x, y);
    if (this.takesLink(x, y, found)) return true;
    if (!found) {
      // In the other modes a click chooses the body.
      const other = this.topmost().find((b) => b !== this.body && this.handles.covers(b, x, y));
      if (this.mode !== "look" && other !== undefined) this.choose(other);
      return false;
    }
    if (found.body !== this.body) this.choose(found.body);
    if (found.kind === "vertex") this.vertex = found.index;
    this.host.begun();
    const poses = this.player.poses();
    this.drag = {
      ...found,
      from: this.handles.camera.world(x, y),
      before: structuredClone(this.scene),
      t: this.player.t,
      posesBefore: poses,
      poses,
      velocity: this.velocity(),
    };
    this.host.redraw();
    return true;
  }

  /** The body of a mechanism below the pointer, or -1. */
  private linkBelow(x: number, y: number): number {
    const { mechanism, bodies } = this.scene;
    if (!mechanism || this.faults.length > 0) return -1;
    const body = this.topmost().find((b) => this.handles.covers(b, x, y)) ?? -1;
    return body >= 0 && bodies[body].name !== mechanism.ground ? body : -1;
  }

  private motion(): SampledMotion {
    const { player, sampled } = this;
    const known = sampled?.opened === player.opened && sampled.motion.end === player.limit;
    if (!known) {
      const motion = new SampledMotion((t) => player.engine.poses(t), player.start, player.limit);
      this.sampled = { opened: player.opened, motion };
    }
    return this.sampled!.motion;
  }

  /** Links have no place of their own: what drags one as a whole moves the mechanism, by its time. */
  private takesLink(x: number, y: number, found: Handle | null): boolean {
    const body = this.linkBelow(x, y);
    if (body < 0 || (found && (found.kind !== "body" || !isJoined(this.scene, found.body)))) return false;
    const { player } = this;
    const { camera } = this.handles;
    const link = new LinkDrag(this.motion(), body, camera.world(x, y), player.t, fineOfLinks / camera.scale);
    if (!(link.reach * camera.scale > 1)) return false;
    player.play(false);
    this.link = link;
    if (body !== this.body) this.choose(body);
    return true;
  }

  move(x: number, y: number): void {
    const { drag, link } = this;
    const { camera } = this.handles;
    if (link) this.player.seek(link.nearest(camera.world(x, y), this.player.t, slackOfLinks / camera.scale));
    if (!drag) return;
    follow(drag, this.scene, this.handles, x, y);
    if (drag.kind === "vertex") this.ownShapes = null;
    this.host.edited(this.scene, false, drives(drag));
  }

  up(): void {
    this.link = null;
    const { drag } = this;
    this.drag = null;
    this.stale = false;
    if (drag) this.host.edited(this.scene, true, drives(drag));
    this.host.redraw();
  }

  /** A new vertex on the edge that is nearest to the pixel, if one is near. */
  addVertex(x: number, y: number): boolean {
    if (this.mode !== "shape") return false;
    if (isCurved(this.scene.bodies[this.body]) && this.handles.covers(this.body, x, y)) return this.refuseCurves();
    const edge = this.handles.edgeAt(x, y);
    if (edge < 0) return false;
    const [u, v] = local(this.poses()[this.body], ...this.handles.camera.world(x, y));
    const { ring, index } = cornerAt(this.scene.bodies[this.body], edge);
    ring.splice(index + 1, 0, [this.handles.rounded(u), this.handles.rounded(v)]);
    this.reshaped(edge + 1);
    return true;
  }

  removeVertex(): boolean {
    if (this.mode !== "shape") return false;
    if (isCurved(this.scene.bodies[this.body])) return this.refuseCurves();
    if (this.vertex < 0) return false;
    if (!dropVertex(this.scene.bodies[this.body], this.vertex)) return false;
    this.reshaped(-1);
    return true;
  }

  /** Curves have no vertices to be taken hold of: says where they are changed. */
  private refuseCurves(): boolean {
    this.host.say(
      `${this.scene.bodies[this.body].name} is bounded by curves: change its path in the text below, "Outline" or ` +
        `"Scene file". Here it can be moved as a whole.`,
    );
    return true;
  }

  private reshaped(vertex: number): void {
    this.vertex = vertex;
    this.ownShapes = null;
    this.host.edited(this.scene, true, false);
  }

  /** While something is dragged, or the scene is not valid, bodies are shown as they are being edited. */
  frame(): Frame | null {
    if (!this.drag && this.faults.length === 0) return null;
    const { player } = this;
    const valid =
      this.faults.length === 0 && !this.stale && (!this.drag || (player.t === this.drag.t && !player.overlapping));
    return {
      shapes: this.shapes(),
      figures: this.shapes().map((shape) => shape.outline),
      names: this.scene.bodies.map((body) => body.name),
      poses: this.poses(),
      world: player.world,
      hidden: this.host.hidden,
      replay: valid && !player.world ? player.replay : null,
      tilings: null,
      event: null,
      contacts: [],
      overlaps: [],
      faults: this.faults,
    };
  }

  draw(c: CanvasRenderingContext2D, _: Camera, colours: Colours): void {
    drawHandles(c, this, this.handles, colours);
  }
}
