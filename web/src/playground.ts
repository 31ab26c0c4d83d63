// The page for trying things out: scenes are opened, changed by hand, shared and saved.
import { h } from "./dom";
import { Engine, TautError, type Pose, type Scene } from "./engine";
import { Editor, type Mode } from "./editing";
import { besideOther, withOutline } from "./importing";
import { KeyframeTable } from "./keyframetable";
import { keyframesOf, motionOf, piecesOf, pivotOf, sampled, withKeyframe, type Keyframe } from "./motions";
import { Player } from "./player";
import { fromFragment, toFragment, type Shared } from "./sharing";
import { Workbench } from "./workbench";
import { roundText } from "./words";

const modes: [Mode, string, string][] = [
  ["look", "Look", "Drag to move the view."],
  ["shape", "Shape", "Drag a body or a vertex. Double-click an edge to add a vertex; Delete removes the chosen one."],
  ["keyframes", "Keyframes", "Drag a ghost to where the body is to be at that instant; drag its handle to turn it."],
  [
    "drive",
    "Drive",
    "Drag the arrow or the spin handle: the plan changes from the instant shown on, also while time runs.",
  ],
];
const firstExample = "lid";
const mostUndo = 100;
/** Milliseconds. */
const slowOpening = 50;

interface Example {
  title: string;
  scene: Scene;
}

class Playground {
  private readonly workbench: Workbench;
  private readonly editor: Editor;
  private readonly examples = JSON.parse(document.getElementById("taut-examples")!.textContent!) as Record<
    string,
    Example
  >;
  private readonly message = h("div", { class: "message", role: "alert", hidden: true, id: "message" });
  private readonly note = h("p", { class: "note", role: "status", id: "note" });
  private readonly hint = h("p", { class: "hint" });
  private readonly modeButtons: HTMLButtonElement[];
  private readonly bodySelect = h("select", {
    id: "body",
    onchange: () => this.editor.choose(Number(this.bodySelect.value)),
  });
  private readonly touch = h(
    "select",
    { id: "touch", onchange: () => this.reopen() },
    h("option", { value: "open" }, "open: touching is allowed"),
    h("option", { value: "closed" }, "closed: touching counts"),
  );
  private readonly start = h("input", {
    type: "number",
    step: "any",
    id: "time-start",
    onchange: () => this.setTime(),
  });
  private readonly end = h("input", { type: "number", step: "any", id: "time-end", onchange: () => this.setTime() });
  private readonly table = new KeyframeTable({
    set: (frames) => this.setKeyframes(frames),
    add: (frames) => {
      const more = withKeyframe(frames, this.player.t, ...this.editor.scene.time);
      if (more) this.setKeyframes(more, "keyframes");
    },
    sample: () => {
      const poses = (t: number): Pose => this.player.engine.poses(t)[this.editor.body];
      this.setKeyframes(sampled(poses, this.pivot(), ...this.editor.scene.time), "keyframes");
    },
  });
  private readonly text = h("textarea", { id: "scene-text", rows: 9, spellcheck: "false", "aria-label": "Scene file" });
  private readonly undoButton: HTMLButtonElement;
  private readonly redoButton: HTMLButtonElement;
  private readonly past: string[] = [];
  private readonly future: string[] = [];
  /** The last scene that could be opened, for plan changes and undoing. */
  private valid!: Scene;
  private pending: { final: boolean; driven: boolean } | null = null;

  constructor(private readonly player: Player) {
    this.workbench = new Workbench(player, [
      ["1 2 3 4", "what dragging does"],
      ["Delete", "remove the chosen vertex"],
      ["Ctrl-Z", "undo; with Shift, redo"],
    ]);
    const { stage } = this.workbench;
    this.editor = new Editor(player, stage.camera, {
      edited: (_, final, driven) => this.schedule(final, driven),
      begun: () => this.hold(),
      redraw: () => this.workbench.redraw(),
    });
    stage.tool = this.editor;
    this.editor.onChoose = () => this.showBody();
    stage.onDoubleClick = (x, y) => this.editor.addVertex(x, y);
    this.modeButtons = modes.map(([mode, label]) =>
      h(
        "button",
        { type: "button", id: `mode-${mode}`, "aria-pressed": "false", onclick: () => this.setMode(mode) },
        label,
      ),
    );
    this.undoButton = h(
      "button",
      { type: "button", id: "undo", onclick: () => this.travel(this.past, this.future) },
      "Undo",
    );
    this.redoButton = h(
      "button",
      { type: "button", id: "redo", onclick: () => this.travel(this.future, this.past) },
      "Redo",
    );
    this.build();
    document.addEventListener("keydown", (e) => this.key(e));
    addEventListener("hashchange", () => void this.fromAddress());
  }

