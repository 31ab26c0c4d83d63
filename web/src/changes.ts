// Changes by dragging reach the map at most once a frame, and time stands still meanwhile.
import type { Editor } from "./editing";
import type { Scene } from "./engine";
import type { Player } from "./player";

/** Where opening takes longer than this, in milliseconds, the answer waits until the pointer is let go. */
const slowOpening = 50;

/** The scene and the instant at which a drag began. */
export interface Base {
  scene: Scene;
  t: number;
}

export interface ChangesHost {
  /** The first change of a drag: what was there before. */
  first(): Scene;
  apply(final: boolean, base: Base): void;
  /** The plan changes from the drag's instant on. */
  drive(base: Base): void;
  redraw(): void;
}

export class Changes {
  private waiting: { final: boolean; driven: boolean } | null = null;
  private resume = false;
  private base: Base | null = null;
  /** Of opening the scene the last time, in milliseconds. */
  private cost = 0;

  constructor(
    private readonly player: Player,
    private readonly editor: () => Editor,
    private readonly host: ChangesHost,
  ) {}

  get pending(): boolean {
    return this.waiting !== null;
  }

  /** Time stands still while something is dragged, and runs on afterwards. */
  hold(): void {
    this.resume = this.player.playing;
    if (this.resume) this.player.play(false);
  }

  /** Of several changes in a frame the last one counts. */
  schedule(final: boolean, driven: boolean): void {
    if (this.waiting) {
      this.waiting.final ||= final;
      return;
    }
    this.waiting = { final, driven };
    if (final) return this.flush();
    requestAnimationFrame(() => this.flush());
  }

  private flush(): void {
    const { waiting } = this;
    this.waiting = null;
    if (!waiting) return;
    this.base ??= { scene: structuredClone(this.host.first()), t: this.player.t };
    this.open(waiting.final, waiting.driven, this.base);
    if (!waiting.final) return;
    this.base = null;
    if (this.resume) this.player.play(true);
    this.resume = false;
  }

  private open(final: boolean, driven: boolean, base: Base): void {
    const editor = this.editor();
    editor.stale = !final && this.cost > slowOpening;
    if (editor.stale) return this.host.redraw();
    const begun = performance.now();
    if (driven) this.host.drive(base);
    else this.host.apply(final, base);
    this.cost = performance.now() - begun;
  }
}
