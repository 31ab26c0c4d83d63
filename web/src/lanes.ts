// Above the slider, and along it: a lane for each question about all of the time.
import { fitCanvas, h } from "./dom";
import type { Player } from "./player";
import type { DistanceCurve, IntervalsAnswer, Nearest, QuestionName, Questions, RangeAnswer } from "./questions";
import type { Colours } from "./theme";
import { roundText, timeText } from "./words";

/** As far as the slider's thumb reaches in, as in strip.ts. */
const edge = 8;
const font = "12px system-ui, sans-serif";
/** Pairs that have a row of their own. */
const mostRows = 6;
const rowHeight = 15;

/** What a lane is drawn with. */
interface Place {
  c: CanvasRenderingContext2D;
  colours: Colours;
  width: number;
  height: number;
  x: (t: number) => number;
}

type LaneName = "intervals" | "range" | "distance";

export class Lanes {
  readonly element = h("div", { class: "lanes", id: "lanes" });
  private readonly canvases: Record<LaneName, HTMLCanvasElement>;
  private readonly keys: Partial<Record<LaneName, string>> = {};

  constructor(
    private readonly player: Player,
    private readonly questions: Questions,
  ) {
    const lane = (name: LaneName): HTMLCanvasElement => {
      const canvas = h("canvas", { class: "lane", id: `lane-${name}`, role: "img", hidden: true });
      const move = (e: PointerEvent): void => {
        if (e.buttons & 1) this.seek(canvas, e.offsetX);
      };
      canvas.addEventListener("pointerdown", (e) => {
        canvas.setPointerCapture(e.pointerId);
        move(e);
      });
      canvas.addEventListener("pointermove", move);
      return canvas;
    };
    this.canvases = { intervals: lane("intervals"), range: lane("range"), distance: lane("distance") };
    this.element.append(...Object.values(this.canvases));
  }

  draw(colours: Colours): void {
    const { asked, answers, failures } = this.questions;
    const { intervals, clearance } = answers;
    const curve = answers.distance_profile?.profile[0];
    const wait = (name: QuestionName): string => failures[name] ?? "…";
    this.lane("intervals", asked.intervals !== undefined, this.intervalsHeight(intervals), colours, (place) => {
      if (intervals) drawIntervals(place, intervals);
      else write(place, `overlaps: ${wait("intervals")}`);
    });
    this.lane("range", asked.range !== undefined, 24, colours, (place) => {
      const { start, end } = this.player;
      if (answers.range?.range) drawRange(place, answers.range, [start, end]);
      else write(place, `without overlap: ${answers.range?.reason ?? wait("range")}`);
    });
    const wanted = asked.distance_profile !== undefined || asked.clearance !== undefined;
    const height = asked.distance_profile ? 84 : 24;
    this.lane("distance", wanted, height, colours, (place) => {
      if (curve) drawCurve(place, curve, this.player.t, clearance?.clearance ?? null);
      const margin = answers.check_clearance;
      if (curve && margin && !margin.clearances) drawMargin(place, curve, margin.clearance);
      if (clearance?.clearance) drawLeast(place, clearance.clearance, curve);
      if (!curve && asked.distance_profile) write(place, `distance: ${wait("distance_profile")}`);
      else if (!clearance && asked.clearance) write(place, `clearance: ${wait("clearance")}`);
    });
    this.label();
  }

  /** What a lane shows, for those who do not see it. */
  private label(): void {
    const { intervals, clearance } = this.questions.answers;
    const say = (name: LaneName, text: string): void => this.canvases[name].setAttribute("aria-label", text);
    const count = intervals?.intervals.length ?? 0;
    say("intervals", `Overlaps over time: ${intervals ? count : "not known yet"}`);
    const least = clearance?.clearance;
    say("range", "How far the bodies can go without overlap");
    say("distance", `Distance over time${least ? `, at least ${roundText(least.lo, 9)}` : ""}`);
  }

  private intervalsHeight(answer: IntervalsAnswer | undefined): number {
    return 9 + rowHeight * Math.min(mostRows + 1, Math.max(1, answer ? pairsOf(answer).length : 1));
  }

  private lane(name: LaneName, wanted: boolean, height: number, colours: Colours, paint: (place: Place) => void): void {
    const canvas = this.canvases[name];
    canvas.hidden = !wanted;
    if (!wanted) return;
    canvas.style.height = `${height}px`;
    const width = canvas.clientWidth;
    if (width === 0) return;
    const ratio = fitCanvas(canvas, width, height);
    const { player, questions } = this;
    const key = [width, height, ratio, player.t, player.start, player.end, questions.version, colours.paper].join();
    if (this.keys[name] === key) return;
    this.keys[name] = key;
    const c = canvas.getContext("2d")!;
    c.setTransform(ratio, 0, 0, ratio, 0, 0);
    c.clearRect(0, 0, width, height);
    c.font = font;
    const whole = player.end - player.start || 1;
    const x = (t: number): number => edge + ((t - player.start) / whole) * (width - 2 * edge);
    paint({ c, colours, width, height, x });
    c.strokeStyle = colours.ink;
    c.lineWidth = 1.5;
    c.beginPath();
    c.moveTo(x(player.t), 0);
    c.lineTo(x(player.t), height);
    c.stroke();
  }

