// What a page gives away: the scene, and pictures of it, at rest and moving.
import { h } from "./dom";
import type { Scene } from "./engine";
import { saveFile } from "./files";
import { GifWriter, Palette } from "./gif";
import type { Workbench } from "./workbench";

/** Of a moving picture of pixels. */
const widest = 720;
const frames = 75;
const hundredthsOfFrame = 6;
const hundredthsOfLast = 150;
/** Frames from which its colours are taken. */
const framesForColours = 9;

export interface SaveHost {
  /** How files are called, without an ending. */
  name(): string;
  scene(): Scene;
  /** Something could not be made. */
  refuse(error: unknown, what: string): void;
}

/** A button with a list of what can be saved. */
export class SaveMenu {
  private readonly title = h("summary", { class: "button" }, "Save");
  readonly element: HTMLDetailsElement;
  private busy = false;

  constructor(
    private readonly workbench: Workbench,
    private readonly host: SaveHost,
  ) {
    const item = (id: string, label: string, title: string, action: () => void | Promise<void>): HTMLElement =>
      h("button", { type: "button", id, title, onclick: () => void this.choose(action) }, label);
    this.element = h(
      "details",
      { class: "menu", id: "save" },
      this.title,
      h(
        "div",
        {},
        item("export", "Scene (JSON)", "The scene as a file for taut", () => this.saveScene()),
        item("svg", "Picture (SVG)", "The instant shown, in lines", () => this.saveSvg()),
        item("png", "Picture (PNG)", "What the page shows, in pixels", () => this.savePng()),
        item("moving-svg", "Moving picture (SVG)", "From the start to the contact or the end, in lines", () =>
          this.saveMovingSvg(),
        ),
        item("gif", "Moving picture (GIF)", "From the start to the contact or the end, as the page shows it", () =>
          this.saveGif(),
        ),
      ),
    );
    this.element.addEventListener("keydown", (e) => {
      if (e.key !== "Escape" || !this.element.open) return;
      e.stopPropagation();
      this.element.open = false;
      this.title.focus();
    });
    document.addEventListener("pointerdown", (e) => {
      if (!this.element.contains(e.target as Node)) this.element.open = false;
    });
  }

  private async choose(action: () => void | Promise<void>): Promise<void> {
    this.element.open = false;
    this.title.focus();
    if (this.busy) return;
    this.busy = true;
    try {
      await action();
    } catch (error) {
      this.host.refuse(error, "It was not saved.");
    }
    this.busy = false;
    this.title.textContent = "Save";
  }

  private saveScene(): void {
    const { excursion, player } = this.workbench;
    // What followed a contact is the page's, not the editor's.
    const scene = excursion.active ? player.scene : this.host.scene();
    saveFile(JSON.stringify(scene, null, 1), `${this.host.name()}.json`, "application/json");
  }

  private saveSvg(): void {
    const { player, stage } = this.workbench;
    saveFile(player.engine.svg(player.t, stage.layers.proof), `${this.host.name()}.svg`, "image/svg+xml");
  }

  private saveMovingSvg(): void {
    const { player, stage } = this.workbench;
    const options = { animate: true, plain: !stage.layers.proof, touch: player.closed ? "closed" : "open" };
    const { svg } = player.engine.ask<{ svg: string }>("draw", player.scene, options);
    saveFile(svg, `${this.host.name()}_moving.svg`, "image/svg+xml");
  }

  private async savePng(): Promise<void> {
    this.workbench.stage.drawAlone();
    const { canvas } = this.workbench.stage;
    const blob = await new Promise<Blob | null>((done) => canvas.toBlob(done, "image/png"));
    this.workbench.redraw();
    if (!blob) throw new Error("the picture is too large");
    saveFile(blob, `${this.host.name()}.png`);
  }

  /** The motion is shown meanwhile. */
  private async saveGif(): Promise<void> {
    const { player } = this.workbench;
    const [before, about] = [player.t, player.opened];
    player.play(false);
    const { canvas } = this.workbench.stage;
    const scale = Math.min(1, widest / canvas.width);
    const small = h("canvas", { width: Math.round(canvas.width * scale), height: Math.round(canvas.height * scale) });
    const pixelsAt = (share: number): Uint8ClampedArray => this.pixelsAt(share, small);
    const samples = Array.from({ length: framesForColours }, (_, k) => pixelsAt(k / (framesForColours - 1)));
    const gif = new GifWriter(small.width, small.height, new Palette(samples));
    for (let k = 0; k <= frames; ++k) {
      gif.add(pixelsAt(k / frames), k < frames ? hundredthsOfFrame : hundredthsOfLast);
      this.title.textContent = `Saving ${Math.round((100 * k) / frames)} %`;
      await new Promise((done) => setTimeout(done, 0));
      if (player.opened !== about) throw new Error("the scene was changed meanwhile");
    }
    player.seek(before);
    saveFile(gif.finish(), `${this.host.name()}.gif`);
  }

  /** At a share of the time from the start to the last instant that is shown. */
  private pixelsAt(share: number, small: HTMLCanvasElement): Uint8ClampedArray {
    const { player, stage } = this.workbench;
    player.seek(share < 1 ? player.start + share * (player.limit - player.start) : player.limit);
    stage.drawAlone();
    const context = small.getContext("2d", { alpha: false, willReadFrequently: true })!;
    context.imageSmoothingQuality = "high";
    context.drawImage(stage.canvas, 0, 0, small.width, small.height);
    return context.getImageData(0, 0, small.width, small.height).data;
  }
}
