// Worlds on both pages: all bodies, their tree, the pair that meets; and changes to which bodies there are.
import assert from "node:assert/strict";
import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import {
  artefacts,
  check,
  duringTests,
  openPage,
  pixelsOf,
  run,
  screenshot,
  settled,
  shownTime,
  viewPage,
} from "./support.mjs";

const site = duringTests();

/** Of the first bodies of a world. */
const fills = ["#2a6f9e", "#e59345", "#0f7d74", "#f0d762", "#683b6a", "#7abee4"];

const view = (scene, name, options) => openPage(site.browser, viewPage(scene, name), options);

async function toTheEnd(page) {
  await page.keyboard.press("End");
  await settled(page);
}

test("every body is drawn, and the pair that meets is named and marked", async () => {
  for (const [name, count] of [
    ["room", 3],
    ["arm", 4],
    ["drawer", 5],
  ]) {
    const scene = `examples/worlds/${name}.json`;
    const answer = check(scene);
    const page = await view(scene, `world-${name}`);
    // On a busy machine the first picture takes a while.
    for (let n = 0; n < 100 && (await pixelsOf(page, fills[0])) === 0; ++n) await settled(page);
    for (const fill of fills.slice(0, count)) assert.ok((await pixelsOf(page, fill)) > 100, `${name}: ${fill}`);
    assert.equal(await pixelsOf(page, "#c4161c"), 0, "nothing is marked before");
    await toTheEnd(page);
    assert.equal(await shownTime(page), answer.t[0], name);
    assert.ok((await pixelsOf(page, "#c4161c")) > 60, `${name}: the contact is marked`);
    const text = await page.textContent("#answer");
    assert.ok(text.includes(`${answer.pair.join(" and ")} meet.`), text);
    const { vertex, edge } = answer.contact;
    const part = (f) => (f.part === undefined ? "" : `part ${f.part} of `);
    const words = `ertex ${vertex.index} of ${part(vertex)}${vertex.body} meets edge ${edge.index}-`;
    assert.ok(text.includes(words), `${words}: ${text}`);
    assert.ok(text.includes(`${answer.coverage.pairs} pairs: ${answer.coverage.tested} tested`), text);
    await page.click("#proof");
    await settled(page);
    assert.match(await page.textContent("#answer"), /tilings of the pairs that are near/);
    await screenshot(page, `world-${name}`);
    assert.deepEqual(page.problems, []);
    await page.close();
  }
});

test("the tilings of the pairs that are near are drawn, and can be left out", async () => {
  const page = await view("examples/worlds/planetary.json", "world-tilings");
  assert.equal(await pixelsOf(page, "#b8106f"), 0, "bodies alone");
  await page.keyboard.press("p");
  await settled(page);
  const drawn = await pixelsOf(page, "#b8106f");
  assert.ok(drawn > 100, `${drawn} pixels join bodies`);
  await screenshot(page, "world-tilings");
  await page.keyboard.press("e");
  await settled(page);
  assert.equal(await pixelsOf(page, "#b8106f"), 0);
  assert.ok(await page.isHidden("#layer-faces"));
  assert.deepEqual(page.problems, []);
  await page.close();
});

test("bodies stand below their parents, can be hidden, and ignored pairs are listed", async () => {
  const page = await view("examples/worlds/planetary.json", "world-planetary");
  const tree = await page.$$eval("#bodies > li", (items) =>
    items.map((li) => [
      li.querySelector("label span").textContent,
      [...li.querySelectorAll(":scope > ul span")].map((s) => s.textContent),
    ]),
  );
  assert.deepEqual(tree, [
    ["ring", []],
    ["carrier", ["planet 1", "planet 2", "planet 3"]],
    ["sun", []],
  ]);
  assert.match(await page.textContent("#ignored"), /Ignored \(1\):.*carrier x every other body/);
  assert.ok((await pixelsOf(page, fills[3])) > 1000);
  await page.getByLabel("Show planet 1", { exact: true }).uncheck();
  await settled(page);
  assert.equal(await pixelsOf(page, fills[3]), 0);
  assert.ok((await pixelsOf(page, fills[4])) > 1000, "the other planets are there");
  await page.getByLabel("Show planet 1", { exact: true }).check();
  await settled(page);
  assert.ok((await pixelsOf(page, fills[3])) > 1000);
  for (const part of [".part-event", ".part-events", ".part-counts"]) assert.ok(!(await page.isVisible(part)), part);
  await page.close();
});