  get element(): HTMLElement {
    return this.workbench.element;
  }

  async begin(): Promise<void> {
    this.setMode("look");
    if (!(await this.fromAddress())) this.loadExample(this.examples[firstExample]);
    Object.assign(window, { taut: this.workbench, playground: this });
  }

  private async fromAddress(): Promise<boolean> {
    try {
      const shared = await fromFragment(location.hash);
      if (!shared) return false;
      this.touch.value = shared.touch === "closed" ? "closed" : "open";
      this.load(this.player.engine.readScene(JSON.stringify(shared.scene), "link"), null);
      return true;
    } catch (error) {
      this.fail(error, "The link holds no scene that can be read.");
      return false;
    }
  }

  private build(): void {
    const { workbench } = this;
    const examples = h(
      "select",
      {
        id: "example",
        "aria-label": "Example",
        onchange: () => {
          const example = this.examples[examples.value];
          if (example) this.loadExample(example);
          examples.value = "";
        },
      },
      h("option", { value: "" }, "Examples"),
      ...Object.entries(this.examples).map(([name, { title }]) => h("option", { value: name }, title)),
    );
    const file = h("input", {
      type: "file",
      id: "file",
      multiple: true,
      class: "hidden",
      accept: ".json,.wkt,.geojson,.txt",
      onchange: () => void this.readFiles([...(file.files ?? [])]).then(() => (file.value = "")),
    });
    const button = (id: string, label: string, title: string, action: () => void): HTMLButtonElement =>
      h("button", { type: "button", id, title, onclick: action }, label);
    workbench.headerTools.append(
      examples,
      h(
        "label",
        {
          class: "button",
          for: "file",
          title: "A scene, or an outline in WKT or GeoJSON for the chosen body. Files can be dropped on the page, too.",
        },
        "Open",
        file,
      ),
      button("share", "Copy link", "A link with the whole scene in it", () => void this.share()),
      button("export", "Save scene", "The scene as a file for taut", () =>
        this.save(JSON.stringify(this.editor.scene, null, 1), "scene.json", "application/json"),
      ),
      button("svg", "Save SVG", "The instant shown as a picture", () => this.saveSvg()),
      this.undoButton,
      this.redoButton,
    );
    const edit = h(
      "details",
      { open: true, class: "part part-edit" },
      h("summary", {}, "Edit"),
      h("div", { class: "modes", role: "group", "aria-label": "What dragging does" }, ...this.modeButtons),
      this.hint,
      h(
        "div",
        { class: "fields" },
        h("label", { for: "body" }, "Body"),
        this.bodySelect,
        h("label", { for: "time-start" }, "Time"),
        h("span", { class: "pair" }, this.start, h("label", { for: "time-end" }, "to"), this.end),
        h("label", { for: "touch" }, "Touch"),
        this.touch,
      ),
      this.table.element,
      this.note,
    );
    const text = h(
      "details",
      { class: "part part-text" },
      h("summary", {}, "Scene file"),
      this.text,
      h("button", { type: "button", id: "apply", onclick: () => this.applyText() }, "Apply"),
    );
    text.addEventListener("toggle", () => this.showText());
    workbench.side.insertBefore(edit, workbench.side.children[1]);
    workbench.side.append(text);
    workbench.stage.element.append(this.message);
    const { element } = workbench;
    element.addEventListener("dragover", (e) => e.preventDefault());
    element.addEventListener("drop", (e) => {
      e.preventDefault();
      void this.readFiles([...(e.dataTransfer?.files ?? [])]);
    });
  }

  private setMode(mode: Mode): void {
    this.editor.mode = mode;
    modes.forEach(([name, , hint], i) => {
      this.modeButtons[i].setAttribute("aria-pressed", String(name === mode));
      if (name === mode) this.hint.textContent = hint;
    });
    this.workbench.redraw();
  }

  private loadExample({ scene, title }: Example): void {
    this.load(this.player.engine.readScene(JSON.stringify(scene), title), title);
  }

  /** Opens a scene from elsewhere, at its start. */
  private load(scene: Scene, title: string | null): void {
    this.remember();
    this.workbench.title = title;
    this.editor.adopt(scene);
    this.apply(true, scene.time[0]);
    this.workbench.opened();
    this.note.textContent = "";
  }

