// Questions that may take long, asked on another thread. One is under way at a time.
import { TautError, type Fault } from "./engine";
import type { FoundWay } from "./wayproblem";

type Reply = { found: FoundWay } | { fault: Fault } | { problem: string };

/** The page begins with both parts as texts, and drops them when it is built. */
const program = ["taut-engine", "taut-worker"].map((id) => document.getElementById(id)?.textContent ?? "").join("\n");

export class Background {
  private worker: Worker | null = null;
  private end: (() => void) | null = null;

  /** The question before ends without an answer. Throws TautError. */
  async findWay(text: string, closed: boolean, clearance: number): Promise<FoundWay | null> {
    this.stop();
    this.worker ??= this.begin();
    const { worker } = this;
    const reply = await new Promise<Reply | null>((done) => {
      this.end = () => done(null);
      worker.onmessage = ({ data }: MessageEvent<Reply>) => done(data);
      worker.onerror = (e) => done({ problem: e.message || "the browser does not let the page have a thread" });
      worker.postMessage({ text, closed, clearance });
    });
    if (!reply) return null;
    this.end = null;
    if ("found" in reply) return reply.found;
    throw "fault" in reply ? new TautError(reply.fault) : new Error(reply.problem);
  }

  get busy(): boolean {
    return this.end !== null;
  }

  /** What is under way ends, and with it the thread. */
  stop(): void {
    if (!this.end) return;
    this.worker?.terminate();
    this.worker = null;
    this.end();
    this.end = null;
  }

  private begin(): Worker {
    const address = URL.createObjectURL(new Blob([program], { type: "text/javascript" }));
    const worker = new Worker(address);
    URL.revokeObjectURL(address);
    return worker;
  }
}
