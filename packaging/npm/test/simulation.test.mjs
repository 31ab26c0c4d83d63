// Simulations, pictures, cells and polygons for curves.
import assert from "node:assert/strict";
import { existsSync, readFileSync, writeFileSync } from "node:fs";
import { execFileSync } from "node:child_process";
import { join } from "node:path";
import { test } from "node:test";

import { falls, folder, hammer, root, taut } from "./project.mjs";

const square = (x, y) => [
  [x, y],
  [x + 1, y],
  [x + 1, y + 1],
  [x, y + 1],
];

test("a simulation stops at a contact, takes another motion, and goes on", async () => {
  const simulation = await taut.Simulation.create(falls, { record: true });
  assert.equal(simulation.state, "running");
  assert.equal(simulation.advanceTo(5), "running");
  assert.equal(simulation.time, 5);
  const [lo, hi] = simulation.nextEvent();
  assert.ok(5 <= lo && lo <= 8 && lo <= hi);
  assert.equal(simulation.advanceTo(10), "contact");
  const { t, contact } = simulation.contact;
  assert.ok(t[0] <= 8 && 8 <= t[1]);
  assert.deepEqual(
    [simulation.pair, contact.vertex.body, contact.edge.body, simulation.contacts],
    [["anvil", "hammer"], "hammer", "anvil", 1],
  );
  assert.ok(simulation.time <= 8);
  const { along_normal: along, normal } = simulation.relativeVelocity();
  assert.ok(along[0] <= -0.5 && -0.5 <= along[1]);
  assert.ok(normal[1][0] <= 1 && 1 <= normal[1][1]);
  // It goes up again from where it is, a little above the anvil.
  const rises = { y: [1e-14 - simulation.time, 0.5] };
  simulation.setMotion("hammer", rises);
  assert.equal(simulation.resume(), "running");
  assert.equal(simulation.advanceTo(10), "finished");
  assert.equal(simulation.coverage.tested, 1);
  const [recorded] = simulation.record();
  assert.equal((await taut.check(recorded)).outcome, "free");
  assert.throws(() => simulation.setMotion("anvil", { velocity: [1, 0] }), taut.TautError);
  assert.throws(() => simulation.setMotion("anvyl", null), RangeError);
  simulation.free();
  assert.throws(() => simulation.advanceTo(10), /was freed/);
});

test("a hammer stops at an anvil, or pushes it away", async () => {
  const simulation = await taut.Simulation.create(falls);
  assert.throws(() => simulation.stop("hammer"), taut.TautError);
  assert.equal(simulation.advanceTo(10), "contact");
  simulation.stop("hammer");
  assert.equal(simulation.resume(), "running");
  assert.equal(simulation.advanceTo(10), "finished");
  const pushing = await taut.Simulation.create(falls);
  while (pushing.advanceTo(10) === "contact") {
    pushing.push("anvil", { direction: [0, -1], step: 0.25 });
    pushing.resume();
  }
  assert.equal(pushing.state, "finished");
  assert.ok(pushing.contacts > 3, String(pushing.contacts));
  assert.throws(() => pushing.push("anvil", { step: 1 }), TypeError);
});

test("a plate follows a cam", async () => {
  const plate = { name: "plate", polygon: [[-3, 1], [3, 1], [3, 1.5], [-3, 1.5]] };
  const cam = { name: "cam", polygon: [[-1, -1], [1, -1], [1, 1], [-1, 1]], motion: { velocity: [0, 0], spin_deg: 90 } };
  const scene = { format: "taut-scene/1", time: [0, 1], bodies: [cam, plate] };
  const { lifts } = await taut.follow(scene, "plate", 2, { instants: 20 });
  assert.equal(lifts.length, 20);
  for (const { t, lift } of lifts) {
    const top = Math.SQRT2 * Math.cos((Math.PI / 2) * t[0] - Math.PI / 4) - 1;
    assert.ok(lift[0] - 1e-12 <= top && top <= lift[1] + 1e-12, `${lift} at ${t}`);
  }
  const turning = { ...scene, time: [0.25, 1.5] };
  const { contacts } = await taut.follow(turning, "plate", 2, { instants: 1, contacts: true, tolerance: 1e-6 });
  assert.deepEqual(contacts.map(({ state }) => state), ["carried", "change", "carried"]);
  assert.deepEqual(contacts.filter((s) => s.state === "carried").map((s) => s.touching[0].vertex.index), [2, 1]);
  assert.equal(contacts[1].once, true);
});