test("higher layers lie over lower ones, and each can be hidden", async () => {
  const page = await view("examples/worlds/layers.json", "layers");
  const rows = await page.$$eval("#layers li span:first-of-type", (spans) => spans.map((s) => s.textContent));
  assert.deepEqual(rows, ["z 4..5", "z 2..4", "z 0..2", "z -1..5", "z -1..0"]);
  const tree = await page.$$eval("#bodies .heights", (spans) => spans.map((s) => s.textContent));
  assert.deepEqual(tree, ["z 0..2", "z 2..4", "z -1..0, z -1..5, z 4..5"]);
  assert.match(await page.textContent("#answer"), /2 tested.*not tested: 1 on different layers/);
  const [lower, upper, pin] = fills;
  const below = await pixelsOf(page, lower);
  const cap = await pixelsOf(page, pin);
  await screenshot(page, "layers");
  await page.getByLabel("Show z 2..4", { exact: true }).uncheck();
  await settled(page);
  assert.equal(await pixelsOf(page, upper), 0);
  assert.ok((await pixelsOf(page, lower)) > 1.1 * below, "what the upper blade covered is seen");
  // The head of the pin is its part on the highest layer; what is left of it is in the bore.
  await page.getByLabel("Show z 4..5", { exact: true }).uncheck();
  await settled(page);
  assert.ok((await pixelsOf(page, pin)) < 0.5 * cap, "the head of the pin is gone");
  assert.ok((await pixelsOf(page, pin)) > 20, "its shaft is not");
  await page.getByLabel("Show z 2..4", { exact: true }).check();
  await settled(page);
  assert.ok((await pixelsOf(page, upper)) > 1000);
  assert.deepEqual(page.problems, []);
  await page.close();
  const flat = await view("examples/worlds/room.json", "layers-none");
  assert.equal(await flat.textContent("#layers"), "", "no list where all bodies reach through everything");
  await flat.close();
});

test("a child is where its chain of parents puts it, also while time runs", async () => {
  const page = await view("examples/worlds/arm.json", "world-arm-poses");
  const tip = (t) =>
    page.evaluate((at) => {
      const { x, y, c, s } = window.taut.player.engine.poses(at)[3];
      return [x + 5.5 * c, y + 5.5 * s];
    }, t);
  // The wrist, at (5.5, 0): 3 along the upper arm and 2.5 along the forearm, which turn by 100 t and 60 t more degrees.
  for (const t of [0, 0.1, 0.2]) {
    const [a, b] = [100 * t, 160 * t].map((degrees) => (degrees * Math.PI) / 180);
    const [x, y] = await tip(t);
    assert.ok(Math.hypot(x - 3 * Math.cos(a) - 2.5 * Math.cos(b), y - 3 * Math.sin(a) - 2.5 * Math.sin(b)) < 1e-12);
  }
  await page.click("#play");
  await page.waitForFunction(() => !window.taut.player.playing, null, { timeout: 20000 });
  assert.equal(await shownTime(page), check("examples/worlds/arm.json").t[0]);
  await page.close();
});

test("bodies that overlap at the start are named and marked, in the dark as well", async () => {
  const file = join(artefacts, "world-overlap.json");
  const square = (x) => [
    [x, 0],
    [x + 2, 0],
    [x + 2, 2],
    [x, 2],
  ];
  const bodies = [
    { name: "a <b>", polygon: square(0) },
    { name: "c", polygon: square(1), motion: { velocity: [1, 0] } },
    { name: "d", polygon: square(9) },
  ];
  writeFileSync(file, JSON.stringify({ format: "taut-scene/1", time: [0, 1], bodies, ignore: [["a <b>", "d"]] }));
  const page = await view(file, "world-overlap", { colorScheme: "dark" });
  assert.match(await page.textContent("#headline"), /Overlap at the start/);
  assert.match(await page.textContent("#answer"), /a <b> and c overlap already when the motion starts/);
  assert.ok((await pixelsOf(page, "#ff6b66")) > 100);
  await screenshot(page, "world-overlap-dark");
  assert.deepEqual(page.problems, []);
  await page.close();
});

const finished = (page) => page.waitForFunction(() => window.taut.player.finished && !window.playground.pending);
const sceneOf = (page) => page.evaluate(() => window.playground.state.scene);

