// Start and goal of a way, dragged in the picture.
import type { Camera } from "./camera";
import type { Pose } from "./engine";
import { local, placed } from "./figure";
import type { Frame } from "./frame";
import { insidePart, spinRadius } from "./handles";
import type { Shape } from "./shapes";
import type { Tool } from "./stage";
import { lineOf, type Colours } from "./theme";
import type { WayProblem } from "./wayproblem";

type End = "start" | "goal";

interface Drag {
  end: End;
  body: number;
  /** The point of the body that is held; none if it is turned. */
  held: [number, number] | null;
  /** Angle of the pointer about the pivot, and the joint's value, when the drag began. */
  from: { angle: number; value: number };
}

export interface WayView {
  readonly problem: WayProblem | null;
  /** The bodies of the problem. */
  readonly shapes: Shape[];
  /** Waypoints of the way that is shown, by the joints' values. */
  readonly waypoints: number[][];
  /** Where it was too tight. */
  readonly tight: number[] | null;
  /** The scene shown is not about this start and this goal: the bodies as they stand at the start, over that. */
  frame(poses: Pose[]): Frame | null;
  /** Start or goal is another one; `final` when the pointer was let go. */
  moved(final: boolean): void;
  redraw(): void;
}

/** Places between two waypoints for the line that the middle of a body goes along. */
const stepsOfLine = 24;

export class WayEditor implements Tool {
  private drag: Drag | null = null;
  private reach = 12;

  constructor(
    private readonly camera: Camera,
    private readonly view: WayView,
  ) {}

  extent(): [number, number][] {
    const { problem, shapes } = this.view;
    if (!problem) return [];
    return problem
      .movers()
      .flatMap((body) =>
        this.ends(problem).flatMap((end) =>
          (shapes[body]?.parts ?? []).flatMap(([figure]) =>
            [...figure.outline(figure.diameter / 50)].map((i) =>
              placed(problem.pose(body, problem[end]), figure.x[i], figure.y[i]),
            ),
          ),
        ),
      );
  }

  frame(): Frame | null {
    const { problem } = this.view;
    return problem && this.view.frame(problem.read.bodies.map((_, b) => problem.pose(b, problem.start)));
  }

  hover(x: number, y: number): string {
    return this.find(x, y) ? "move" : "";
  }

  down(x: number, y: number, e: PointerEvent): boolean {
    this.reach = e.pointerType === "touch" ? 24 : 12;
    this.drag = this.find(x, y);
    return this.drag !== null;
  }

  move(x: number, y: number): void {
    const { drag, camera } = this;
    const { problem } = this.view;
    if (!drag || !problem) return;
    const values = problem[drag.end];
    const wanted = drag.held
      ? problem.reaching(drag.body, drag.held, camera.world(x, y), values)
      : this.turned(problem, drag, values, x, y);
    if (drag.end === "goal") problem.moveGoal();
    wanted.forEach((value, k) => (values[k] = value));
    this.view.moved(false);
  }

  up(): void {
    if (this.drag) this.view.moved(true);
    this.drag = null;
  }

  draw(c: CanvasRenderingContext2D, _: Camera, colours: Colours): void {
    const { problem, waypoints, tight } = this.view;
    if (!problem) return;
    for (const body of problem.ends()) this.line(c, problem, body, waypoints, colours);
    for (const values of waypoints.slice(1, -1)) this.outlines(c, problem, values, colours.muted, [2, 3]);
    if (tight) this.outlines(c, problem, tight, colours.failingEdge, []);
    this.outlines(c, problem, problem.start, colours.ink, [6, 4]);
    if (!problem.outside) this.outlines(c, problem, problem.goal, colours.free, [6, 4], 0.3);
    for (const body of problem.movers()) {
      for (const end of this.ends(problem)) this.handle(c, problem, body, end, colours);
    }
    this.names(c, problem, colours);
  }

  private ends(problem: WayProblem): End[] {
    return problem.outside ? ["start"] : ["goal", "start"];
  }

  /** What lies below the pointer: the goal lies over the start. */
  private find(x: number, y: number): Drag | null {
    const { problem } = this.view;
    if (!problem) return null;
    for (const end of this.ends(problem)) {
      for (const body of problem.movers()) {
        const turn = problem.turnOf(body);
        if (turn < 0) continue;
        const [hx, hy] = this.handlePlace(problem, body, end);
        if (Math.hypot(hx - x, hy - y) <= this.reach)
          return {
            end,
            body,
            held: null,
            from: { angle: this.angle(problem, body, end, x, y), value: problem[end][turn] },
          };
      }
    }
    for (const end of this.ends(problem)) {
      // What hangs on something else lies over it.
      for (const body of problem.movers().reverse()) {
        const [u, v] = local(problem.pose(body, problem[end]), ...this.camera.world(x, y));
        if (problem.read.bodies[body].parts.some((rings) => insidePart(rings, u, v)))
          return { end, body, held: [u, v], from: { angle: 0, value: 0 } };
      }
    }
    return null;
  }

