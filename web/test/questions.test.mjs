// Questions beyond the first contact: what both pages say and draw of them is what the command says.
import assert from "node:assert/strict";
import { test } from "node:test";
import {
  check,
  duringTests,
  openPage,
  pixelsOf,
  run,
  save,
  screenshot,
  settled,
  shownTime,
  viewPage,
} from "./support.mjs";

const site = duringTests();

/** Changes a box of a question. By the keyboard, as answers that come meanwhile move what is below them. */
async function toggle(page, name) {
  await page.focus(`#ask-${name}`);
  await page.keyboard.press("Space");
}

/** Without the angles of sweeps, which compiled motions do not tell. */
const ask = (...args) =>
  JSON.parse(run(...args, "--json"), (key, value) =>
    /^(from|to|angle)_deg$/.test(key) && args[0] !== "separate" ? undefined : value,
  );

/** The same directions, whose degrees are enclosed, and may differ in their last digits. */
function sameDirections(found, expected) {
  const free = (answer) => answer.bodies ?? [answer];
  const plain = (answer) => JSON.parse(JSON.stringify(answer, (key, value) => (/_deg$/.test(key) ? undefined : value)));
  assert.deepEqual(plain(found), plain(expected));
  free(found).forEach(({ directions }, b) =>
    directions.forEach((arc, k) => {
      for (const key of ["from_deg", "to_deg"]) {
        const [a, b_] = [arc[key], free(expected)[b].directions[k][key]];
        assert.ok(a[0] <= b_[1] && b_[0] <= a[1], `${a} and ${b_}`);
      }
    }),
  );
}
const view = (scene, name, flags, options) => openPage(site.browser, viewPage(scene, name, ...flags), options);
const answered = (page) => page.waitForFunction(() => !window.taut.questions.waiting() && window.taut.player.finished);
const answers = (page) => page.evaluate(() => window.taut.questions.answers);

/** The colour of a pixel of a lane, at a share of the time and of the height. */
function laneColour(page, lane, t, height) {
  return page.evaluate(
    ([name, at, share]) => {
      const canvas = document.querySelector(`#lane-${name}`);
      const { start, end } = window.taut.player;
      const ratio = canvas.width / canvas.clientWidth;
      const x = 8 + ((at - start) / (end - start)) * (canvas.clientWidth - 16);
      const pixel = canvas
        .getContext("2d")
        .getImageData(Math.round(x * ratio), Math.round(share * canvas.height), 1, 1);
      return [...pixel.data];
    },
    [lane, t, height],
  );
}

const red = ([r, g, b, a]) => a > 200 && r > 150 && g < 90 && b < 90;

test("overlaps are bars along the time, also behind the first contact", async () => {
  const scene = "examples/worlds/arm.json";
  const expected = ask("intervals", scene);
  assert.ok(expected.intervals.length > 0);
  const page = await view(scene, "questions-intervals", ["--intervals"]);
  await answered(page);
  await settled(page);
  const found = (await answers(page)).intervals;
  for (const key of ["intervals", "undecided", "coverage"]) assert.deepEqual(found[key], expected[key], key);
  const { pair, from, to } = expected.intervals[0];
  assert.ok(red(await laneColour(page, "intervals", (from[0] + to[0]) / 2, 0.26)), "the bar is there");
  assert.ok(!red(await laneColour(page, "intervals", from[0] * 0.9, 0.26)), "and nothing before it");
  const line = await page.textContent("#answer-intervals li");
  assert.ok(line.startsWith(pair.join(" x ")), line);
  // The time goes on to the end of the scene: first to the contact, which is marked, then behind it.
  await page.keyboard.press("End");
  await settled(page);
  assert.equal(await shownTime(page), Math.min(...expected.intervals.map((o) => o.from[0])));
  assert.ok((await pixelsOf(page, "#c4161c")) > 60, "the contact is marked");
  await page.keyboard.press("End");
  await settled(page);
  assert.equal(await shownTime(page), await page.evaluate(() => window.taut.player.scene.time[1]));
  await page.click("#answer-intervals li button");
  await settled(page);
  assert.equal(await shownTime(page), from[0], "words lead to their instant, pair by pair");
  await screenshot(page, "questions-intervals");
  assert.deepEqual(page.problems, []);
  await page.close();
});

