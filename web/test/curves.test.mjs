// Bodies bounded by curves on both pages: drawn as curves, with the band in which they are known to lie.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import {
  check,
  duringTests,
  openPage,
  pixelsOf,
  root,
  run,
  screenshot,
  settled,
  shownTime,
  viewPage,
} from "./support.mjs";

const site = duringTests();

const names = ["cam", "slot", "geneva", "hinge"];
const contact = "#c4161c";

async function toTheEnd(page) {
  await page.keyboard.press("End");
  await settled(page);
}

/** Where on the canvas a point of the world is. */
const pixelOf = (page, point) => page.evaluate((p) => window.taut.stage.camera.pixel(...p), point);

/** The colour at a pixel of the picture. */
const colourAt = (page, [x, y]) =>
  page.evaluate(
    ([px, py]) => {
      const canvas = document.querySelector("canvas.picture");
      const ratio = canvas.width / canvas.clientWidth;
      return [...canvas.getContext("2d").getImageData(Math.round(px * ratio), Math.round(py * ratio), 1, 1).data];
    },
    [x, y],
  );

test("the page of a scene with curves has the command's answer, in words and marks", async () => {
  for (const name of names) {
    const scene = `examples/curves/${name}.json`;
    const answer = check(scene);
    const page = await openPage(site.browser, viewPage(scene, `curve-${name}`));
    assert.equal(await pixelsOf(page, contact), 0, `${name}: nothing is marked before`);
    await screenshot(page, `curve-${name}-start`);
    await toTheEnd(page);
    const text = await page.textContent("#answer");
    assert.ok(text.includes(`Curves known to ${answer.geometry.tolerance.toPrecision(3)}`), text);
    assert.match(text, /no tiling/);
    assert.ok(await page.isHidden("#proof"));
    await page.click(".part-picture > summary");
    assert.ok(await page.isVisible("#layer-bands"), "there is a box for bands");
    if (answer.outcome === "contact") {
      assert.equal(await shownTime(page), answer.t[0], name);
      const { vertex, edge } = answer.contact;
      const said = (f) => (f.at === undefined ? `edge ${f.index}-` : `egment ${f.index} (at `);
      for (const feature of [vertex, edge]) assert.ok(text.includes(said(feature)), `${said(feature)}: ${text}`);
      assert.ok((await pixelsOf(page, contact)) > 60, `${name}: the contact is marked`);
    } else {
      assert.match(text, /Proved free/);
    }
    await screenshot(page, `curve-${name}`);
    assert.deepEqual(page.problems, []);
    await page.close();
  }
});

/** A disc of radius 1 and a larger one that comes, and their formulas. */
const discs = {
  format: "taut-scene/1",
  time: [0, 10],
  bodies: [
    { name: "wheel", polygon: { path: "M1 0 A1 1 0 0 1 -1 0 A1 1 0 0 1 1 0 Z" } },
    { name: "roller", polygon: { path: "M12 1 A2 2 0 0 1 8 1 A2 2 0 0 1 12 1 Z" }, motion: { velocity: [-1, 0] } },
  ],
};
const ellipse = {
  format: "taut-scene/1",
  time: [0, 1],
  bodies: [
    {
      name: "leaf",
      polygon: { path: "M3 1 A4 1.5 30 0 0 -3 -1 C-3 -4 2 -4 2 -2 Q2.5 -1 3 1 Z" },
      motion: { rotation: { angle: [0.7] } },
    },
    {
      name: "stone",
      polygon: [
        [9, 9],
        [10, 9],
        [10, 10],
      ],
    },
  ],
};

async function openInPlayground(page, scene) {
  await page.evaluate(() => (document.querySelector(".part-text").open = true));
  await page.fill("#scene-text", JSON.stringify(scene));
  await page.click("#apply");
  await settled(page);
}

