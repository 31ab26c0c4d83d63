// A question is one call into WebAssembly: a scene as JSON text goes in, an answer comes out. build.mjs makes a function
// of each that the library describes.
import { callHere } from "./library.js";
import { optionsText, parsed, sceneText } from "./object.js";
import { callInWorker } from "./workers.js";

/**
 * Calls the exported function `name` with texts, the options among them, and perhaps a log: `{ answer, bytes }`, the
 * parsed answer and what came with it. Options of JavaScript's own say where and how that is done.
 */
export async function ask(name, texts, options, log) {
  const { signal, onProgress, worker = Boolean(signal || onProgress), ...own } = options;
  const asked = { name, texts: [...texts, optionsText(own)], bytes: log, watched: Boolean(onProgress) };
  const { text, bytes } = await (worker ? callInWorker : callHere)(asked, { signal, onProgress });
  return { answer: parsed(text), bytes };
}

/** The function that asks a question: of the scene, the log if the question reads one, what is required, and options. */
export function question({ name, required, readsLog, writesLog }) {
  return async (scene, ...rest) => {
    const log = readsLog ? rest.shift() : undefined;
    if (readsLog && !(log instanceof Uint8Array)) throw new TypeError("the proof is not a Uint8Array");
    const positional = Object.fromEntries(required.map((option) => [option, rest.shift()]));
    const options = { ...rest[0], ...positional };
    const { answer, bytes } = await ask("taut_ask", [name, sceneText(scene)], options, log ?? new Uint8Array());
    return writesLog ? { answer, log: bytes.length > 0 ? bytes : null } : answer;
  };
}
