// The playground, served as files, compared with the command line.
import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { pathToFileURL } from "node:url";
import {
  artefacts,
  check,
  duringTests,
  openPage,
  pages,
  pixelsOf,
  root,
  run,
  save,
  screenshot,
  settled,
  shownTime,
} from "./support.mjs";

const site = duringTests();

const open = (options) => openPage(site.browser, site.server.address, options);
const finished = (page) => page.waitForFunction(() => window.taut.player.finished && !window.playground.pending);
const sceneOf = (page) => page.evaluate(() => window.playground.state.scene);

async function choose(page, example) {
  await page.selectOption("#example", example);
  await finished(page);
  await settled(page);
}

/** The command's answer for the scene that the page has now. */
async function commandsAnswer(page, name) {
  const file = join(artefacts, `${name}.json`);
  writeFileSync(file, JSON.stringify(await sceneOf(page)));
  return check(file);
}

/** What the page says must be what the command says. */
async function compare(page, name) {
  await finished(page);
  await settled(page);
  const answer = await commandsAnswer(page, name);
  const shown = await page.evaluate(() => window.taut.player.status.answer);
  assert.equal(shown.outcome, answer.outcome, name);
  assert.deepEqual(shown.t, answer.t, name);
  assert.deepEqual(shown.contact, answer.contact, name);
  return answer;
}

/** Where a vertex of a body is on the screen. */
const vertexAt = (page, body, index) =>
  page.evaluate(
    ([b, i]) => {
      const box = document.querySelector("canvas.picture").getBoundingClientRect();
      const [x, y] = window.taut.stage.tool.handles.pixel(b, i);
      return [box.left + x, box.top + y];
    },
    [body, index],
  );
const place = (page, expression) =>
  page.evaluate((code) => {
    const box = document.querySelector("canvas.picture").getBoundingClientRect();
    const tool = window.taut.stage.tool;
    const [x, y] = new Function("tool", "taut", `return ${code}`)(tool, window.taut);
    return [box.left + x, box.top + y];
  }, expression);

async function drag(page, from, to) {
  await page.mouse.move(...from);
  await page.mouse.down();
  for (let k = 1; k <= 5; ++k)
    await page.mouse.move(from[0] + ((to[0] - from[0]) * k) / 5, from[1] + ((to[1] - from[1]) * k) / 5);
  await page.mouse.up();
  await finished(page);
  await settled(page);
}

test("every example opens, with the command's answer", async () => {
  const page = await open();
  // Those about ways are asked about elsewhere.
  const names = await page.$$eval("#example option", (all) => all.map((o) => o.value).filter(Boolean));
  const examples = names.filter((name) => !name.startsWith("paths/"));
  assert.ok(examples.length >= 10);
  for (const example of examples) {
    await choose(page, example);
    const answer = check(join(root, "examples", `${example}.json`));
    const shown = await page.evaluate(() => window.taut.player.status.answer);
    assert.deepEqual(shown, answer, example);
  }
  assert.deepEqual(page.problems, []);
  await page.close();
});

test("dragging a body changes the answer", async () => {
  const page = await open();
  await choose(page, "hello");
  assert.equal((await compare(page, "drag-before")).outcome, "contact");
  await page.click("#mode-shape");
  const hammer = await place(page, "taut.stage.camera.pixel(2, 5.4)");
  await drag(page, hammer, [hammer[0] + 0.5 * (await page.evaluate(() => window.taut.stage.camera.scale)), hammer[1]]);
  const moved = await compare(page, "drag-after");
  assert.equal(moved.outcome, "contact");
  const scene = await sceneOf(page);
  assert.ok(Math.abs(scene.bodies[1].motion.x[0] - 0.5) < 0.02, JSON.stringify(scene.bodies[1].motion));
  // Far to the side the hammer misses.
  const again = await place(page, "taut.stage.camera.pixel(2.5, 5.4)");
  await drag(page, again, [again[0] + 4 * (await page.evaluate(() => window.taut.stage.camera.scale)), again[1]]);
  assert.equal((await compare(page, "drag-free")).outcome, "free");
  assert.equal(await page.textContent("#headline"), "Free");
  await screenshot(page, "playground-shape");
  await page.keyboard.press("Control+z");
  await finished(page);
  assert.equal((await compare(page, "drag-undone")).outcome, "contact");
  await page.click("#redo");
  assert.equal((await compare(page, "drag-redone")).outcome, "free");
  assert.deepEqual(page.problems, []);
  await page.close();
});

