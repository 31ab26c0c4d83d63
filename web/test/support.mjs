// A browser, the command to compare with, and the pages.
import { after, before } from "node:test";
import { execFileSync } from "node:child_process";
import { existsSync, mkdirSync, readFileSync } from "node:fs";
import { createServer } from "node:http";
import { dirname, extname, join, normalize, resolve } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";
import { chromium } from "playwright-core";

export const root = join(dirname(fileURLToPath(import.meta.url)), "../..");
export const taut = join(root, "build/release/taut");
export const pages = join(root, "build/web");
/** Screenshots and pages, kept by CI as artefacts. */
export const artefacts = join(root, "build/browser");
mkdirSync(artefacts, { recursive: true });

const executable = ["/usr/bin/chromium", "/usr/bin/chromium-browser", process.env.TAUT_CHROMIUM].find(
  (p) => p && existsSync(p),
);

export async function launch() {
  if (!executable) throw new Error("no Chromium: install the package chromium, or name the program in TAUT_CHROMIUM");
  return chromium.launch({
    executablePath: executable,
    args: [
      "--no-sandbox",
      "--disable-gpu",
      "--disable-quic",
      "--no-first-run",
      "--disable-background-networking",
      "--disable-component-update",
      "--disable-sync",
    ],
  });
}

/** Runs the command; its exit code tells the outcome, so that only bad input and defects count as failures here. */
export function run(...args) {
  try {
    return execFileSync(taut, args, { cwd: root, encoding: "utf8", maxBuffer: 1 << 28 });
  } catch (error) {
    if (error.status === 1 || error.status === 3) return error.stdout;
    throw error;
  }
}

/** Two bodies of one polygon each are shown event by event: by the engine that has events. */
function engineShown(scene) {
  const { bodies, ignore } = JSON.parse(readFileSync(resolve(root, scene), "utf8"));
  const special = (body) => body.parts || body.holes || body.relative_to || body.polygon?.path || body.polygon?.holes;
  return bodies.length === 2 && !ignore?.length && !bodies.some(special) ? ["--engine", "kinetic"] : [];
}

/** The pages have compiled motions, which do not tell the angle of a sweep. */
export function check(scene, ...args) {
  const answer = JSON.parse(run("check", "--json", ...engineShown(scene), scene, ...args));
  delete answer.contact?.angle_deg;
  return answer;
}

/** Writes the page of a scene; its address. */
export function viewPage(scene, name, ...args) {
  const file = join(artefacts, `${name}.html`);
  run("view", scene, "-o", file, ...args);
  return pathToFileURL(file).href;
}

/** Opens a page that may ask for nothing but what it was given, and reports every error in it. */
export async function openPage(browser, address, options = {}) {
  const page = await browser.newPage({ viewport: { width: 1280, height: 800 }, colorScheme: "light", ...options });
  page.problems = [];
  page.on("pageerror", (error) => page.problems.push(String(error)));
  page.on("console", (message) => {
    if (message.type() === "error") page.problems.push(message.text());
  });
  page.on("request", (request) => {
    if (request.url() !== address.split("#")[0] && !/^(data|blob):/.test(request.url()))
      page.problems.push(`request: ${request.url()}`);
  });
  await page.goto(address);
  await page.waitForFunction(() => window.taut?.player.finished, null, { timeout: 120000 });
  return page;
}

export const screenshot = async (page, name) => {
  await page.waitForTimeout(400);
  await page.screenshot({ path: join(artefacts, `${name}.png`) });
};

/** Saves what the entry of the menu gives, as a file of this name; returns its path. */
export async function save(page, entry, name) {
  await page.click("#save summary");
  const [download] = await Promise.all([page.waitForEvent("download"), page.click(entry)]);
  const file = join(artefacts, name);
  await download.saveAs(file);
  return file;
}

/** The number shown, at full precision. */
export const shownTime = (page) => page.$eval("#clock", (e) => Number(e.dataset.t));

/** After the next frame has been drawn. */
export const settled = (page) =>
  page.evaluate(
    () => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => requestAnimationFrame(done)))),
  );

/** How many pixels of the picture are close to a colour #rrggbb. */
export const pixelsOf = (page, colour) =>
  page.evaluate((hex) => {
    const wanted = [1, 3, 5].map((i) => parseInt(hex.slice(i, i + 2), 16));
    const canvas = document.querySelector("canvas.picture");
    const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
    let count = 0;
    for (let i = 0; i < data.length; i += 4) if (wanted.every((w, k) => Math.abs(data[i + k] - w) < 14)) ++count;
    return count;
  }, colour);

/** Serves a folder of files on this machine only. */
export async function serve(folder) {
  const types = { ".html": "text/html", ".js": "text/javascript", ".json": "application/json" };
  const server = createServer((request, response) => {
    const path = normalize(decodeURIComponent(new URL(request.url, "http://localhost").pathname));
    const file = join(folder, path === "/" ? "index.html" : path);
    if (!file.startsWith(folder) || !existsSync(file)) return response.writeHead(404).end();
    response
      .writeHead(200, { "content-type": types[extname(file)] ?? "application/octet-stream" })
      .end(readFileSync(file));
  });
  await new Promise((done) => server.listen(0, "127.0.0.1", done));
  return { address: `http://127.0.0.1:${server.address().port}/`, close: () => server.close() };
}

/** A browser and a server of the pages, for all tests of a file: they are there while tests run. */
export function duringTests() {
  const at = {};
  before(async () => {
    at.browser = await launch();
    at.server = await serve(pages);
  });
  after(async () => {
    await at.browser?.close();
    at.server?.close();
  });
  return at;
}
