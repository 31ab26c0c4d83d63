// Questions beyond the first contact: asked of the library by the names that they have there, answered as the commands
// answer them with --json.
import { Background } from "./background";
import {
  TautError,
  type Coverage,
  type Feature,
  type Lock,
  type Outcome,
  type PairAnswer,
  type Ring,
  type Scene,
} from "./engine";
import type { Player } from "./player";

export interface Overlap {
  pair: [string, string];
  from: [number, number];
  to: [number, number];
}

/** What every answer has. */
export interface Verdict {
  outcome: Outcome;
  /** Why it is undecided or untested. */
  reason?: string;
  coverage: Coverage;
}

export interface IntervalsAnswer extends Verdict {
  intervals: Overlap[];
  undecided: (PairAnswer & { reason?: string })[];
}

export interface Nearest {
  lo: number;
  hi: number;
  t: [number, number];
  pair: [string, string];
  /** Left out where the bodies touch. */
  points?: [[number, number], [number, number]];
  edges?: [Feature, Feature];
}

export interface ClearanceAnswer extends Verdict {
  clearance: Nearest | null;
  /** Why the bracket is wider than was asked for. */
  wide?: string;
}

export interface DistanceCurve {
  largest: { lo: number; hi: number; t: number; settled: boolean; wide?: string };
  /** Instant, and the bracket of the distance. */
  instants: [number, number, number][];
  /** From, to, and the bracket that the distance does not leave meanwhile. */
  stretches: [number, number, number, number][];
}

export interface ProfileAnswer extends Verdict {
  profile: DistanceCurve[];
}

export interface DirectionArc {
  from_deg: [number, number];
  to_deg: [number, number];
  point: boolean;
}

export interface FreeDirections {
  body: string;
  all: boolean;
  directions: DirectionArc[];
}

export interface SeparationAnswer extends Partial<FreeDirections> {
  outcome: "free" | "locked" | "overlap_at_start" | "undecided" | "untested";
  coverage: Coverage;
  pair?: [string, string];
  bodies?: FreeDirections[];
  order?: { body: string; direction_deg: number }[];
  stuck?: string[];
  reason?: string;
  wide?: string;
  /** With turns: who leaves, one after the other, and along which places. */
  ways?: { body: string; points: { x: number; y: number; deg: number }[] }[];
  /** Bodies of which it is not known whether they come out. */
  unsure?: string[];
  /** The bodies as they leave; null if none does. */
  scene?: Scene | null;
}

/** What a body passes over, and a little more. */
export interface SweptAnswer {
  body: string;
  tolerance: number;
  area: number;
  parts: { outline: Ring; holes?: Ring[] }[];
}

export interface RangeAnswer extends Verdict {
  /** An end is null where it is the scene's own. */
  range: {
    from: [number, number] | null;
    to: [number, number] | null;
    /** The end is where a mechanism locks. */
    to_lock?: boolean;
  } | null;
  around: number;
  before?: Overlap;
  after?: Overlap;
}

export interface MarginAnswer extends Omit<Verdict, "outcome"> {
  outcome: Outcome | "closer_at_start";
  lock?: Lock;
  clearance: number;
  /** Those of the scene, for which `clearance` does not count. */
  clearances?: Scene["clearances"];
  t?: [number, number];
  pair?: [string, string];
  /** The pair that comes closer first; points where the bodies do not overlap; its own margin, and what that is then. */
  first?: {
    distance?: number;
    points?: [[number, number], [number, number]];
    margin?: number | number[];
    margin_at?: number;
  };
}

/** What the library calls each question, and its answer. */
export interface Answers {
  intervals: IntervalsAnswer;
  clearance: ClearanceAnswer;
  distance_profile: ProfileAnswer;
  separate: SeparationAnswer;
  range: RangeAnswer;
  check_clearance: MarginAnswer;
  swept: SweptAnswer;
}
export type QuestionName = keyof Answers;

/** What is asked, with the options of each question: {"distance_profile": {"instants": 200}}. */
export type Asked = { [Name in QuestionName]?: Record<string, unknown> };

/** The questions for which it matters what touching means. */
const takesTouch = new Set<QuestionName>(["intervals", "range", "check_clearance"]);
/** How long each question may take at most, in seconds. */
const longestWait = 60;
/** For so long nothing may change before a question is asked, in milliseconds. */
const settlingTime = 150;

/** Asks what is chosen about the scene that is open, anew whenever another one is. */
export class Questions {
  asked: Asked = {};
  readonly answers: Partial<Answers> = {};
  readonly failures: Partial<Record<QuestionName, string>> = {};
  /** Grows with every answer. */
  version = 0;
  private about = -1;
  private timer = 0;
  private readonly background = new Background();
  /** The question that is being answered. */
  private asking: QuestionName | null = null;

  constructor(
    private readonly player: Player,
    private readonly changed: () => void,
  ) {}

  choose(name: QuestionName, options: Record<string, unknown> | null): void {
    if (options) this.asked[name] = options;
    else delete this.asked[name];
    if (this.asking === name) this.background.stop();
    this.forget(name);
    this.showBeyond();
    this.changed();
  }

  /** To be called now and then: takes note of another scene. */
  update(): void {
    if (this.about !== this.player.opened) {
      this.about = this.player.opened;
      this.background.stop();
      for (const name of this.names()) this.forget(name);
      this.showBeyond();
      this.wait();
    } else if (this.waiting() && this.timer === 0 && !this.asking) {
      this.wait();
    }
  }

  /** Is a question waiting for its answer? */
  waiting(): boolean {
    return this.names().some((name) => !this.answers[name] && !this.failures[name]);
  }

  private names(): QuestionName[] {
    return Object.keys(this.asked) as QuestionName[];
  }

  private forget(name: QuestionName): void {
    delete this.answers[name];
    delete this.failures[name];
    ++this.version;
  }

  /** What is asked about all of the time is shown for all of the time. */
  private showBeyond(): void {
    const { intervals, clearance, distance_profile, range, swept } = this.asked;
    this.player.beyond = [intervals, clearance, distance_profile, range, swept].some(
      (options) => options !== undefined,
    );
  }

  private wait(): void {
    clearTimeout(this.timer);
    this.timer = window.setTimeout(() => this.askNext(), settlingTime);
  }

  /** One after the other, so that the page shows what is there already. */
  private askNext(): void {
    this.timer = 0;
    if (this.about !== this.player.opened) return;
    if (!this.player.finished) return this.wait();
    const name = this.names().find((each) => !this.answers[each] && !this.failures[each]);
    if (name && !this.asking) void this.ask(name, this.player.scene);
  }

  /** On another thread. What was chosen anew, or another scene, ends it without an answer. */
  private async ask<Name extends QuestionName>(name: Name, scene: Scene): Promise<void> {
    const touch = this.player.closed ? "closed" : "open";
    const wanted = this.asked[name];
    const options = { ...wanted, ...(takesTouch.has(name) ? { touch } : {}), max_seconds: longestWait };
    const about = this.about;
    this.asking = name;
    try {
      const answer = (await this.background.call("ask", name, scene, options)) as Answers[typeof name] | null;
      if (answer && this.about === about && this.asked[name] === wanted) this.answers[name] = answer;
    } catch (error) {
      if (this.about === about && this.asked[name] === wanted)
        this.failures[name] = error instanceof TautError ? error.message : String(error);
    }
    this.asking = null;
    ++this.version;
    this.changed();
    if (this.about === about) this.timer = window.setTimeout(() => this.askNext(), 0);
    else this.wait();
  }
}
