// Undo and redo: scenes as they were, and the buttons that bring them back.
import { h } from "./dom";
import type { Scene } from "./engine";

const mostUndo = 100;

export interface HistoryHost {
  /** The last scene that could be opened; none before the first. */
  present(): Scene | undefined;
  restore(scene: Scene): void;
}

export class History {
  readonly undoButton = h("button", { type: "button", id: "undo", onclick: () => this.undo() }, "Undo");
  readonly redoButton = h("button", { type: "button", id: "redo", onclick: () => this.redo() }, "Redo");
  private readonly past: string[] = [];
  private readonly future: string[] = [];

  constructor(private readonly host: HistoryHost) {}

  /** Before a change: what is present can be brought back. */
  remember(): void {
    const scene = this.host.present();
    if (!scene) return;
    this.past.push(JSON.stringify(scene));
    if (this.past.length > mostUndo) this.past.shift();
    this.future.length = 0;
  }

  undo(): void {
    this.travel(this.past, this.future);
  }

  redo(): void {
    this.travel(this.future, this.past);
  }

  showButtons(): void {
    this.undoButton.disabled = this.past.length === 0;
    this.redoButton.disabled = this.future.length === 0;
  }

  private travel(from: string[], to: string[]): void {
    const scene = from.pop();
    if (!scene) return;
    to.push(JSON.stringify(this.host.present()));
    this.host.restore(JSON.parse(scene) as Scene);
  }
}