test("a vertex dragged across the boundary is refused, and the crossing edges are marked", async () => {
  const page = await open();
  await choose(page, "hello");
  await page.click("#mode-shape");
  await page.selectOption("#body", "0");
  const from = await vertexAt(page, 0, 2);
  const scale = await page.evaluate(() => window.taut.stage.camera.scale);
  assert.equal(await pixelsOf(page, "#c4161c"), 0);
  await drag(page, from, [from[0] - 5 * scale, from[1] + 0.6 * scale]);
  const message = await page.textContent("#message");
  assert.match(message, /anvil: the boundary is not simple: edges \d-\d and \d-\d cross/);
  assert.ok((await pixelsOf(page, "#c4161c")) > 200, "the crossing edges are marked");
  const file = join(artefacts, "crossing.json");
  writeFileSync(file, JSON.stringify(await sceneOf(page)));
  assert.throws(
    () => run("check", file),
    (error) => error.status === 2 && String(error.stderr).includes(message.slice(0, 70)),
  );
  assert.equal(await page.textContent("#headline"), "No valid scene");
  await screenshot(page, "playground-crossing");
  // Dragged back, all is well again.
  await drag(page, await vertexAt(page, 0, 2), from);
  assert.ok(await page.isHidden("#message"));
  await compare(page, "crossing-mended");
  await page.close();
});

test("vertices are added and removed", async () => {
  const page = await open();
  await choose(page, "hello");
  await page.click("#mode-shape");
  await page.selectOption("#body", "0");
  const a = await vertexAt(page, 0, 2);
  const b = await vertexAt(page, 0, 3);
  await page.mouse.dblclick((a[0] + b[0]) / 2, a[1]);
  await finished(page);
  assert.equal((await sceneOf(page)).bodies[0].polygon.length, 5);
  await compare(page, "vertex-added");
  await page.keyboard.press("Delete");
  await finished(page);
  assert.equal((await sceneOf(page)).bodies[0].polygon.length, 4);
  await page.close();
});

test("ghosts make keyframes: a body at rest is set in motion, turned, and given a stop on the way", async () => {
  const page = await open();
  await choose(page, "hello");
  await page.click("#mode-keyframes");
  await page.selectOption("#body", "0");
  assert.equal((await page.evaluate(() => window.playground.state.keyframes)).length, 1);
  const scale = await page.evaluate(() => window.taut.stage.camera.scale);
  const inside = await place(page, "taut.stage.camera.pixel(3.4, 0.5)");
  await drag(page, inside, [inside[0] - 2 * scale, inside[1]]);
  let frames = await page.evaluate(() => window.playground.state.keyframes);
  assert.equal(frames.length, 2);
  assert.ok(Math.abs(frames[1].x + 2) < 0.02 && frames[1].t === 10, JSON.stringify(frames));
  await compare(page, "keyframes-moved");
  const handle = await place(page, "tool.handles.turn(tool.handles.ghostPose(tool.keyframes()[1]))");
  await drag(page, handle, [handle[0] - 46, handle[1] - 46]);
  frames = await page.evaluate(() => window.playground.state.keyframes);
  assert.ok(Math.abs(frames[1].angle - Math.PI / 2) < 0.05, JSON.stringify(frames));
  await compare(page, "keyframes-turned");
  await page.evaluate(() => window.taut.player.seek(3));
  await page.click("#add-keyframe");
  await finished(page);
  frames = await page.evaluate(() => window.playground.state.keyframes);
  assert.deepEqual(
    frames.map((k) => k.t),
    [0, 3, 10],
  );
  await page.getByLabel("y of keyframe 2").fill("-1.5");
  await page.getByLabel("y of keyframe 2").press("Enter");
  await finished(page);
  await compare(page, "keyframes-three");
  assert.equal(await page.evaluate(() => window.playground.state.pieces), 2);
  await screenshot(page, "playground-keyframes");
  await page.getByLabel("Remove keyframe 2").click();
  await finished(page);
  assert.equal((await page.evaluate(() => window.playground.state.keyframes)).length, 2);
  assert.deepEqual(page.problems, []);
  await page.close();
});

