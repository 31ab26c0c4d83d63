// The questions, each of which is one call into WebAssembly: a scene as JSON text goes in, an answer comes out.
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

/** As the library spells options: maxSeconds is max_seconds there, and allPairs: true is pairs: "all". */
function libraryOptions({ allPairs, ...options }) {
  const named = Object.entries(options).map(([key, value]) => [key.replace(/[A-Z]/g, (c) => `_${c.toLowerCase()}`), value]);
  return { ...Object.fromEntries(named), ...(allPairs ? { pairs: "all" } : {}) };
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

export async function check(scene, options) {
  return (await ask("check", scene, options))[0];
}

/** The answer to the last question, with its log. */
function withLog([answer, module]) {
  const at = module._taut_log();
  const log = module.HEAPU8.slice(at, at + module._taut_log_size());
  return { answer, log: log.length > 0 ? log : null };
}

export async function prove(scene, options) {
  return withLog(await ask("prove", scene, options));
}

export async function proveClearance(scene, clearance, options) {
  return withLog(await ask("prove_clearance", scene, { ...options, clearance }));
}

export async function verify(scene, log, options) {
  if (!(log instanceof Uint8Array)) throw new TypeError("the proof is not a Uint8Array");
  return (await ask("verify", scene, options, log))[0];
}

export async function clearance(scene, options) {
  return (await ask("clearance", scene, options))[0];
}

export async function intervals(scene, options) {
  return (await ask("intervals", scene, options))[0];
}

export async function range(scene, from, options) {
  return (await ask("range", scene, { ...options, from }))[0];
}

export async function checkClearance(scene, clearance, options) {
  return (await ask("check_clearance", scene, { ...options, clearance }))[0];
}

export async function distanceProfile(scene, options) {
  return (await ask("distance_profile", scene, options))[0];
}

export async function separate(scene, options) {
  return (await ask("separate", scene, options))[0];
}

export async function envelope(linkage, options) {
  return (await ask("envelope", linkage, options))[0];
}