/** What the page says must be what the command says of the scene that the page has. */
async function compare(page, name) {
  await finished(page);
  await settled(page);
  const file = join(artefacts, `${name}.json`);
  writeFileSync(file, JSON.stringify(await sceneOf(page)));
  const answer = check(file);
  const shown = await page.evaluate(() => window.taut.player.status.answer);
  for (const key of ["outcome", "t", "contact", "pair", "coverage"]) assert.deepEqual(shown[key], answer[key], key);
  return answer;
}

async function playground(example) {
  const page = await openPage(site.browser, site.server.address);
  await page.selectOption("#example", example);
  await finished(page);
  await settled(page);
  return page;
}

test("the playground opens worlds and answers them", async () => {
  const page = await playground("worlds/room");
  assert.deepEqual((await compare(page, "played-room")).pair, ["pillars", "robot"]);
  for (const example of ["worlds/geneva", "worlds/conveyor", "worlds/puzzle", "worlds/planetary", "lid"]) {
    await page.selectOption("#example", example);
    await compare(page, `played-${example.replace("/", "-")}`);
  }
  assert.deepEqual(page.problems, []);
  await page.close();
});

test("a body is added, gets a parent and a hole, is ignored, and removed again; all can be undone", async () => {
  const page = await playground("worlds/arm");
  await page.click("#add-body");
  await compare(page, "played-added");
  let scene = await sceneOf(page);
  assert.equal(scene.bodies.length, 5);
  assert.equal(scene.bodies[4].name, "body 5");
  assert.equal(await page.$eval("#body", (e) => e.value), "4", "it is the one that is chosen");

  const poses = () => page.evaluate(() => window.taut.player.engine.poses(0));
  const before = await poses();
  await page.selectOption("#parent", "hand");
  await compare(page, "played-parent");
  assert.equal((await sceneOf(page)).bodies[4].relative_to, "hand");
  const after = await poses();
  for (const key of ["x", "y", "c", "s"])
    assert.ok(Math.abs(before[4][key] - after[4][key]) < 1e-9, `${key} stays at the start`);
  // The parents of the hand cannot be its children.
  await page.selectOption("#body", "1");
  assert.deepEqual(await page.$$eval("#parent option", (all) => all.map((o) => o.value)), ["", "shelf"]);

  await page.selectOption("#body", "4");
  await page.click("#cut-hole");
  await compare(page, "played-hole");
  scene = await sceneOf(page);
  assert.equal(scene.bodies[4].parts[0].holes[0].length, 8);

  await page.selectOption("#ignore-other", "*");
  await page.click("#ignore");
  const ignoring = await compare(page, "played-ignore");
  assert.equal(ignoring.coverage.ignored, 6);
  assert.match(await page.textContent("#ignored"), /body 5 x every other body/);
  await screenshot(page, "playground-world");
  await page.getByLabel("Ask about body 5 x every other body again").click();
  assert.equal((await compare(page, "played-asked")).coverage.ignored, 2);

  await page.click("#remove-body");
  await compare(page, "played-removed");
  assert.deepEqual(
    (await sceneOf(page)).bodies.map((b) => b.name),
    ["shelf", "upper arm", "forearm", "hand"],
  );
  for (let k = 0; k < 6; ++k) {
    await page.click("#undo");
    await finished(page);
  }
  assert.equal((await sceneOf(page)).bodies.length, 4);
  assert.deepEqual(page.problems, []);
  await page.close();
});

test("a body gets another name wherever it is named, and a new scene shows all bodies", async () => {
  const page = await playground("worlds/arm");
  await page.selectOption("#body", "1");
  await page.fill("#name", "hand");
  await page.press("#name", "Enter");
  await compare(page, "played-name-taken");
  assert.equal((await sceneOf(page)).bodies[1].name, "hand 2", "two bodies never have one name");
  await page.fill("#name", "boom <1>");
  await page.press("#name", "Enter");
  await compare(page, "played-name");
  const scene = await sceneOf(page);
  assert.equal(scene.bodies[2].relative_to, "boom <1>");
  assert.deepEqual(scene.ignore[0], ["boom <1>", "forearm"]);
  assert.match(await page.textContent("#bodies"), /boom <1>/);
  await page.fill("#name", "*");
  await page.press("#name", "Enter");
  await settled(page);
  assert.match(await page.textContent("#message"), /a body is called "\*"/);
  await page.click("#undo");
  await finished(page);

  await page.getByLabel("Show shelf", { exact: true }).uncheck();
  await settled(page);
  assert.equal(await pixelsOf(page, fills[0]), 0);
  await page.selectOption("#example", "worlds/room");
  await finished(page);
  await settled(page);
  assert.ok((await pixelsOf(page, fills[0])) > 1000);
  assert.ok(await page.getByLabel("Show room", { exact: true }).isChecked());
  assert.deepEqual(page.problems, []);
  await page.close();
});