test("a body that turns about a pivot keeps it", async () => {
  const page = await open();
  await page.click(".part-text > summary");
  const scene = await sceneOf(page);
  scene.bodies[1].motion = { velocity: [0, 3], spin_deg: 1, pivot: [90, 0] };
  await page.fill("#scene-text", JSON.stringify(scene));
  await page.click("#apply");
  await finished(page);
  await page.click("#mode-keyframes");
  const before = await page.evaluate(() => window.taut.player.poses(0));
  const ghost = await page.evaluate(() =>
    window.taut.stage.tool.handles.ghostPose(window.taut.stage.tool.keyframes()[0]),
  );
  assert.ok(Math.abs(ghost.x - before[1].x) + Math.abs(ghost.y - before[1].y) < 1e-9);
  await page.getByLabel("y of keyframe 2").fill("200");
  await page.getByLabel("y of keyframe 2").press("Enter");
  await finished(page);
  assert.deepEqual((await sceneOf(page)).bodies[1].motion.pivot, [90, 0]);
  await compare(page, "pivot-keyframes");
  await page.click("#mode-drive");
  await page.evaluate(() => window.taut.player.seek(30));
  await page.keyboard.press("0");
  await settled(page);
  const spin = await place(page, "tool.handles.spin(tool.velocity())");
  await drag(page, spin, [spin[0] + 40, spin[1] + 20]);
  const { motion } = (await sceneOf(page)).bodies[1];
  assert.equal(motion.length, 2);
  assert.deepEqual(motion[1].pivot, [90, 0]);
  await compare(page, "pivot-drive");
  assert.deepEqual(page.problems, []);
  await page.close();
});

test("a formula becomes keyframes on request", async () => {
  const page = await open();
  await choose(page, "rotor");
  const count = await page.locator("#sample").count();
  if (count === 0) await page.selectOption("#body", "0");
  const scene = await sceneOf(page);
  scene.bodies[1].motion = { rotation: { half_angle_tangent: [0, 0.1] } };
  await page.click(".part-text > summary");
  await page.fill("#scene-text", JSON.stringify(scene));
  await page.click("#apply");
  await finished(page);
  await page.selectOption("#body", "1");
  await page.click("#sample");
  await finished(page);
  assert.equal((await page.evaluate(() => window.playground.state.keyframes)).length, 8);
  await compare(page, "sampled");
  await page.close();
});

test("a new plan while time runs: the past stays, the future is the command's answer to the new scene", async () => {
  const page = await open();
  await choose(page, "hello");
  await page.selectOption("#body", "1");
  await page.click("#mode-drive");
  await page.evaluate(() => window.taut.player.seek(1.2));
  // The tip moves with the body: slowly, so that it can be looked up and grasped.
  await page.selectOption("#speed", "0.1");
  await page.click("#play");
  await page.waitForFunction(() => window.taut.player.t > 1.25);
  const t = await page.evaluate(() => window.taut.player.t);
  const now = await place(page, "tool.handles.arrowTip(tool.velocity())");
  await page.mouse.move(...now);
  await page.mouse.down();
  await page.mouse.move(now[0] + 60, now[1] - 220, { steps: 4 });
  await page.mouse.up();
  await page.waitForFunction((old) => window.taut.player.t > old, t);
  assert.equal(await page.evaluate(() => window.taut.player.playing), true, "time runs on");
  await page.click("#play");
  await finished(page);
  assert.match(
    await page.textContent("#note"),
    /New plan for hammer at t = .*the map stays, \d+ certificates get new failure times/,
  );
  const scene = await sceneOf(page);
  assert.equal(scene.bodies[1].motion.length, 2);
  assert.ok(scene.bodies[1].motion[0].until >= t);
  assert.ok(scene.bodies[1].motion[1].y[1] > 0, "it goes up now");
  assert.equal((await compare(page, "plan-up")).outcome, "free");
  // The spin handle: later, and down again.
  await page.evaluate(() => window.taut.player.seek(6));
  await page.keyboard.press("0");
  await settled(page);
  const spin = await place(page, "tool.handles.spin(tool.velocity())");
  await drag(page, spin, [spin[0] - 40, spin[1] + 40]);
  const tip2 = await place(page, "tool.handles.arrowTip(tool.velocity())");
  const origin = await place(page, "taut.stage.camera.pixel(...tool.handles.anchor(1))");
  await drag(page, tip2, [origin[0] - 30, origin[1] + 120]);
  const answer = await compare(page, "plan-down");
  assert.equal((await sceneOf(page)).bodies[1].motion.length, 3);
  assert.equal(
    await page.evaluate(() => window.taut.player.replay.count),
    answer.events,
    "as many events as in one run",
  );
  await screenshot(page, "playground-drive");
  assert.deepEqual(page.problems, []);
  await page.close();
});

