// Maps, and drawings as scenes.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";

import { root, taut } from "./project.mjs";

const square = (x, y, side) => [
  [x, y],
  [x + side, y],
  [x + side, y + side],
  [x, y + side],
];
const houses = Array.from({ length: 100 }, (_, k) => ({
  name: `house ${k}`,
  polygon: square(4 * (k % 10), 4 * Math.floor(k / 10), 3),
}));
const cart = { name: "cart", polygon: square(-0.25, -0.25, 0.5) };

test("a map answers as check() does about its scene", async () => {
  const town = await taut.StaticMap.create(houses);
  const mover = town.prepare(cart);
  assert.equal(mover.name, "cart");
  const keyframes = [
    { t: 0, x: 3.5, y: 0 },
    { t: 9, x: 3.5, y: 36 },
    { t: 12, x: 15.5, y: 36 },
  ];
  for (const motion of [{ keyframes }, { velocity: [0, 1] }, { velocity: [1, 0] }]) {
    for (const touch of ["open", "closed"]) {
      const bodies = [...houses, { ...cart, motion }];
      const scene = { format: "taut-scene/1", time: [0, 12], bodies };
      const expected = await taut.check(scene, { engine: "spacetime", touch });
      const answer = town.check(mover, motion, [0, 12], { touch });
      // The scene's pairs of houses are not the map's.
      const [a, b] = [answer, expected].map(({ coverage, ...rest }) => rest);
      assert.deepEqual(a, b);
    }
  }
  const answer = town.check(mover, { keyframes }, [0, 12]);
  assert.deepEqual([answer.outcome, answer.pair ?? answer.bodies], ["contact", ["house 91", "cart"]]);
  assert.ok(answer.t[0] <= 9.0625 && 9.0625 <= answer.t[1]);
  assert.equal(town.overlapped(mover, { keyframes: [{ t: 0, x: 1, y: 1, angle_deg: 45 }] }), "house 0");
  assert.equal(town.overlapped(mover, { x: [3.5], y: [3.5] }), null);
  assert.equal(town.overlapped(mover, { x: [3.25], y: [1] }), null);
  assert.equal(town.overlapped(mover, { x: [3.25], y: [1] }, 0, { touch: "closed" }), "house 0");
  assert.throws(() => town.prepare(houses[0]), RangeError);
  const other = await taut.StaticMap.create(houses.slice(1));
  assert.throws(() => other.check(mover, null, [0, 1]), TypeError);
  await assert.rejects(taut.StaticMap.create([{ name: "a", polygon: [[0, 0]] }]), taut.TautError);
  assert.throws(() => town.check(mover, { keyframes: [] }, [0, 1]), taut.TautError);
  town.free();
  assert.throws(() => town.overlapped(mover, null), /was freed/);
});

test("readDrawing() makes scenes of drawings", async () => {
  const text = readFileSync(join(root, "examples/import/latch.svg"), "utf8");
  for (const worker of [false, true]) {
    const { scene, report, svg } = await taut.readDrawing(text, "latch.svg", { worker, curves: true });
    assert.deepEqual(report.faults, []);
    assert.deepEqual(
      scene.bodies.map(({ name }) => name),
      report.bodies.map(({ name }) => name),
    );
    assert.match(svg, /<svg/);
    assert.equal((await taut.check({ ...scene, at_rest: "test" })).coverage.at_rest, 0);
  }
  const wkt = await taut.readDrawing("POLYGON((0 0, 2 0, 2 1, 0 1, 0 0), (0.5 0.5, 1 0.5, 1 0.75, 0.5 0.5))", "a.wkt");
  assert.deepEqual([wkt.report.bodies[0].holes, wkt.report.bodies[0].area], [1, 2 - 0.0625]);
  const open = '<svg xmlns="http://www.w3.org/2000/svg"><path fill="none" stroke="red" d="M0 0 H50 V50 H20"/></svg>';
  const broken = await taut.readDrawing(open, "open.svg");
  assert.equal(broken.scene, null);
  assert.ok(broken.report.faults.length > 0 && broken.report.faults[0].problem);
  assert.equal((await taut.readDrawing(open, "open.svg", { open: "close" })).scene.bodies.length, 1);
  await assert.rejects(taut.readDrawing(open, "open.svg", { open: "shut" }), taut.TautError);
  await assert.rejects(taut.readDrawing(open, "open.svg", { tolerance: 0 }), taut.TautError);
  await assert.rejects(taut.readDrawing("nothing", "a.txt"), taut.TautError);
});