  private pivot(problem: WayProblem, body: number, end: End): [number, number] {
    return this.camera.pixel(...placed(problem.pose(body, problem[end]), ...problem.pivotOf(body)));
  }

  private angle(problem: WayProblem, body: number, end: End, x: number, y: number): number {
    const [px, py] = this.pivot(problem, body, end);
    return Math.atan2(py - y, x - px);
  }

  private handlePlace(problem: WayProblem, body: number, end: End): [number, number] {
    const [px, py] = this.pivot(problem, body, end);
    const { c, s } = problem.pose(body, problem[end]);
    return [px + spinRadius * c, py - spinRadius * s];
  }

  private turned(problem: WayProblem, drag: Drag, values: number[], x: number, y: number): number[] {
    const k = problem.turnOf(drag.body);
    const { range, periodic } = problem.read.joints[k];
    const motion = problem.read.bodies[drag.body].motion!.find(({ joint }) => joint === k)!;
    let turn = this.angle(problem, drag.body, drag.end, x, y) - drag.from.angle;
    turn -= 2 * Math.PI * Math.round(turn / (2 * Math.PI));
    let value = drag.from.value + (turn * 180) / Math.PI / (motion.times ?? 1);
    const period = range[1] - range[0];
    if (periodic) value -= period * Math.floor((value - range[0]) / period);
    return values.map((old, j) => (j === k ? Math.min(range[1], Math.max(range[0], Number(value.toFixed(3)))) : old));
  }

  private outlines(
    c: CanvasRenderingContext2D,
    problem: WayProblem,
    values: number[],
    colour: string,
    dashes: number[],
    fill = 0,
  ): void {
    const path = new Path2D();
    for (const body of problem.movers()) {
      const pose = problem.pose(body, values);
      for (const figure of this.view.shapes[body]?.parts.flat() ?? []) {
        const kept = figure.outline(0.5 / this.camera.scale);
        kept.forEach((i, k) => {
          const at = this.camera.pixel(...placed(pose, figure.x[i], figure.y[i]));
          if (k === 0) path.moveTo(...at);
          else path.lineTo(...at);
        });
        path.closePath();
      }
    }
    c.save();
    c.fillStyle = c.strokeStyle = colour;
    c.globalAlpha = fill;
    if (fill > 0) c.fill(path, "evenodd");
    c.globalAlpha = 1;
    c.setLineDash(dashes);
    c.lineWidth = 1.8;
    c.stroke(path);
    c.restore();
  }

  /** Where the middle of the body goes. */
  private line(
    c: CanvasRenderingContext2D,
    problem: WayProblem,
    body: number,
    waypoints: number[][],
    colours: Colours,
  ): void {
    const middle = this.view.shapes[body]?.outline.centre;
    if (!middle || waypoints.length < 2) return;
    c.save();
    c.strokeStyle = colours.free;
    c.lineWidth = 2;
    c.beginPath();
    for (let i = 0; i + 1 < waypoints.length; ++i) {
      for (let k = 0; k <= stepsOfLine; ++k) {
        const values = waypoints[i].map((a, j) => a + (k / stepsOfLine) * (waypoints[i + 1][j] - a));
        c.lineTo(...this.camera.pixel(...placed(problem.pose(body, values), ...middle)));
      }
    }
    c.stroke();
    c.restore();
  }

  private handle(c: CanvasRenderingContext2D, problem: WayProblem, body: number, end: End, colours: Colours): void {
    if (problem.turnOf(body) < 0) return;
    const from = this.pivot(problem, body, end);
    const to = this.handlePlace(problem, body, end);
    c.strokeStyle = lineOf(colours, body);
    c.lineWidth = 1;
    c.beginPath();
    c.moveTo(...from);
    c.lineTo(...to);
    c.stroke();
    c.lineWidth = 2;
    c.fillStyle = colours.paper;
    for (const [[x, y], radius] of [
      [from, 3],
      [to, 6],
    ] as [[number, number], number][]) {
      c.beginPath();
      c.arc(x, y, radius, 0, 2 * Math.PI);
      c.fill();
      c.stroke();
    }
  }

  private names(c: CanvasRenderingContext2D, problem: WayProblem, colours: Colours): void {
    const [body] = problem.movers().slice(-1);
    const middle = this.view.shapes[body]?.outline.centre;
    if (!middle) return;
    c.font = "600 13px system-ui, sans-serif";
    c.lineWidth = 3.5;
    c.lineJoin = "round";
    const places = this.ends(problem).map((end) => ({
      end,
      at: this.camera.pixel(...placed(problem.pose(body, problem[end]), ...middle)),
    }));
    const near =
      places.length > 1 && Math.hypot(places[0].at[0] - places[1].at[0], places[0].at[1] - places[1].at[1]) < 24;
    for (const {
      end,
      at: [x, y],
    } of near ? [{ end: "start and goal", at: places[0].at }] : places) {
      const { width } = c.measureText(end);
      c.strokeStyle = colours.paper;
      c.strokeText(end, x - width / 2, y - 14);
      c.fillStyle = end === "goal" ? colours.free : colours.ink;
      c.fillText(end, x - width / 2, y - 14);
    }
  }
}
