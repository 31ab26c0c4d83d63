// What may take long, on another thread. One call is under way at a time.
import { TautError, type Engine, type Fault } from "./engine";

/** Those that need no scene to be open. */
export type Method = "ask" | "findWay" | "goOn";

export interface Call {
  method: Method;
  args: unknown[];
}

type Reply = { result: unknown } | { fault: Fault } | { problem: string };

/** The page begins with both parts as texts, and drops them when it is built. */
const program = ["taut-engine", "taut-worker"].map((id) => document.getElementById(id)?.textContent ?? "").join("\n");

export class Background {
  private worker: Worker | null = null;
  private end: (() => void) | null = null;

  /** What the engine's method returns. The call before ends, with null. Throws TautError. */
  async call<Name extends Method>(
    method: Name,
    ...args: Parameters<Engine[Name]>
  ): Promise<ReturnType<Engine[Name]> | null> {
    this.stop();
    this.worker ??= this.begin();
    const { worker } = this;
    const reply = await new Promise<Reply | null>((done) => {
      this.end = () => done(null);
      worker.onmessage = ({ data }: MessageEvent<Reply>) => {
        this.end = null;
        done(data);
      };
      worker.onerror = (e) => done({ problem: e.message || "the browser does not let the page have a thread" });
      worker.postMessage({ method, args });
    });
    if (!reply) return null;
    if ("result" in reply) return reply.result as ReturnType<Engine[Name]>;
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

/** What went wrong, line by line. */
export const linesOf = (error: unknown): string[] =>
  error instanceof TautError ? [error.message, error.fault.hint].filter(Boolean) : [String(error)];
