// The library on a thread of its own: what takes long leaves the page as it is, and can be stopped.
import { Engine, TautError } from "./engine";
import type { Call } from "./background";

const engine = Engine.load();
const port = self as unknown as {
  onmessage: (e: MessageEvent<Call>) => void;
  postMessage(message: unknown): void;
};

port.onmessage = async ({ data: { method, args } }) => {
  try {
    const call = (await engine)[method] as (...all: unknown[]) => unknown;
    port.postMessage({ result: call.apply(await engine, args) });
  } catch (error) {
    port.postMessage(error instanceof TautError ? { fault: error.fault } : { problem: String(error) });
  }
};
