// The library on the thread that asks, compiled once: with the first question.
import compressed from "taut-wasm";
import { call, instantiate } from "./instance.js";

let compiling = null;
let loading = null;
let listener = null;

async function decompressed() {
  const stream = new Blob([await compressed()]).stream().pipeThrough(new DecompressionStream("gzip"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** The compiled module, which workers share. */
export function compiled() {
  compiling ??= decompressed().then((bytes) => WebAssembly.compile(bytes));
  return compiling;
}

/** The instance of this thread. */
export function library() {
  loading ??= compiled().then((module) => instantiate(module, (progress) => listener?.(progress)));
  return loading;
}

/** What call() on this thread gives. */
export async function callHere(asked, { signal, onProgress }) {
  const module = await library();
  // Later on this thread is at work, and sees nothing.
  signal?.throwIfAborted();
  listener = onProgress;
  return call(module, asked);
}
