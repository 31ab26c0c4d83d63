// Bundles the pages into single files: usage: node build.mjs TAUT_JS OUT_FOLDER
import { build } from "esbuild";
import { mkdir, readFile, writeFile } from "node:fs/promises";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const here = dirname(fileURLToPath(import.meta.url));
const [wasmFile, out] = process.argv.slice(2);
if (!out) throw new Error("usage: node build.mjs TAUT_JS OUT_FOLDER");

async function bundle(entry) {
  const result = await build({
    entryPoints: [join(here, entry)], bundle: true, minify: true, write: false, format: "iife", target: "es2021",
    charset: "utf8", logLevel: "warning",
  });
  return result.outputFiles[0].text.trim();
}

/** A script inside a page must not contain the end of its element. */
const inScript = (text) => text.replaceAll("</script", "<\\/script").replaceAll("<!--", "<\\!--");

/** Functions as replacements: the texts contain dollar signs. */
async function page(name, script) {
  let text = await readFile(join(here, name), "utf8");
  const wasm = await readFile(wasmFile, "utf8");
  const parts = { "@STYLE@": await bundle("src/style.css"), "@WASM@": inScript(wasm), "@SCRIPT@": inScript(await bundle(script)) };
  for (const [mark, content] of Object.entries(parts)) text = text.replace(mark, () => content);
  await writeFile(join(out, name), text);
  return text;
}

await mkdir(out, { recursive: true });
const viewer = await page("viewer.html", "src/viewer.ts");
if (viewer.split("@TAUT-DATA@").length !== 2) throw new Error("viewer.html must contain @TAUT-DATA@ once");
