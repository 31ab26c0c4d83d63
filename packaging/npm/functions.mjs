// The package's functions and their types, from the library's own description of its questions.
import { createRequire } from "node:module";
import { readFile } from "node:fs/promises";
import { join, resolve } from "node:path";

const require = createRequire(import.meta.url);
const capitalized = (word) => word[0].toUpperCase() + word.slice(1);
/** As JavaScript spells the library's names: max_seconds is maxSeconds. */
const camelCase = (name) => name.replace(/_([a-z])/g, (_, c) => c.toUpperCase());

/** What question_descriptions() says, of the library that was built into the folder. */
export async function questionsOf(built) {
  const createModule = require(resolve(built, "taut_api.js"));
  const module = await createModule({
    wasmBinary: await readFile(join(built, "taut_api.wasm")),
  });
  const at = module._taut_questions();
  return JSON.parse(new TextDecoder().decode(module.HEAPU8.subarray(at, module.HEAPU8.indexOf(0, at))));
}

/** What comes by position after the scene, under the names that options have. */
const required = (question) => question.options.filter((option) => option.required).map((option) => option.name);

/** The module with all functions. */
export function functionsOf(questions) {
  const lines = questions.map((question) => {
    const { name, reads_log, writes_log } = question;
    const form = JSON.stringify({
      name,
      required: required(question),
      readsLog: reads_log,
      writesLog: writes_log,
    });
    return `export const ${camelCase(name)} = question(${form});`;
  });
  return [
    'import { question } from "./question.js";',
    'export { TautError } from "./error.js";',
    'export { readDrawing } from "./drawing.js";',
    'export { StaticMap } from "./map.js";',
    'export { Simulation } from "./simulation.js";',
    'export { setWorkers, stopWorkers } from "./workers.js";',
    ...lines,
    "",
  ].join("\n");
}

function typeOf(option) {
  if (option.type === "word") return option.words.map((word) => JSON.stringify(word)).join(" | ");
  if (option.type === "text") return "string";
  return option.type === "flag" ? "boolean" : "number";
}

function optionsType(question) {
  const optional = question.options.filter((option) => !option.required);
  const members = optional.map((option) => {
    const otherwise = option.default === undefined ? "" : ` ${option.default} without it.`;
    return `  /** ${option.meaning}${otherwise} */\n  ${camelCase(option.name)}?: ${typeOf(option)};\n`;
  });
  return `export interface ${capitalized(camelCase(question.name))}Options extends AskOptions {\n${members.join("")}}\n`;
}

function declaration(question) {
  const name = camelCase(question.name);
  const positional = question.options.filter((option) => option.required);
  const parameters = [
    question.about === "scene" ? "scene: Scene" : `${question.about}: object | string`,
    ...(question.reads_log ? ["log: Uint8Array"] : []),
    ...positional.map((option) => `${camelCase(option.name)}: ${typeOf(option)}`),
    `options?: ${capitalized(name)}Options`,
  ];
  const answer = question.writes_log ? `{ answer: ${question.answer}; log: Uint8Array | null }` : question.answer;
  const notes = positional.map((option) => ` \`${camelCase(option.name)}\`: ${option.meaning}`);
  return (
    `/** ${question.meaning}${notes.join("")} Throws TautError if the scene or an option is not valid. */\n` +
    `export function ${name}(${parameters.join(", ")}): Promise<${answer}>;\n`
  );
}

/** Their declarations. */
export function declarationsOf(questions) {
  return questions.map((question) => `\n${optionsType(question)}${declaration(question)}`).join("");
}