test("a link holds the scene and the way of touching", async () => {
  const page = await open();
  await choose(page, "gears_thick_tooth");
  await page.selectOption("#touch", "closed");
  await finished(page);
  await page.click("#share");
  await page.waitForFunction(() => location.hash.startsWith("#s="));
  const link = page.url();
  await page.waitForFunction(() => /link/.test(document.querySelector("#note").textContent));
  const other = await openPage(site.browser, link);
  const closed = check("examples/gears_thick_tooth.json", "--touch", "closed");
  assert.deepEqual(await other.evaluate(() => window.taut.player.status.answer), closed);
  assert.deepEqual(await sceneOf(other), await sceneOf(page));
  assert.deepEqual(other.problems, []);
  await other.close();
  await page.close();
});

test("a damaged link is said to be one", async () => {
  const page = await open();
  await choose(page, "combs");
  await page.click("#share");
  await page.waitForFunction(() => location.hash.startsWith("#s="));
  const fragment = new URL(page.url()).hash;
  const before = await sceneOf(page);
  await page.close();
  for (const hash of ["#s=", "#s=AAAA", "#s=garbage", "#s=%%%", fragment.slice(0, -9)]) {
    const damaged = await openPage(site.browser, site.server.address + hash);
    await damaged.waitForSelector("#message:not([hidden])");
    const message = await damaged.innerText("#message");
    assert.match(message, /link holds no scene.* an example.*cut off.*ask for it again/s, hash);
    assert.deepEqual(damaged.problems, [], hash);
    // Pasted into a page that is open, it leaves the scene alone.
    await damaged.evaluate((whole) => (location.hash = whole), fragment);
    await damaged.waitForFunction(() => document.querySelector("#message").hidden);
    assert.deepEqual(await sceneOf(damaged), before);
    await damaged.evaluate((broken) => (location.hash = broken), hash + "A");
    await damaged.waitForSelector("#message:not([hidden])");
    assert.match(await damaged.innerText("#message"), /the one from before/);
    assert.deepEqual(await sceneOf(damaged), before);
    if (hash === "#s=garbage") await screenshot(damaged, "playground-damaged-link");
    await damaged.close();
  }
});

/** Types into a number field and leaves it. */
async function typeInto(page, field, text) {
  await field.click();
  await page.keyboard.press("Control+a");
  await page.keyboard.press("Delete");
  await page.keyboard.type(text);
  await page.keyboard.press("Enter");
  await settled(page);
}

