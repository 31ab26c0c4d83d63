// Workers of browsers, and of what has the same.
export const processors = () => globalThis.navigator?.hardwareConcurrency ?? 2;

/** A Worker as workers.js uses it. */
export function wrapped(worker) {
  return {
    post: (message) => worker.postMessage(message),
    busy() {},
    terminate: () => worker.terminate(),
    listen(onMessage, onError) {
      worker.onmessage = ({ data }) => onMessage(data);
      worker.onerror = (event) => onError(new Error(event.message || "taut: the worker does not start"));
    },
  };
}

/** A worker that runs the script, which need not be served by anybody. */
export function start(script) {
  const url = URL.createObjectURL(new Blob([script], { type: "text/javascript" }));
  const worker = wrapped(new Worker(url));
  return { ...worker, terminate: () => (URL.revokeObjectURL(url), worker.terminate()) };
}
