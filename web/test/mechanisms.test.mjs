// Mechanisms on both pages: joints in the picture, locks in the answer and beside the slider, links that are dragged.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { check, duringTests, openPage, root, screenshot, settled, shownTime, viewPage } from "./support.mjs";

const site = duringTests();

const examples = ["crank_rocker", "excavator", "jansen", "scissor_lift", "toggle_press"];
const fileOf = (name) => `examples/mechanisms/${name}.json`;
const sceneOf = (name) => JSON.parse(readFileSync(join(root, fileOf(name)), "utf8"));

const view = (name, options) => openPage(site.browser, viewPage(fileOf(name), `mechanism-${name}`), options);

async function playground(example) {
  const page = await openPage(site.browser, site.server.address);
  await page.selectOption("#example", example);
  await page.waitForFunction(() => window.taut.player.finished && !window.playground.pending);
  await settled(page);
  return page;
}

/** Where the mark of a joint is: the body that carries it, and its place in the world at t. */
const jointsAt = (page, t) =>
  page.evaluate((at) => {
    const { player } = window.taut;
    const poses = player.engine.poses(at);
    return player.world.joints.map(([body, [u, v]]) => {
      const { x, y, c, s } = poses[body];
      return { body: player.scene.bodies[body].name, x: x + c * u - s * v, y: y + s * u + c * v };
    });
  }, t);

/** The pixel on the screen of a place in the world. */
const pixelOf = (page, x, y) =>
  page.evaluate(
    ([wx, wy]) => {
      const [px, py] = window.taut.stage.camera.pixel(wx, wy);
      const box = document.querySelector("canvas.picture").getBoundingClientRect();
      return [box.left + px, box.top + py];
    },
    [x, y],
  );

/** The colours of the canvas from a pixel outwards to the right. */
const coloursFrom = (page, x, y, length) =>
  page.evaluate(
    ([px, py, n]) => {
      const canvas = document.querySelector("canvas.picture");
      const box = canvas.getBoundingClientRect();
      const ratio = canvas.width / box.width;
      const [left, top] = [(px - box.left) * ratio, (py - box.top) * ratio].map(Math.round);
      const { data } = canvas.getContext("2d").getImageData(left, top, n, 1);
      return Array.from({ length: n }, (_, k) => data[4 * k] + data[4 * k + 1] + data[4 * k + 2]);
    },
    [x, y, length],
  );

test("mechanisms open, play, and show the answer of the command", async () => {
  for (const name of examples) {
    const answer = check(fileOf(name));
    const page = await view(name);
    const shown = await page.evaluate(() => window.taut.player.status.answer);
    for (const key of ["outcome", "t", "contact", "pair", "coverage", "lock"])
      assert.deepEqual(shown[key], answer[key], `${name}: ${key}`);
    await screenshot(page, `mechanism-${name}-start`);
    await page.keyboard.press("End");
    await settled(page);
    await screenshot(page, `mechanism-${name}-end`);
    assert.equal(await shownTime(page), answer.t?.[0] ?? answer.scope.time[1], name);
    await page.keyboard.press("Home");
    await page.selectOption("#speed", "10");
    await page.click("#play");
    await page.waitForFunction(() => !window.taut.player.playing, null, { timeout: 20000 });
    assert.equal(await shownTime(page), answer.t?.[0] ?? answer.scope.time[1], `${name}: played to the end`);
    assert.deepEqual(page.problems, []);
    await page.close();
  }
});

