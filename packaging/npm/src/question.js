// A question is one call into WebAssembly: a scene as JSON text goes in, an answer comes out. build.mjs makes a function
// of each that the library describes.
import createModule from "taut-module";
import compressed from "taut-wasm";

/** What taut refuses, or cannot decide: `kind` is "input", "undecided" or "internal". */
export class TautError extends Error {
  constructor({ kind, place, problem, hint }) {
    super((place ? `${place}: ` : "") + problem + (hint ? `\nhint: ${hint}` : ""));
    this.name = "TautError";
    this.kind = kind;
    this.place = place;
    this.problem = problem;
    this.hint = hint;
  }
}

let loading = null;

async function decompressed() {
  const stream = new Blob([compressed]).stream().pipeThrough(new DecompressionStream("gzip"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** Compiled with the first question, and once. */
function load() {
  loading ??= decompressed().then((wasmBinary) => createModule({ wasmBinary }));
  return loading;
}

function copyIn(module, bytes) {
  const at = module._malloc(bytes.length + 1);
  if (at === 0) throw new RangeError("taut: not enough memory");
  module.HEAPU8.set(bytes, at);
  module.HEAPU8[at + bytes.length] = 0;
  return at;
}

function readOut(module, at) {
  let end = at;
  while (module.HEAPU8[end] !== 0) ++end;
  return new TextDecoder().decode(module.HEAPU8.subarray(at, end));
}

/** As the library spells options: maxSeconds is max_seconds there. */
function libraryOptions(options) {
  const spelled = (key) => key.replace(/[A-Z]/g, (c) => `_${c.toLowerCase()}`);
  return Object.fromEntries(Object.entries(options).map(([key, value]) => [spelled(key), value]));
}

async function ask(question, scene, options = {}, log = new Uint8Array()) {
  const module = await load();
  const encode = (text) => new TextEncoder().encode(text);
  const sceneText = typeof scene === "string" ? scene : JSON.stringify(scene);
  if (typeof sceneText !== "string") throw new TypeError("the scene is neither an object nor JSON text");
  if (sceneText.includes("\0")) throw new TypeError("the scene has a NUL character in it");
  const held = [encode(question), encode(sceneText), encode(JSON.stringify(libraryOptions(options))), log].map((b) =>
    copyIn(module, b),
  );
  try {
    const answer = JSON.parse(readOut(module, module._taut_ask(...held, log.length)));
    if (answer.error) throw new TautError(answer.error);
    return [answer, module];
  } finally {
    for (const at of held) module._free(at);
  }
}

/** The function that asks a question: of the scene, the log if the question reads one, what is required, and options. */
export function question({ name, required, readsLog, writesLog }) {
  return async (scene, ...rest) => {
    const log = readsLog ? rest.shift() : undefined;
    if (readsLog && !(log instanceof Uint8Array)) throw new TypeError("the proof is not a Uint8Array");
    const positional = Object.fromEntries(required.map((option) => [option, rest.shift()]));
    const [answer, module] = await ask(name, scene, { ...rest[0], ...positional }, log);
    return writesLog ? withLog(answer, module) : answer;
  };
}

/** The answer to the last question, with its log. */
function withLog(answer, module) {
  const at = module._taut_log();
  const log = module.HEAPU8.slice(at, at + module._taut_log_size());
  return { answer, log: log.length > 0 ? log : null };
}
