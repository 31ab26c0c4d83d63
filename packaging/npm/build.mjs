// The npm package: an ES module and a CommonJS module, which load the WebAssembly from one file beside them, and a script
// with a global `taut`, which has it inside.
// usage: node build.mjs FOLDER_WITH_TAUT_API OUT_FOLDER
import { cp, mkdir, readFile, rm, writeFile } from "node:fs/promises";
import { createRequire } from "node:module";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";

import { declarationsOf, functionsOf, questionsOf } from "./functions.mjs";

const here = dirname(fileURLToPath(import.meta.url));
const source = join(here, "src");
const [built, out] = process.argv.slice(2);
if (!out) throw new Error("usage: node build.mjs FOLDER_WITH_TAUT_API OUT_FOLDER");
// The pages' tools are the package's, too.
const { build } = createRequire(join(here, "../../web/package.json"))("esbuild");

/** Modules by name, with their contents as esbuild's onLoad() returns them. */
function virtual(modules) {
  return {
    name: "taut",
    setup(setup) {
      setup.onResolve({ filter: /^taut-module$/ }, () => ({ path: resolve(built, "taut_api.js") }));
      // What is beside the package's files, and the reader's tools find.
      setup.onResolve({ filter: /^taut2d-beside:/ }, ({ path }) => ({
        path: path.slice("taut2d-beside:".length),
        external: true,
      }));
      for (const [name, contents] of Object.entries(modules)) {
        setup.onResolve({ filter: new RegExp(`^${name}$`) }, () => ({ path: name, namespace: "taut" }));
        setup.onLoad({ filter: new RegExp(`^${name}$`), namespace: "taut" }, () => ({
          resolveDir: source,
          ...contents,
        }));
      }
    },
  };
}

const common = {
  bundle: true,
  minify: true,
  // Both halves of the world: what either has of its own is in its platform file.
  platform: "neutral",
  target: "es2021",
  charset: "utf8",
  logLevel: "warning",
};

const questions = await questionsOf(built);
const dist = join(out, "dist");
await rm(out, { recursive: true, force: true });
await mkdir(dist, { recursive: true });

// A quarter of the size.
const wasm = { contents: gzipSync(await readFile(join(built, "taut_api.wasm")), { level: 9 }), loader: "binary" };
await build({
  ...common,
  stdin: { contents: 'export { default } from "taut-bytes";', resolveDir: source, sourcefile: "wasm.js" },
  outfile: join(dist, "wasm.js"),
  format: "esm",
  plugins: [virtual({ "taut-bytes": wasm })],
});
for (const platform of ["node", "web"])
  await build({
    ...common,
    entryPoints: [join(source, `platform.${platform}.js`)],
    outfile: join(dist, `platform.${platform}.js`),
    format: "esm",
    external: ["node:*"],
  });
await build({
  ...common,
  entryPoints: [join(source, "worker.js")],
  outfile: join(dist, "worker.js"),
  format: "iife",
  external: ["node:*"],
  plugins: [virtual({})],
});
const worker = { contents: await readFile(join(dist, "worker.js")), loader: "text" };
for (const [format, file] of [
  ["esm", "taut.js"],
  ["cjs", "taut.cjs"],
  ["iife", "taut.global.js"],
]) {
  const alone = format === "iife";
  const load = alone
    ? 'import bytes from "taut-bytes";\nexport default async () => bytes;'
    : 'export default async () => (await import("taut2d-beside:./wasm.js")).default;';
  await build({
    ...common,
    stdin: { contents: functionsOf(questions), resolveDir: source, sourcefile: "taut.js" },
    outfile: join(dist, file),
    format,
    globalName: alone ? "taut" : undefined,
    plugins: [
      virtual({
        "taut-bytes": wasm,
        "taut-wasm": { contents: load },
        "taut-worker": worker,
        ...(alone && { "#platform": { contents: 'export * from "./platform.web.js";' } }),
      }),
    ],
    external: alone ? [] : ["#platform"],
  });
}
for (const file of ["package.json", "README.md"]) await cp(join(here, file), join(out, file));
const parts = ["scenes", "answers", "objects"].map((name) => readFile(join(source, `${name}.d.ts`), "utf8"));
await writeFile(join(dist, "taut.d.ts"), [...(await Promise.all(parts)), declarationsOf(questions)].join("\n"));
await cp(join(here, "../../LICENSE"), join(out, "LICENSE"));
const { version } = JSON.parse(await readFile(join(here, "package.json"), "utf8"));
const cmake = await readFile(join(here, "../../CMakeLists.txt"), "utf8");
if (!cmake.includes(`VERSION ${version} `)) throw new Error(`package.json says ${version}, CMakeLists.txt does not`);