test("layers are set in the panel, and stay while bodies are edited", async () => {
  const page = await playground("worlds/arm");
  const type = async (field, text) => {
    await page.fill(field, text);
    await page.press(field, "Enter");
    await settled(page);
  };
  await page.selectOption("#body", "0");
  assert.equal(await page.inputValue("#height-low"), "", "all layers");
  await type("#height-low", "3");
  assert.deepEqual((await sceneOf(page)).bodies[0].z, [3, null]);
  await type("#height-high", "2");
  assert.match(await page.textContent(".world-panel"), /Upper height: the lower height must be below the upper one/);
  assert.deepEqual((await sceneOf(page)).bodies[0].z, [3, null]);
  await type("#height-high", "6");
  await page.selectOption("#body", "3");
  await type("#height-high", "3");
  // The shelf is above the hand now, and was what it met.
  const answer = await compare(page, "played-layers");
  assert.equal(answer.coverage.layers, 1);
  assert.match(await page.textContent("#answer"), /1 on different layers/);
  assert.deepEqual((await sceneOf(page)).bodies[3].z, [null, 3]);
  await screenshot(page, "playground-layers");

  await page.click("#cut-hole");
  await page.selectOption("#parent", "upper arm");
  await page.fill("#name", "claw");
  await page.press("#name", "Enter");
  await compare(page, "played-layers-kept");
  assert.deepEqual((await sceneOf(page)).bodies[3].z, [null, 3]);
  await type("#height-high", "");
  assert.equal((await sceneOf(page)).bodies[3].z, undefined);
  assert.deepEqual(page.problems, []);
  await page.close();
});

test("removing a parent leaves its children, and two plain bodies have a tiling again", async () => {
  const page = await playground("worlds/drawer");
  await page.selectOption("#body", "1");
  await page.click("#remove-body");
  await compare(page, "played-orphans");
  const { bodies } = await sceneOf(page);
  assert.ok(bodies.every((body) => body.relative_to === undefined));
  await page.close();

  const hello = await playground("hello");
  assert.ok(!(await hello.$eval(".app", (e) => e.classList.contains("world"))));
  await hello.click("#add-body");
  await finished(hello);
  await settled(hello);
  assert.ok(await hello.$eval(".app", (e) => e.classList.contains("world")));
  await hello.click("#proof");
  await settled(hello);
  assert.match(await hello.textContent("#answer"), /tilings of the pairs that are near/);
  await hello.click("#remove-body");
  await finished(hello);
  await settled(hello);
  assert.ok(!(await hello.$eval(".app", (e) => e.classList.contains("world"))));
  assert.ok(await hello.evaluate(() => window.taut.player.replay.count > 0));
  assert.deepEqual(hello.problems, []);
  await hello.close();
});

test("a body that moves with another one is dragged where the pointer goes", async () => {
  const page = await playground("worlds/arm");
  await page.evaluate(() => window.taut.player.seek(0.1));
  await page.click("#mode-shape");
  await settled(page);
  const at = (body) =>
    page.evaluate((b) => {
      const box = document.querySelector("canvas.picture").getBoundingClientRect();
      const { handles } = window.taut.stage.tool;
      const [x, y] = handles.camera.pixel(...handles.anchor(b));
      return [box.left + x, box.top + y];
    }, body);
  const from = await at(2);
  const hand = await at(3);
  await page.mouse.move(...from);
  await page.mouse.down();
  await page.mouse.move(from[0] - 30, from[1] + 40, { steps: 4 });
  await page.mouse.up();
  await compare(page, "played-dragged");
  const [to, handAfter] = [await at(2), await at(3)];
  // To a hundredth of a pixel or so, by which the numbers in the file are rounded.
  assert.ok(Math.hypot(to[0] - from[0] + 30, to[1] - from[1] - 40) < 1, `${from} to ${to}`);
  assert.ok(Math.hypot(handAfter[0] - hand[0] + 30, handAfter[1] - hand[1] - 40) < 1, "the hand goes along");
  assert.deepEqual(page.problems, []);
  await page.close();
});

