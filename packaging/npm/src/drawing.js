// Drawings and maps as scenes.
import { ask } from "./question.js";

/** `name` is that of the drawing's file, whose ending says what it is. objects.d.ts says the rest. */
export async function readDrawing(text, name, options = {}) {
  for (const given of [text, name]) {
    if (typeof given !== "string" || given.includes("\0")) throw new TypeError("expected two texts without NUL");
  }
  return (await ask("taut_read_drawing", [text, name], options)).answer;
}