test("the distance is a curve in its boxes, with its least, and the closest points are drawn", async () => {
  const scene = "examples/parking.json";
  const profile = ask("clearance", scene, "--profile", "60");
  const least = ask("clearance", scene).clearance;
  const page = await view(scene, "questions-distance", ["--clearance", "--profile", "60"]);
  await answered(page);
  await settled(page);
  const found = await answers(page);
  assert.deepEqual(found.distance_profile.profile, profile.profile);
  assert.deepEqual(found.clearance.clearance, least);
  // The curve passes through the boxes: there is blue between the bounds of a stretch, and nothing far above.
  const blue = ([r, , b, a]) => a > 40 && b > r + 20;
  const [first] = profile.profile;
  const most = Math.max(first.largest.hi, ...first.stretches.map((s) => s[3]));
  for (const [from, to, lo, hi] of first.stretches.filter((_, k) => k % 9 === 4)) {
    const level = (d) => (84 - 6 - (d / most) * (84 - 26)) / 84;
    const t = from + 0.5 * (to - from);
    assert.ok(blue(await laneColour(page, "distance", t, level((lo + hi) / 2))), `box at ${t}`);
    if (hi < 0.6 * most) assert.ok(!blue(await laneColour(page, "distance", t, level(hi) - 0.12)), `above ${t}`);
  }
  assert.equal(await pixelsOf(page, "#7b1fd1"), 0, "no points before the instant is shown");
  await page.click("#answer-clearance button");
  await settled(page);
  assert.equal(await shownTime(page), least.t[0]);
  assert.ok((await pixelsOf(page, "#7b1fd1")) > 60, "the closest points");
  assert.match(
    await page.textContent("#answer-clearance"),
    new RegExp(`street x car, at t = ${String(least.t[0]).slice(0, 6)}`),
  );
  await screenshot(page, "questions-distance");
  // The lane leads there, too: some pixels beside it are near enough.
  await page.keyboard.press("Home");
  const box = await page.locator("#lane-distance").boundingBox();
  const { start, end } = await page.evaluate(() => ({ start: window.taut.player.start, end: window.taut.player.end }));
  await page.mouse.click(box.x + 8 + ((least.t[0] - start) / (end - start)) * (box.width - 16) + 2, box.y + 40);
  await settled(page);
  assert.equal(await shownTime(page), least.t[0]);
  assert.deepEqual(page.problems, []);
  await page.close();
});

test("free directions are a rose for each body, in the dark as well", async () => {
  const two = ask("separate", "examples/jigsaw.json");
  let page = await view("examples/jigsaw.json", "questions-rose", ["--separate"]);
  await answered(page);
  await settled(page);
  sameDirections((await answers(page)).separate, two);
  assert.equal(await page.locator(".rose").count(), 1);
  assert.equal(await page.locator(".rose path.rose-free").count(), two.directions.length);
  const label = await page.getAttribute(".rose", "aria-label");
  assert.match(label, /Free directions of knob, in degrees: 258.699\d* to 281.300\d*/);
  assert.ok(!(await page.isVisible("#lane-distance")), "nothing to be shown along the time");
  await page.close();
  const many = ask("separate", "examples/worlds/puzzle.json");
  page = await view("examples/worlds/puzzle.json", "questions-roses", ["--separate"], { colorScheme: "dark" });
  await answered(page);
  await settled(page);
  sameDirections((await answers(page)).separate, many);
  assert.equal(await page.locator(".rose").count(), many.bodies.length);
  assert.match(await page.textContent("#answer-separate"), /One by one: top left/);
  await page.locator(".roses").scrollIntoViewIfNeeded();
  await screenshot(page, "questions-roses-dark");
  assert.deepEqual(page.problems, []);
  await page.close();
});