  private seek(canvas: HTMLCanvasElement, x: number): void {
    const { player } = this;
    player.playing = false;
    const share = (x - edge) / Math.max(1, canvas.clientWidth - 2 * edge);
    const t = player.start + Math.min(1, Math.max(0, share)) * (player.end - player.start);
    player.seek(this.nearby(t, canvas.clientWidth));
  }

  /** The least distance, if it is within a few pixels: it can be met. */
  private nearby(t: number, width: number): number {
    const least = this.questions.answers.clearance?.clearance;
    const { start, end } = this.player;
    const reach = (5 / Math.max(1, width)) * (end - start);
    return least && Math.abs(least.t[0] - t) < reach ? least.t[0] : t;
  }
}

/** Pairs that overlap at some time, or of which that is not known, in the order of the answer. */
function pairsOf(answer: IntervalsAnswer): string[] {
  const all = [...answer.intervals.map((o) => o.pair), ...answer.undecided.map((u) => u.bodies)];
  return [...new Set(all.map((pair) => pair.join(" x ")))];
}

function write({ c, colours }: Place, text: string, at = 12, left = edge): void {
  c.strokeStyle = colours.paper;
  c.lineWidth = 5;
  c.lineJoin = "round";
  c.strokeText(text, left, at);
  c.fillStyle = colours.muted;
  c.fillText(text, left, at);
}

const labelEnd = (c: CanvasRenderingContext2D, text: string): number => edge + c.measureText(text).width + 5;

function drawIntervals(place: Place, answer: IntervalsAnswer): void {
  const { c, colours, width, x } = place;
  const pairs = pairsOf(answer);
  const rows = pairs.slice(0, mostRows);
  const line = (row: number): number => 4 + row * rowHeight;
  (rows.length > 0 ? rows : [""]).forEach((_, row) => {
    c.fillStyle = colours.free;
    c.globalAlpha = 0.35;
    c.fillRect(edge, line(row) + 4, width - 2 * edge, 4);
    c.globalAlpha = 1;
  });
  for (const { pair, from, to } of answer.intervals) {
    const row = rows.indexOf(pair.join(" x "));
    if (row < 0) continue;
    c.fillStyle = colours.contact;
    // What is as short as an instant is seen all the same.
    c.fillRect(x(from[0]), line(row), Math.max(1.5, x(to[1]) - x(from[0])), 12);
  }
  for (const { bodies } of answer.undecided) {
    const row = rows.indexOf(bodies.join(" x "));
    if (row >= 0) hatch(place, line(row));
  }
  if (rows.length === 0) write(place, "no overlap", 15);
  else if (pairs.length > 1) {
    rows.forEach((name, row) => {
      const covered = answer.intervals.some((o) => o.pair.join(" x ") === name && x(o.from[0]) < labelEnd(c, name));
      if (!covered) c.clearRect(0, line(row), labelEnd(c, name), 13);
      write(place, name, line(row) + 10);
    });
  }
  if (pairs.length > mostRows) write(place, `and ${pairs.length - mostRows} more pairs`, line(mostRows) + 10);
}

/** What is free around an instant, which is marked. */
function drawRange({ c, colours, x }: Place, { range, around }: RangeAnswer, [start, end]: [number, number]): void {
  const from = x(range!.from?.[1] ?? start);
  const to = x(range!.to?.[0] ?? end);
  c.fillStyle = colours.free;
  c.globalAlpha = 0.7;
  c.fillRect(from, 6, Math.max(1.5, to - from), 12);
  c.globalAlpha = 1;
  c.fillStyle = colours.ink;
  c.beginPath();
  c.moveTo(x(around), 12);
  c.lineTo(x(around) - 5, 3);
  c.lineTo(x(around) + 5, 3);
  c.fill();
}

function hatch({ c, colours, width }: Place, y: number): void {
  c.strokeStyle = colours.muted;
  c.lineWidth = 1;
  c.beginPath();
  for (let at = edge; at < width - edge - 8; at += 7) {
    c.moveTo(at, y + 12);
    c.lineTo(at + 8, y);
  }
  c.stroke();
}

/** How high a distance is in the lane. */
function levelOf(height: number, curve: DistanceCurve): (d: number) => number {
  const most = Math.max(curve.largest.hi, ...curve.stretches.map(([, , , hi]) => hi)) || 1;
  return (d) => height - 6 - (d / most) * (height - 26);
}

