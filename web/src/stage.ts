// The canvas: what is shown of the world, and moving about in it.
import { Camera, type Box } from "./camera";
import { fitCanvas, h, iconButton } from "./dom";
import { Painter } from "./drawing";
import { placed } from "./figure";
import type { FaultMarks, Frame, Layers, NearestMarks, RegionMarks } from "./frame";
import { heightsText, Hidden, layersOf } from "./heights";
import type { Player } from "./player";
import { ringText, roundText } from "./words";
import { coloursOf, type Colours, type ThemeChoice } from "./theme";

/** What may take the pointer before the view does, and draws over the picture: the editor. */
export interface Tool {
  /** True if the tool takes this drag. */
  down(x: number, y: number, e: PointerEvent): boolean;
  move(x: number, y: number, e: PointerEvent): void;
  up(): void;
  hover(x: number, y: number): string;
  draw(context: CanvasRenderingContext2D, camera: Camera, colours: Colours): void;
  /** Bodies as they are being edited, instead of the player's. */
  frame(): Frame | null;
  /** What is to be seen besides. */
  extent?(): [number, number][];
}

/** The buttons for the view lie on the right: nothing that is shown does. */
const roomForButtons = 36;

export class Stage {
  readonly camera = new Camera();
  readonly canvas = h("canvas", { class: "picture", tabindex: 0, role: "img" });
  readonly element: HTMLElement;
  /** The vertex below the pointer. */
  private readonly readout = h("output", { class: "readout", id: "readout" });
  readonly painter: Painter;
  layers: Layers = { proof: false, faces: true, tiling: true, corners: true, vertices: false, bands: true };
  theme: ThemeChoice = "auto";
  faults: FaultMarks[] = [];
  /** Where bodies are closest, if that is now. */
  nearest: NearestMarks | null = null;
  /** What a body passes over. */
  region: RegionMarks | null = null;
  /** What is not to be seen of a world. */
  readonly hidden = new Hidden();
  tool: Tool | null = null;
  /** True if the double click was meant for something else than the view. */
  onDoubleClick: (x: number, y: number) => boolean = () => false;
  /** The view was moved by hand: leave it. */
  private moved = false;
  /** The point that is shown large, if one is. */
  zoomedTo: [number, number] | null = null;
  private readonly pointers = new Map<number, [number, number]>();
  private toolDrags = false;

  constructor(
    private readonly player: Player,
    private readonly redraw: () => void,
  ) {
    const buttons = h(
      "div",
      { class: "zoom", role: "group", "aria-label": "View" },
      iconButton("plus", "Zoom in", () => this.zoom(1.4), "+"),
      iconButton("minus", "Zoom out", () => this.zoom(1 / 1.4), "-"),
      iconButton("fit", "Show everything", () => this.fit(), "0"),
    );
    this.element = h("div", { class: "stage" }, this.canvas, buttons, this.readout);
    this.painter = new Painter(this.canvas.getContext("2d", { alpha: false })!, this.camera);
    this.listen();
    new ResizeObserver(() => {
      if (!this.moved) this.fit();
      this.redraw();
    }).observe(this.element);
  }

  colours(): Colours {
    return coloursOf(this.theme);
  }

  frame(): Frame {
    const player = this.player;
    return (
      this.tool?.frame() ?? {
        shapes: player.shapes,
        figures: player.figures,
        names: player.scene.bodies.map((body) => body.name),
        poses: player.poses(),
        world: player.world,
        hidden: this.hidden,
        replay: player.behind || player.world ? null : player.replay,
        tilings: player.world && !player.behind ? () => player.tilings() : null,
        event: player.marks(),
        contacts: player.contactMarks(),
        overlaps: player.overlaps(),
        faults: this.faults,
      }
    );
  }

  draw(): void {
    const { clientWidth: width, clientHeight: height } = this.element;
    if (width === 0 || height === 0) return;
    const ratio = fitCanvas(this.canvas, width, height);
    this.camera.resize(width, height);
    const colours = this.colours();
    this.painter.draw(this.frame(), this.layers, colours, ratio);
    if (this.region) this.painter.region(this.region, this.frame(), colours);
    if (this.nearest) this.painter.marks.nearest(this.nearest, colours);
    this.tool?.draw(this.canvas.getContext("2d")!, this.camera, colours);
  }

  /** The picture without what the tool draws over it. */
  drawAlone(): void {
    const { tool } = this;
    this.tool = null;
    this.draw();
    this.tool = tool;
  }

  /** Shows everything that the bodies pass over, as far as it is known. */
  fit(): void {
    this.moved = false;
    this.zoomedTo = null;
    const { clientWidth: width, clientHeight: height } = this.element;
    if (width === 0 || !this.player.scene) return;
    this.camera.resize(width, height);
    this.camera.fit(this.extent(), roomForButtons);
    this.redraw();
  }

  /** As fit(), unless the view was moved by hand. */
  refit(): void {
    if (!this.moved) this.fit();
  }

  zoom(factor: number): void {
    this.moved = true;
    this.camera.zoom(factor);
    this.redraw();
  }

