// Calls into WebAssembly, with texts and bytes in and out. The same on the thread that asks and in workers.
import createModule from "taut-module";

/** An instance of the library, with a memory of its own. `onProgress` is called in the midst of calls that are watched. */
export function instantiate(compiled, onProgress) {
  const instantiateWasm = (imports, done) => {
    WebAssembly.instantiate(compiled, imports).then((instance) => done(instance, compiled));
    return {};
  };
  return createModule({ instantiateWasm, onProgress });
}

function copyIn(module, bytes) {
  const at = module._malloc(bytes.length + 1);
  if (at === 0) throw new RangeError("taut: not enough memory");
  module.HEAPU8.set(bytes, at);
  module.HEAPU8[at + bytes.length] = 0;
  return at;
}

/** The text that ends at the next NUL. */
export function readOut(module, at) {
  return new TextDecoder().decode(module.HEAPU8.subarray(at, module.HEAPU8.indexOf(0, at)));
}

/**
 * Calls the exported function `name` with texts, with bytes and their number, and with numbers: `{ text, bytes }`, where
 * bytes are what the call left besides its text.
 */
export function call(module, { name, texts, bytes, numbers = [], watched = false }) {
  const held = [];
  const hold = (array) => held[held.push(copyIn(module, array)) - 1];
  try {
    const given = texts.map((text) => hold(new TextEncoder().encode(text)));
    if (bytes) given.push(hold(bytes), bytes.length);
    module._taut_watch(watched ? 1 : 0);
    const text = readOut(module, module[`_${name}`](...given, ...numbers));
    const at = module._taut_log();
    return { text, bytes: module.HEAPU8.slice(at, at + module._taut_log_size()) };
  } finally {
    for (const at of held) module._free(at);
  }
}
