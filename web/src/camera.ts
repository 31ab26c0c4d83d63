// From world coordinates to pixels: y points up in the world, down on the screen.
import type { Pose } from "./engine";

export interface Placing {
  a: number;
  b: number;
  c: number;
  d: number;
  e: number;
  f: number;
}

export interface Box {
  lowX: number;
  lowY: number;
  highX: number;
  highY: number;
}

export class Camera {
  scale = 1;
  width = 1;
  height = 1;
  private x = 0;
  private y = 0;

  resize(width: number, height: number): void {
    this.width = width;
    this.height = height;
  }

  /** Shows the box, with some room around it, and `right` pixels more on the right. */
  fit(box: Box, right = 0): void {
    const margin = Math.min(44, 0.08 * Math.min(this.width, this.height));
    const w = Math.max(box.highX - box.lowX, 1e-300);
    const h = Math.max(box.highY - box.lowY, 1e-300);
    this.scale = Math.min((this.width - right - 2 * margin) / w, (this.height - 2 * margin) / h);
    this.x = (box.lowX + box.highX) / 2 + right / 2 / this.scale;
    this.y = (box.lowY + box.highY) / 2;
  }

  pixel(x: number, y: number): [number, number] {
    return [this.width / 2 + (x - this.x) * this.scale, this.height / 2 - (y - this.y) * this.scale];
  }

  /** Pixels of a body's own points: x = e + a u + b v, y = f + c u + d v. */
  placing(pose: Pose): Placing {
    const k = this.scale;
    return {
      a: k * pose.c,
      b: -k * pose.s,
      e: this.width / 2 + (pose.x - this.x) * k,
      c: -k * pose.s,
      d: -k * pose.c,
      f: this.height / 2 - (pose.y - this.y) * k,
    };
  }

  world(px: number, py: number): [number, number] {
    return [this.x + (px - this.width / 2) / this.scale, this.y - (py - this.height / 2) / this.scale];
  }

  pan(dx: number, dy: number): void {
    this.x -= dx / this.scale;
    this.y += dy / this.scale;
  }

  /** Keeps the world point below the pixel where it is. */
  zoom(factor: number, px = this.width / 2, py = this.height / 2): void {
    const [wx, wy] = this.world(px, py);
    this.scale *= factor;
    this.x = wx - (px - this.width / 2) / this.scale;
    this.y = wy + (py - this.height / 2) / this.scale;
  }

  centreOn(x: number, y: number): void {
    this.x = x;
    this.y = y;
  }
}
