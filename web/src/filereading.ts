// What files hold: scenes, problems about ways, drawings with their report, and outlines.
import type { Decisions, Engine, Part, Scene } from "./engine";
import { ImportReport } from "./importreport";
import { isProblem } from "./wayproblem";

const undecided: Decisions = { open: "error", crossing: "error" };

/** What becomes of it. What throws is refused. */
export interface FileHost {
  load(scene: Scene, title: string | null): void;
  openProblem(text: string, name: string, title: string | null): void;
  /** In place of what the body of this number was. */
  adoptOutline(parts: Part[], title: string, body: number): void;
  refuse(error: unknown, what: string): void;
  /** The chosen body, and how many there are. */
  body(): number;
  count(): number;
}

const untitled = (name: string): string => name.replace(/\.[^.]*$/, "");
const notOpened = (name: string): string => `${name} was not opened. The scene shown is the one from before.`;

export class FileReading {
  readonly report = new ImportReport((decided) => this.readAgain(decided));
  /** The drawing that was read last. */
  private drawing = { text: "", name: "", decided: undecided };

  constructor(
    private readonly engine: Engine,
    private readonly host: FileHost,
  ) {}

  /** A scene replaces all; an outline replaces the chosen body's polygon, several outlines those of the first bodies. */
  async read(files: File[]): Promise<void> {
    let body = files.length > 1 ? 0 : this.host.body();
    for (const file of files) {
      try {
        if (this.open(file.name, await file.text(), body % this.host.count())) ++body;
      } catch (error) {
        return this.host.refuse(error, notOpened(file.name));
      }
    }
  }

  /** True if it was an outline, of body `body` from now on. */
  private open(name: string, text: string, body: number): boolean {
    const { engine, host } = this;
    const title = untitled(name);
    if (/\.(svg|dxf|kicad_pcb)$/i.test(name)) {
      this.openDrawing({ text, name }, undecided);
    } else if (isProblem(text)) {
      host.openProblem(text, name, title);
    } else if (/"taut-scene\//.test(text)) {
      host.load(engine.readScene(text, name), title);
    } else {
      host.adoptOutline(engine.readOutline(text, name), title, body);
      return true;
    }
    return false;
  }

  /** The drawing becomes the scene, unless it can be read in two ways: the report says so, and asks. */
  private openDrawing(source: { text: string; name: string }, decided: Decisions): void {
    const { text, name } = source;
    const drawing = this.engine.readDrawing(text, name, decided);
    if (drawing.scene) this.host.load(drawing.scene, untitled(name));
    this.drawing = { ...source, decided };
    this.report.show(name, drawing);
  }

  /** The last drawing once more, with an answer to what the report asks, and those that were given before. */
  private readAgain(more: Partial<Decisions>): void {
    try {
      this.openDrawing(this.drawing, { ...this.drawing.decided, ...more });
    } catch (error) {
      this.host.refuse(error, notOpened(this.drawing.name));
    }
  }
}