test("a lock is named, explained, and marked beside the slider", async () => {
  const page = await view("toggle_press", {});
  const { lock } = check(fileOf("toggle_press"));
  assert.match(await page.textContent("#headline"), /^Locks at t = 0\.6647615158762…$/);
  const text = await page.textContent("#answer");
  assert.match(
    text,
    /locks at t = 0\.6647615158762… \(dead point\): upper, lower in line; joints that could move there with the drives held: A, B, C/,
  );
  assert.match(text, /Proved free of contact until there, on \[0, 0\.66476151/);
  await page.click("#headline button");
  await settled(page);
  assert.ok(Math.abs((await shownTime(page)) - lock.t[0]) < 1e-9, "the words lead to the lock");
  const marked = await page.evaluate(() => {
    const canvas = document.querySelector("canvas.strip");
    const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
    const places = [];
    for (let i = 0; i < data.length; i += 4)
      if (data[i] === 0x7a && data[i + 1] === 0x56 && data[i + 2] === 0)
        places.push(((i / 4) % canvas.width) / canvas.width);
    return places;
  });
  assert.ok(marked.length > 20, "the mark");
  assert.ok(Math.min(...marked) > 0.9, "it is at the end of the time that is shown");
  assert.deepEqual(page.problems, []);
  await page.close();
});

test("joints are drawn where the library has them, all along the motion", async () => {
  const page = await view("crank_rocker");
  const { joints } = sceneOf("crank_rocker").mechanism;
  const drawn = await jointsAt(page, 0);
  Object.values(joints).forEach(({ revolute, at }, k) => {
    assert.equal(drawn[k].body, revolute[0]);
    assert.ok(Math.hypot(drawn[k].x - at[0], drawn[k].y - at[1]) < 1e-9, "in the drawn pose");
  });
  // The pin of the crank goes around the origin, from (0, 18).
  const [, pin] = await jointsAt(page, 90);
  assert.ok(Math.hypot(pin.x + 18, pin.y) < 1e-9);
  await page.evaluate(() => window.taut.player.seek(90));
  await settled(page);
  const [middle, ...more] = await coloursFrom(page, ...(await pixelOf(page, pin.x, pin.y)), 7);
  assert.ok(middle > 740, "white within the ring");
  assert.ok(Math.min(...more) < 250, "and the dark ring around it");
  assert.deepEqual(page.problems, []);
  await page.close();
});

const drag = async (page, from, to, steps = 8) => {
  await page.mouse.move(...(await pixelOf(page, ...from)));
  await page.mouse.down();
  await page.mouse.move(...(await pixelOf(page, ...to)), { steps });
  await page.mouse.up();
  await settled(page);
};

test("a link is dragged, and the linkage follows", async () => {
  const page = await playground("mechanisms/crank_rocker");
  assert.equal(await shownTime(page), 0);
  // The middle of the crank, on the way to where a crank at 70 degrees has it; not quite on its circle.
  const at = (degrees, radius) => {
    const angle = ((90 + degrees) * Math.PI) / 180;
    return [radius * Math.cos(angle), radius * Math.sin(angle)];
  };
  await drag(page, at(0, 9), at(35, 11));
  await drag(page, at(35, 9), at(70, 12));
  const t = await shownTime(page);
  const pixel = await page.evaluate(() => 1 / window.taut.stage.camera.scale);
  assert.ok(Math.abs(t - 70) < ((pixel / 9) * 180) / Math.PI, `t = ${t}`);
  assert.equal(await page.$eval("#body", (e) => e.selectedOptions[0].textContent), "crank", "it is the one chosen");
  await screenshot(page, "playground-dragged-link");
  // Others lead the crank as well: the pin C at the rocker's end, to where it is at 120.
  const before = (await jointsAt(page, t))[2];
  const after = (await jointsAt(page, 120))[2];
  await drag(page, [before.x, before.y], [after.x, after.y], 12);
  const led = await shownTime(page);
  const now = (await jointsAt(page, led))[2];
  assert.ok(Math.hypot(now.x - after.x, now.y - after.y) < 1.5 * pixel, `C at t = ${led}`);
  assert.ok(Math.abs(led - 120) < 3, `and on the same way: t = ${led}`);
  // Not beyond the contact.
  await drag(page, at(led, 9), at(265, 9), 20);
  assert.equal(await shownTime(page), check(fileOf("crank_rocker")).t[0]);
  // The ground is no link: dragging it moves the view.
  const centre = () => page.evaluate(() => window.taut.stage.camera.world(0, 0));
  const view = await centre();
  await drag(page, [30, -3], [40, -3]);
  assert.notDeepEqual(await centre(), view);
  assert.equal(await shownTime(page), check(fileOf("crank_rocker")).t[0]);
  assert.deepEqual(page.problems, []);
  await page.close();
});

test("a link has no keyframes of its own, and joints follow its new name", async () => {
  const page = await playground("mechanisms/jansen");
  await page.selectOption("#body", { label: "crank" });
  assert.match(await page.textContent("#keyframes"), /Joints move this body/);
  await page.click("#mode-keyframes");
  await page.fill("#name", "driver");
  await page.press("#name", "Enter");
  await settled(page);
  assert.equal(await page.textContent("#headline"), "Free, of what was tested");
  const { mechanism } = await page.evaluate(() => window.playground.state.scene);
  assert.deepEqual(mechanism.joints.O.revolute, ["frame", "driver"]);
  await screenshot(page, "playground-jansen");
  assert.deepEqual(page.problems, []);
  await page.close();
});
