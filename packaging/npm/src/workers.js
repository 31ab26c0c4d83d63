// Questions off the thread that asks: a pool of workers, each with an instance of the library. An aborted question ends
// its worker; another one only has to instantiate what is compiled already.
import script from "taut-worker";
import { compiled } from "./library.js";

const settings = { count: null, create: null };
const idle = [];
/** Those who wait for their turn. `taken` turns are at work. */
const waiting = [];
let taken = 0;

/** The promise; or, if the signal is aborted before that, its reason, after `clean()`. */
function unlessAborted(promise, signal, clean) {
  if (!signal) return promise;
  return new Promise((resolve, reject) => {
    const abort = () => {
      clean();
      reject(signal.reason);
    };
    signal.addEventListener("abort", abort, { once: true });
    promise.then(resolve, reject).finally(() => signal.removeEventListener("abort", abort));
  });
}

/** One worker, which answers one call at a time. */
class LibraryWorker {
  usable = true;
  #thread;
  #pending = null;

  constructor(thread, module) {
    this.#thread = thread;
    thread.listen(
      (message) => this.#hear(message),
      (error) => this.#fail(error),
    );
    thread.post({ compiled: module });
  }

  ask(call, onProgress) {
    if (!this.usable) return Promise.reject(new Error("taut: the worker has ended"));
    this.#thread.busy(true);
    return new Promise((resolve, reject) => {
      this.#pending = { resolve, reject, onProgress };
      this.#thread.post(call);
    });
  }

  terminate() {
    this.usable = false;
    this.#pending = null;
    this.#thread.terminate();
  }

  #hear(message) {
    if (message.progress) return this.#pending?.onProgress?.(message.progress);
    if (message.failure) return this.#fail(new Error(message.failure));
    this.#thread.busy(false);
    this.#pending?.resolve(message);
    this.#pending = null;
  }

  /** After an error its memory may be in any state. */
  #fail(error) {
    const pending = this.#pending;
    this.terminate();
    pending?.reject(error);
  }
}

/** Until there is room for one more at work. */
async function turn(signal) {
  const most = settings.count ?? (await import("#platform")).processors();
  signal?.throwIfAborted();
  if (taken < most) {
    ++taken;
    return;
  }
  await new Promise((resolve, reject) => {
    const abort = () => {
      waiting.splice(waiting.indexOf(begin), 1);
      reject(signal.reason);
    };
    const begin = () => {
      signal?.removeEventListener("abort", abort);
      resolve();
    };
    signal?.addEventListener("abort", abort, { once: true });
    waiting.push(begin);
  });
}

function endTurn() {
  const begin = waiting.shift();
  if (begin) begin();
  else --taken;
}

async function started() {
  const [platform, module] = await Promise.all([import("#platform"), compiled()]);
  const thread = settings.create ? platform.wrapped(settings.create()) : platform.start(script);
  return new LibraryWorker(thread, module);
}

/** What call() in a worker gives. Rejects with the signal's reason as soon as that is aborted. */
export async function callInWorker(call, { signal, onProgress }) {
  signal?.throwIfAborted();
  await turn(signal);
  let worker = null;
  const keep = (other) => idle.push(other);
  try {
    const found = idle.length > 0 ? Promise.resolve(idle.pop()) : started();
    worker = await unlessAborted(found, signal, () => found.then(keep, () => {}));
    return await unlessAborted(worker.ask(call, onProgress), signal, () => worker.terminate());
  } finally {
    if (worker?.usable) keep(worker);
    endTurn();
  }
}

/** Settings for questions in workers. */
export function setWorkers({ count = null, create = null }) {
  if (count !== null && !(Number.isInteger(count) && count >= 1)) throw new RangeError("count is no number of workers");
  Object.assign(settings, { count, create });
  stopWorkers();
}

/** Ends the workers that have nothing to do, and gives their memory back. */
export function stopWorkers() {
  for (const worker of idle.splice(0)) worker.terminate();
}
