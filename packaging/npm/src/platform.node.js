// Workers of Node.js.
import * as os from "node:os";
import { Worker } from "node:worker_threads";

export const processors = () => os.availableParallelism?.() ?? os.cpus().length;

/** A worker of node:worker_threads as workers.js uses it. While it is idle, it does not keep the process alive. */
export function wrapped(worker) {
  worker.unref();
  return {
    post: (message) => worker.postMessage(message),
    busy: (is) => (is ? worker.ref() : worker.unref()),
    terminate: () => worker.terminate(),
    listen(onMessage, onError) {
      worker.on("message", onMessage);
      worker.on("error", onError);
    },
  };
}

/** A worker that runs the script. */
export const start = (script) => wrapped(new Worker(script, { eval: true }));
