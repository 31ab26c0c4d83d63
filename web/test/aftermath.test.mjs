// After a contact: what bounces keeps its energy, what stops rests, and in between the command finds no contact.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { check, duringTests, openPage, run, save, screenshot, settled, viewPage } from "./support.mjs";

const site = duringTests();

const view = (scene, name, options) => openPage(site.browser, viewPage(scene, name), options);

async function goOn(page, which) {
  await page.click(`#${which}`);
  await page.waitForSelector("#reset");
  await page.evaluate(() => window.taut.player.play(false));
}

const headline = (page) => page.textContent("#headline");
/** Of all bodies at an instant. */
const posesAt = (page, t) => page.evaluate((at) => window.taut.player.engine.poses(at), t);
const contacts = (page) => page.$$eval("#excursion li", (all) => all.map((e) => e.textContent));

test("a robot bounces off walls and pillars, with the energy that it has", async () => {
  const page = await view("examples/worlds/room.json", "bounce");
  assert.match(await headline(page), /^Contact at t = 2\.28/);
  await goOn(page, "bounce");
  await settled(page);
  const listed = await contacts(page);
  assert.equal(await headline(page), `They bounce: ${listed.length} contacts`);
  assert.ok(listed.length >= 3 && /^t = 2\.2836531: /.test(listed[0]), listed.join());
  const file = await save(page, "#export", "bounced.json");
  assert.equal(check(file).outcome, "free");
  // All the same the bodies touch: closer than they ever are apart otherwise, at the first contact.
  const close = JSON.parse(run("check", "--json", "--clearance", "1e-7", file));
  assert.equal(close.outcome, "contact");
  assert.ok(Math.abs(close.t[0] - 2.2836531040612145) < 1e-5, String(close.t));
  // From contact to contact, half of v^2 and of the spin's square times (w^2 + h^2) / 12, the robot's inertia by its mass.
  const { bodies } = JSON.parse(readFileSync(file, "utf8"));
  const [x, y] = [0, 1].map((k) => bodies[2].polygon.map((p) => p[k]));
  const inertia = ((Math.max(...x) - Math.min(...x)) ** 2 + (Math.max(...y) - Math.min(...y)) ** 2) / 12;
  const flights = bodies[2].motion.filter(
    ({ until }, k, all) => (all[k - 1]?.until ?? 0) > 2.28 && (until ?? 4) > 2.29,
  );
  const energies = flights.map((piece) => {
    const rate = (of) => of?.[1] ?? 0;
    return (rate(piece.x) ** 2 + rate(piece.y) ** 2 + inertia * rate(piece.rotation?.angle) ** 2) / 2;
  });
  assert.ok(energies.length >= 3, `${energies.length} flights`);
  for (const energy of energies) assert.ok(Math.abs(energy / energies[0] - 1) < 1e-9, energies.join());
  const turns = new Set(flights.map((piece) => JSON.stringify([piece.x[1], piece.y[1]])));
  assert.equal(turns.size, flights.length, "each contact changes the velocity");
  // A contact in the list leads to its instant.
  await page.click("#excursion li:nth-child(2) button");
  const [second] = await contacts(page).then((all) =>
    all.slice(1).map((text) => Number(/^t = ([\d.]+)/.exec(text)[1])),
  );
  const shown = await page.evaluate(() => window.taut.player.t);
  assert.ok(Math.abs(shown - second) < 1e-8, `${shown} and ${second}`);
  await screenshot(page, "aftermath-bounce");
  await page.click("#reset");
  await settled(page);
  assert.match(await headline(page), /^Contact at t = 2\.28/);
  assert.ok(await page.isVisible("#bounce"));
  assert.deepEqual(page.problems, []);
  await page.close();
});

test("a hammer stops where it meets the anvil", async () => {
  const page = await view("examples/hello.json", "stop");
  await goOn(page, "stop");
  await settled(page);
  assert.equal(await headline(page), "They stop: 1 contact");
  const [at, end] = [await posesAt(page, 8 + 1e-9), await posesAt(page, 10)];
  assert.deepEqual(at, end, "the hammer rests");
  const before = await posesAt(page, 7.9);
  assert.ok(before[1].y > end[1].y + 0.04, "it moved until then");
  assert.equal(check(await save(page, "#export", "stopped.json")).outcome, "free");
  assert.deepEqual(page.problems, []);
  await page.close();
});

test("in the playground, another mode and every change lead back", async () => {
  const page = await openPage(site.browser, site.server.address, {
    viewport: { width: 390, height: 844 },
    colorScheme: "dark",
  });
  await page.selectOption("#example", "worlds/room");
  await page.waitForFunction(() => window.taut.player.finished && !window.playground.pending);
  await goOn(page, "bounce");
  await settled(page);
  const wide = await page.evaluate(() => document.documentElement.scrollWidth);
  assert.ok(wide <= 390, `${wide} pixels wide`);
  await screenshot(page, "aftermath-phone");
  await page.click("#mode-keyframes");
  await page.waitForFunction(() => /^Contact/.test(document.querySelector("#headline").textContent));
  await goOn(page, "bounce");
  await page.fill("#time-end", "3");
  await page.keyboard.press("Enter");
  await page.waitForFunction(() => /^Contact/.test(document.querySelector("#headline").textContent));
  await goOn(page, "bounce");
  const few = await contacts(page);
  assert.ok(few.length < 4 && few.length >= 1, few.join());
  // Links that hang on others neither bounce nor stop; what is free has nothing to go on from.
  for (const example of ["worlds/arm", "curves/slot", "gears"]) {
    await page.selectOption("#example", example);
    await page.waitForFunction(() => window.taut.player.finished && !window.playground.pending);
    await settled(page);
    assert.equal(await page.$("#bounce"), null, example);
    assert.equal(await page.$("#reset"), null, example);
  }
  assert.deepEqual(page.problems, []);
  await page.close();
});
