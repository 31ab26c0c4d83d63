// The page of all combinations: the pose under the pointer is the command's, and so is what it says of it.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { after, before, test } from "node:test";
import { artefacts, launch, root, run, screenshot } from "./support.mjs";

let browser;
before(async () => (browser = await launch()));
after(() => browser?.close());

/** Opens the page of a linkage, which may ask for nothing else. */
async function open(name, options = {}, scene = `examples/linkages/${name}.json`, ...more) {
  const file = join(artefacts, `envelope_${name}.html`);
  run("envelope", scene, "--html", file, ...more);
  const page = await browser.newPage({ viewport: { width: 1200, height: 620 }, colorScheme: "light", ...options });
  page.problems = [];
  page.on("pageerror", (error) => page.problems.push(String(error)));
  page.on("console", (message) => message.type() === "error" && page.problems.push(message.text()));
  await page.goto(pathToFileURL(file).href);
  await page.waitForFunction(() => window.envelope);
  return page;
}

const said = (page) => page.$eval(".controls .state", (e) => [e.classList[1], e.textContent]);
const values = (page) => page.evaluate(() => window.envelope.values);

test("the pose under the pointer is what the command says of it", async () => {
  const { joints, cells } = JSON.parse(run("envelope", "examples/linkages/loader.json", "--json", "--cells"));
  const page = await open("loader");
  const box = await (await page.$("canvas")).boundingBox();
  const seen = new Set();
  for (let i = 0; i < 40; ++i) {
    await page.mouse.move(box.x + 70 + ((i * 37) % (box.width - 100)), box.y + 20 + ((i * 61) % (box.height - 80)));
    const at = await values(page);
    const inside = cells.filter((c) => at.every((x, k) => c.lo[k] <= x && x <= c.hi[k]));
    assert.ok(inside.length > 0);
    const [state, text] = await said(page);
    assert.ok(inside.some((c) => c.state === state));
    if (state === "colliding") assert.match(text, /overlap/);
    seen.add(state);
    at.forEach((x, k) => assert.ok(joints[k].range[0] <= x && x <= joints[k].range[1]));
  }
  assert.ok(seen.has("free") && seen.has("colliding"));
  await screenshot(page, "envelope");
  assert.deepEqual(page.problems, []);
});

test("a click keeps the pose, and arrow keys and sliders move it", async () => {
  const page = await open("lift");
  const box = await (await page.$("canvas")).boundingBox();
  await page.mouse.click(box.x + 300, box.y + 200);
  const kept = await values(page);
  await page.mouse.move(box.x + 100, box.y + 100);
  assert.deepEqual(await values(page), kept);
  await page.keyboard.press("ArrowUp");
  const [lift, reach] = await values(page);
  assert.equal(lift, kept[0]);
  assert.ok(reach > kept[1]);
  await page.$eval("input[type=range]", (e) => {
    e.value = e.max;
    e.dispatchEvent(new Event("input"));
  });
  const scene = JSON.parse(readFileSync(join(root, "examples/linkages/lift.json"), "utf8"));
  assert.equal((await values(page))[0], scene.joints.lift[1]);
  assert.deepEqual(page.problems, []);
});

test("bodies are drawn where the joints put them", async () => {
  const page = await open("loader");
  await page.evaluate(() => {
    window.envelope.values.splice(0, 2, 0, 0);
    window.envelope.show();
  });
  const still = await page.$$eval(".pose g g", (all) => all.map((e) => e.getAttribute("transform")));
  assert.ok(
    still.every((t) => /^matrix\(1 -?0 -?0 1 -?0 -?0\)$/.test(t)),
    still.join(),
  );
  await page.evaluate(() => {
    window.envelope.values.splice(0, 2, 30, 0);
    window.envelope.show();
  });
  const turned = await page.$$eval(".pose g g", (all) => all.map((e) => e.getAttribute("transform")));
  // The arm turns about (-1.5, 1.65), and the bucket with it.
  const [c, s] = [Math.cos(Math.PI / 6), Math.sin(Math.PI / 6)];
  const expected = [c, s, -s, c, -1.5 - c * -1.5 + s * 1.65, 1.65 - s * -1.5 - c * 1.65];
  for (const transform of [turned[2], turned[3]]) {
    const found = transform.match(/-?[\d.e-]+/g).map(Number);
    found.forEach((x, k) => assert.ok(Math.abs(x - expected[k]) < 1e-12, transform));
  }
  assert.equal(turned[0], still[0]);
});

test("the page has names, a legend with shares, round ticks, and a look to choose", async () => {
  const page = await open("loader", { permissions: ["clipboard-read", "clipboard-write"] });
  const names = await page.$$eval(".pose text", (all) => all.map((e) => e.textContent));
  assert.deepEqual(names, ["tractor", "ground", "arm", "bucket"]);
  const shares = await page.$$eval(".shares .state", (all) => all.map((e) => e.textContent));
  assert.match(shares.join(", "), /^free [\d.]+ %, colliding [\d.]+ %, undecided [\d.]+ %$/);
  assert.match(await page.textContent(".joint output"), /°$/);
  await page.keyboard.press("t");
  assert.equal(await page.evaluate(() => document.documentElement.dataset.theme), "dark");
  await screenshot(page, "envelope-dark");
  await page.click("#copy");
  const pose = JSON.parse(await page.evaluate(() => navigator.clipboard.readText()));
  assert.deepEqual(Object.keys(pose), ["lift", "tilt"]);
  // The picture that is saved looks as on the page, without the page's style.
  const [download] = await Promise.all([page.waitForEvent("download"), page.click("#svg")]);
  assert.equal(download.suggestedFilename(), "loader.svg");
  const file = join(artefacts, "envelope-pose.svg");
  await download.saveAs(file);
  const looks = (svg) => {
    const style = (e) => ["fill", "stroke", "strokeWidth", "display"].map((k) => getComputedStyle(e)[k]);
    return [...svg.querySelectorAll("path, text")].map((e) => style(e).join());
  };
  const shown = await page.$eval(".pose svg", looks);
  const alone = await browser.newPage();
  await alone.goto(pathToFileURL(file).href);
  assert.deepEqual(await alone.$eval("svg", looks), shown);
  assert.ok(shown.length >= 8 && new Set(shown).size >= 4, "bodies in several colours, and names");
  await alone.close();
  assert.deepEqual(page.problems, []);
  await page.close();
});

test("links of a mechanism follow tables of their joints, which end where the drives do", async () => {
  const page = await open("excavator", {}, "examples/paths/excavator.json", "--tolerance", "0.2");
  const table = await page.evaluate(() => window.envelope.data.bodies.flatMap(({ motion }) => motion ?? []));
  assert.equal(table.length, 9);
  // Each table begins and ends with what the mechanism does over the range.
  const problem = JSON.parse(readFileSync(join(root, "examples/paths/excavator.json"), "utf8"));
  const elbow = table.find(({ joint, pivot }) => joint === 1 && pivot);
  assert.deepEqual([elbow.values[0], elbow.values.at(-1)], problem.mechanism.drive.elbow);
  await page.evaluate(() => {
    window.envelope.values.splice(0, 3, -2.5, -20, 4);
    window.envelope.show();
  });
  assert.deepEqual(page.problems, []);
  await screenshot(page, "envelope-mechanism");
  await page.close();
});
