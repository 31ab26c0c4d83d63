// Time: what the engine has found so far, which instant is shown, and how it moves.
import { Engine, TautError, type ContactAnswer, type Pose, type Scene, type Status, type WorldStyles } from "./engine";
import type { Figure } from "./figure";
import { Replay, type MapEvent } from "./replay";
import type { ContactMarks, EventMarks } from "./frame";
import { Shape } from "./shapes";

/** For so long after it an event stays marked while the motion plays, in milliseconds. */
const markFor = 450;
/** The scene's whole time takes so many seconds at speed 1. */
const secondsAtSpeedOne = 10;
/** Tilings of a world that take longer to make are not drawn while it plays, in milliseconds. */
const mostForTilings = 12;

export class Player {
  readonly replay = new Replay();
  scene!: Scene;
  shapes!: Shape[];
  status!: Status;
  closed = false;
  /** The instant shown. */
  t = 0;
  playing = false;
  private slowTilings = false;
  /** Grows with every scene that is opened and every plan that is changed. */
  opened = 0;
  speed = 1;
  /** Time goes on behind the contact, where bodies pass through each other: there are questions about all of it. */
  beyond = false;
  /** The event that was stepped to and is explained, or -1. */
  selected = -1;
  /** What the engine could not do after it had begun. */
  failure: string | null = null;
  /** Told of every change. */
  onChange: () => void = () => {};

  /** An instant to show as soon as the engine has come so far. */
  private wanted: number | null = null;
  private run = 0;
  private lastFrame = 0;
  private recent = { event: -1, since: 0 };

  constructor(readonly engine: Engine) {}

  /** Opens a scene at its start. Throws TautError, and the present scene stays. */
  open(scene: Scene, closed: boolean, at?: number): void {
    const status = this.engine.open(scene, "scene", closed);
    this.adopt(scene, closed, status);
    this.seek(scene.time[0]);
    this.wanted = at ?? null;
    this.pump();
  }

  /**
   * Body `body` moves as in `edited` from t on, as in `base` before. The engine has looked ahead, so it is brought to t
   * again; then it takes up the new plan and goes on with the map and the certificates it has. Throws TautError.
   */
  changePlan(base: Scene, edited: Scene, body: number, t: number): { milliseconds: number; certificates: number } {
    ++this.run;
    this.engine.open(base, "scene", this.closed);
    this.engine.advance(t, 1e9);
    const begun = performance.now();
    const status = this.engine.changePlan(JSON.stringify(edited), body);
    const milliseconds = performance.now() - begun;
    this.replay.open(this.engine);
    this.replay.update(this.engine);
    const k = this.replay.count;
    this.recent.event = -1;
    this.adoptStatus(edited, status);
    this.seek(t);
    this.pump();
    return { milliseconds, certificates: k > 0 ? this.replay.certificatesAfter(k - 1) : status.initial };
  }

  get start(): number {
    return this.scene.time[0];
  }

  /** The last instant of which something is known: the contact, the end, or how far the engine has come. */
  get known(): number {
    return this.status.answer.t?.[0] ?? Math.max(this.start, this.status.freeUntil);
  }

  /** The last instant that can be shown. */
  get limit(): number {
    return this.beyond && this.finished ? this.last : this.known;
  }

  /** The end of all motion: that of the scene's time, or right before a mechanism locks. */
  get last(): number {
    const { lock, scope } = this.status.answer;
    return lock ? scope.time[1] : this.scene.time[1];
  }

  /** The right end of the slider: as limit, but the scene's end while the engine is at work. */
  get end(): number {
    const whole = this.status.state === "running" || this.overlapping;
    return whole ? this.last : Math.max(this.limit, this.start);
  }

  /** To the contact; from there on to the end, if that is shown. */
  toTheEnd(): void {
    this.seek(this.t < this.known ? this.known : this.limit);
  }

  get finished(): boolean {
    return this.status.state !== "running" || this.failure !== null;
  }

  get overlapping(): boolean {
    return this.status.state === "overlap_at_start";
  }

  get atContact(): boolean {
    return this.status.state === "contact" && (this.beyond ? this.t === this.known : this.t >= this.known);
  }

  /** The tilings of a world at the time shown; while it plays, only if they are made in a moment. */
  tilings(): number[] {
    if (this.playing && this.slowTilings) return [];
    const begun = performance.now();
    const lines = this.engine.tilings(this.t);
    this.slowTilings = performance.now() - begun > mostForTilings;
    return lines;
  }

  /** Behind the contact there is no tiling. */
  get behind(): boolean {
    return this.overlapping || this.t > this.known;
  }

  seek(t: number): void {
    this.wanted = null;
    this.t = Math.min(Math.max(t, this.start), this.limit);
    this.selected = -1;
    const before = this.replay.applied;
    this.replay.goTo(this.replay.eventsUntil(this.t));
    if (this.replay.applied > before) this.noteRecent();
    else if (this.replay.applied < before) this.recent.event = -1;
    this.onChange();
  }

  /** Events that follow each other too fast to be seen are not marked: that would only flicker. */
  private noteRecent(): void {
    const now = performance.now();
    this.recent.event = now - this.recent.since < 150 ? -1 : this.replay.applied - 1;
    this.recent.since = now;
  }

