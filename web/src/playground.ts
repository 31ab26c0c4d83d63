// The page for trying things out: scenes are opened, changed by hand, shared and saved.
import { Changes, type Base } from "./changes";
import { Editor } from "./editing";
import { EditPanel, modeOfKey } from "./editpanel";
import type { Part, Pose, Scene } from "./engine";
import { FaultMessage, culprits } from "./faultmessage";
import { FileReading } from "./filereading";
import type { Mode } from "./handles";
import { History } from "./history";
import { besideOthers, withOutline } from "./importing";
import { keyframesOf, motionOf, piecesOf, sampled, withKeyframe, type Keyframe } from "./motions";
import { acceptDrops, headerTools, pageExamples, type Example, type OpenHost } from "./openandsave";
import type { Player } from "./player";
import { PathText } from "./pathtext";
import { SaveMenu } from "./saving";
import { SceneText } from "./scenetext";
import { fromFragment, shareLink, type Shared } from "./sharing";
import { isProblem } from "./wayproblem";
import { Ways } from "./ways";
import { Workbench } from "./workbench";
import { WorldEditing } from "./worldediting";
import { roundText } from "./words";

const firstExample = "lid";

/** What is opened first, unless the address has a scene. */
export interface Begin extends Shared {
  title: string | null;
}

export class Playground {
  private readonly workbench: Workbench;
  private readonly editor: Editor;
  private readonly examples = pageExamples();
  private readonly message = new FaultMessage();
  private readonly panel: EditPanel;
  private readonly text: SceneText;
  private readonly path: PathText;
  private readonly history: History;
  private readonly changes: Changes;
  private readonly worldEditing: WorldEditing;
  private readonly ways: Ways;
  /** A scene is being opened that belongs to the way that is asked about. */
  private showsWay = false;
  private readonly files: FileReading;
  private first: Begin | null = null;
  /** The last scene that could be opened, for plan changes and undoing. */
  private valid!: Scene;

  constructor(private readonly player: Player) {
    this.workbench = new Workbench(player, [
      ["1 2 3 4 5", "what dragging does"],
      ["Delete", "remove the chosen vertex"],
      ["Ctrl-Z", "undo; with Shift, redo"],
    ]);
    this.changes = this.newChanges();
    this.editor = new Editor(player, this.workbench.stage.camera, {
      edited: (_, final, driven) => this.changes.schedule(final, driven),
      begun: () => this.changes.hold(),
      redraw: () => this.workbench.redraw(),
      say: (note) => (this.panel.note = note),
      hidden: this.workbench.stage.hidden,
    });
    this.history = new History({ present: () => this.editor.scene && this.valid, restore: (s) => this.restore(s) });
    this.panel = this.newPanel();
    this.text = new SceneText(
      () => this.editor.scene,
      (text) => this.applyText(text),
    );
    this.path = new PathText((body, paths) => this.applyPaths(body, paths));
    this.worldEditing = new WorldEditing(player, this.editor, this.workbench, {
      change: (scene, note, body) => this.change(scene, note, body),
      say: (note) => (this.panel.note = note),
    });
    this.files = new FileReading(player.engine, {
      load: (scene, title) => this.load(scene, title),
      openProblem: (text, name, title) => this.openProblem(text, name, title),
      adoptOutline: (parts, title, body) => this.adoptOutline(parts, title, body),
      refuse: (error, what) => this.refuse(error, what),
      body: () => this.editor.body,
      count: () => this.editor.scene.bodies.length,
    });
    this.ways = new Ways(this.workbench, {
      closed: () => this.panel.touch === "closed",
      show: (scene, title, way) => this.showWay(scene, title, way),
    });
    this.build();
    document.addEventListener("keydown", (e) => this.key(e));
    addEventListener("hashchange", () => void this.fromAddress());
  }

  get element(): HTMLElement {
    return this.workbench.element;
  }

  /** Without a scene to begin with, the page's first example. */
  async begin(first: Begin | null = null): Promise<void> {
    this.setMode("look");
    this.first = first;
    if (!(await this.fromAddress())) this.loadFirst();
    Object.assign(window, { taut: this.workbench, playground: this });
  }

  private loadFirst(): void {
    const { first } = this;
    if (!first) return this.loadExample(this.examples[firstExample]);
    this.load(this.player.engine.readScene(JSON.stringify(first.scene), "scene"), first.title, first.touch);
  }

  private newChanges(): Changes {
    return new Changes(this.player, () => this.editor, {
      first: () => {
        this.history.remember();
        return this.valid;
      },
      apply: (final, base) => this.apply(final, base.t),
      drive: (base) => this.drive(base),
      redraw: () => this.workbench.redraw(),
    });
  }