test("ghosts and the arrow of a body that moves with another one are dragged where the pointer goes", async () => {
  const page = await playground("worlds/arm");
  // Without the shelf the arm goes all the way, and the picture shows it.
  await page.selectOption("#body", "0");
  await page.click("#remove-body");
  await finished(page);
  await page.click('[aria-label="Show everything"]');
  await page.selectOption("#body", "2");
  await page.click("#mode-keyframes");
  await settled(page);
  const ghost = (index) =>
    page.evaluate((k) => {
      const box = document.querySelector("canvas.picture").getBoundingClientRect();
      const { handles } = window.taut.stage.tool;
      const frame = window.playground.state.keyframes[k];
      const pose = handles.ghostPose(frame);
      const at = ([u, v]) => {
        const [x, y] = handles.camera.pixel(pose.x + pose.c * u - pose.s * v, pose.y + pose.s * u + pose.c * v);
        return [box.left + x, box.top + y];
      };
      return { middle: at([6.25, -0.2]), wrist: at([5.5, 0]) };
    }, index);
  // At the end the wrist is 3 along the upper arm, at 100 degrees, and 2.5 along the forearm, at 160.
  const { middle, wrist } = await ghost(1);
  const pixel = await page.evaluate(() => {
    const box = document.querySelector("canvas.picture").getBoundingClientRect();
    const along = (length, degrees) => [Math.cos, Math.sin].map((f) => length * f((degrees * Math.PI) / 180));
    const [a, b] = [along(3, 100), along(2.5, 160)];
    const [x, y] = window.taut.stage.camera.pixel(a[0] + b[0], a[1] + b[1]);
    return [box.left + x, box.top + y];
  });
  assert.ok(Math.hypot(wrist[0] - pixel[0], wrist[1] - pixel[1]) < 1e-6);
  await page.mouse.move(...middle);
  await page.mouse.down();
  await page.mouse.move(middle[0] + 25, middle[1] - 15, { steps: 4 });
  await page.mouse.up();
  await compare(page, "played-ghost");
  const after = (await ghost(1)).middle;
  assert.ok(Math.hypot(after[0] - middle[0] - 25, after[1] - middle[1] + 15) < 1, `${middle} to ${after}`);

  await page.evaluate(() => window.taut.player.seek(0.1));
  await page.click("#mode-drive");
  await settled(page);
  const tip = () =>
    page.evaluate(() => {
      const box = document.querySelector("canvas.picture").getBoundingClientRect();
      const tool = window.taut.stage.tool;
      const [x, y] = tool.handles.arrowTip(tool.velocity());
      return [box.left + x, box.top + y];
    });
  const from = await tip();
  await page.mouse.move(...from);
  await page.mouse.down();
  await page.mouse.move(from[0] + 20, from[1] + 30, { steps: 4 });
  await page.mouse.up();
  await compare(page, "played-arrow");
  const to = await tip();
  assert.ok(Math.hypot(to[0] - from[0] - 20, to[1] - from[1] - 30) < 1.5, `${from} to ${to}`);
  assert.deepEqual(page.problems, []);
  await page.close();
});

test("the vertices of a hole are dragged, added and removed, and with the third from the end goes the hole", async () => {
  const page = await playground("hello");
  await page.selectOption("#body", "0");
  await page.click("#cut-hole");
  await compare(page, "played-hello-hole");
  await page.click("#mode-shape");
  await settled(page);
  const outline = await page.evaluate(() => window.playground.state.scene.bodies[0].parts[0].outline.length);
  const at = (vertex) =>
    page.evaluate((i) => {
      const box = document.querySelector("canvas.picture").getBoundingClientRect();
      const [x, y] = window.taut.stage.tool.handles.pixel(0, i);
      return [box.left + x, box.top + y];
    }, vertex);
  const hole = async () => (await sceneOf(page)).bodies[0].parts?.[0].holes[0];
  const before = await hole();
  const from = await at(outline);
  await page.mouse.move(...from);
  await page.mouse.down();
  await page.mouse.move(from[0] + 3, from[1] + 2, { steps: 3 });
  await page.mouse.up();
  await compare(page, "played-hole-dragged");
  const after = await hole();
  assert.notDeepEqual(after[0], before[0]);
  assert.deepEqual(after.slice(1), before.slice(1));

  // Out of the outline: the edges of both rings are marked.
  const inside = await at(outline);
  await page.mouse.move(...inside);
  await page.mouse.down();
  await page.mouse.move(inside[0] + 900, inside[1] - 500, { steps: 3 });
  await page.mouse.up();
  await settled(page);
  assert.match(await page.textContent("#message"), /meets edge \d+-\d+ of hole 1/);
  assert.ok((await pixelsOf(page, "#c4161c")) > 60, "the edges at fault are marked");
  await page.click("#undo");
  await finished(page);

  for (let left = 8; left > 2; --left) {
    await page.mouse.click(...(await at(outline)));
    await page.keyboard.press("Delete");
    await compare(page, "played-hole-smaller");
  }
  assert.equal(await hole(), undefined);
  assert.equal((await sceneOf(page)).bodies[0].polygon.length, outline);
  assert.ok(!(await page.$eval(".app", (e) => e.classList.contains("world"))), "there is a tiling again");
  assert.deepEqual(page.problems, []);
  await page.close();
});