  /** Shows event k, right after its repair. */
  show(k: number): void {
    if (k < 0) return this.seek(this.start);
    if (k >= this.replay.count) return this.seek(this.known);
    this.playing = false;
    this.wanted = null;
    this.t = Math.min(Math.max(this.replay.timeOf(k), this.start), this.limit);
    this.replay.goTo(k + 1);
    this.selected = k;
    this.onChange();
  }

  stepEvent(direction: 1 | -1): void {
    const here = this.selected >= 0 ? this.selected : direction > 0 ? this.replay.applied - 1 : this.replay.applied;
    this.show(here + direction);
  }

  play(on: boolean): void {
    if (on && this.t >= this.end) this.seek(this.start);
    this.playing = on;
    this.lastFrame = performance.now();
    this.onChange();
  }

  /** Moves on with the clock; true if the picture must be drawn anew. */
  frame(now: number): boolean {
    const step = Math.min(0.1, (now - this.lastFrame) / 1000);
    this.lastFrame = now;
    if (this.playing) {
      const whole = Math.max(this.scene.time[1] - this.start, 0);
      this.seek(this.t + (step * this.speed * whole) / secondsAtSpeedOne);
      if (this.t >= this.end || whole === 0) this.play(false);
      return true;
    }
    return this.recent.event >= 0 && now - this.recent.since < markFor + 100;
  }

  /** The outlines of the bodies' first parts. */
  get figures(): Figure[] {
    return this.shapes.map((shape) => shape.outline);
  }

  /** How bodies look of which there is no tiling. */
  get world(): WorldStyles | null {
    return this.status.world ?? null;
  }

  poses(): Pose[] {
    return this.engine.poses(this.t);
  }

  /** The event to mark in the picture. */
  marks(): EventMarks | null {
    let k = this.selected;
    const { event, since } = this.recent;
    if (k < 0 && this.playing && event === this.replay.applied - 1 && performance.now() - since < markFor) k = event;
    if (k < 0 || k >= this.replay.count) return null;
    return { event: this.replay.event(k), ...this.replay.edgesOf(k) };
  }

  /** The event to explain in words: at the contact, the contact. */
  told(): MapEvent | null {
    const marks = this.marks();
    if (marks) return marks.event;
    return this.atContact && this.replay.count > 0 ? this.replay.event(this.replay.count - 1) : null;
  }

  /** The contact, and those that come at the same time. */
  contactMarks(): ContactMarks[] {
    const { contact, also = [] } = this.status.answer;
    if (!contact || !this.atContact) return [];
    return [contact, ...also.flatMap((pair) => pair.contact ?? [])].map((each) => this.marksOf(each));
  }

  /** Bodies of a world that overlap at its start. */
  overlaps(): [number, number][] {
    const { answer, world } = this.status;
    if (!world || !this.overlapping) return [];
    const pairs = [
      answer.pair ?? (answer.scope.bodies as [string, string]),
      ...(answer.also ?? []).map((p) => p.bodies),
    ];
    return pairs.map(([a, b]) => [this.bodyCalled(a), this.bodyCalled(b)]);
  }

  private bodyCalled(name: string): number {
    return this.scene.bodies.findIndex((body) => body.name === name);
  }

  private marksOf({ point, normal, vertex, edge }: ContactAnswer): ContactMarks {
    const features = [edge, ...(vertex.at === undefined ? [] : [vertex])].map((feature) => {
      const { body, part = 0, ring = 0, index } = feature;
      return { body: this.bodyCalled(body), part, ring, index };
    });
    const [a, b] = [vertex.body, edge.body].map((name) => this.bodyCalled(name)).sort((i, j) => i - j);
    const names = `${this.scene.bodies[a].name} x ${this.scene.bodies[b].name}`;
    const label = this.world ? `contact: ${names}` : "contact";
    return { point, normal, features, label };
  }

  certificates(): number {
    return this.replay.applied > 0 ? this.replay.certificatesAfter(this.replay.applied - 1) : this.status.initial;
  }

  private adopt(scene: Scene, closed: boolean, status: Status): void {
    this.shapes = scene.bodies.map((body) => new Shape(body));
    this.closed = closed;
    this.replay.open(this.engine);
    this.recent.event = -1;
    this.adoptStatus(scene, status);
  }

  private adoptStatus(scene: Scene, status: Status): void {
    this.scene = scene;
    this.status = status;
    this.failure = null;
    this.opened++;
  }

  /**
   * Lets the engine work in slices, so that the page stays responsive. What it found is taken up now and then only, for
   * that costs as much as all events so far.
   */
  private pump(): void {
    const run = ++this.run;
    let taken = performance.now();
    const slice = (): void => {
      if (run !== this.run) return;
      try {
        const status = this.engine.advance(this.scene.time[1], 10);
        const now = performance.now();
        if (status.state !== "running" || now - taken > 30 + 0.01 * this.replay.count) {
          taken = now;
          this.status = status;
          this.replay.update(this.engine);
        }
      } catch (error) {
        this.failure = error instanceof TautError ? error.message : String(error);
      }
      if (this.wanted !== null && (this.finished || this.limit >= this.wanted)) this.seek(this.wanted);
      this.onChange();
      if (!this.finished) setTimeout(slice, 0);
    };
    slice();
  }
}