test("a number that cannot be read changes nothing, and its field is marked", async () => {
  const page = await open();
  await choose(page, "lid");
  await page.check("#ask-check_clearance");
  await page.waitForFunction(() => window.taut.questions.answers.check_clearance);
  const state = async () =>
    page.evaluate(() =>
      JSON.stringify([
        window.playground.state.scene,
        window.taut.player.status.answer,
        window.taut.questions.answers,
        document.querySelector("#headline").textContent,
      ]),
    );
  const before = await state();
  const fields = ["#time-start", "#time-end", "#margin"].map((id) => page.locator(id));
  for (const name of ["x", "y", "angle"]) fields.push(page.getByLabel(`${name} of keyframe 2`));
  for (const field of fields) {
    const value = await field.inputValue();
    assert.notEqual(value, "");
    for (const [text, why] of [
      ["", /nothing was typed/],
      ["1e999", /not a number/],
      ["-", /not a number/],
    ]) {
      await typeInto(page, field, text);
      assert.equal(await field.inputValue(), value);
      assert.equal(await field.getAttribute("aria-invalid"), "true");
      const fault = page.locator(`#${await field.getAttribute("aria-describedby")}`);
      assert.ok(await fault.isVisible());
      assert.match(await fault.innerText(), why);
      assert.ok((await fault.innerText()).includes(`stays ${value}`), await fault.innerText());
      assert.equal(await state(), before, `${value} "${text}"`);
    }
    if (field === fields[1]) await screenshot(page, "playground-unreadable-number");
  }
  await typeInto(page, page.locator("#margin"), "0");
  assert.match(await page.innerText(".questions .number-fault"), /must be greater than 0/);
  assert.equal(await state(), before);
  // A number takes the mark away, and counts.
  await typeInto(page, page.locator("#time-end"), "100");
  assert.equal(await page.getAttribute("#time-end", "aria-invalid"), null);
  assert.equal((await compare(page, "readable-number")).outcome, "free");
  assert.deepEqual((await sceneOf(page)).time, [0, 100]);
  // Keyframes between the ends of the time stay between them.
  await page.evaluate(() => window.taut.player.seek(50));
  await page.click("#add-keyframe");
  await finished(page);
  const middle = page.getByLabel("t of keyframe 2");
  await typeInto(page, middle, "300");
  assert.equal(await middle.inputValue(), "50");
  assert.match(await page.innerText("#keyframes .number-fault:not([hidden])"), /must lie between 0 and 100/);
  assert.deepEqual(page.problems, []);
  await page.close();
});

test("a file that is refused leaves the scene, the picture and the answer as they were", async () => {
  const page = await open();
  await choose(page, "lid");
  const bow = "[[0,0],[4,4],[4,0],[0,4]]";
  const square = "[[9,9],[10,9],[10,10]]";
  const scene = (polygon) =>
    `{"format":"taut-scene/1","time":[0,1],"bodies":[{"name":"a","polygon":${square}},{"name":"bow","polygon":${polygon}}]}`;
  const refused = [
    ["selfint.json", scene(bow), /bow: .* edges \d-\d and \d-\d cross/s],
    ["cut.json", scene(bow).slice(0, -5), /cut\.json:1:\d+/],
    ["bow.wkt", "POLYGON ((0 0, 4 4, 4 0, 0 4))", /edges \d-\d and \d-\d cross/],
    ["words.txt", "hello", /POLYGON/],
    ["empty.dxf", "hello", /./],
  ];
  const state = () =>
    page.evaluate(() => [
      window.playground.state.scene,
      window.taut.player.status.answer,
      document.querySelector("#headline").textContent,
      document.querySelector("canvas.picture").toDataURL(),
    ]);
  await page.click("#mode-look");
  await settled(page);
  const before = await state();
  for (const [name, text, why] of refused) {
    await page.setInputFiles("#file", { name, mimeType: "text/plain", buffer: Buffer.from(text) });
    await page.waitForFunction((n) => document.querySelector("#message").innerText.includes(n), name);
    await settled(page);
    const message = await page.innerText("#message");
    assert.ok(message.startsWith(`${name} was not opened`), message);
    assert.match(message, why);
    const after = await state();
    before.forEach((each, k) => assert.deepEqual(after[k], each, `${name}: ${k}`));
    assert.equal(await pixelsOf(page, "#c4161c"), 0, name);
    if (name === "selfint.json") await screenshot(page, "playground-refused-file");
  }
  // The text of a scene, too.
  await page.evaluate(() => (document.querySelector(".part-text").open = true));
  await page.fill("#scene-text", scene(bow));
  await page.click("#apply");
  await settled(page);
  assert.match(await page.innerText("#message"), /text of the scene was not applied/);
  assert.equal(await pixelsOf(page, "#c4161c"), 0);
  assert.deepEqual((await state()).slice(0, 3), before.slice(0, 3));
  // What is opened next takes the message away.
  await page.setInputFiles("#file", join(root, "examples/combs.json"));
  await page.waitForFunction(() => document.querySelector("#message").hidden);
  assert.deepEqual(page.problems, []);
  await page.close();
});

