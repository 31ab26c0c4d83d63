// A project of a user: the package is unpacked into its node_modules.
import { execFileSync } from "node:child_process";
import { mkdirSync, mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { after } from "node:test";
import { fileURLToPath, pathToFileURL } from "node:url";

export const root = join(dirname(fileURLToPath(import.meta.url)), "../../..");
export const tools = createRequire(join(root, "web/package.json"));
export const folder = mkdtempSync(join(tmpdir(), "taut-npm-"));
after(() => rmSync(folder, { recursive: true }));

const [name] = readdirSync(join(root, "build")).filter((file) => /^taut2d-.*\.tgz$/.test(file));
export const archive = join(root, "build", name);
export const installed = join(folder, "node_modules/taut2d");
mkdirSync(installed, { recursive: true });
execFileSync("tar", ["-xzf", archive, "-C", installed, "--strip-components=1"]);
writeFileSync(join(folder, "package.json"), "{}");

export const taut = await import(pathToFileURL(join(installed, "dist/taut.js")).href);

/** An anvil, and a hammer above it. */
export const hammer = (motion) => ({
  format: "taut-scene/1",
  time: [0, 10],
  bodies: [
    {
      name: "anvil",
      polygon: [
        [0, 0],
        [4, 0],
        [4, 1],
        [0, 1],
      ],
    },
    {
      name: "hammer",
      polygon: [
        [1, 5],
        [3, 5],
        [2, 6],
      ],
      motion,
    },
  ],
});
export const falls = hammer({ velocity: [0, -0.5] });

/** Runs a program in the project; what it prints. */
export function printed(file, text) {
  writeFileSync(join(folder, file), text);
  return execFileSync(process.execPath, [join(folder, file)], { cwd: folder, encoding: "utf8" });
}

/** A program for a browser, from the text of one with imports. */
export async function bundled(text) {
  writeFileSync(join(folder, "entry.mjs"), text);
  const outfile = join(folder, "bundled.js");
  await tools("esbuild").build({
    entryPoints: [join(folder, "entry.mjs")],
    bundle: true,
    outfile,
    format: "iife",
    platform: "browser",
    logLevel: "warning",
  });
  return readFileSync(outfile, "utf8");
}

/** The title of a page, once it has one. */
export async function titleOf(url) {
  const { chromium } = tools("playwright-core");
  const browser = await chromium.launch({
    executablePath: "/usr/bin/chromium",
    args: ["--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking"],
  });
  try {
    const tab = await browser.newPage();
    await tab.goto(url);
    await tab.waitForFunction("document.title !== ''", undefined, { timeout: 60000 });
    return await tab.title();
  } finally {
    await browser.close();
  }
}

/** A script within a page. */
export const script = (text) => `<script>${text.replaceAll("</script", "<\\/script")}</script>\n`;
export const globalScript = () => script(readFileSync(join(installed, "dist/taut.global.js"), "utf8"));
export function pageOf(file, html) {
  writeFileSync(join(folder, file), html);
  return pathToFileURL(join(folder, file)).href;
}
