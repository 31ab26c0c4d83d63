// The package as users have it: unpacked into a project's node_modules.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import {
  existsSync,
  mkdirSync,
  mkdtempSync,
  readFileSync,
  readdirSync,
  rmSync,
  statSync,
  writeFileSync,
} from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { after, test } from "node:test";
import { fileURLToPath, pathToFileURL } from "node:url";

const root = join(dirname(fileURLToPath(import.meta.url)), "../../..");
const tools = createRequire(join(root, "web/package.json"));
const folder = mkdtempSync(join(tmpdir(), "taut-npm-"));
after(() => rmSync(folder, { recursive: true }));

const [archive] = readdirSync(join(root, "build")).filter((name) => /^taut2d-.*\.tgz$/.test(name));
const installed = join(folder, "node_modules/taut2d");
mkdirSync(installed, { recursive: true });
execFileSync("tar", ["-xzf", join(root, "build", archive), "-C", installed, "--strip-components=1"]);
writeFileSync(join(folder, "package.json"), "{}");

const hammer = (motion) => ({
  format: "taut-scene/1",
  time: [0, 10],
  bodies: [
    {
      name: "anvil",
      polygon: [
        [0, 0],
        [4, 0],
        [4, 1],
        [0, 1],
      ],
    },
    {
      name: "hammer",
      polygon: [
        [1, 5],
        [3, 5],
        [2, 6],
      ],
      motion,
    },
  ],
});
const falls = hammer({ velocity: [0, -0.5] });

/** Runs a program in the project, which prints JSON. */
function run(name, text) {
  writeFileSync(join(folder, name), text);
  return JSON.parse(execFileSync(process.execPath, [join(folder, name)], { cwd: folder, encoding: "utf8" }));
}
const program = (load) => `${load}; check(${JSON.stringify(falls)}).then((a) => console.log(JSON.stringify(a)));`;

const taut = await import(pathToFileURL(join(installed, "dist/taut.js")).href);

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
  assert.deepEqual(Object.keys(far), ["range", "around", "after", "scope"]);
  await assert.rejects(taut.range(falls, 11), taut.TautError);
  assert.equal((await taut.checkClearance(rises, hi * 0.99)).outcome, "free");
  assert.equal((await taut.checkClearance(rises, hi * 1.01)).outcome, "overlap_at_start");
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
  writeFileSync(join(folder, "entry.mjs"), program('import { check } from "taut2d"'));
  await tools("esbuild").build({
    entryPoints: [join(folder, "entry.mjs")],
    bundle: true,
    outfile: join(folder, "bundled.js"),
    format: "iife",
    platform: "browser",
    logLevel: "warning",
  });
  assert.equal(run("c.cjs", readFileSync(join(folder, "bundled.js"), "utf8")).outcome, "contact");
});

test("it is as large as its page says", () => {
  const said = Number(/Packed size: ([\d.]+) MB/.exec(readFileSync(join(installed, "README.md"), "utf8"))[1]);
  const size = statSync(join(root, "build", archive)).size / 1e6;
  assert.ok(Math.abs(size - said) <= 0.1, `${size} MB`);
});

test("its types are those that it has", () => {
  writeFileSync(
    join(folder, "typed.ts"),
    `import { check, prove, verify, clearance, intervals, range, checkClearance, distanceProfile, separate, TautError, type Answer } from "taut2d";
const scene = {};
const answer: Answer = await check(scene, { touch: "closed", maxSeconds: 1 });
const { log } = await prove(scene);
if (log) console.log((await verify(scene, log)).valid, answer.t?.[0]);
await clearance(scene, { tolerance: 1e-6 });
await intervals("{}");
await range(scene, 2, { touch: "open" });
await checkClearance(scene, 0.1);
await distanceProfile(scene, { instants: 9 });
await separate(scene);
console.log(new TautError instanceof Error);
// @ts-expect-error an unknown word
await check(scene, { touch: "ajar" });
`,
  );
  const tsc = join(dirname(tools.resolve("typescript/package.json")), "bin/tsc");
  const args = ["--noEmit", "--strict", "--target", "es2022", "--module", "nodenext", "--moduleResolution", "nodenext"];
  writeFileSync(join(folder, "package.json"), '{"type":"module"}');
  execFileSync(process.execPath, [tsc, ...args, join(folder, "typed.ts")], { encoding: "utf8", stdio: "pipe" });
});

test(
  "it works in a page by a script tag",
  { skip: !existsSync("/usr/bin/chromium") && "no Chromium here" },
  async () => {
    const page = `<script>${readFileSync(join(installed, "dist/taut.global.js"), "utf8").replaceAll("</script", "<\\/script")}</script>
<script>taut.check(${JSON.stringify(falls)}).then((a) => (document.title = a.outcome), (e) => (document.title = String(e)));</script>`;
    writeFileSync(join(folder, "page.html"), page);
    const { chromium } = tools("playwright-core");
    const browser = await chromium.launch({
      executablePath: "/usr/bin/chromium",
      args: ["--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking"],
    });
    try {
      const tab = await browser.newPage();
      await tab.goto(pathToFileURL(join(folder, "page.html")).href);
      await tab.waitForFunction("document.title !== ''", undefined, { timeout: 60000 });
      assert.equal(await tab.title(), "contact");
    } finally {
      await browser.close();
    }
  },
);