test("what is drawn is the curve itself, at every magnification", async () => {
  const page = await openPage(site.browser, site.server.address);
  await openInPlayground(page, discs);
  await toTheEnd(page);
  await page.keyboard.press("b"); // without bands
  // The boundary of the wheel, found by walking outwards along rays in the picture, is on the circle.
  for (const zoom of [1, 40, 3000, 1e6]) {
    const angle = 4;
    const at = [Math.cos(angle), Math.sin(angle)];
    await page.evaluate(
      ([p, k]) => {
        window.taut.stage.fit();
        const { camera } = window.taut.stage;
        camera.centreOn(...p);
        camera.zoom(k);
        window.taut.redraw();
      },
      [at, zoom],
    );
    await settled(page);
    const [x, y] = await pixelOf(page, at);
    const along = (d) => [x + d * Math.cos(angle), y - d * Math.sin(angle)];
    assert.deepEqual(await colourAt(page, along(6)), [255, 255, 255, 255], `${zoom}: outside there is paper`);
    const inside = await colourAt(page, along(-6));
    assert.ok(inside[2] > inside[0] + 60, `${zoom}: inside is the body's blue: ${inside}`);
  }
  assert.deepEqual(page.problems, []);
  await page.close();
});

test("arcs of turned ellipses and Bezier curves lie where SVG has them", async () => {
  const page = await openPage(site.browser, site.server.address);
  await openInPlayground(page, ellipse);
  // The browser's own reading of the same data, placed by the same pose.
  const differ = await page.evaluate(() => {
    const { stage, player } = window.taut;
    const canvas = document.querySelector("canvas.picture");
    const ratio = canvas.width / canvas.clientWidth;
    const data = player.scene.bodies[0].parts[0].path;
    const own = document.createElement("canvas");
    [own.width, own.height] = [canvas.width, canvas.height];
    const c = own.getContext("2d");
    const { a, b, c: d, d: e, e: x, f: y } = stage.camera.placing(player.poses()[0]);
    c.setTransform(ratio * a, ratio * d, ratio * b, ratio * e, ratio * x, ratio * y);
    c.fill(new Path2D(data), "evenodd");
    const mine = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data;
    const theirs = c.getImageData(0, 0, own.width, own.height).data;
    let [inside, wrong] = [0, 0];
    for (let i = 0; i < mine.length; i += 4) {
      if (theirs[i + 3] < 255) continue;
      ++inside;
      if (mine[i] > 250 && mine[i + 1] > 250 && mine[i + 2] > 250) ++wrong;
    }
    return { inside, wrong };
  });
  assert.ok(differ.inside > 2000, `the body is seen: ${differ.inside}`);
  // But for its number, written on it in white.
  assert.ok(differ.wrong < 60, `${differ.wrong} of ${differ.inside} pixels of the body are paper`);
  await screenshot(page, "curve-leaf");
  assert.deepEqual(page.problems, []);
  await page.close();
});

test("the band is seen from near, and both polygons are its walls", async () => {
  const page = await openPage(site.browser, site.server.address);
  await openInPlayground(page, discs);
  await toTheEnd(page);
  const bands = await page.evaluate(() => window.taut.player.world.bands);
  for (const [body, radius, centre] of [
    [0, 1, [0, 0]],
    [1, 2, [10, 1]],
  ]) {
    const [width, ...walls] = bands[body][0][0];
    const [low, high] = walls
      .map((wall) => {
        let least = Infinity;
        let most = 0;
        for (let i = 0; i < wall.length; i += 2) {
          const next = [wall[(i + 2) % wall.length], wall[(i + 3) % wall.length]];
          const r = Math.hypot(wall[i] - centre[0], wall[i + 1] - centre[1]);
          const middle = Math.hypot((wall[i] + next[0]) / 2 - centre[0], (wall[i + 1] + next[1]) / 2 - centre[1]);
          [least, most] = [Math.min(least, r, middle), Math.max(most, r)];
        }
        return [least, most];
      })
      .sort((a, b) => a[0] - b[0]);
    assert.ok(low[1] <= radius * (1 + 1e-15), "one wall is within the circle");
    assert.ok(high[0] >= radius * (1 - 1e-15), "the other one around it");
    assert.ok(high[1] - low[0] <= 2.1 * width && width < radius / 500, `${high[1] - low[0]} ${width}`);
  }
  const shown = async () => {
    await settled(page);
    return page.evaluate(() => document.querySelector("canvas.picture").toDataURL());
  };
  const whole = await shown();
  await page.keyboard.press("b");
  assert.equal(await shown(), whole, "from afar no band is seen");
  await page.keyboard.press("z");
  await page.keyboard.press("z");
  const without = await shown();
  await page.keyboard.press("b");
  assert.notEqual(await shown(), without, "from near it is");
  await screenshot(page, "curve-band");
  assert.deepEqual(page.problems, []);
  await page.close();
});

