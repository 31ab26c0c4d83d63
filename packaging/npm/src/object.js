// Objects with memory live in the instance of this thread. Once that is there, their calls are answered at once.
import { TautError } from "./error.js";
import { call } from "./instance.js";
import { library } from "./library.js";

/** As the library spells options: maxSeconds is max_seconds there. */
export function optionsText(options) {
  const spelled = (key) => key.replace(/[A-Z]/g, (c) => `_${c.toLowerCase()}`);
  return JSON.stringify(Object.fromEntries(Object.entries(options).map(([key, value]) => [spelled(key), value])));
}

export function sceneText(scene) {
  const text = typeof scene === "string" ? scene : JSON.stringify(scene);
  if (typeof text !== "string") throw new TypeError("the scene is neither an object nor JSON text");
  if (text.includes("\0")) throw new TypeError("the scene has a NUL character in it");
  return text;
}

/** What a call answered, if that is no error. */
export function parsed(text) {
  const answer = JSON.parse(text);
  if (answer?.error) throw new TautError(answer.error);
  return answer;
}

const shape = [
  [0, 0],
  [1, 0],
  [0, 1],
];

/** A scene that has nothing but a motion, on that time. */
export const motionScene = (motion, [start, end]) =>
  sceneText({ format: "taut-scene/1", time: [start, end], bodies: [{ name: "it", polygon: shape, motion }] });

/** A scene that has nothing but a body. */
export const bodyScene = (body, [start, end]) =>
  sceneText({ format: "taut-scene/1", time: [start, end], bodies: [body] });

/** The module's functions as `functions.name(texts, numbers)`, which give what they answered. */
export async function functionsOf(prefix) {
  const module = await library();
  return (name, texts, ...numbers) => parsed(call(module, { name: `${prefix}_${name}`, texts, numbers }).text);
}

/** Frees what was made in the library when its object is collected, if nobody did before. */
export const collected = new FinalizationRegistry((free) => free());
