// Counts over time: active certificates as steps, events as a growing sum.
import { fitCanvas } from "./dom";
import type { Player } from "./player";
import type { Colours } from "./theme";

const top = 8;
const bottom = 18;

export class CountPlot {
  /** All but the line at the present. */
  private readonly base = document.createElement("canvas");
  private baseKey = "";

  constructor(
    readonly canvas: HTMLCanvasElement,
    private readonly player: Player,
    seek: (t: number) => void,
  ) {
    const move = (e: PointerEvent): void => {
      if (!(e.buttons & 1)) return;
      const box = canvas.getBoundingClientRect();
      seek(player.start + ((e.clientX - box.left) / box.width) * (player.end - player.start));
    };
    canvas.addEventListener("pointerdown", (e) => {
      canvas.setPointerCapture(e.pointerId);
      move(e);
    });
    canvas.addEventListener("pointermove", move);
  }

  draw(colours: Colours): void {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    if (width === 0) return;
    const ratio = fitCanvas(this.canvas, width, height);
    const { start, end, replay, known, status } = this.player;
    const key = [
      width,
      height,
      ratio,
      start,
      end,
      replay.count,
      known,
      status.max,
      this.player.opened,
      colours.paper,
    ].join();
    if (key !== this.baseKey) {
      this.baseKey = key;
      fitCanvas(this.base, width, height);
      this.drawBase(colours, width, height, ratio);
    }
    const c = this.canvas.getContext("2d")!;
    c.setTransform(1, 0, 0, 1, 0, 0);
    c.clearRect(0, 0, this.canvas.width, this.canvas.height);
    c.drawImage(this.base, 0, 0);
    c.setTransform(ratio, 0, 0, ratio, 0, 0);
    const now = ((this.player.t - start) / (end - start || 1)) * (width - 2) + 1;
    c.strokeStyle = colours.ink;
    c.lineWidth = 1.5;
    c.beginPath();
    c.moveTo(now, top - 4);
    c.lineTo(now, height - bottom);
    c.stroke();
  }

  private drawBase(colours: Colours, width: number, height: number, ratio: number): void {
    const c = this.base.getContext("2d")!;
    c.setTransform(ratio, 0, 0, ratio, 0, 0);
    c.clearRect(0, 0, width, height);
    const { start, end, replay } = this.player;
    const whole = end - start || 1;
    const x = (t: number): number => ((t - start) / whole) * (width - 2) + 1;
    const floor = height - bottom;
    const level = (value: number, most: number): number => floor - (value / Math.max(most, 1)) * (floor - top);
    c.strokeStyle = colours.line;
    c.lineWidth = 1;
    c.strokeRect(0.5, top - 4, width - 1, floor - top + 4);
    this.line(c, x, (k) => level(k + 1, replay.count), level(0, 1), colours.events, 1.2);
    const most = this.player.status.max;
    const initial = level(this.player.status.initial, most);
    this.line(c, x, (k) => level(replay.certificatesAfter(k), most), initial, colours.certificates, 1.6);
    c.fillStyle = colours.muted;
    c.font = "12px system-ui, sans-serif";
    c.fillText(String(Number(start.toPrecision(4))), 1, height - 4);
    const right = String(Number(end.toPrecision(6)));
    c.fillText(right, width - 1 - c.measureText(right).width, height - 4);
    c.fillText("t", width / 2 - 2, height - 4);
  }

  /** Steps at the events; of many in one pixel, the highest and the last. */
  private line(
    c: CanvasRenderingContext2D,
    x: (t: number) => number,
    y: (k: number) => number,
    first: number,
    colour: string,
    width: number,
  ): void {
    const { replay } = this.player;
    c.beginPath();
    let level = first;
    c.moveTo(x(this.player.start), level);
    let pixel = -1;
    let highest = level;
    for (let k = 0; k < replay.count; ++k) {
      const at = x(replay.timeOf(k));
      const value = y(k);
      if (Math.floor(at) === pixel && k + 1 < replay.count) {
        highest = Math.min(highest, value);
        level = value;
        continue;
      }
      if (highest < level) c.lineTo(pixel, highest);
      c.lineTo(at, level);
      c.lineTo(at, value);
      pixel = Math.floor(at);
      level = highest = value;
    }
    c.lineTo(x(this.player.known), level);
    c.strokeStyle = colour;
    c.lineWidth = width;
    c.stroke();
  }
}