test("in the playground questions are chosen, answered anew after a change, and taken back", async () => {
  const page = await openPage(site.browser, site.server.address);
  await page.selectOption("#example", "lid");
  await answered(page);
  const before = await page.evaluate(() => window.taut.player.end);
  const all = ["intervals", "clearance", "check_clearance", "range", "distance_profile", "separate"];
  for (const name of all) await toggle(page, name);
  await answered(page);
  await settled(page);
  const { intervals, clearance } = await answers(page);
  assert.ok((await page.evaluate(() => window.taut.player.end)) > before, "time goes on behind the contact");
  assert.equal(intervals.intervals.length, 1);
  assert.equal(clearance.clearance.lo, 0);
  await page.screenshot({ path: "build/browser/questions-playground.png" });
  // The lid closes less far: it no longer overlaps.
  await page.fill("#time-end", "100");
  await page.press("#time-end", "Enter");
  await answered(page);
  await settled(page);
  await page.waitForFunction(() => window.taut.questions.answers.intervals?.intervals.length === 0);
  assert.match(await page.textContent("#answer-intervals"), /They never overlap/);
  const now = (await answers(page)).clearance.clearance;
  assert.ok(now.lo >= 0 && now.t[1] <= 100);
  for (const name of all) await toggle(page, name);
  await settled(page);
  assert.ok(!(await page.isVisible("#lane-intervals")) && !(await page.isVisible("#lane-distance")));
  assert.equal(await page.textContent("#answer-separate"), "");
  assert.deepEqual(page.problems, []);
  await page.close();
});

test("a clearance to be kept, and how far bodies can go from the instant shown", async () => {
  const page = await openPage(site.browser, site.server.address);
  await page.selectOption("#example", "lid");
  await answered(page);
  await page.evaluate(() => window.taut.player.seek(50));
  for (const name of ["check_clearance", "range", "distance_profile"]) await toggle(page, name);
  await page.fill("#margin", "2.5");
  await page.press("#margin", "Enter");
  await answered(page);
  await page.waitForFunction(() => window.taut.questions.answers.check_clearance?.clearance === 2.5);
  await settled(page);
  const { range, check_clearance: margin } = await answers(page);
  const expected = ask("range", "examples/lid.json", "--from", "50");
  assert.deepEqual([range.range.from, range.range.to, range.around], [expected.range.from, expected.range.to, 50]);
  assert.match(await page.textContent("#answer-range"), /from the start106\.6\d+…: bin x lid/);
  const green = ([r, g, , a]) => a > 100 && g > r + 30;
  assert.ok(green(await laneColour(page, "range", 80, 0.5)), "free up to there");
  assert.ok(!green(await laneColour(page, "range", 108, 0.5)), "and no farther");
  const kept = ask("check", "--clearance", "2.5", "examples/lid.json");
  for (const key of ["outcome", "clearance", "t", "pair"]) assert.deepEqual(margin[key], kept[key], key);
  assert.match(await page.textContent("#answer-check_clearance"), /bin x lid: closer than 2.5 at the start/);
  await page.screenshot({ path: "build/browser/questions-margin.png" });
  await page.uncheck("#ask-check_clearance");
  await settled(page);
  assert.ok(!(await page.isVisible("#margin")));
  assert.deepEqual(page.problems, []);
  await page.close();
});

test("lanes fit a narrow window", async () => {
  const page = await view(
    "examples/worlds/arm.json",
    "questions-narrow",
    ["--intervals", "--clearance", "--profile", "50", "--separate"],
    { viewport: { width: 390, height: 844 } },
  );
  await answered(page);
  await settled(page);
  const wide = await page.evaluate(() => document.documentElement.scrollWidth);
  assert.ok(wide <= 390, `${wide} pixels`);
  await screenshot(page, "questions-narrow");
  assert.deepEqual(page.problems, []);
  await page.close();
});

