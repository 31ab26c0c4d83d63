// Above the slider: ticks at the events, dots where motions go over to their next pieces, and the contact.
import { fitCanvas, h } from "./dom";
import { piecesOf } from "./motions";
import type { Player } from "./player";
import type { Colours } from "./theme";

/** A bar across the way. */
function drawLock(c: CanvasRenderingContext2D, colours: Colours, at: number, height: number): void {
  c.fillStyle = colours.lock;
  c.fillRect(at - 2, 0, 4, height);
  c.fillRect(at - 6, 0, 12, 4);
}

export class EventStrip {
  readonly canvas = h("canvas", { class: "strip", "aria-hidden": "true" });
  /** What the picture depends on. */
  private key = "";

  constructor(private readonly player: Player) {}

  draw(colours: Colours): void {
    const { player, canvas } = this;
    const { clientWidth: width, clientHeight: height } = canvas;
    if (width === 0) return;
    const ratio = fitCanvas(canvas, width, height);
    const key = [
      width,
      ratio,
      player.start,
      player.end,
      player.known,
      player.replay.count,
      player.finished,
      player.opened,
      player.status.answer.lock === undefined,
      colours.paper,
    ].join();
    if (key === this.key) return;
    this.key = key;
    const c = canvas.getContext("2d")!;
    c.setTransform(ratio, 0, 0, ratio, 0, 0);
    c.clearRect(0, 0, width, height);
    const whole = player.end - player.start || 1;
    const edge = 8; // as far as the slider's thumb reaches in
    const x = (t: number): number => edge + ((t - player.start) / whole) * (width - 2 * edge);
    c.strokeStyle = colours.muted;
    c.lineWidth = 1;
    c.beginPath();
    let last = -9;
    for (let k = 0; k < player.replay.count; ++k) {
      const at = Math.round(x(player.replay.timeOf(k))) + 0.5;
      if (at === last) continue;
      c.moveTo(at, 3);
      c.lineTo(at, height);
      last = at;
    }
    c.stroke();
    // Where a body's motion goes over to its next piece.
    const { world } = player;
    player.scene.bodies.forEach((body, b) => {
      c.fillStyle = world ? world.styles[b % world.styles.length][0] : colours.bodyFill[b];
      for (const { until } of piecesOf(body)) {
        if (until === undefined || until <= player.start || until >= player.end) continue;
        c.beginPath();
        c.arc(x(until), 4, 3.5, 0, 2 * Math.PI);
        c.fill();
      }
    });
    if (!player.finished) {
      c.fillStyle = colours.line;
      c.fillRect(x(player.known), height / 2, width - edge - x(player.known), 2);
    }
    if (player.status.answer.lock && player.end >= player.last) drawLock(c, colours, x(player.last), height);
    if (player.status.answer.t) {
      c.fillStyle = colours.contact;
      const at = x(player.known);
      c.beginPath();
      c.moveTo(at, height);
      c.lineTo(at - 5, 1);
      c.lineTo(at + 5, 1);
      c.fill();
    }
  }
}
