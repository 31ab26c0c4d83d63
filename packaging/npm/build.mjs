// The npm package in three forms (ES module, CommonJS, script with a global `taut`), the WebAssembly inside.
// usage: node build.mjs FOLDER_WITH_TAUT_API OUT_FOLDER
import { cp, mkdir, readFile, rm, writeFile } from "node:fs/promises";
import { createRequire } from "node:module";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";

import { declarationsOf, functionsOf, questionsOf } from "./functions.mjs";

const here = dirname(fileURLToPath(import.meta.url));
const [built, out] = process.argv.slice(2);
if (!out) throw new Error("usage: node build.mjs FOLDER_WITH_TAUT_API OUT_FOLDER");
// The pages' tools are the package's, too.
const { build } = createRequire(join(here, "../../web/package.json"))("esbuild");

const modules = {
  name: "taut",
  setup(setup) {
    setup.onResolve({ filter: /^taut-module$/ }, () => ({
      path: resolve(built, "taut_api.js"),
    }));
    // A quarter of the size, three times.
    setup.onLoad({ filter: /\.wasm$/ }, async ({ path }) => ({
      contents: gzipSync(await readFile(path), { level: 9 }),
      loader: "binary",
    }));
    setup.onResolve({ filter: /^taut-wasm$/ }, () => ({
      path: resolve(built, "taut_api.wasm"),
    }));
  },
};

const questions = await questionsOf(built);
await rm(out, { recursive: true, force: true });
await mkdir(join(out, "dist"), { recursive: true });
for (const [format, file] of [
  ["esm", "taut.js"],
  ["cjs", "taut.cjs"],
  ["iife", "taut.global.js"],
]) {
  await build({
    stdin: {
      contents: functionsOf(questions),
      resolveDir: join(here, "src"),
      sourcefile: "taut.js",
    },
    outfile: join(out, "dist", file),
    bundle: true,
    minify: true,
    format,
    globalName: format === "iife" ? "taut" : undefined,
    // Both halves of the world: nothing of either is used.
    platform: "neutral",
    target: "es2021",
    charset: "utf8",
    plugins: [modules],
    logLevel: "warning",
  });
}
for (const file of ["package.json", "README.md"]) await cp(join(here, file), join(out, file));
const answers = await readFile(join(here, "src/answers.d.ts"), "utf8");
await writeFile(join(out, "dist/taut.d.ts"), answers + declarationsOf(questions));
await cp(join(here, "../../LICENSE"), join(out, "LICENSE"));
const { version } = JSON.parse(await readFile(join(here, "package.json"), "utf8"));
const cmake = await readFile(join(here, "../../CMakeLists.txt"), "utf8");
if (!cmake.includes(`VERSION ${version} `)) throw new Error(`package.json says ${version}, CMakeLists.txt does not`);