test("questions have the command's answers on the page", async () => {
  const scene = "examples/curves/cam.json";
  const address = viewPage(scene, "curve-questions", "--intervals", "--clearance", "--profile", "9");
  const page = await openPage(site.browser, address);
  await page.waitForFunction(() => Object.keys(window.taut.questions.answers).length === 3, null, { timeout: 120000 });
  const answers = await page.evaluate(() => window.taut.questions.answers);
  const intervals = JSON.parse(run("intervals", "--json", scene));
  assert.deepEqual(
    answers.intervals.intervals.map((i) => [i.from, i.to]),
    intervals.intervals.map((i) => [i.from, i.to]),
  );
  const profile = JSON.parse(run("clearance", "--profile", "9", "--json", scene));
  assert.deepEqual(answers.distance_profile.profile[0].instants, profile.profile[0].instants);
  assert.ok(answers.clearance.clearance.hi === 0);
  await screenshot(page, "curve-questions");
  assert.deepEqual(page.problems, []);
  await page.close();
});

test("in the playground curves are moved as wholes, and changed as text", async () => {
  const page = await openPage(site.browser, site.server.address);
  await openInPlayground(page, discs);
  assert.match(await page.textContent("#headline"), /^Contact at t = 7\.1715728/);
  await page.click("#mode-shape");
  await page.selectOption("#body", "1");
  // Dragging the roller down by 1 puts it level with the wheel: they meet at t = 7.
  const box = await (await page.$("canvas.picture")).boundingBox();
  const from = await pixelOf(page, [10.5, 1.2]);
  const scale = await page.evaluate(() => window.taut.stage.camera.scale);
  await page.mouse.move(box.x + from[0], box.y + from[1]);
  await page.mouse.down();
  await page.mouse.move(box.x + from[0], box.y + from[1] + scale / 2, { steps: 3 });
  await page.mouse.move(box.x + from[0], box.y + from[1] + scale, { steps: 3 });
  await page.mouse.up();
  await page.waitForFunction(() => !window.playground.pending);
  await settled(page);
  assert.match(await page.textContent("#headline"), /^Contact at t = \[7, 7\.0000/);
  // A vertex is not to be had of a curve, and the page says where it is changed.
  await page.mouse.dblclick(box.x + from[0], box.y + from[1] + scale);
  assert.match(await page.textContent("#note"), /roller is bounded by curves: change its path/);
  // As text: a smaller roller.
  await page.evaluate(() => (document.querySelector(".part-path").open = true));
  assert.match(await page.inputValue("#path-text"), /^M 12 1 A 2 2 0 0 1 8 1 A 2 2/);
  await page.fill("#path-text", "m11 1a1 1 0 0 1 -2 0a1 1 0 0 1 2 0z");
  await page.click("#apply-path");
  await settled(page);
  assert.match(await page.textContent("#headline"), /^Contact at t = \[8, 8\.0000/);
  // What meets itself is refused, with its segments in red.
  await page.fill("#path-text", "M0 0 Q10 0 10 10 Q10 0 20 1 L 5 -8 Z L 3 9 L 4 -20 Z");
  await page.click("#apply-path");
  await page.waitForSelector(".message:not([hidden])");
  await screenshot(page, "curve-refused");
  await page.fill("#path-text", "M 1 2 X");
  await page.click("#apply-path");
  assert.match(await page.textContent(".message"), /no command of a path/);
  // A hole where there is most room is one more subpath.
  await page.selectOption("#body", "0");
  await page.evaluate(() => window.playground.history.undo());
  await settled(page);
  assert.deepEqual(page.problems, []);
  await page.close();
});

test("keyframes move a body with curves, and its SVG has arcs", async () => {
  const page = await openPage(site.browser, site.server.address);
  await openInPlayground(page, JSON.parse(readFileSync(join(root, "examples/curves/slot.json"), "utf8")));
  await page.click("#mode-keyframes");
  await settled(page);
  await screenshot(page, "curve-keyframes");
  const svg = await page.evaluate(() => window.taut.player.engine.svg(window.taut.player.t, false));
  assert.match(svg, /<path[^>]* d="M[^"]*A[\d.]+,/, "arcs are arcs");
  assert.deepEqual(page.problems, []);
  await page.close();
});
