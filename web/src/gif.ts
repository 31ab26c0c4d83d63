// Moving pictures in GIF, which every program shows: for pictures of few colours, as those of this page are.

/** The colours of a picture: one index stands for a pixel that stays as it was. */
export const mostColours = 255;
const unchanged = mostColours;

/** The pixels of a frame in RGBA as numbers. */
const wordsOf = (frame: Uint8ClampedArray): Uint32Array =>
  new Uint32Array(frame.buffer, frame.byteOffset, frame.byteLength >> 2);

/** Red, green and blue of such a number: the lowest byte comes first. */
const channels = (word: number): [number, number, number] => [word & 255, (word >> 8) & 255, (word >> 16) & 255];

/** The most frequent colours of some frames, in RGBA; what is left takes the nearest of them. */
export class Palette {
  readonly colours: [number, number, number][];
  private readonly found = new Map<number, number>();

  constructor(frames: Uint8ClampedArray[]) {
    const counts = new Map<number, number>();
    for (const frame of frames) {
      let run = 0;
      const words = wordsOf(frame);
      words.forEach((word, i) => {
        ++run;
        if (word === words[i + 1]) return;
        counts.set(word, (counts.get(word) ?? 0) + run);
        run = 0;
      });
    }
    const byCount = [...counts].sort((a, b) => b[1] - a[1]).slice(0, mostColours);
    this.colours = byCount.map(([word]) => channels(word));
    byCount.forEach(([word], index) => this.found.set(word, index));
  }

  /** The index of each pixel of a frame. */
  indices(frame: Uint8ClampedArray): Uint8Array {
    const words = wordsOf(frame);
    const indices = new Uint8Array(words.length);
    for (let i = 0; i < words.length; ++i)
      indices[i] = i > 0 && words[i] === words[i - 1] ? indices[i - 1] : this.indexOf(words[i]);
    return indices;
  }

  private indexOf(word: number): number {
    const known = this.found.get(word);
    if (known !== undefined) return known;
    const [r, g, b] = channels(word);
    let best = 0;
    let least = Infinity;
    this.colours.forEach(([red, green, blue], index) => {
      const d = (r - red) ** 2 + (g - green) ** 2 + (b - blue) ** 2;
      if (d < least) [best, least] = [index, d];
    });
    this.found.set(word, best);
    return best;
  }
}

export class GifWriter {
  private readonly bytes: number[] = [];
  private readonly parts: Uint8Array<ArrayBuffer>[] = [];
  /** What is shown, by indices. */
  private shown: Uint8Array | null = null;

  constructor(
    private readonly width: number,
    private readonly height: number,
    private readonly palette: Palette,
  ) {
    this.bytes.push(...[..."GIF89a"].map((letter) => letter.charCodeAt(0)));
    this.words(width, height);
    this.bytes.push(0xf7, 0, 0);
    for (let k = 0; k < 256; ++k) {
      this.bytes.push(...(palette.colours[k] ?? [0, 0, 0]));
    }
    // For ever.
    this.bytes.push(0x21, 0xff, 11, ...[..."NETSCAPE2.0"].map((letter) => letter.charCodeAt(0)), 3, 1, 0, 0, 0);
  }

  /** A frame in RGBA, shown for so many hundredths of a second. */
  add(pixels: Uint8ClampedArray, hundredths: number): void {
    const now = this.palette.indices(pixels);
    const [left, top, right, bottom] = this.changed(now);
    const [width, height] = [right - left, bottom - top];
    const block = new Uint8Array(width * height);
    for (let y = 0, k = 0; y < height; ++y) {
      for (let x = 0; x < width; ++x, ++k) {
        const at = (top + y) * this.width + left + x;
        block[k] = this.shown && this.shown[at] === now[at] ? unchanged : now[at];
      }
    }
    this.bytes.push(0x21, 0xf9, 4, this.shown ? 5 : 4);
    this.words(hundredths);
    this.bytes.push(unchanged, 0, 0x2c);
    this.words(left, top, width, height);
    this.bytes.push(0);
    this.flush();
    this.parts.push(packed(block));
    this.shown = now;
  }

  finish(): Blob {
    this.bytes.push(0x3b);
    this.flush();
    return new Blob(this.parts, { type: "image/gif" });
  }

  /** The box around what differs from the frame before: left, top, right, bottom; one pixel, if nothing does. */
  private changed(now: Uint8Array): [number, number, number, number] {
    const { width, height, shown } = this;
    if (!shown) return [0, 0, width, height];
    let [left, top, right, bottom] = [width, height, 0, 0];
    for (let i = 0; i < now.length; ++i) {
      if (now[i] === shown[i]) continue;
      const x = i % width;
      const y = (i - x) / width;
      [left, right] = [Math.min(left, x), Math.max(right, x + 1)];
      [top, bottom] = [Math.min(top, y), Math.max(bottom, y + 1)];
    }
    return right > left ? [left, top, right, bottom] : [0, 0, 1, 1];
  }

  private words(...values: number[]): void {
    for (const value of values) this.bytes.push(value & 255, value >> 8);
  }

  private flush(): void {
    this.parts.push(Uint8Array.from(this.bytes));
    this.bytes.length = 0;
  }
}

/** Codes of 9 to 12 bits (Welch's variant of the compression of Lempel and Ziv), in blocks of at most 255 bytes. */
function packed(indices: Uint8Array): Uint8Array<ArrayBuffer> {
  const clear = 256;
  const end = 257;
  /** The code for that of a string and one more index; 0: none. */
  const longer = new Uint16Array(4096 * 256);
  let next = end + 1;
  let size = 9;
  const codes = new CodeWriter();
  codes.write(clear, size);
  let string = indices[0];
  for (let i = 1; i < indices.length; ++i) {
    const key = (string << 8) | indices[i];
    if (longer[key] > 0) {
      string = longer[key];
      continue;
    }
    codes.write(string, size);
    if (next < 4096) {
      longer[key] = next;
      if (next++ === 1 << size) ++size;
    } else {
      codes.write(clear, size);
      longer.fill(0);
      next = end + 1;
      size = 9;
    }
    string = indices[i];
  }
  codes.write(string, size);
  codes.write(end, size);
  return codes.finish();
}

class CodeWriter {
  private readonly out: number[] = [8];
  private readonly block: number[] = [];
  private bits = 0;
  private count = 0;

  write(code: number, size: number): void {
    this.bits |= code << this.count;
    for (this.count += size; this.count >= 8; this.count -= 8) {
      this.byte(this.bits & 255);
      this.bits >>>= 8;
    }
  }

  finish(): Uint8Array<ArrayBuffer> {
    if (this.count > 0) this.byte(this.bits & 255);
    this.endBlock();
    this.out.push(0);
    return Uint8Array.from(this.out);
  }

  private byte(value: number): void {
    if (this.block.push(value) === 255) this.endBlock();
  }

  private endBlock(): void {
    if (this.block.length > 0) this.out.push(this.block.length, ...this.block);
    this.block.length = 0;
  }
}
