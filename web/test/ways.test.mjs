// Ways in the playground: the answers are the command's, and what is dragged, typed and switched is what is asked.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { check, duringTests, openPage, root, run, save, screenshot, settled, viewPage } from "./support.mjs";

const site = duringTests();

const open = (options) => openPage(site.browser, site.server.address, options);
const headline = (page) => page.textContent("#headline");
const words = (page) => page.textContent("#answer");
/** After the present search. */
const decided = (page) =>
  page.waitForFunction(
    () => !window.playground.ways.busy && !/Looking/.test(document.querySelector("#headline").textContent),
  );
const asked = (page) => page.evaluate(() => JSON.parse(window.playground.ways.problem.text()));

async function example(page, name) {
  await page.selectOption("#example", `paths/${name}`);
  await decided(page);
}

async function openRoom(page) {
  await page.selectOption("#example", "worlds/room");
  await page.waitForFunction(() => window.taut.player.finished && !window.playground.pending);
  await page.selectOption("#body", "2");
  await page.click("#mode-way");
  await decided(page);
}

/** The pixel of the page at which the middle of a body is, at the start or the goal. */
const pixelOf = (page, end, body) =>
  page.evaluate(
    ([end, body]) => {
      const { problem, shapes } = window.playground.ways;
      const { x, y, c, s } = problem.pose(body, problem[end]);
      const [u, v] = shapes[body].outline.centre;
      const { stage } = window.taut;
      const { left, top } = stage.canvas.getBoundingClientRect();
      const [px, py] = stage.camera.pixel(x + c * u - s * v, y + s * u + c * v);
      return [left + px, top + py];
    },
    [end, body],
  );

async function drag(page, [x, y], [toX, toY]) {
  await page.mouse.move(x, y);
  await page.mouse.down();
  for (let k = 1; k <= 5; ++k) await page.mouse.move(x + ((toX - x) * k) / 5, y + ((toY - y) * k) / 5);
  await page.mouse.up();
  await decided(page);
}

test("the answers about problems are those of the command", async () => {
  const page = await open();
  for (const name of ["piano", "piano_long", "bracket", "arm"]) {
    await example(page, name);
    const wanted = JSON.parse(run("path", `examples/paths/${name}.json`, "--json"));
    assert.deepEqual(await page.evaluate(() => window.playground.ways.found.answer), wanted, name);
    const way = wanted.outcome === "path";
    assert.equal(await headline(page), way ? "There is a way" : "There is no way");
    const cells = wanted.cell_count.toLocaleString("en");
    assert.match(await words(page), new RegExp(`\\b${cells} cells`), "the size of the proof");
    // A way is an ordinary scene, which is shown in motion, and which the command proves free.
    assert.equal(await page.evaluate(() => window.taut.player.playing), way);
    if (way) assert.equal(check(await save(page, "#export", `way-${name}.json`)).outcome, "free");
    else assert.match(await words(page), /x from 0 to 5, y from 0 to 5, any turn/, "within what it is proved");
    await screenshot(page, `way-${name}`);
  }
  assert.deepEqual(page.problems, []);
  await page.close();
});