  private newPanel(): EditPanel {
    return new EditPanel({
      setMode: (mode) => this.setMode(mode),
      choose: (body) => this.choose(body),
      setTouch: () => (this.ways.active ? this.ways.search() : this.apply(true)),
      setTime: (start, end) => this.setTime(start, end),
      set: (frames) => this.setKeyframes(frames),
      add: (frames) => {
        const more = withKeyframe(frames, this.player.t, ...this.editor.scene.time);
        if (more) this.setKeyframes(more, "keyframes");
      },
      sample: () => {
        const poses = (t: number): Pose => this.editor.ownPose(t);
        this.setKeyframes(sampled(poses, this.editor.pivot(), ...this.editor.scene.time), "keyframes");
      },
    });
  }

  private build(): void {
    const { stage, side, headerTools: tools, element } = this.workbench;
    stage.tool = this.editor;
    this.editor.onChoose = () => this.showBody();
    stage.onDoubleClick = (x, y) => this.editor.addVertex(x, y);
    const host: OpenHost = {
      open: (example) => this.loadExample(example),
      read: (files) => this.files.read(files),
      share: () => this.share(),
    };
    const menu = new SaveMenu(this.workbench, {
      name: () => "scene",
      scene: () => this.editor.scene,
      refuse: (error, what) => this.refuse(error, what),
    });
    const { undoButton, redoButton } = this.history;
    tools.append(...headerTools(this.examples, host), menu.element, undoButton, redoButton);
    side.insertBefore(this.files.report.element, side.children[1]);
    side.insertBefore(this.panel.element, side.children[2]);
    side.insertBefore(this.ways.panel.element, side.children[3]);
    this.workbench.bodiesPart.append(this.worldEditing.panel.element);
    this.workbench.element.classList.add("editable");
    side.append(this.path.element, this.text.element);
    stage.element.append(this.message.element);
    acceptDrops(element, host);
  }

  /** Opens the scene of a shared link. False if the address is none; of a damaged one, the page says so. */
  private async fromAddress(): Promise<boolean> {
    try {
      const shared = await fromFragment(location.hash);
      if (!shared) return false;
      const scene = this.player.engine.readScene(JSON.stringify(shared.scene), "link");
      this.load(scene, null, shared.touch === "closed" ? "closed" : "open");
    } catch (error) {
      const first = this.editor.scene === undefined;
      if (first) this.loadFirst();
      const shown = !first ? "the one from before" : this.first ? "the page's own" : "an example";
      this.refuse(error, `The link holds no scene that can be read. The scene shown is ${shown}.`);
    }
    return true;
  }

  private setMode(mode: Mode): void {
    const { stage, excursion } = this.workbench;
    if (mode !== this.editor.mode) excursion.reset();
    this.editor.mode = mode;
    this.panel.showMode(mode);
    const way = mode === "way";
    this.workbench.element.classList.toggle("way", way);
    stage.tool = way ? this.ways.editor : this.editor;
    if (way && !this.ways.active) this.ways.enter(this.valid, this.editor.body);
    if (!way && this.ways.active) this.ways.leave();
    if (way) stage.refit();
    this.workbench.redraw();
  }

  private choose(body: number): void {
    this.editor.choose(body);
    if (this.ways.active) this.ways.enter(this.valid, body);
  }

  /** A scene with joints, a start and a goal. Throws TautError, and what is there stays. */
  private openProblem(text: string, name: string, title: string | null): void {
    if (this.ways.active) this.setMode("look");
    this.ways.open(text, name, title);
    this.setMode("way");
  }

  private showWay(scene: Scene, title: string | null, way: boolean): void {
    this.showsWay = true;
    try {
      if (way) this.change(scene, "", this.editor.body);
      else this.load(scene, title);
    } finally {
      this.showsWay = false;
    }
  }

  private loadExample({ scene, title }: Example): void {
    const text = JSON.stringify(scene);
    if (isProblem(text)) this.openProblem(text, title, title);
    else this.load(this.player.engine.readScene(text, title), title);
  }

  /** Opens a scene from elsewhere, at its start. Throws TautError, and the present scene stays as it is. */
  private load(scene: Scene, title: string | null, touch = this.panel.touch): void {
    this.player.open(structuredClone(scene), touch === "closed", scene.time[0]);
    this.history.remember();
    this.panel.touch = touch;
    this.workbench.title = title;
    this.editor.adopt(scene);
    this.succeeded(this.player.scene);
    this.showBody();
    this.workbench.opened();
    this.panel.note = "";
  }

  private restore(scene: Scene): void {
    this.editor.adopt(scene);
    this.apply(true);
  }

  /** Opens the edited scene, and shows what is wrong with it if it cannot be opened. */
  private apply(final: boolean, at = this.player.t): void {
    const scene = structuredClone(this.editor.scene);
    try {
      const t = Math.min(Math.max(at, scene.time[0]), scene.time[1]);
      this.player.open(scene, this.panel.touch === "closed", t);
      this.succeeded(scene);
    } catch (error) {
      this.workbench.invalid = true;
      this.fail(error);
    }
    if (final) this.showBody();
  }