test("the region that a body passes over is drawn, and is the command's", async () => {
  const scene = "examples/mechanisms/crank_rocker.json";
  const page = await view(scene, "questions-swept", []);
  await page.check("#ask-swept");
  await page.selectOption("#swept-body", "coupler");
  await answered(page);
  await settled(page);
  const expected = ask("swept", scene, "--body", "coupler");
  assert.deepEqual((await answers(page)).swept, expected);
  assert.match(await page.textContent("#answer-swept"), new RegExp(`area of ${Number(expected.area.toPrecision(6))}`));
  // A place that is within the region, and under no body then, has a tint; one outside has none.
  const colourAt = (x, y) =>
    page.evaluate(
      ([wx, wy]) => {
        const { stage } = window.taut;
        const [px, py] = stage.camera.pixel(wx, wy);
        const ratio = stage.canvas.width / stage.canvas.clientWidth;
        return [
          ...stage.canvas.getContext("2d").getImageData(Math.round(px * ratio), Math.round(py * ratio), 1, 1).data,
        ];
      },
      [x, y],
    );
  const [outline] = expected.parts.map((part) => part.outline);
  const right = outline.reduce((most, p) => (p[0] > most[0] ? p : most));
  const colours = [await colourAt(right[0] - 1, right[1]), await colourAt(right[0] + 2, right[1])].map(String);
  assert.notEqual(colours[0], colours[1], "the region has an edge there");
  assert.equal(colours[1], "255,255,255,255");
  await screenshot(page, "questions-swept");
  await page.selectOption("#swept-body", "crank");
  await answered(page);
  await settled(page);
  assert.deepEqual((await answers(page)).swept, ask("swept", scene, "--body", "crank"));
  await page.uncheck("#ask-swept");
  await settled(page);
  assert.ok(!(await page.isVisible("#swept-body")));
  assert.equal(await page.evaluate(() => window.taut.stage.region), null);
  assert.deepEqual(page.problems, []);
  await page.close();
});

test("bodies that come apart by turning are shown as they leave", async () => {
  const scene = "examples/worlds/bent_bar.json";
  const page = await view(scene, "questions-turns", ["--separate"]);
  await answered(page);
  await settled(page);
  assert.match(await page.textContent("#answer-separate"), /Stuck: block, bar/);
  assert.equal(await page.$("#show-leaving"), null);
  await page.check("#turns");
  await answered(page);
  await settled(page);
  const expected = ask("separate", "--turns", scene);
  const { scene: leaving, ...found } = (await answers(page)).separate;
  assert.deepEqual(found.ways, expected.ways);
  assert.deepEqual([found.outcome, found.stuck, found.unsure], [expected.outcome, expected.stuck, expected.unsure]);
  assert.match(await page.textContent("#answer-separate"), /plug: without a turn.*bar: turning on its way/);
  await page.click("#show-leaving");
  await page.waitForSelector("#reset");
  await page.waitForFunction(() => window.taut.player.playing && window.taut.player.t > window.taut.player.start);
  assert.equal(await page.textContent("#headline"), "2 bodies leave");
  const file = await save(page, "#export", "leaving.json");
  assert.equal(check(file).outcome, "free");
  assert.equal(JSON.parse(run("check", "--json", file)).scope.time[1], leaving.time[1]);
  await screenshot(page, "questions-turns");
  await page.click("#reset");
  await answered(page);
  assert.deepEqual(await page.evaluate(() => window.taut.player.scene.time), [0, 1]);
  assert.deepEqual(page.problems, []);
  await page.close();
});

test("a question that takes long leaves the page as it is, and ends when it is not asked any more", async () => {
  // A spiral along another one: the distance at thousands of instants.
  const page = await openPage(site.browser, site.server.address);
  await page.selectOption("#example", "spiral");
  await page.waitForFunction(() => window.taut.player.finished && !window.playground.pending);
  await page.evaluate(() => window.taut.questions.choose("distance_profile", { instants: 100000 }));
  await page.waitForFunction(() => window.taut.questions.asking === "distance_profile");
  // Frames go on meanwhile.
  const frames = await page.evaluate(async () => {
    const begun = performance.now();
    let count = 0;
    for (; performance.now() - begun < 500; ++count) await new Promise((done) => requestAnimationFrame(done));
    return [count, window.taut.questions.asking];
  });
  assert.ok(frames[0] > 5 && frames[1] === "distance_profile", frames.join());
  await page.uncheck("#ask-distance_profile");
  await page.waitForFunction(() => window.taut.questions.asking === null, null, { timeout: 2000 });
  await page.check("#ask-clearance");
  await answered(page);
  assert.ok((await answers(page)).clearance.clearance.hi > 0);
  assert.deepEqual(page.problems, []);
  await page.close();
});