test("start and goal of a body are dragged and turned, and every change is asked anew", async () => {
  const page = await open();
  await openRoom(page);
  assert.equal(await headline(page), "There is a way");
  const before = await asked(page);
  const from = await pixelOf(page, "goal", 2);
  const to = [from[0] - 100, from[1] + 170];
  await drag(page, from, to);
  const after = await asked(page);
  assert.deepEqual(after.start, before.start);
  assert.ok(
    Math.abs((await pixelOf(page, "goal", 2))[0] - to[0]) < 1 &&
      Math.abs((await pixelOf(page, "goal", 2))[1] - to[1]) < 1,
  );
  assert.equal(await headline(page), "There is a way");
  const ends = await page.evaluate(() =>
    [window.taut.player.start, window.taut.player.scene.time[1]].map((t) => window.taut.player.engine.poses(t)[2]),
  );
  const goalPose = await page.evaluate(() =>
    window.playground.ways.problem.pose(2, window.playground.ways.problem.goal),
  );
  for (const k of ["x", "y", "c", "s"])
    assert.ok(Math.abs(ends[1][k] - goalPose[k]) < 1e-9, "the way ends at the goal");
  assert.equal(check(await save(page, "#export", "way-dragged.json")).outcome, "free");

  // The handle turns the goal, by a quarter.
  const at = await pixelOf(page, "goal", 2);
  await drag(page, [at[0] + 46, at[1]], [at[0] + 1, at[1] - 80]);
  const turned = await asked(page);
  assert.ok(Math.abs(turned.goal.turn - after.goal.turn - 90) < 2, JSON.stringify(turned.goal));
  assert.ok(Math.abs(turned.goal.x - after.goal.x) < 1e-9 && Math.abs(turned.goal.y - after.goal.y) < 1e-9);

  // A goal that collides is no problem: both bodies are named.
  const pillar = await pixelOf(page, "start", 1);
  await drag(page, await pixelOf(page, "goal", 2), pillar);
  assert.equal(await headline(page), "No answer");
  assert.match(await words(page), /robot|pillars/);
  await screenshot(page, "way-refused");

  // Without turns, translations alone decide, by exact signs. Outside of the room there is nothing to be had.
  await page.fill("#way-values tr:nth-child(1) td:nth-child(3) input", String(after.goal.x));
  await page.keyboard.press("Enter");
  await page.fill("#way-values tr:nth-child(2) td:nth-child(3) input", String(after.goal.y));
  await page.keyboard.press("Enter");
  await page.uncheck("#way-turns");
  await decided(page);
  assert.equal(await headline(page), "There is a way");
  assert.match(await words(page), /exact signs/);
  assert.deepEqual(Object.keys((await asked(page)).joints), ["x", "y"]);
  assert.ok(!/long/.test(await words(page)));
  await page.check("#way-shortest");
  await decided(page);
  const [, way, least] = (await words(page)).match(/It is ([\d.]+) long; no way is shorter than ([\d.]+)\./);
  assert.ok(Number(least) > 0.99 * Number(way) && Number(least) <= Number(way), `${least} of ${way}`);
  await page.uncheck("#way-shortest");
  await page.check("#way-outside");
  await decided(page);
  assert.equal(await headline(page), "There is no way");
  await page.uncheck("#way-outside");
  await page.fill("#way-clearance", "0.1");
  await page.keyboard.press("Enter");
  await decided(page);
  assert.equal(await headline(page), "There is a way");
  const scene = await save(page, "#export", "way-clear.json");
  assert.equal(JSON.parse(run("check", "--json", "--clearance", "0.0999999", scene)).outcome, "free");
  assert.deepEqual(page.problems, []);
  await page.close();
});

test("a dragged link goes where its joints let it", async () => {
  const page = await open();
  await example(page, "arm");
  const hand = 2;
  const before = await asked(page);
  const from = await pixelOf(page, "goal", hand);
  await drag(page, from, [from[0] + 25, from[1] - 25]);
  const after = await asked(page);
  assert.deepEqual(after.start, before.start);
  const at = await pixelOf(page, "goal", hand);
  assert.ok(Math.hypot(at[0] - from[0] - 25, at[1] - from[1] + 25) < 3, `${from} to ${at}`);
  for (const [name, value] of Object.entries(after.goal)) {
    const [lo, hi] = before.joints[name];
    assert.ok(lo <= value && value <= hi, name);
  }
  assert.deepEqual(page.problems, []);
  await page.close();
});

test("a search is stopped, ends with the mode, and is undone", async () => {
  const page = await open();
  await openRoom(page);
  const stopped = await page.evaluate(async () => {
    const button = document.querySelector("#way-search");
    button.click();
    const text = button.textContent;
    button.click();
    await new Promise((done) => setTimeout(done, 50));
    return [text, button.textContent, window.playground.ways.busy];
  });
  assert.deepEqual(stopped, ["Stop", "Look again", false]);
  assert.match(await words(page), /stopped/);
  await page.click("#way-search");
  await decided(page);
  assert.equal(await headline(page), "There is a way");
  await page.click("#mode-look");
  // The scene's own answer.
  await page.waitForFunction(() => document.querySelector("#headline").textContent === "Free, of what was tested");
  assert.ok(!(await page.isVisible(".part-way")));
  const names = await page.evaluate(() => window.playground.state.scene.bodies.map((body) => body.motion ?? null));
  assert.notEqual(names[2], null);
  await page.keyboard.press("5");
  await decided(page);
  // Undo leads out of the mode, back to the robot's own motion, which meets a pillar.
  while (!/^Contact/.test(await headline(page))) {
    assert.ok(await page.isEnabled("#undo"));
    await page.click("#undo");
    await page.waitForFunction(() => window.taut.player.finished && !window.playground.pending);
    await settled(page);
  }
  assert.equal(await page.getAttribute("#mode-way", "aria-pressed"), "false");
  assert.deepEqual(page.problems, []);
  await page.close();
});