  pan(dx: number, dy: number): void {
    this.moved = true;
    this.camera.pan(dx, dy);
    this.redraw();
  }

  /** Shows these points large, and no less than `least` of the world. */
  zoomTo(points: [number, number][], least = this.player.figures[0].diameter * 1e-3): void {
    const box = boxOf(points);
    this.zoomedTo = points[0];
    const size = Math.max(box.highX - box.lowX, box.highY - box.lowY, least);
    const room = 0.8 * size;
    this.moved = true;
    this.camera.fit({ lowX: box.lowX - room, lowY: box.lowY - room, highX: box.highX + room, highY: box.highY + room });
    this.redraw();
  }

  private extent(): Box {
    const { player } = this;
    const points: [number, number][] = this.tool?.extent?.() ?? [];
    const samples = 48;
    for (let i = 0; i <= samples; ++i) {
      const poses = player.engine.poses(player.start + ((player.end - player.start) * i) / samples);
      player.shapes.forEach((shape, b) => {
        for (const [f] of shape.parts)
          for (const k of f.outline(f.diameter / 50)) points.push(placed(poses[b], f.x[k], f.y[k]));
      });
    }
    return boxOf(points.filter(([x, y]) => Number.isFinite(x) && Number.isFinite(y)));
  }

  private place(e: { clientX: number; clientY: number }): [number, number] {
    const box = this.canvas.getBoundingClientRect();
    return [e.clientX - box.left, e.clientY - box.top];
  }

  private listen(): void {
    const { canvas } = this;
    canvas.addEventListener(
      "wheel",
      (e) => {
        e.preventDefault();
        this.moved = true;
        const lines = e.deltaMode === 1 ? 16 : 1;
        this.camera.zoom(Math.exp(-e.deltaY * lines * 0.0015), ...this.place(e));
        this.redraw();
      },
      { passive: false },
    );
    canvas.addEventListener("dblclick", (e) => {
      if (!this.onDoubleClick(...this.place(e))) this.fit();
    });
    canvas.addEventListener("pointerdown", (e) => {
      canvas.setPointerCapture(e.pointerId);
      const at = this.place(e);
      this.pointers.set(e.pointerId, at);
      if (this.pointers.size === 1 && e.button === 0) this.toolDrags = this.tool?.down(...at, e) ?? false;
    });
    canvas.addEventListener("pointermove", (e) => this.dragged(e));
    const end = (e: PointerEvent): void => {
      this.pointers.delete(e.pointerId);
      if (this.toolDrags && this.pointers.size === 0) {
        this.toolDrags = false;
        this.tool?.up();
      }
    };
    canvas.addEventListener("pointerup", end);
    canvas.addEventListener("pointercancel", end);
  }

  private readOut([x, y]: [number, number]): void {
    const frame = this.frame();
    const found = this.painter.nearestVertex(frame, x, y, 10);
    let text = "";
    if (found) {
      const figure = frame.shapes[found.body].parts[found.part][found.ring];
      const [wx, wy] = placed(frame.poses[found.body], ...figure.corner(found.index));
      const ring = ringText(found, frame.shapes[found.body].parts.length);
      const layer =
        layersOf(this.player.scene.bodies).length > 0 ? heightsText(frame.shapes[found.body].heights[found.part]) : "";
      text = `${figure.curve ? "start of segment" : "vertex"} ${found.index} of ${ring}${frame.names[found.body]} at (${roundText(wx, 9)}, ${roundText(wy, 9)})${layer && ", "}${layer}`;
    }
    if (this.readout.textContent !== text) this.readout.textContent = text;
  }

  private dragged(e: PointerEvent): void {
    const at = this.place(e);
    const before = this.pointers.get(e.pointerId);
    if (!before) {
      this.canvas.style.cursor = this.tool?.hover(...at) || "grab";
      this.readOut(at);
      return;
    }
    if (this.toolDrags) {
      this.tool?.move(...at, e);
    } else if (this.pointers.size === 1) {
      this.pan(at[0] - before[0], at[1] - before[1]);
    } else {
      const [, other] = [...this.pointers].find(([id]) => id !== e.pointerId)!;
      const gap = (p: [number, number]): number => Math.hypot(p[0] - other[0], p[1] - other[1]);
      this.camera.pan((at[0] - before[0]) / 2, (at[1] - before[1]) / 2);
      if (gap(before) > 10) this.camera.zoom(gap(at) / gap(before), (at[0] + other[0]) / 2, (at[1] + other[1]) / 2);
      this.moved = true;
      this.redraw();
    }
    this.pointers.set(e.pointerId, at);
  }
}

function boxOf(points: [number, number][]): Box {
  const box = { lowX: Infinity, lowY: Infinity, highX: -Infinity, highY: -Infinity };
  for (const [x, y] of points) {
    box.lowX = Math.min(box.lowX, x);
    box.lowY = Math.min(box.lowY, y);
    box.highX = Math.max(box.highX, x);
    box.highY = Math.max(box.highY, y);
  }
  return points.length > 0 ? box : { lowX: -1, lowY: -1, highX: 1, highY: 1 };
}
