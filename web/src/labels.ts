// Which labels there is room for.

/** A line of text: where it begins, on its base line. */
export interface Label {
  x: number;
  y: number;
  width: number;
}

export const ascent = 11;
export const descent = 4;

/** Labels of one picture: of those that would lie on each other, the first one is shown. */
export class Labels {
  private taken: Label[] = [];

  clear(): void {
    this.taken = [];
  }

  isFree(a: Label, height = ascent + descent): boolean {
    return !this.taken.some(
      (b) => a.x < b.x + b.width + height / 2 && b.x < a.x + a.width + height / 2 && Math.abs(a.y - b.y) < 1.2 * height,
    );
  }

  /** True if there is room, which is then taken. */
  take(label: Label, height?: number): boolean {
    const free = this.isFree(label, height);
    if (free) this.taken.push(label);
    return free;
  }
}
