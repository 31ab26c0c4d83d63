// The library on a thread of its own: a question that takes long leaves the page as it is, and can be stopped.
import { Engine, TautError } from "./engine";

const engine = Engine.load();
const port = self as unknown as {
  onmessage: (e: MessageEvent<{ text: string; closed: boolean; clearance: number }>) => void;
  postMessage(message: unknown): void;
};

port.onmessage = async ({ data: { text, closed, clearance } }) => {
  try {
    port.postMessage({ found: (await engine).findWay(text, closed, clearance) });
  } catch (error) {
    port.postMessage(error instanceof TautError ? { fault: error.fault } : { problem: String(error) });
  }
};