  private remember(): void {
    if (!this.editor.scene) return;
    this.past.push(JSON.stringify(this.valid));
    if (this.past.length > mostUndo) this.past.shift();
    this.future.length = 0;
  }

  private travel(from: string[], to: string[]): void {
    const scene = from.pop();
    if (!scene) return;
    to.push(JSON.stringify(this.valid));
    this.editor.adopt(JSON.parse(scene) as Scene);
    this.apply(true);
  }

  /** Time stands still while something is dragged, and runs on afterwards. */
  private hold(): void {
    this.resume = this.player.playing;
    if (this.resume) this.player.play(false);
  }

  /** At most once a frame; of several changes the last one counts. */
  private schedule(final: boolean, driven: boolean): void {
    if (this.pending) {
      this.pending.final ||= final;
      return;
    }
    this.pending = { final, driven };
    if (final) return this.flush();
    requestAnimationFrame(() => this.flush());
  }

  private flush(): void {
    const { pending } = this;
    this.pending = null;
    if (!pending) return;
    if (!this.base) {
      this.remember();
      this.base = { scene: structuredClone(this.valid), t: this.player.t };
    }
    // Where opening takes long, the answer has to wait until the pointer is let go.
    this.editor.stale = !pending.final && this.cost > slowOpening;
    const begun = performance.now();
    if (this.editor.stale) this.workbench.redraw();
    else if (pending.driven) this.drive();
    else this.apply(pending.final, this.base.t);
    if (!this.editor.stale) this.cost = performance.now() - begun;
    if (!pending.final) return;
    this.base = null;
    if (this.resume) this.player.play(true);
    this.resume = false;
  }

  /** The scene and the instant at which the present drag began. */
  private resume = false;
  /** Of opening the scene the last time, in milliseconds. */
  private cost = 0;
  private base: { scene: Scene; t: number } | null = null;

  /** Opens the edited scene, and shows what is wrong with it if it cannot be opened. */
  private apply(final: boolean, at = this.player.t): void {
    const scene = structuredClone(this.editor.scene);
    try {
      this.player.open(scene, this.touch.value === "closed", Math.min(Math.max(at, scene.time[0]), scene.time[1]));
      this.succeeded(scene);
    } catch (error) {
      this.workbench.invalid = true;
      this.fail(error);
    }
    if (final) this.showBody();
  }

  /** A new plan from the instant shown on. */
  private drive(): void {
    const scene = structuredClone(this.editor.scene);
    const base = this.base!;
    const { body } = this.editor;
    const events = this.player.replay.count;
    try {
      const { milliseconds, certificates } = this.player.changePlan(base.scene, scene, body, base.t);
      this.succeeded(scene);
      this.note.textContent =
        `New plan for ${scene.bodies[body].name} at t = ${roundText(base.t)}: the map stays, ${certificates} certificates ` +
        `get new failure times, in ${milliseconds.toFixed(1)} ms. Events before it: ${this.player.replay.applied} of ${events} stay.`;
    } catch (error) {
      this.workbench.invalid = true;
      this.fail(error);
    }
    this.showBody();
  }

  private succeeded(scene: Scene): void {
    this.valid = scene;
    this.editor.faults = [];
    this.workbench.invalid = false;
    this.message.hidden = true;
    this.undoButton.disabled = this.past.length === 0;
    this.redoButton.disabled = this.future.length === 0;
    this.workbench.redraw();
  }

  private fail(error: unknown, prefix = ""): void {
    const lines = [prefix];
    this.editor.faults = [];
    if (error instanceof TautError) {
      const { fault } = error;
      lines.push(error.message, fault.hint);
      if (fault.body >= 0) this.editor.faults = [{ body: fault.body, vertices: fault.vertices, edges: fault.edges }];
    } else {
      lines.push(String(error));
    }
    this.message.replaceChildren(...lines.filter((l) => l).map((l) => h("p", {}, l)));
    this.message.hidden = false;
    this.workbench.redraw();
  }

  private reopen(): void {
    this.apply(true);
  }

  private setTime(): void {
    this.remember();
    this.editor.scene.time = [Number(this.start.value), Number(this.end.value)];
    this.apply(true);
    this.workbench.stage.refit();
  }

  /** Fields and keyframes of the chosen body. */
  private showBody(): void {
    const { scene, body } = this.editor;
    this.bodySelect.replaceChildren(
      ...scene.bodies.map((b, i) => h("option", { value: i, selected: i === body }, b.name)),
    );
    if (document.activeElement !== this.start) this.start.value = String(scene.time[0]);
    if (document.activeElement !== this.end) this.end.value = String(scene.time[1]);
    this.undoButton.disabled = this.past.length === 0;
    this.redoButton.disabled = this.future.length === 0;
    this.table.show(this.editor.keyframes());
    this.showText();
  }

