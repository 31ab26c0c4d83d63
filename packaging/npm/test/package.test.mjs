// The package as users have it: unpacked into a project's node_modules.
import assert from "node:assert/strict";
import { execFileSync, spawnSync } from "node:child_process";
import { existsSync, readFileSync, readdirSync, statSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { test } from "node:test";

import {
  archive,
  bundled,
  falls,
  folder,
  globalScript,
  hammer,
  installed,
  pageOf,
  printed,
  root,
  script,
  taut,
  titleOf,
  tools,
} from "./project.mjs";

/** Runs a program in the project, which prints JSON. */
const run = (name, text) => JSON.parse(printed(name, text));
const program = (load) => `${load}; check(${JSON.stringify(falls)}).then((a) => console.log(JSON.stringify(a)));`;

test("check() says when, with a scene as an object and as text", async () => {
  for (const scene of [falls, JSON.stringify(falls)]) {
    const answer = await taut.check(scene);
    assert.equal(answer.outcome, "contact");
    assert.ok(answer.t[0] <= 8 && 8 <= answer.t[1] && answer.t[1] - answer.t[0] < 1e-12, String(answer.t));
    assert.deepEqual(answer.pair ?? answer.bodies ?? ["anvil", "hammer"], ["anvil", "hammer"]);
  }
  assert.equal((await taut.check(hammer({ velocity: [0, 0.5] }))).outcome, "free");
  const touching = { ...falls, time: [0, 8] };
  assert.equal((await taut.check(touching)).outcome, "free");
  assert.equal((await taut.check(touching, { touch: "closed" })).outcome, "contact");
  for (const engine of ["kinetic", "spacetime", "both", "either"])
    assert.equal((await taut.check(falls, { engine })).outcome, "contact", engine);
  const stopped = await taut.check(falls, { maxSeconds: 0 });
  assert.equal(stopped.outcome, "undecided");
});

test("proofs are verified, and damaged ones are not", async () => {
  const { answer, log } = await taut.prove(falls);
  assert.equal(answer.outcome, "contact");
  const verified = await taut.verify(falls, log);
  assert.equal(verified.valid, true);
  assert.equal(verified.outcome, "contact");
  assert.match(verified.scene_sha256, /^[0-9a-f]{64}$/);
  const damaged = log.slice();
  damaged[damaged.length >> 1] ^= 1;
  assert.equal((await taut.verify(falls, damaged)).valid, false);
  assert.equal((await taut.verify(hammer({ velocity: [0, -0.25] }), log)).valid, false);
  // The same bytes as from the program.
  const built = join(root, "build/release/taut");
  if (existsSync(built)) {
    writeFileSync(join(folder, "scene.json"), JSON.stringify(falls));
    try {
      execFileSync(built, ["prove", join(folder, "scene.json"), "-o", join(folder, "scene.proof")]);
    } catch (error) {
      assert.equal(error.status, 1);
    }
    assert.deepEqual(Buffer.from(log), readFileSync(join(folder, "scene.proof")));
  }
  await assert.rejects(taut.verify(falls, "text"), TypeError);
});

test("clearance(), intervals() and range() answer, too", async () => {
  const rises = hammer({ velocity: [0, 0.5] });
  const { lo, hi } = (await taut.clearance(rises)).clearance;
  assert.ok(lo <= 4 && 4 <= hi && hi - lo < 1e-8, `${lo} ${hi}`);
  const through = await taut.intervals({ ...falls, time: [0, 20] });
  assert.equal(through.intervals.length, 1);
  const far = await taut.range(falls, 1);
  assert.deepEqual(Object.keys(far), ["outcome", "range", "around", "after", "coverage", "scope"]);
  await assert.rejects(taut.range(falls, 11), taut.TautError);
  assert.equal((await taut.checkClearance(rises, hi * 0.99)).outcome, "free");
  assert.equal((await taut.checkClearance(rises, hi * 1.01)).outcome, "closer_at_start");
  const own = { ...rises, clearances: [{ pair: [rises.bodies[0].name, "*"], margin: [hi * 0.5, 0.001] }] };
  const kept = await taut.checkClearance(own, 9);
  assert.deepEqual([kept.outcome, kept.clearances], ["free", own.clearances]);
  const { profile } = await taut.distanceProfile(rises, { instants: 5 });
  assert.equal(profile[0].instants.length, 5);
  assert.ok(profile[0].stretches.every(([, , low, high]) => lo <= high && low <= high));
  assert.equal((await taut.separate(rises)).outcome, "free");
  await assert.rejects(taut.distanceProfile(rises, { instants: 1 }), taut.TautError);
});

test("what is wrong is said with place and remedy", async () => {
  const bow = structuredClone(falls);
  bow.bodies[0].polygon = [
    [0, 0],
    [1, 1],
    [1, 0],
    [0, 1],
  ];
  const failure = async (work) => {
    try {
      await work;
    } catch (error) {
      assert.ok(error instanceof taut.TautError, String(error));
      return error;
    }
    assert.fail("was accepted");
  };
  const crossed = await failure(taut.check(bow));
  assert.equal(crossed.kind, "input");
  assert.match(crossed.problem, /not simple/);
  assert.notEqual(crossed.hint, "");
  assert.match((await failure(taut.check("{"))).place, /^scene:1/);
  assert.match((await failure(taut.check(falls, { tuoch: "open" }))).message, /touch/);
  assert.match((await failure(taut.check(falls, { touch: "ajar" }))).message, /"closed"/);
  assert.match(
    (await failure(taut.check({ ...falls, bodies: [{ name: "a", polygon: { wkt: "a.wkt" } }] }))).message,
    /a\.wkt/,
  );
  await assert.rejects(taut.check(undefined), TypeError);
  // It answers as before.
  assert.equal((await taut.check(falls)).outcome, "contact");
});

test("it is imported, required and bundled", async () => {
  assert.equal(run("a.mjs", program('import { check } from "taut2d"')).outcome, "contact");
  assert.equal(run("b.cjs", program('const { check } = require("taut2d")')).outcome, "contact");
  assert.equal(run("c.cjs", await bundled(program('import { check } from "taut2d"'))).outcome, "contact");
});

test("it is as large as its page says", () => {
  const said = Number(/Packed size: ([\d.]+) MB/.exec(readFileSync(join(installed, "README.md"), "utf8"))[1]);
  const size = statSync(archive).size / 1e6;
  assert.ok(Math.abs(size - said) <= 0.1, `${size} MB`);
});

/** Compiles a program of the project; what the compiler prints. */
function compiled(name, text) {
  writeFileSync(join(folder, name), text);
  writeFileSync(join(folder, "package.json"), '{"type":"module"}');
  const tsc = join(dirname(tools.resolve("typescript/package.json")), "bin/tsc");
  const args = [
    "--noEmit",
    "--strict",
    "--target",
    "es2022",
    "--lib",
    "es2022,dom",
    "--module",
    "nodenext",
    "--moduleResolution",
    "nodenext",
  ];
  const { stdout } = spawnSync(process.execPath, [tsc, ...args, join(folder, name)], { encoding: "utf8" });
  return stdout;
}

test("its types are those that it has", () => {
  const text = `import { check, prove, verify, clearance, intervals, range, checkClearance, distanceProfile, separate, Simulation, StaticMap, draw, cells, flatten, readDrawing, setWorkers, stopWorkers, TautError, type Answer, type Scene } from "taut2d";
const scene: Scene = { format: "taut-scene/1", time: [0, 1], bodies: [{ name: "a", polygon: [[0, 0], [1, 0], [0, 1]] }] };
const answer: Answer = await check(scene, { touch: "closed", maxSeconds: 1 });
if (answer.outcome === "contact") console.log(answer.t[0], answer.contact.point[0], answer.coverage.tested);
if (answer.outcome === "untested") console.log(answer.reason.length);
const { log } = await prove(scene);
const verified = log && (await verify(scene, log));
console.log(verified?.valid ? verified.scene_sha256 : verified?.reason, answer.t?.[0]);
await clearance(scene, { tolerance: 1e-6 });
await intervals("{}");
await range(scene, 2, { touch: "open" });
await checkClearance(scene, 0.1);
await distanceProfile(scene, { instants: 9 });
await separate(scene, { travel: 3 });
const constant = { format: "taut-scene/1", time: [0, 1], bodies: [{ name: "a", parts: [{ path: "M0 0H1V1Z" }] }] } as const;
await check(constant);
console.log(new TautError instanceof Error);
const simulation = await Simulation.create(scene, { record: true, maxSeconds: 1 });
if (simulation.advanceTo(1) === "contact") simulation.setMotion("a", { velocity: [1, 0] });
const town = await StaticMap.create([{ name: "a", polygon: [[0, 0], [1, 0], [0, 1]] }]);
console.log(town.check(town.prepare({ name: "b", polygon: [[2, 0], [3, 0], [2, 1]] }), null, [0, 1]).outcome);
console.log((await draw(scene, { at: 1 })).svg, (await cells(scene, "a", 1)).cells[0]?.[0], (await flatten(scene, 1)).bodies);
console.log((await readDrawing("", "a.svg", { open: "close" })).scene?.bodies.length);
// @ts-expect-error made by create()
new Simulation();
await check(scene, { signal: AbortSignal.timeout(9), worker: true, onProgress: ({ share }) => share?.toFixed() });
setWorkers({ count: 2, create: () => undefined });
stopWorkers();
// @ts-expect-error no signal
await check(scene, { signal: 1 });
// @ts-expect-error an unknown word
await check(scene, { touch: "ajar" });
// @ts-expect-error an answer has no such member
console.log(answer.point);
// @ts-expect-error a body has a polygon or parts
await check({ format: "taut-scene/1", time: [0, 1], bodies: [{ name: "a" }] });
// @ts-expect-error a key that scenes do not have
await check({ format: "taut-scene/1", tiem: [0, 1], bodies: [] });
`;
  assert.equal(compiled("typed.ts", text), "");
});

/** Scenes that name no files and have a time: those of the examples, and some for what these do not show. */
function typedScenes() {
  const scenes = {};
  const examples = join(root, "examples");
  for (const name of readdirSync(examples, { recursive: true })
    .filter((n) => n.endsWith(".json"))
    .sort()) {
    const text = readFileSync(join(examples, name), "utf8");
    if (!/"joints"|"csv"|"wkt"|"geojson"/.test(text)) scenes[name] = JSON.parse(text);
  }
  const [anvil, hammerBody] = falls.bodies;
  const raised = (name, y) => ({ name, polygon: anvil.polygon.map(([u, v]) => [u, v + y]) });
  return Object.assign(scenes, {
    through: { ...falls, time: [0, 20] },
    touching: { ...falls, time: [0, 8] },
    identified: {
      ...falls,
      id: 7,
      bodies: [
        { ...anvil, id: "a" },
        { ...hammerBody, id: [1] },
      ],
    },
    ignored: { ...falls, ignore: [["*", "anvil"]] },
    alone: { ...falls, bodies: [anvil] },
    rest: { ...falls, at_rest: "test", bodies: [anvil, raised("plate", 0.5), raised("roof", 9), hammerBody] },
    overlapping: { ...falls, bodies: [anvil, raised("plate", 0.5)] },
    together: { ...falls, bodies: [anvil, hammerBody, { ...hammerBody, name: "other" }] },
    keyframes: hammer({
      keyframes: [
        { t: 0, x: 0, y: 0 },
        { t: 5, turn: { center: [4, 0], deg: 90 } },
        { t: 9, x: 1, y: 1 },
      ],
    }),
  });
}

/** Every question about a scene, in several ways: [type, answer]. */
async function answersAbout(scene) {
  const out = [];
  const add = async (type, work) => out.push([type, await work]);
  const [start] = scene.time;
  for (const options of [{ pairs: "all" }, { touch: "closed" }, { engine: "kinetic", maxEvents: 1 }, { maxSeconds: 0 }])
    await add("Answer", taut.check(scene, { maxSeconds: 5, ...options }));
  const { answer, log } = await taut.prove(scene, { maxSeconds: 5 });
  out.push(["Answer", answer]);
  if (log) await add("Verified", taut.verify(scene, log));
  await add("Verified", taut.verify(scene, new Uint8Array(9)));
  const kept = await taut.proveClearance(scene, 0.05, { maxSeconds: 5 });
  out.push(["MarginAnswer", kept.answer]);
  if (kept.log) await add("Verified", taut.verify(scene, kept.log));
  for (const options of [{ maxSeconds: 5 }, { maxSeconds: 0 }]) {
    await add("ClearanceAnswer", taut.clearance(scene, { pairs: "all", ...options }));
    await add("IntervalsAnswer", taut.intervals(scene, options));
    // From an instant at which bodies overlap there is no range.
    if (answer.outcome !== "overlap_at_start") await add("RangeAnswer", taut.range(scene, start, options));
    await add("MarginAnswer", taut.checkClearance(scene, 0.05, { pairs: "all", ...options }));
    await add("MarginAnswer", taut.checkClearance(scene, 3, options));
    const clearances = [{ pair: ["*", "*"], margin: [3, 0.25], origin: start - 1 }];
    await add("MarginAnswer", taut.checkClearance({ ...scene, clearances }, 3, { pairs: "all", ...options }));
    await add("ProfileAnswer", taut.distanceProfile(scene, { pairs: "all", instants: 3, ...options }));
    await add("SeparationAnswer", taut.separate(scene, options));
  }
  await add("SeparationAnswer", taut.separate(scene, { maxSeconds: 5, travel: 2 }));
  return out;
}

/** Small enough that all questions are answered in a moment. */
const asked =
  /^(hello|lid|combs|lock|gears_thick_tooth|worlds.(arm|room|puzzle|drawer)|curves.(slot|cam))\.json$|^\w+$/;

test("its types have all members of scenes and answers, and answers have all that types require", async () => {
  const scenes = Object.entries(typedScenes());
  assert.ok(scenes.length > 20, String(scenes.length));
  const constants = scenes.map(([name, scene]) => ["Scene", name, scene]);
  const lift = readFileSync(join(root, "examples/linkages/lift.json"), "utf8");
  for (const cells of [false, true])
    constants.push(["EnvelopeAnswer", "lift", await taut.envelope(lift, { tolerance: 0.05, cells })]);
  const piano = readFileSync(join(root, "examples/paths/piano.json"), "utf8");
  for (const cells of [false, true]) constants.push(["PathAnswer", "piano", await taut.path(piano, { cells })]);
  constants.push(["PathAnswer", "coarse", await taut.path(piano, { tolerance: 1 })]);
  constants.push(["CellsAnswer", "falls", await taut.cells(falls, "hammer", 1)]);
  constants.push(["SweptRegion", "falls", await taut.swept(falls, "hammer")]);
  constants.push(["FollowAnswer", "falls", await taut.follow(falls, "anvil", 9, { instants: 4, directionDeg: -90 })]);
  const held = { instants: 4, directionDeg: -90, contacts: true };
  constants.push(["FollowAnswer", "held", await taut.follow(falls, "anvil", 9, held)]);
  constants.push(["SceneObject", "falls", await taut.flatten(falls, 1)]);
  constants.push(["Drawn", "falls", await taut.draw(falls, { at: 1 })]);
  constants.push(["ReadDrawing", "square", await taut.readDrawing("POLYGON((0 0, 1 0, 0 1, 0 0))", "square.wkt")]);
  const press = readFileSync(join(root, "examples/mechanisms/toggle_press.json"), "utf8");
  constants.push(["MechanismAnswer", "press", await taut.mechanism(press, { instants: 2 })]);
  const simulation = await taut.Simulation.create(falls);
  constants.push(["Tiling", "falls", simulation.tiling()]);
  simulation.advanceTo(10);
  for (const [type, name] of [
    ["TimedContact", "contact"],
    ["Pair", "pair"],
    ["Coverage", "coverage"],
  ])
    constants.push([type, name, simulation[name]]);
  constants.push(["ContactMotion", "falls", simulation.relativeVelocity()]);
  const outcomes = new Set();
  for (const [name, scene] of scenes.filter(([n]) => asked.test(n))) {
    for (const [type, answer] of await answersAbout(scene)) {
      constants.push([type, name, answer]);
      outcomes.add(`${type} ${answer.outcome ?? answer.valid}`);
    }
  }
  for (const kind of [
    "Answer",
    "IntervalsAnswer",
    "ClearanceAnswer",
    "RangeAnswer",
    "MarginAnswer",
    "SeparationAnswer",
  ])
    for (const outcome of ["untested", "undecided"])
      assert.ok(outcomes.has(`${kind} ${outcome}`), `${kind} ${outcome}`);
  const types = [...new Set(constants.map(([type]) => type))];
  const text = (list) =>
    `import type { ${types.join(", ")} } from "taut2d";\n` +
    list.map(([t, name, value], k) => `// ${name}\nexport const c${k}: ${t} = ${JSON.stringify(value)};\n`).join("");
  assert.equal(compiled("answers.ts", text(constants)), "");
  // What is not in the types, or not in an answer, is found at any depth.
  const contact = constants.find(([type, , a]) => type === "Answer" && a.outcome === "contact")[2];
  const spoiled = [
    (a) => (a.more = 1),
    (a) => (a.contact.vertex.more = 1),
    (a) => delete a.coverage.at_rest,
    (a) => delete a.contact,
  ];
  for (const spoil of spoiled) {
    const answer = structuredClone(contact);
    spoil(answer);
    assert.match(compiled("spoiled.ts", text([["Answer", "spoiled", answer]])), /error TS/, String(spoil));
  }
});

test(
  "it works in a page by a script tag",
  { skip: !existsSync("/usr/bin/chromium") && "no Chromium here" },
  async () => {
    const ask = `taut.check(${JSON.stringify(falls)}).then((a) => (document.title = a.outcome), (e) => (document.title = String(e)));`;
    assert.equal(await titleOf(pageOf("page.html", globalScript() + script(ask))), "contact");
  },
);
