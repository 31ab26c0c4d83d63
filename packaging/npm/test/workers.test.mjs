// Questions in workers: the same answers, several at a time, and they stop when they are told to.
import assert from "node:assert/strict";
import { existsSync, readFileSync } from "node:fs";
import { createServer } from "node:http";
import { join } from "node:path";
import { test } from "node:test";

import {
  bundled,
  falls,
  globalScript,
  hammer,
  installed,
  pageOf,
  printed,
  root,
  script,
  taut,
  titleOf,
} from "./project.mjs";

/** A question that takes many minutes. */
const lift = readFileSync(join(root, "examples/linkages/lift.json"), "utf8");
const endless = (options) => taut.envelope(lift, { tolerance: 1e-6, ...options });

test("a worker gives the same answers, errors and proofs", async () => {
  assert.deepEqual(await taut.check(falls, { worker: true }), await taut.check(falls));
  const [here, there] = [await taut.prove(falls), await taut.prove(falls, { worker: true })];
  assert.deepEqual(there, here);
  assert.equal((await taut.verify(falls, there.log, { worker: true })).valid, true);
  const failures = [];
  for (const worker of [false, true])
    failures.push(await taut.check({ ...falls, time: [1] }, { worker }).catch((error) => error));
  assert.ok(failures[1] instanceof taut.TautError);
  assert.deepEqual({ ...failures[1] }, { ...failures[0] });
  await assert.rejects(taut.check(falls, { worker: true, tuoch: "open" }), taut.TautError);
});

test("this thread goes on meanwhile, and more questions than workers are all answered", async () => {
  taut.setWorkers({ count: 2 });
  let ticks = 0;
  const timer = setInterval(() => ++ticks, 5);
  timer.unref();
  const scenes = Array.from({ length: 9 }, (_, k) => hammer({ velocity: [0, -0.5 - k] }));
  const answers = await Promise.all(scenes.map((scene) => taut.check(scene, { worker: true })));
  await assert.rejects(endless({ signal: AbortSignal.timeout(300) }), { name: "TimeoutError" });
  clearInterval(timer);
  answers.forEach(({ t }, k) => assert.ok(t[0] <= 4 / (0.5 + k) && 4 / (0.5 + k) <= t[1]));
  assert.ok(ticks > 20, String(ticks));
  assert.throws(() => taut.setWorkers({ count: 0 }), RangeError);
  taut.setWorkers({});
});

test("an aborted question stops, with the signal's reason", async () => {
  const stopped = async (after, options) => {
    const control = new AbortController();
    let aborted = 0;
    setTimeout(() => {
      aborted = performance.now();
      control.abort();
    }, after);
    await assert.rejects(endless({ signal: control.signal, ...options }), { name: "AbortError" });
    return performance.now() - aborted;
  };
  // At once, as its worker starts, and in the midst of work.
  for (const after of [0, 20, 500]) assert.ok((await stopped(after)) < 200, String(after));
  await assert.rejects(taut.check(falls, { signal: AbortSignal.abort(new Error("mine")) }), /mine/);
  // Those that wait for their turn, and without the one that is at work.
  taut.setWorkers({ count: 1 });
  const first = new AbortController();
  const busy = assert.rejects(endless({ signal: first.signal }), /enough/);
  assert.ok((await stopped(50)) < 200);
  const next = taut.check(falls, { worker: true });
  first.abort(new Error("enough"));
  await busy;
  assert.equal((await next).outcome, "contact");
  taut.setWorkers({});
  // On this thread it is seen before the work, and no later.
  const late = new AbortController();
  const answer = taut.check(falls, { signal: late.signal, worker: false });
  await answer.then(() => late.abort());
  assert.equal((await answer).outcome, "contact");
  await assert.rejects(taut.check(falls, { signal: late.signal, worker: false }), { name: "AbortError" });
});

test("a question says how far it is", async () => {
  const seen = [];
  const control = new AbortController();
  const onProgress = (progress) => {
    seen.push(progress);
    if (seen.length === 4) control.abort();
  };
  await assert.rejects(endless({ signal: control.signal, onProgress }), { name: "AbortError" });
  assert.equal(seen.length, 4);
  for (const [k, { kind, done, share }] of seen.entries()) {
    assert.equal(kind, "cells");
    assert.ok(done > (seen[k - 1]?.done ?? 0) && share > 0 && share <= 1, JSON.stringify(seen));
  }
});

test("a process ends where workers are idle, and waits where they are not", () => {
  const program = (load) => `${load}
check(${JSON.stringify(falls)}, { worker: true }).then((a) => console.log(a.outcome));`;
  assert.equal(printed("ends.mjs", program('import { check } from "taut2d";')), "contact\n");
  assert.equal(printed("ends.cjs", program('const { check } = require("taut2d");')), "contact\n");
});

/** Answers in a worker, then aborts a question: both as the title. */
const inPage = `const control = new AbortController();
check(${JSON.stringify(falls)}, { worker: true })
  .then(async ({ outcome }) => {
    setTimeout(() => control.abort(), 300);
    const failure = await envelope(${JSON.stringify(lift)}, { tolerance: 1e-6, signal: control.signal }).catch((e) => e.name);
    document.title = outcome + " " + failure;
  })
  .catch((error) => (document.title = String(error)));`;
const skip = !existsSync("/usr/bin/chromium") && "no Chromium here";

test("workers in a page, by a script tag and bundled, also from a file", { skip }, async () => {
  const tag = globalScript() + script(`const { check, envelope } = taut;\n${inPage}`);
  assert.equal(await titleOf(pageOf("tag.html", tag)), "contact AbortError");
  const text = await bundled(`import { check, envelope } from "taut2d";\n${inPage}`);
  assert.equal(await titleOf(pageOf("bundle.html", script(text))), "contact AbortError");
});

test("a page whose policy forbids workers made from text has its own", { skip }, async () => {
  const create = `taut.setWorkers({ create: () => new Worker("worker.js") });`;
  const pages = {
    "/": globalScript() + script(`${create} const { check, envelope } = taut;\n${inPage}`),
    "/without": globalScript() + script(`const { check, envelope } = taut;\n${inPage}`),
  };
  const server = createServer(({ url }, response) => {
    const type = url === "/worker.js" ? "text/javascript" : "text/html";
    response.writeHead(200, { "Content-Type": type, "Content-Security-Policy": "worker-src 'self'" });
    response.end(url === "/worker.js" ? readFileSync(join(installed, "dist/worker.js")) : (pages[url] ?? ""));
  });
  await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
  try {
    const home = `http://127.0.0.1:${server.address().port}/`;
    assert.equal(await titleOf(home), "contact AbortError");
    assert.match(await titleOf(`${home}without`), /Error/);
  } finally {
    server.close();
    server.closeAllConnections();
  }
});