  private pivot(): [number, number] {
    return pivotOf(this.editor.scene.bodies[this.editor.body]) ?? [0, 0];
  }

  private setKeyframes(frames: Keyframe[], mode?: Mode): void {
    this.remember();
    frames.sort((a, b) => a.t - b.t);
    this.editor.scene.bodies[this.editor.body].motion = motionOf(frames, this.pivot());
    this.apply(true);
    if (mode) this.setMode(mode);
  }

  private showText(): void {
    if (!this.text.closest("details")!.open || document.activeElement === this.text) return;
    this.text.value = JSON.stringify(this.editor.scene, null, 1).replace(
      /\[\s+([-\d.e+]+),\s+([-\d.e+]+)\s+\]/g,
      "[$1, $2]",
    );
  }

  private applyText(): void {
    try {
      this.load(this.player.engine.readScene(this.text.value, "scene"), null);
    } catch (error) {
      this.fail(error);
    }
  }

  /** A scene replaces all; an outline replaces the chosen body's polygon, two outlines both. */
  private async readFiles(files: File[]): Promise<void> {
    try {
      let body = files.length > 1 ? 0 : this.editor.body;
      for (const file of files) {
        const text = await file.text();
        if (/"taut-scene\//.test(text))
          this.load(this.player.engine.readScene(text, file.name), file.name.replace(/\.json$/, ""));
        else
          this.adoptOutline(
            this.player.engine.readOutline(text, file.name),
            file.name.replace(/\.[^.]*$/, ""),
            body++ & 1,
          );
      }
    } catch (error) {
      this.fail(error);
    }
  }

  private adoptOutline(polygon: [number, number][], name: string, index: number): void {
    this.remember();
    const scene = withOutline(this.editor.scene, index, polygon, name);
    this.editor.adopt(scene);
    this.workbench.title = null;
    this.note.textContent = "";
    this.apply(true, scene.time[0]);
    if (this.player.overlapping) {
      this.editor.adopt(besideOther(scene, index, this.player.engine.poses(scene.time[0])));
      this.apply(true, scene.time[0]);
      this.note.textContent = `${scene.bodies[index].name} lay on ${scene.bodies[1 - index].name}, and was put beside it.`;
    }
    this.workbench.opened();
  }

  private async share(): Promise<void> {
    const shared: Shared = { scene: this.valid, touch: this.touch.value as "open" | "closed" };
    const fragment = await toFragment(shared);
    history.replaceState(null, "", fragment);
    let copied = true;
    await navigator.clipboard?.writeText(location.href).catch(() => (copied = false));
    const size = location.href.length;
    this.note.textContent =
      (copied && navigator.clipboard ? "The link is copied" : "The link is in the address bar") +
      `, ${size} characters` +
      (size > 30000 ? ". Some programs cut links as long as that: save the scene instead." : ".");
  }

  private saveSvg(): void {
    try {
      this.save(this.player.engine.svg(this.player.t), "scene.svg", "image/svg+xml");
    } catch (error) {
      this.fail(error);
    }
  }

  private save(text: string, name: string, type: string): void {
    const link = h("a", { href: URL.createObjectURL(new Blob([text], { type })), download: name });
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 10000);
  }

  private key(e: KeyboardEvent): void {
    const target = e.target as HTMLElement;
    if (target.matches("textarea, select, input:not([type=range]):not([type=checkbox])")) return;
    if ((e.ctrlKey || e.metaKey) && e.key.toLowerCase() === "z") {
      e.preventDefault();
      if (e.shiftKey) this.travel(this.future, this.past);
      else this.travel(this.past, this.future);
    } else if (e.key === "Delete" || e.key === "Backspace") {
      if (this.editor.removeVertex()) e.preventDefault();
    } else if (/^[1-4]$/.test(e.key)) {
      this.setMode(modes[Number(e.key) - 1][0]);
    }
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

async function main(): Promise<void> {
  const playground = new Playground(new Player(await Engine.load()));
  document.body.replaceChildren(playground.element);
  await playground.begin();
}

main().catch((error: unknown) => {
  document.body.replaceChildren(
    h("main", { class: "fatal" }, h("h1", {}, "The playground cannot start"), h("p", {}, String(error))),
  );
});
