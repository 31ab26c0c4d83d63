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
    entryPoints: [join(here, entry)],
    bundle: true,
    minify: true,
    write: false,
    format: "iife",
    target: "es2021",
    charset: "utf8",
    logLevel: "warning",
  });
  return result.outputFiles[0].text.trim();
}

/** A script inside a page must not contain the end of its element. */
const inScript = (text) => text.replaceAll("</script", "<\\/script").replaceAll("<!--", "<\\!--");

const titles = {
  hello: "Hammer and anvil",
  lid: "A lid that opens",
  gears: "Gears",
  gears_thick_tooth: "Gears, one tooth too thick",
  combs: "Combs",
  dips: "Dips (Fig. 16)",
  jigsaw: "Jigsaw",
  jigsaw_caught: "Jigsaw, caught",
  lock: "Lock and key",
  lock_wrong_key: "Lock and a wrong key",
  maze: "A ship in a maze",
  maze_long_ship: "A ship too long for the maze",
  parking_clips: "Parking, clipping a corner",
  rotor: "Rotor (Fig. 17)",
  rotor_long_tooth: "Rotor, one tooth too long",
  spiral: "Spirals",
  "worlds/layers": "Layers: scissors",
  "mechanisms/crank_rocker": "Mechanism: a crank-rocker",
  "mechanisms/jansen": "Mechanism: a Jansen leg",
  "worlds/room": "World: a robot in a room",
  "worlds/arm": "World: an arm of three links",
  "worlds/planetary": "World: a planetary gear",
  "worlds/geneva": "World: a Geneva drive",
  "worlds/drawer": "World: a drawer",
  "worlds/conveyor": "World: boxes on a belt",
  "worlds/puzzle": "World: a puzzle",
  "paths/piano": "Way: a piano around the corner",
  "paths/piano_long": "Way: a piano that is too long",
  "paths/excavator": "Way: an excavator around a pipe",
  "paths/bracket": "Way: a bracket out of its case",
  "paths/arm": "Way: an arm among posts",
  "curves/cam": "Curves: a cam and its follower",
  "curves/slot": "Curves: a pin in a slot",
  "curves/geneva": "Curves: a Geneva drive",
  "curves/hinge": "Curves: a living hinge",
};

/** As JSON that may stand inside a script element. */
async function examples() {
  const all = {};
  for (const [name, title] of Object.entries(titles)) {
    all[name] = { title, scene: JSON.parse(await readFile(join(here, "../examples", `${name}.json`), "utf8")) };
  }
  return JSON.stringify(all).replaceAll("<", "\\u003c");
}

/** Functions as replacements: the texts contain dollar signs. */
async function page(name, script, style = "src/style.css") {
  let text = await readFile(join(here, name), "utf8");
  const wasm = await readFile(wasmFile, "utf8");
  const parts = {
    "@STYLE@": await bundle(style),
    "@SCRIPT@": inScript(await bundle(script)),
  };
  if (text.includes("@WASM@")) parts["@WASM@"] = inScript(wasm);
  if (text.includes("@WORKER@")) parts["@WORKER@"] = inScript(await bundle("src/worker.ts"));
  if (text.includes("@EXAMPLES@")) parts["@EXAMPLES@"] = await examples();
  for (const [mark, content] of Object.entries(parts)) text = text.replace(mark, () => content);
  await writeFile(join(out, name), text);
  return text;
}

await mkdir(out, { recursive: true });
await page("index.html", "src/playgroundpage.ts");
for (const [name, ...of] of [
  ["viewer.html", "src/viewer.ts"],
  ["envelope.html", "src/envelope.ts", "src/envelope.css"],
]) {
  const text = await page(name, ...of);
  if (text.split("@TAUT-DATA@").length !== 2) throw new Error(`${name} must contain @TAUT-DATA@ once`);
}