  /** A new plan from the instant shown on. */
  private drive(base: Base): void {
    // There is no map that could stay: the world is answered anew.
    if (this.player.world) return this.apply(true, base.t);
    const scene = structuredClone(this.editor.scene);
    const { body } = this.editor;
    const events = this.player.replay.count;
    try {
      const { milliseconds, certificates } = this.player.changePlan(base.scene, scene, body, base.t);
      this.succeeded(scene);
      this.panel.note =
        `New plan for ${scene.bodies[body].name} at t = ${roundText(base.t)}: the map stays, ${certificates} certificates ` +
        `get new failure times, in ${milliseconds.toFixed(1)} ms. Events before it: ${this.player.replay.applied} of ${events} stay.`;
    } catch (error) {
      this.workbench.invalid = true;
      this.fail(error);
    }
    this.showBody();
  }

  private succeeded(scene: Scene): void {
    // Another scene than the way's is about something else.
    if (this.ways.active && !this.showsWay) this.setMode("look");
    this.valid = scene;
    this.editor.faults = [];
    this.workbench.invalid = false;
    this.message.hide();
    this.history.showButtons();
    this.workbench.redraw();
  }

  /** Of the scene that is shown: what is wrong is marked in it. */
  private fail(error: unknown): void {
    this.editor.faults = culprits(error);
    this.message.show(error);
    this.workbench.redraw();
  }

  /** Of what is not shown: the scene and its answer stay, and nothing in it is at fault. */
  private refuse(error: unknown, what: string): void {
    this.message.show(error, what);
  }

  /** A scene with other bodies, or that belong together otherwise. */
  private change(scene: Scene, note: string, body: number): void {
    this.history.remember();
    this.editor.adopt(scene);
    this.editor.body = Math.min(body, scene.bodies.length - 1);
    this.panel.note = note;
    this.apply(true);
    this.workbench.stage.refit();
  }

  private setTime(start: number, end: number): void {
    this.history.remember();
    this.editor.scene.time = [start, end];
    this.apply(true);
    this.workbench.stage.refit();
  }

  private showBody(): void {
    this.panel.show(this.editor.scene, this.editor.body, this.editor.keyframes());
    this.worldEditing.panel.show(this.editor.scene, this.editor.body);
    this.history.showButtons();
    this.text.show();
    this.path.show(this.editor.scene, this.editor.body);
  }

  private setKeyframes(frames: Keyframe[], mode?: Mode): void {
    this.history.remember();
    frames.sort((a, b) => a.t - b.t);
    this.editor.scene.bodies[this.editor.body].motion = motionOf(frames, this.editor.pivot());
    this.apply(true);
    if (mode) this.setMode(mode);
  }

  private applyText(text: string): void {
    try {
      this.load(this.player.engine.readScene(text, "scene"), null);
    } catch (error) {
      this.refuse(error, "The text of the scene was not applied.");
    }
  }

  /** The library reads what people write as paths, and gives it back as the page reads it. */
  private applyPaths(body: number, paths: string[]): void {
    try {
      const scene = structuredClone(this.editor.scene);
      scene.bodies[body].parts = paths.map((path) => ({ path, "fill-rule": "evenodd" }));
      this.change(this.player.engine.readScene(JSON.stringify(scene), "outline"), "", body);
    } catch (error) {
      this.refuse(error, "The outline was not applied.");
    }
  }

  /** Outlines from two places may lie on one another: then the new one is put beside the others. */
  private adoptOutline(parts: Part[], name: string, index: number): void {
    const scene = withOutline(this.editor.scene, index, parts, name);
    this.load(scene, null);
    if (this.player.overlapping) {
      this.editor.adopt(besideOthers(scene, index, this.player.engine.poses(scene.time[0])));
      this.apply(true, scene.time[0]);
      const [other, ...more] = scene.bodies.filter((_, b) => b !== index).map((body) => body.name);
      this.panel.note = `${scene.bodies[index].name} lay on ${more.length > 0 ? "others" : other}, and was put beside ${more.length > 0 ? "them" : "it"}.`;
    }
    this.workbench.opened();
  }

  private async share(): Promise<void> {
    this.panel.note = await shareLink({ scene: this.valid, touch: this.panel.touch });
  }

  private key(e: KeyboardEvent): void {
    const target = e.target as HTMLElement;
    if (target.matches("textarea, select, input:not([type=range]):not([type=checkbox])")) return;
    if ((e.ctrlKey || e.metaKey) && e.key.toLowerCase() === "z") {
      e.preventDefault();
      if (e.shiftKey) this.history.redo();
      else this.history.undo();
    } else if (e.key === "Delete" || e.key === "Backspace") {
      if (this.editor.removeVertex()) e.preventDefault();
    } else if (/^[1-5]$/.test(e.key)) {
      this.setMode(modeOfKey(Number(e.key)));
    }
  }

  /** For tests: is a change under way to the map? */
  get pending(): boolean {
    return this.changes.pending;
  }

  /** For tests: what the page stands on. */
  get state(): { scene: Scene; keyframes: Keyframe[] | null; pieces: number } {
    const { scene, body } = this.editor;
    return {
      scene,
      keyframes: keyframesOf(scene.bodies[body], ...scene.time),
      pieces: piecesOf(scene.bodies[body]).length,
    };
  }
}