test("what has no ways says so, and files are opened or refused", async () => {
  const page = await open();
  await page.selectOption("#example", "mechanisms/crank_rocker");
  await page.waitForFunction(() => window.taut.player.finished);
  await page.selectOption("#body", "1");
  await page.click("#mode-way");
  await settled(page);
  assert.match(await words(page), /link of a mechanism/);
  await page.selectOption("#example", "curves/cam");
  await page.waitForFunction(() => window.taut.player.finished);
  await page.click("#mode-way");
  await settled(page);
  assert.match(await words(page), /curves/);
  const text = readFileSync(join(root, "examples/paths/reach.json"), "utf8");
  const file = (name, content) => ({ name, mimeType: "application/json", buffer: Buffer.from(content) });
  await page.setInputFiles("#file", file("reach.json", text));
  await page.waitForFunction(() => /no way/.test(document.querySelector("#headline").textContent));
  assert.equal(await page.textContent("h1"), "reach");
  await page.setInputFiles("#file", file("wrong.json", text.replace('"elbow": 30', '"elbow": 300')));
  await page.waitForFunction(() => !document.querySelector("#message").hidden);
  assert.match(await page.textContent("#message"), /wrong\.json was not opened/);
  assert.equal(await page.textContent("h1"), "reach");
  assert.deepEqual(page.problems, []);
  await page.close();
});

test("the viewer's page looks for ways, too, also on a phone", async () => {
  const address = viewPage("examples/worlds/room.json", "room-ways");
  const page = await openPage(site.browser, `${address}#playground`, {
    viewport: { width: 390, height: 844 },
    isMobile: true,
    hasTouch: true,
    colorScheme: "dark",
  });
  await page.selectOption("#body", "2");
  await page.tap("#mode-way");
  await decided(page);
  assert.equal(await headline(page), "There is a way");
  const wide = await page.evaluate(() => document.documentElement.scrollWidth);
  assert.ok(wide <= 390, `${wide} pixels wide`);
  await screenshot(page, "way-phone");
  assert.deepEqual(page.problems, []);
  await page.close();
});

test("what is exactly tight is undecided, and the place is marked", async () => {
  // A table and a door of just its width.
  const wall = (from, to) => [
    [-0.1, from],
    [0.1, from],
    [0.1, to],
    [-0.1, to],
  ];
  const problem = {
    format: "taut-scene/1",
    joints: { x: [-3, 3], y: [-2, 2], turn: [-30, 30] },
    bodies: [
      {
        name: "table",
        polygon: [
          [-1, -0.6],
          [1, -0.6],
          [1, 0.6],
          [-1, 0.6],
        ],
        motion: { free: { x: "x", y: "y", deg: "turn" } },
      },
      { name: "wall", parts: [wall(0.6, 4), wall(-4, -0.6)] },
    ],
    start: { x: -2, y: 0, turn: 10 },
    goal: { x: 2 },
  };
  const page = await open();
  const buffer = Buffer.from(JSON.stringify(problem));
  await page.setInputFiles("#file", { name: "tight.json", mimeType: "application/json", buffer });
  await page.waitForFunction(() => document.querySelector("#headline").textContent === "Undecided");
  assert.match(await words(page), /table and wall have too little room where x = -?[\d.]+, y = /);
  assert.match(await words(page), /Between vertex \d of .*(table|wall) and edge \d-\d of /);
  const [x] = await page.evaluate(() => window.playground.ways.tight);
  assert.ok(Math.abs(x) < 1.2, "in the door");
  await settled(page);
  await screenshot(page, "way-tight");
  assert.deepEqual(page.problems, []);
  await page.close();
});

test("a way of an excavator, whose bucket is dragged through its loops", async () => {
  const page = await open();
  await example(page, "excavator");
  assert.match(await headline(page), /way/i);
  const moved = await page.evaluate(() => {
    const { problem } = window.playground.ways;
    const bucket = problem.read.bodies.findIndex(({ name }) => name === "bucket");
    const at = (values) => {
      const { x, y, c, s } = problem.pose(bucket, values);
      return [x + c * 105 - s * 19, y + s * 105 + c * 19];
    };
    const [x, y] = at(problem.start);
    const to = [x - 3, y + 4];
    const reached = at(problem.reaching(bucket, [105, 19], to, problem.start));
    return Math.hypot(reached[0] - to[0], reached[1] - to[1]);
  });
  assert.ok(moved < 0.1, String(moved));
  await screenshot(page, "way-excavator");
  await page.close();
});
