// Is there any way? The problem at hand, what is asked about it, and the answer.
import { linesOf, type Background } from "./background";
import { inParts, type Pose, type Scene, type WorldStyles } from "./engine";
import type { Frame } from "./frame";
import { isJoined } from "./mechanisms";
import { Shape } from "./shapes";
import { WayEditor, type WayView } from "./wayeditor";
import { WayPanel } from "./waypanel";
import { problemOf, WayProblem, type FoundWay, type ProblemFile } from "./wayproblem";
import { wayVerdict } from "./waywords";
import type { Verdict, Workbench } from "./workbench";

export interface WaysHost {
  closed(): boolean;
  /** Opens a scene of the problem, as a change that can be undone. */
  show(scene: Scene, title: string | null, way: boolean): void;
}

export class Ways implements WayView {
  problem: WayProblem | null = null;
  shapes: Shape[] = [];
  private styles: WorldStyles | null = null;
  readonly editor: WayEditor;
  readonly panel: WayPanel;
  private found: FoundWay | null = null;
  private fault: string[] | null = null;
  /** The scene shown is the way that was found. */
  private fresh = false;
  /** The body of the scene that the problem was made for; -1 if it was read. */
  private body = -1;
  private turns = true;
  private clearance = 0;
  private shortest = false;
  active = false;

  constructor(
    private readonly workbench: Workbench,
    private readonly host: WaysHost,
  ) {
    this.editor = new WayEditor(workbench.stage.camera, this);
    this.panel = new WayPanel({
      setTurns: (on) => this.setTurns(on),
      setOutside: (on) => {
        if (!this.problem) return;
        this.problem.outside = on;
        this.search();
      },
      setClearance: (distance) => {
        this.clearance = distance;
        this.search();
      },
      setShortest: (on) => {
        this.shortest = on;
        this.search();
      },
      setValue: (end, joint, value) => {
        if (!this.problem) return;
        if (end === "goal") this.problem.moveGoal();
        this.problem[end][joint] = value;
        this.search();
      },
      stop: () => this.stop(),
      again: () => this.search(),
    });
  }

  get waypoints(): number[][] {
    const { answer } = this.found ?? {};
    const joints = this.problem?.read.joints ?? [];
    return (answer?.waypoints ?? []).map((values) => joints.map(({ name }) => values[name]));
  }

  get tight(): number[] | null {
    const tight = this.found?.answer.tight;
    return tight && this.problem ? this.problem.read.joints.map(({ name }) => tight.values[name]) : null;
  }

  private get background(): Background {
    return this.workbench.background;
  }

  /** For tests: is a way being looked for? */
  get busy(): boolean {
    return this.background.busy;
  }

  /** A problem about this body of the scene that is open: from its first place to its last one. */
  enter(scene: Scene, body: number): void {
    const { player } = this.workbench;
    const [start, end] = scene.time.map((t) => player.engine.poses(t));
    player.play(false);
    player.seek(player.start);
    this.active = true;
    this.body = body;
    this.drop();
    if (isJoined(scene, body))
      return this.refuse(["A link of a mechanism has no way of its own. Choose another body."]);
    this.make(scene, start, goalOf(scene, body, start[body], end[body]));
  }

  /** The same problem, but that the body may turn or may not. */
  private setTurns(on: boolean): void {
    this.turns = on;
    const { problem, body } = this;
    if (!problem || body < 0) return;
    const start = problem.read.bodies.map((_, b) => problem.pose(b, problem.start));
    const { outside } = problem;
    this.make(inParts(structuredClone(problem.read.scene)), start, problem.pose(body, problem.goal), outside);
  }

  private make(scene: Scene, start: Pose[], goal: Pose, outside = false): void {
    const file = problemOf(scene, this.body, start, goal, this.turns);
    if (!file)
      return this.refuse([
        "Ways are found among polygons, and a body here has curves.",
        "`taut flatten` makes polygons around them.",
      ]);
    this.adopt(file, outside);
    this.search();
  }

  /** A problem from a file or an example. Throws TautError, and the present one stays. */
  open(text: string, name: string, title: string | null): void {
    const read = this.workbench.player.engine.readProblem(text, name);
    this.active = true;
    this.drop();
    this.body = -1;
    this.take(new WayProblem(JSON.parse(text) as ProblemFile, read));
    this.host.show(inParts(read.scene), title, false);
    this.search();
  }

  /** What was looked for is kept by nobody. */
  leave(): void {
    this.active = false;
    this.drop();
    this.panel.show(null, false, this.turns);
    this.workbench.verdict = null;
  }

  /** Start or goal is another one. */
  moved(final: boolean): void {
    if (final) return this.search();
    this.background.stop();
    this.forget();
    this.panel.show(this.problem, this.body >= 0, this.turns);
    this.redraw();
  }

  search(): void {
    const { problem, workbench } = this;
    if (!problem) return;
    workbench.player.play(false);
    this.forget();
    void this.background
      .call("findWay", problem.text(), this.host.closed(), this.clearance, this.shortest)
      .then((found) => found && this.answered(found))
      .catch((error: unknown) => this.refuse(linesOf(error)));
    this.show();
  }

  frame(poses: Pose[]): Frame | null {
    const { player, stage } = this.workbench;
    if (this.fresh || !this.active || poses.length !== player.shapes.length) return null;
    return {
      shapes: this.shapes,
      figures: this.shapes.map((shape) => shape.outline),
      names: player.scene.bodies.map((body) => body.name),
      poses,
      world: player.world && this.styles,
      hidden: stage.hidden,
      replay: null,
      tilings: null,
      event: null,
      contacts: [],
      overlaps: [],
      faults: [],
    };
  }

  redraw(): void {
    this.workbench.redraw();
  }

  private stop(): void {
    this.background.stop();
    this.refuse(["The search was stopped."]);
  }

  private adopt(file: ProblemFile, outside: boolean): void {
    this.drop();
    try {
      const read = this.workbench.player.engine.readProblem(JSON.stringify(file), "way");
      this.take(new WayProblem(file, read, outside));
    } catch (error) {
      this.refuse(linesOf(error));
    }
  }

  private take(problem: WayProblem): void {
    this.problem = problem;
    const { scene } = problem.read;
    this.shapes = inParts(structuredClone(scene)).bodies.map((body) => new Shape(body));
    this.styles = this.workbench.player.engine.shapes(JSON.stringify(scene));
  }

  private answered(found: FoundWay): void {
    this.found = found;
    if (found.scene) {
      this.host.show(inParts(found.scene), null, true);
      this.fresh = true;
      this.workbench.player.seek(this.workbench.player.start);
      this.workbench.player.play(true);
    }
    this.show();
  }

  private refuse(lines: string[]): void {
    this.fault = lines;
    this.show();
  }

  private drop(): void {
    this.background.stop();
    this.problem = null;
    this.forget();
  }

  private forget(): void {
    this.found = this.fault = null;
    this.fresh = false;
  }

  private show(): void {
    this.panel.show(this.problem, this.body >= 0, this.turns, this.busy);
    this.workbench.verdict = (): Verdict => wayVerdict(this.problem, this.found, this.fault);
    this.redraw();
  }
}

/** Where the body is at the end of the time; beside its place, if that is where it is now. */
function goalOf(scene: Scene, body: number, a: Pose, b: Pose): Pose {
  const still = Math.abs(a.x - b.x) + Math.abs(a.y - b.y) + Math.abs(a.c - b.c) + Math.abs(a.s - b.s) < 1e-9;
  return still ? { ...a, x: a.x + 1.5 * new Shape(scene.bodies[body]).outline.diameter } : b;
}