/** The boxes that the distance does not leave, and a line through the instants. */
function drawCurve(place: Place, curve: DistanceCurve, t: number, least: Nearest | null): void {
  const { c, colours, width, height, x } = place;
  const y = levelOf(height, curve);
  c.strokeStyle = colours.line;
  c.lineWidth = 1;
  c.strokeRect(edge - 0.5, 16.5, width - 2 * edge + 1, height - 22);
  c.fillStyle = colours.distance;
  c.globalAlpha = 0.3;
  for (const [from, to, lo, hi] of curve.stretches)
    c.fillRect(x(from), y(hi), Math.max(0.5, x(to) - x(from)), Math.max(1, y(lo) - y(hi)));
  c.globalAlpha = 1;
  c.strokeStyle = colours.distance;
  c.lineWidth = 1.6;
  c.beginPath();
  curve.instants.forEach(([at, lo, hi], k) =>
    k === 0 ? c.moveTo(x(at), y((lo + hi) / 2)) : c.lineTo(x(at), y((lo + hi) / 2)),
  );
  c.stroke();
  const now = curve.stretches.find(([from, to]) => from <= t && t <= to);
  const words = now ? `distance now: ${roundText(now[2], 4)} to ${roundText(now[3], 4)}` : "distance";
  const greatest = `greatest ${roundText(curve.largest.hi, 6)}`;
  const longest = `${words}; ${greatest} at t = ${roundText(curve.largest.t)}`;
  const fits = (text: string): boolean => c.measureText(text).width < width - 2 * edge;
  write(place, [longest, `${words}; ${greatest}`].find(fits) ?? words);
  if (least) return;
  const [at, lo] = curve.instants.reduce((a, b) => (b[1] < a[1] ? b : a));
  dot(place, x(at), y(lo), colours.distance);
}

/** The clearance that all pairs are to keep, if it is within the lane. */
function drawMargin({ c, colours, width, height }: Place, curve: DistanceCurve, clearance: number): void {
  const y = levelOf(height, curve)(clearance);
  if (y < 16) return;
  c.strokeStyle = colours.contact;
  c.lineWidth = 1;
  c.setLineDash([5, 4]);
  c.beginPath();
  c.moveTo(edge, y);
  c.lineTo(width - edge, y);
  c.stroke();
  c.setLineDash([]);
}

function dot({ c, colours }: Place, x: number, y: number, colour: string): void {
  c.beginPath();
  c.arc(x, y, 4, 0, 2 * Math.PI);
  c.fillStyle = colour;
  c.fill();
  c.strokeStyle = colours.paper;
  c.lineWidth = 1;
  c.stroke();
}

/** The least distance: on the curve, if there is one. */
function drawLeast(place: Place, least: Nearest, curve: DistanceCurve | undefined): void {
  const { c, colours, height, width, x } = place;
  const y = curve ? levelOf(height, curve)(least.hi) : height - 8;
  if (!curve) {
    c.strokeStyle = colours.line;
    c.lineWidth = 1;
    c.beginPath();
    c.moveTo(edge, y);
    c.lineTo(width - edge, y);
    c.stroke();
  }
  dot(place, x(least.t[0]), y, colours.nearest);
  const text = `least ${timeText(least.lo, least.hi)}`;
  const room = c.measureText(text).width;
  const { at, left } = placeOfLeast(place, curve, x(least.t[0]), y, room);
  write({ ...place, colours: { ...colours, muted: colours.nearest } }, text, at, left);
}

/** Beside its dot, on either side, as near to it as the curve leaves room. */
function placeOfLeast(
  { width, height, x }: Place,
  curve: DistanceCurve | undefined,
  dotX: number,
  dotY: number,
  room: number,
): { at: number; left: number } {
  const sides = [dotX + 9, dotX - 9 - room].filter((left) => left >= edge && left + room <= width - edge);
  const near = Math.max(curve ? 30 : 12, dotY - 5);
  if (!curve) return { at: near, left: sides[0] ?? edge };
  const level = levelOf(height, curve);
  const covered = (left: number, at: number): boolean =>
    curve.instants.some(([t, lo, hi]) => {
      const [px, py] = [x(t), level((lo + hi) / 2)];
      return px > left - 6 && px < left + room + 6 && py > at - 14 && py < at + 6;
    });
  const places = sides.flatMap((left) =>
    Array.from({ length: Math.max(1, Math.floor((height - 36) / 4)) }, (_, k) => ({ left, at: 30 + 4 * k })),
  );
  const free = places.filter(({ left, at }) => !covered(left, at));
  free.sort((a, b) => Math.abs(a.at - near) - Math.abs(b.at - near));
  return free[0] ?? { at: near, left: sides[0] ?? edge };
}