test("scenes, WKT and GeoJSON are opened and dropped; scenes and pictures are saved", async () => {
  const page = await open();
  await page.setInputFiles("#file", join(root, "examples/combs.json"));
  await page.waitForFunction(() => window.playground.state.scene.bodies[1].name === "upper");
  await finished(page);
  assert.equal((await compare(page, "imported")).outcome, check("examples/combs.json").outcome);
  await page.setInputFiles("#file", [
    join(root, "examples/continents/south_america_ne50m.wkt"),
    join(root, "examples/continents/africa_ne50m.wkt"),
  ]);
  await page.waitForFunction(() => window.playground.state.scene.bodies[1].name === "africa_ne50m");
  await finished(page);
  const scene = await sceneOf(page);
  assert.deepEqual(
    scene.bodies.map((b) => b.name),
    ["south_america_ne50m", "africa_ne50m"],
  );
  assert.ok(scene.bodies[0].polygon.length > 1000);
  // Their coordinates overlap: the second one was put beside the first.
  assert.equal((await compare(page, "continents")).outcome, "free");
  assert.match(await page.textContent("#note"), /was put beside/);
  await screenshot(page, "playground-continents");
  // Dropped on the page.
  const data = await page.evaluateHandle(() => {
    const transfer = new DataTransfer();
    const ring = [
      [0, 0],
      [3, 0],
      [3, 1],
      [0, 1],
      [0, 0],
    ];
    transfer.items.add(new File([JSON.stringify({ type: "Polygon", coordinates: [ring] })], "box.geojson"));
    return transfer;
  });
  await page.selectOption("#body", "1");
  await page.dispatchEvent(".app", "drop", { dataTransfer: data });
  await page.waitForFunction(() => window.playground.state.scene.bodies[1].name === "box");
  assert.equal((await sceneOf(page)).bodies[1].polygon.length, 4);
  // With holes, they are parts of the body.
  const plate = join(artefacts, "plate.wkt");
  writeFileSync(plate, "MULTIPOLYGON (((0 0, 4 0, 4 4, 0 4), (1 1, 2 1, 2 2, 1 2)), ((5 0, 6 0, 6 1)))");
  await page.setInputFiles("#file", plate);
  await page.waitForFunction(() => window.playground.state.scene.bodies[1].name === "plate");
  const { parts, polygon } = (await sceneOf(page)).bodies[1];
  assert.equal(polygon, undefined);
  assert.deepEqual(
    parts.map((part) => [part.outline.length, part.holes?.length ?? 0]),
    [
      [4, 1],
      [3, 0],
    ],
  );
  // What is not a scene is refused with its place.
  const bad = join(artefacts, "bad.json");
  writeFileSync(bad, '{"format":"taut-scene/1","tiem":[0,1]}');
  await page.setInputFiles("#file", bad);
  await page.waitForFunction(() => !document.querySelector("#message").hidden);
  assert.match(await page.textContent("#message"), /bad\.json:1:\d+: unknown key "tiem"/);
  await choose(page, "lid");
  const saved = await save(page, "#export", "saved.json");
  assert.deepEqual(check(saved), check("examples/lid.json"));
  await page.evaluate(() => window.taut.player.seek(50));
  await page.keyboard.press("p");
  const picture = await save(page, "#svg", "saved.svg");
  assert.equal(readFileSync(picture, "utf8"), run("draw", "examples/lid.json", "--at", "50"));
  assert.deepEqual(page.problems, []);
  await page.close();
});

test("two bodies have the colours of many: in the picture, light and dark, and in the list", async () => {
  for (const colorScheme of ["light", "dark"]) {
    const page = await open({ colorScheme });
    const list = () => page.$$eval("#bodies .number", (all) => all.map((e) => getComputedStyle(e).backgroundColor));
    const two = await list();
    assert.deepEqual(two, ["rgb(42, 111, 158)", "rgb(229, 147, 69)"]);
    assert.ok((await pixelsOf(page, "#2a6f9e")) > 500 && (await pixelsOf(page, "#e59345")) > 500);
    await choose(page, "worlds/room");
    await settled(page);
    assert.deepEqual((await list()).slice(0, 2), two);
    await page.close();
  }
});