test("a ball bounces between two walls", async () => {
  const walls = [
    { name: "left", polygon: square(-1, 0) },
    { name: "right", polygon: square(5, 0) },
  ];
  const ball = { name: "ball", polygon: square(2, 0), motion: { velocity: [1, 0] } };
  const scene = { format: "taut-scene/1", time: [0, 20], bodies: [...walls, ball] };
  const simulation = await taut.Simulation.create(scene);
  const seen = [];
  const state = simulation.advanceMany(20, ({ t, contact }) => {
    seen.push(t[0]);
    const away = contact.vertex.body === "left" || contact.edge.body === "left" ? 1 : -1;
    // Where it is, and on from there the other way, a hair off the wall.
    const x = (away > 0 ? -2 : 2) + away * 1e-13;
    simulation.setMotion("ball", { x: [x - away * simulation.time, away] });
  });
  assert.equal(state, "finished");
  // At 2, and every 4 from there.
  assert.equal(seen.length, 5);
  seen.forEach((t, k) => assert.ok(Math.abs(t - (2 + 4 * k)) < 1e-9, String(seen)));
  const once = await taut.Simulation.create(scene);
  assert.equal(
    once.advanceMany(20, () => false),
    "contact",
  );
});

test("bodies come and go, are ignored, and change parents", async () => {
  const bodies = [
    { name: "a", polygon: square(0, 0) },
    { name: "b", polygon: square(3, 0), motion: { velocity: [-1, 0] } },
  ];
  const simulation = await taut.Simulation.create({ format: "taut-scene/1", time: [0, 9], bodies });
  simulation.advanceTo(1);
  simulation.addBody({ name: "c", polygon: square(9, 0) });
  assert.equal(simulation.coverage.pairs, 3);
  simulation.ignore("a", "b");
  assert.equal(simulation.advanceTo(5), "running");
  simulation.removeBody("c");
  assert.throws(() => simulation.setMotion("c", null), RangeError);
  assert.throws(
    () => simulation.addBody({ name: "d", polygon: square(0, 0), motion: { velocity: [0.1, 0] } }),
    /overlap/,
  );
  simulation.setParent("b", "a", { x: [0, -1] });
  assert.equal(simulation.advanceTo(9), "finished");
  const two = await taut.Simulation.create(falls);
  const tiling = two.tiling();
  assert.equal(tiling.points.length, 7);
  assert.ok(tiling.faces.some(({ kind }) => kind === "root"));
  await assert.rejects(taut.Simulation.create(falls, { tuoch: 1 }), taut.TautError);
  assert.throws(() => new taut.Simulation(falls), TypeError);
});

test("draw() makes the pictures of the command", async () => {
  const still = await taut.draw(falls, { at: 3 });
  const moving = await taut.draw(falls, { animate: true, plain: true, worker: true });
  assert.match(still.svg, /^<svg /);
  assert.match(moving.svg, /<animate/);
  await assert.rejects(taut.draw(falls, { at: 11 }), /within/);
  const program = join(root, "build/release/taut");
  if (!existsSync(program)) return;
  writeFileSync(join(folder, "falls.json"), JSON.stringify(falls));
  const drawn = (...options) =>
    execFileSync(program, ["draw", join(folder, "falls.json"), ...options], { encoding: "utf8" }).trim();
  assert.equal(still.svg.trim(), drawn("--at", "3"));
  assert.equal(moving.svg.trim(), drawn("--animate", "--plain"));
  const world = readFileSync(join(root, "examples/worlds/room.json"), "utf8");
  writeFileSync(join(folder, "room.json"), world);
  const room = execFileSync(program, ["draw", join(folder, "room.json"), "--width", "400"], { encoding: "utf8" });
  assert.equal((await taut.draw(world, { width: 400 })).svg.trim(), room.trim());
});

test("cells(), swept(), mechanism() and flatten() answer, too", async () => {
  const { cells, origin } = await taut.cells(hammer({ velocity: [0, -0.5] }), "hammer", 1, { originX: 0.5 });
  assert.deepEqual(origin, [0.5, 0]);
  // The triangle from y 5 to 6 goes down by 5; the rows that it touches from outside count.
  assert.equal(Math.min(...cells.map(([, j]) => j)), -1);
  assert.equal(Math.max(...cells.map(([, j]) => j)), 6);
  const { area } = await taut.swept(falls, "hammer");
  assert.ok(area >= 11 && area < 11.2, String(area));
  const disc = { name: "disc", polygon: { path: "M1 0 A1 1 0 0 1 -1 0 A1 1 0 0 1 1 0 Z" } };
  const flat = await taut.flatten({ format: "taut-scene/1", time: [0, 1], bodies: [disc] }, 0.01, { side: "inner" });
  assert.ok(flat.bodies[0].polygon.length > 10);
  for (const [x, y] of flat.bodies[0].polygon) assert.ok(Math.hypot(x, y) <= 1 + 1e-15);
  const press = readFileSync(join(root, "examples/mechanisms/toggle_press.json"), "utf8");
  const { mobility } = await taut.mechanism(press);
  assert.equal(mobility, 1);
});