test("the picture that the playground saves is that of the command", async () => {
  const page = await playground("worlds/drawer");
  const svg = await page.evaluate(() => window.taut.player.engine.svg(1e9, true));
  const file = join(artefacts, "saved-drawer.json");
  writeFileSync(file, JSON.stringify(await sceneOf(page)));
  assert.equal(svg, run("draw", file));
  await page.close();
});

test("no body shows the number of one below it", async () => {
  const page = await openPage(site.browser, viewPage("examples/worlds/layers.json", "numbers"));
  // Each blade has its number while it is seen; closed, the upper one covers that of the lower one.
  const numbers = (t) =>
    page.evaluate((at) => {
      const context = document.querySelector(".picture").getContext("2d");
      const drawn = [];
      const fillText = context.fillText.bind(context);
      context.fillText = (text, x, y) => {
        // Not the scale, which has a number, too.
        if (!text.match(/\D/) && x > 30) drawn.push(text);
        fillText(text, x, y);
      };
      window.taut.player.seek(at);
      window.taut.stage.draw();
      context.fillText = fillText;
      return drawn.sort();
    }, t);
  assert.deepEqual(await numbers(0), ["1", "2", "3"]);
  assert.deepEqual(await numbers(1), ["2", "3"]);
  assert.deepEqual(page.problems, []);
  await page.close();
});

test("numbers and the names of contacts do not lie on each other", async () => {
  // Sixty hammers come down on sixty anvils at once, and twelve plates lie on one another.
  const square = (x, y, w = 1) => [
    [x, y],
    [x + w, y],
    [x + w, y + 1],
    [x, y + 1],
  ];
  const bodies = Array.from({ length: 60 }, (_, k) => [
    { name: `anvil number ${k}`, polygon: square(1.25 * k, 0) },
    { name: `hammer number ${k}`, polygon: square(1.25 * k, 2), motion: { velocity: [0, -1] } },
  ]).flat();
  const plates = Array.from({ length: 12 }, (_, k) => ({
    name: `plate ${k}`,
    polygon: square(20 + 0.01 * k, 12, 30),
    motion: { velocity: [0.001 * k, 0] },
  }));
  const ignore = plates.map(({ name }) => [name, "*"]);
  const scene = { format: "taut-scene/1", time: [0, 2], bodies: [...bodies, ...plates], ignore };
  const file = join(artefacts, "crowded.json");
  writeFileSync(file, JSON.stringify(scene));
  const page = await view(file, "world-crowded");
  await toTheEnd(page);
  const texts = await page.evaluate(() => {
    const context = document.querySelector(".picture").getContext("2d");
    const drawn = [];
    const fillText = context.fillText.bind(context);
    context.fillText = (text, x, y) => {
      drawn.push({ text, x, y, width: context.measureText(text).width });
      fillText(text, x, y);
    };
    window.taut.stage.draw();
    delete context.fillText;
    return drawn;
  });
  const numbers = texts.filter(({ text }) => /^\d+$/.test(text));
  const contacts = texts.filter(({ text }) => text.includes("number"));
  assert.ok(numbers.length > 0 && contacts.length > 0, JSON.stringify(texts));
  for (const labels of [numbers, contacts]) {
    labels.forEach((a, i) =>
      labels.slice(i + 1).forEach((b) => {
        const apart = a.x + a.width < b.x || b.x + b.width < a.x || Math.abs(a.y - b.y) >= 11;
        assert.ok(apart, `${JSON.stringify(a)} lies on ${JSON.stringify(b)}`);
      }),
    );
  }
  await screenshot(page, "world-crowded");
  assert.deepEqual(page.problems, []);
  await page.close();
});
