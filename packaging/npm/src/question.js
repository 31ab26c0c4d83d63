// A question is one call into WebAssembly: a scene as JSON text goes in, an answer comes out. build.mjs makes a function
// of each that the library describes.
import { TautError } from "./error.js";
import { callHere } from "./library.js";
import { callInWorker } from "./workers.js";

/** As the library spells options: maxSeconds is max_seconds there. */
function libraryOptions(options) {
  const spelled = (key) => key.replace(/[A-Z]/g, (c) => `_${c.toLowerCase()}`);
  return Object.fromEntries(Object.entries(options).map(([key, value]) => [spelled(key), value]));
}

function textOf(scene) {
  const text = typeof scene === "string" ? scene : JSON.stringify(scene);
  if (typeof text !== "string") throw new TypeError("the scene is neither an object nor JSON text");
  if (text.includes("\0")) throw new TypeError("the scene has a NUL character in it");
  return text;
}

/** The parsed answer, and bytes that came with it. Options of JavaScript's own say where and how it is asked. */
async function ask(question, scene, options, log = new Uint8Array()) {
  const { signal, onProgress, worker = Boolean(signal || onProgress), ...own } = options;
  const texts = [question, textOf(scene), JSON.stringify(libraryOptions(own))];
  const asked = { name: "taut_ask", texts, bytes: log, watched: Boolean(onProgress) };
  const { text, bytes } = await (worker ? callInWorker : callHere)(asked, { signal, onProgress });
  const answer = JSON.parse(text);
  if (answer.error) throw new TautError(answer.error);
  return { answer, bytes };
}

/** The function that asks a question: of the scene, the log if the question reads one, what is required, and options. */
export function question({ name, required, readsLog, writesLog }) {
  return async (scene, ...rest) => {
    const log = readsLog ? rest.shift() : undefined;
    if (readsLog && !(log instanceof Uint8Array)) throw new TypeError("the proof is not a Uint8Array");
    const positional = Object.fromEntries(required.map((option) => [option, rest.shift()]));
    const { answer, bytes } = await ask(name, scene, { ...rest[0], ...positional }, log);
    return writesLog ? { answer, log: bytes.length > 0 ? bytes : null } : answer;
  };
}
