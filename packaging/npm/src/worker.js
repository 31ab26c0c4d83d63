// What runs in a worker: the first message has the compiled module, each further one a call.
import { call, instantiate } from "./instance.js";

// In Node.js a worker's messages do not come to its global scope.
const port = typeof self === "undefined" ? require("node:worker_threads").parentPort : self;
let library = null;

port.onmessage = async ({ data }) => {
  if (data.compiled) {
    library = instantiate(data.compiled, (progress) => port.postMessage({ progress }));
    return;
  }
  try {
    const { text, bytes } = call(await library, data);
    port.postMessage({ text, bytes }, [bytes.buffer]);
  } catch (error) {
    port.postMessage({ failure: String(error) });
  }
};