test("it works from a file, too, and on a phone", async () => {
  const page = await openPage(site.browser, pathToFileURL(join(pages, "index.html")).href, {
    viewport: { width: 390, height: 844 },
    isMobile: true,
    hasTouch: true,
    deviceScaleFactor: 2,
    colorScheme: "dark",
  });
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth <= window.innerWidth), true);
  await page.tap("#mode-keyframes");
  await page.evaluate(() => window.scrollTo(0, 0));
  await screenshot(page, "playground-phone");
  const nameless = await page.$$eval("button, input, select, textarea, [tabindex]", (all) =>
    all
      .filter((e) => !(e.getAttribute("aria-label") || e.textContent.trim() || e.labels?.length))
      .map((e) => e.outerHTML),
  );
  assert.deepEqual(nameless, []);
  assert.deepEqual(page.problems, []);
  await page.close();
});

test("the slider of a scene that was changed ends at its contact", async () => {
  const page = await open();
  await choose(page, "lid");
  await page.keyboard.press("End");
  await settled(page);
  assert.equal(await shownTime(page), check("examples/lid.json").t[0]);
  await screenshot(page, "playground");
  await page.close();
});

const drawing = (gap) => `<svg xmlns="http://www.w3.org/2000/svg" width="40mm" viewBox="0 0 40 40">
<g id="plate" fill="none" stroke="black"><path d="M0 0H40V40H0V${gap}"/><circle cx="20" cy="20" r="5"/></g>
<g id="pin" fill="none" stroke="black"><circle cx="60" cy="5" r="3"/><path d="M50 30h5"/></g></svg>`;
const asFile = (name, text) => ({ name, mimeType: "text/plain", buffer: Buffer.from(text) });
const report = (page) => page.evaluate(() => document.getElementById("importreport").innerText);

test("a drawing becomes a scene, with a report", async () => {
  const page = await open();
  await page.setInputFiles("#file", asFile("plate.svg", drawing("0.01")));
  await page.waitForFunction(() => window.playground.state.scene.bodies[0].name === "plate");
  assert.deepEqual(
    (await sceneOf(page)).bodies.map((b) => b.name),
    ["plate", "pin"],
  );
  const text = await report(page);
  assert.match(text, /plate: area 1521.47, 40 x 40, parts: 1, holes: 1/);
  assert.match(text, /Gaps that were closed\s+0.01 at \(0, 0\)/);
  assert.match(text, /Open lines\s+from \(50, -30\) to \(55, -30\)/);
  const view = () => page.evaluate(() => document.querySelector(".importpicture svg").getAttribute("viewBox"));
  const whole = await view();
  await page.click("#importreport li button");
  assert.notEqual(await view(), whole);
  await page.click(".importpicture");
  assert.equal(await view(), whole);
  await screenshot(page, "drawing");
  await page.close();
});

test("an outline that stays open is asked about", async () => {
  const page = await open();
  const before = (await sceneOf(page)).bodies.map((b) => b.name);
  await page.setInputFiles("#file", asFile("open.svg", drawing("0.5")));
  await page.waitForSelector("#import-close");
  assert.match(await report(page), /an outline stays open, with a gap of 0.5/);
  assert.deepEqual(
    (await sceneOf(page)).bodies.map((b) => b.name),
    before,
  );
  await screenshot(page, "open-drawing");
  await page.click("#import-close");
  await page.waitForFunction(() => window.playground.state.scene.bodies[0].name === "plate");
  assert.match(await report(page), /plate: area 1521.67, 40 x 40, parts: 1, holes: 1/);
  await page.close();
});

test("contours that cross are asked about, and answers are kept", async () => {
  const page = await open();
  const slotted = drawing("0.5").replace(
    '<circle cx="20"',
    '<rect x="35" y="10" width="10" height="4"/><circle cx="20"',
  );
  await page.setInputFiles("#file", asFile("slotted.svg", slotted));
  await page.waitForSelector("#import-close");
  await page.click("#import-close");
  await page.waitForSelector("#import-subtract");
  assert.match(await report(page), /crosses that at/);
  await screenshot(page, "crossing-drawing");
  await page.click("#import-subtract");
  await page.waitForFunction(() => window.playground.state.scene.bodies[0].name === "plate");
  assert.match(await report(page), /plate: area 1501.67, 40 x 40, parts: 1, holes: 1/);
  await page.close();
});
