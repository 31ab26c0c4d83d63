// The page of `taut view`, from file://, compared with the command line.
import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import {
  artefacts,
  check,
  launch,
  openPage,
  pixelsOf,
  root,
  run,
  save,
  screenshot,
  settled,
  shownTime,
  viewPage,
} from "./support.mjs";

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser?.close());

const names = {
  convex_flip: "convex, flip",
  convex_triangle: "convex, triangle",
  reflex_a: "reflex, case (a)",
  reflex_b: "reflex, case (b)",
  reflex_c: "reflex, case (c)",
  collision: "contact",
};

/** The events that the command tells, and its answer. */
function traceOf(scene) {
  const events = run("trace", scene)
    .trim()
    .split("\n")
    .map((line) => JSON.parse(line));
  return { answer: events.pop(), events };
}

/** A file with two bodies at rest. */
function sceneFile(name, bodies) {
  const file = join(artefacts, `${name}.json`);
  writeFileSync(file, JSON.stringify({ format: "taut-scene/1", time: [0, 1], bodies }));
  return file;
}

/** The contact, or the end of the time. */
async function toTheEnd(page) {
  await page.keyboard.press("End");
  await settled(page);
}

test("scrubbing to the contact shows the command line's time and witness", async () => {
  for (const name of ["gears_thick_tooth", "lid", "hello", "jigsaw_caught"]) {
    const scene = `examples/${name}.json`;
    const answer = check(scene);
    assert.equal(answer.outcome, "contact", name);
    const page = await openPage(browser, viewPage(scene, name));
    await page.locator("#time").focus();
    await page.$eval("#time", (slider) => {
      slider.value = slider.max;
      slider.dispatchEvent(new Event("input", { bubbles: true }));
    });
    await settled(page);
    assert.equal(await shownTime(page), answer.t[0], name);
    const headline = /t = (.+?)(   \(angle .*)?$/m.exec(run("check", "--engine", "kinetic", scene))[1];
    assert.equal(await page.textContent("#headline"), `Contact at t = ${headline}`);
    await page.keyboard.press("Home");
    await page.click("#headline button");
    await settled(page);
    assert.equal(await shownTime(page), answer.t[0], "the headline leads there");
    const { vertex, edge } = answer.contact;
    const text = await page.textContent("#answer");
    assert.match(
      text,
      new RegExp(`[Vv]ertex ${vertex.index} of ${vertex.body} meets edge ${edge.index}-\\d+ of ${edge.body}`),
    );
    assert.ok((await pixelsOf(page, "#c4161c")) > 60, `${name}: the contact is marked`);
    assert.equal(await page.textContent("#events-count"), String(answer.events));
    assert.match(await page.textContent("#event"), new RegExp(`^contact event ${answer.events} of ${answer.events}`));
    await screenshot(page, `${name}-contact`);
    assert.deepEqual(page.problems, []);
    await page.close();
  }
});

test("before the contact nothing is marked", async () => {
  const page = await openPage(browser, viewPage("examples/lid.json", "lid"));
  assert.equal(await pixelsOf(page, "#c4161c"), 0);
  assert.equal(await pixelsOf(page, "#b8106f"), 0, "bodies alone");
  await page.click("#proof");
  await settled(page);
  assert.equal(await page.getAttribute("#proof", "aria-pressed"), "true");
  assert.ok((await pixelsOf(page, "#b8106f")) > 60, "edges between the bodies are drawn");
  await page.close();
});

test("a million times larger, the picture of the contact is the same", async () => {
  const page = await openPage(browser, viewPage("examples/gears_thick_tooth.json", "gears_thick_tooth"));
  await page.keyboard.press("End");
  await page.keyboard.press("z");
  await settled(page);
  const share = await page.evaluate(async () => {
    const canvas = document.querySelector("canvas.picture");
    // Without the scale bar, which is at the bottom.
    const picture = () => canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height - 60).data;
    const near = picture();
    window.taut.stage.zoom(1e6);
    window.taut.stage.draw();
    const nearer = picture();
    let different = 0;
    for (let i = 0; i < near.length; i += 4) {
      if (Math.abs(near[i] - nearer[i]) + Math.abs(near[i + 2] - nearer[i + 2]) > 60) ++different;
    }
    return (4 * different) / near.length;
  });
  assert.ok(share < 0.002, `${100 * share} % of the pixels differ`);
  await page.close();
});

test("closed touching, a title and a first instant are taken over", async () => {
  const page = await openPage(
    browser,
    viewPage(
      "examples/gears_thick_tooth.json",
      "closed",
      "--touch",
      "closed",
      "--at",
      "0.25",
      "--title",
      "Two <gears>",
    ),
  );
  assert.equal(await page.textContent("h1"), "Two <gears>");
  assert.equal(await shownTime(page), 0.25);
  const answer = check("examples/gears_thick_tooth.json", "--touch", "closed");
  await toTheEnd(page);
  assert.equal(await shownTime(page), answer.t[0]);
  assert.match(await page.textContent("#answer"), /touching included/);
  await page.close();
});

test("playing moves time on, and stops at the end", async () => {
  const page = await openPage(browser, viewPage("examples/gears.json", "gears"));
  await page.click("#play");
  await page.waitForFunction(() => Number(document.querySelector("#clock").dataset.t) > 0.02);
  assert.equal(await page.getAttribute("#play", "aria-label"), "Pause");
  await page.click("#play");
  const t = await shownTime(page);
  await settled(page);
  assert.equal(await shownTime(page), t, "time stands still after a pause");
  await page.selectOption("#speed", "10");
  await page.click("#play");
  await page.waitForFunction(() => document.querySelector("#play").getAttribute("aria-label") === "Pause");
  await page.waitForFunction(() => document.querySelector("#play").getAttribute("aria-label") === "Play", null, {
    timeout: 60000,
  });
  assert.equal(await shownTime(page), JSON.parse(readFileSync(join(root, "examples/gears.json"), "utf8")).time[1]);
  assert.deepEqual(page.problems, []);
  await page.close();
});

test("events are those of the trace, forwards and backwards", async () => {
  for (const name of ["gears_thick_tooth", "combs", "spiral"]) {
    const scene = `examples/${name}.json`;
    const { events: trace, answer } = traceOf(scene);
    const page = await openPage(browser, viewPage(scene, name));
    const seen = await page.evaluate(() => {
      const { player } = window.taut;
      const { replay } = player;
      const state = () => JSON.stringify([[...replay.origin], [...replay.next], [...replay.face]]);
      const start = state();
      const events = [];
      for (let k = 0; k < replay.count; ++k) {
        player.stepEvent(1);
        const e = player.replay.event(k);
        const { gone, come } = replay.edgesOf(k);
        events.push({
          shown: player.selected,
          t: player.t,
          lo: e.lo,
          hi: e.hi,
          repair: e.repair,
          certificates: e.certificates,
          corner: e.corner.map((v) => ({
            body: player.scene.bodies[replay.vertexBody[v]].name,
            index: replay.vertexIndex[v],
          })),
          gone: gone.length,
          come: come.length,
        });
      }
      const end = state();
      for (let k = replay.count; k > 0; --k) player.stepEvent(-1);
      player.stepEvent(-1);
      const back = state();
      player.seek(player.limit);
      return { events, same: back === start, different: end !== start, again: state() === end };
    });
    assert.equal(seen.events.length, trace.length, name);
    trace.forEach((line, k) => {
      const e = seen.events[k];
      assert.equal(e.shown, k);
      assert.deepEqual([e.lo, e.hi], line.t);
      assert.equal(e.repair, line.repair);
      assert.deepEqual(e.corner, line.corner);
      assert.equal(e.certificates, line.certificates);
      const edges = {
        convex_flip: [1, 1],
        convex_triangle: [1, 0],
        reflex_a: [0, 1],
        reflex_b: [1, 1],
        reflex_c: [1, 1],
        collision: [0, 0],
      };
      assert.deepEqual([e.gone, e.come], edges[e.repair], `${name}, event ${k + 1}: ${e.repair}`);
    });
    assert.ok(seen.same, `${name}: the map at the start comes back`);
    assert.ok(seen.different && seen.again);
    assert.equal(answer.events, trace.length);
    await page.close();
  }
});

test("the map shown is the one that the library draws", async () => {
  // The picture of `taut draw` has one segment for each tiling edge.
  const scene = "examples/combs.json";
  const page = await openPage(browser, viewPage(scene, "combs"));
  for (const share of [0, 0.31, 0.62, 0.9]) {
    const shown = await page.evaluate((s) => {
      const { player, stage } = window.taut;
      player.seek(player.start + s * (player.limit - player.start));
      stage.draw();
      const { origin, vertexBody, slots } = player.replay;
      const counts = { rigid: 0, pq: 0 };
      for (let h = 2 * vertexBody.length; h < slots; h += 2) {
        if (origin[h] >= 0) counts[vertexBody[origin[h]] === vertexBody[origin[h + 1]] ? "rigid" : "pq"]++;
      }
      return { t: player.t, ...counts };
    }, share);
    const svg = run("draw", scene, "--at", String(shown.t));
    const segments = (colour) =>
      (new RegExp(`<path d="([^"]*)" fill="none" stroke="${colour}"`).exec(svg)?.[1].match(/L/g) ?? []).length;
    assert.equal(shown.rigid, segments("#5f6b76"), `tiling edges at ${shown.t}`);
    assert.equal(shown.pq, segments("#c2187a"), `edges between the bodies at ${shown.t}`);
  }
  await page.close();
});

test("stepping names the corner and its case, in the panel, the list and the picture", async () => {
  const scene = "examples/gears_thick_tooth.json";
  const trace = traceOf(scene).events;
  const page = await openPage(browser, viewPage(scene, "gears_thick_tooth"));
  const cases = new Set();
  for (let k = 0; k < 40; ++k) {
    await page.keyboard.press("ArrowRight");
    await settled(page);
    assert.match(
      await page.textContent("#event"),
      new RegExp(`^${names[trace[k].repair].replace(/[()]/g, "\\$&")} event ${k + 1} of ${trace.length}`),
    );
    assert.match(await page.textContent(".row.selected"), new RegExp(`^${k + 1}`));
    cases.add(trace[k].repair);
  }
  assert.ok(cases.size >= 4, "the first events are of several kinds");
  assert.ok((await pixelsOf(page, "#7a5600")) > 10, "the failing vertex is marked");
  await page.keyboard.press("z");
  await screenshot(page, "event");
  await page.keyboard.press("ArrowLeft");
  await settled(page);
  assert.match(await page.textContent("#event"), /event 39 of/);
  // A row of the list is a way to an event, too.
  const row = page.locator(".row", { hasText: "36" }).first();
  const number = Number(await row.locator(".number").textContent());
  await row.click();
  await settled(page);
  assert.match(await page.textContent("#event"), new RegExp(`event ${number} of`));
  assert.deepEqual(page.problems, []);
  await page.close();
});

test("the keyboard alone suffices", async () => {
  const page = await openPage(browser, viewPage("examples/jigsaw.json", "jigsaw"));
  const scale = () => page.evaluate(() => window.taut.stage.camera.scale);
  const before = await scale();
  await page.keyboard.press("+");
  assert.ok((await scale()) > before);
  await page.keyboard.press("0");
  assert.equal(await scale(), before);
  await page.keyboard.press("p");
  await page.keyboard.press("f");
  assert.equal(await page.isChecked("#layer-faces"), false);
  await page.keyboard.press("f");
  await page.keyboard.press("?");
  assert.ok(await page.locator("dialog").isVisible());
  await page.keyboard.press("Escape");
  await page.locator("dialog").waitFor({ state: "hidden" });
  await settled(page);
  await page.keyboard.press("Space");
  await page.waitForFunction(() => window.taut.player.t > window.taut.player.start);
  await page.keyboard.press("Space");
  await page.keyboard.press("Home");
  await settled(page);
  assert.equal(await shownTime(page), await page.evaluate(() => window.taut.player.start));
  await page.keyboard.press("t");
  await settled(page);
  assert.equal(await page.getAttribute("html", "data-theme"), "dark");
  // Everything that can be reached has a name.
  const nameless = await page.$$eval("button, input, select, [tabindex]", (all) =>
    all
      .filter((e) => !(e.getAttribute("aria-label") || e.textContent.trim() || e.labels?.length))
      .map((e) => e.outerHTML),
  );
  assert.deepEqual(nameless, []);
  await page.close();
});

test("the vertex below the pointer is named as in the command's reports", async () => {
  const page = await openPage(browser, viewPage("examples/lid.json", "lid"));
  await toTheEnd(page);
  const { contact } = check("examples/lid.json");
  const at = await page.evaluate(([x, y]) => {
    const box = document.querySelector("canvas.picture").getBoundingClientRect();
    const [px, py] = window.taut.stage.camera.pixel(x, y);
    return [box.left + px, box.top + py];
  }, contact.point);
  await page.mouse.move(at[0] + 2, at[1] + 1);
  const { body, index } = contact.vertex;
  assert.equal(await page.textContent("#readout"), `vertex ${index} of ${body} at (4, -13.4164079)`);
  await page.mouse.move(at[0] + 2, at[1] - 60);
  assert.equal(await page.textContent("#readout"), "");
  await page.close();
});

test("text has enough contrast, light and dark", async () => {
  const scenes = ["examples/gears_thick_tooth.json", "examples/worlds/planetary.json"];
  for (const [scene, colorScheme] of scenes.flatMap((s) => ["light", "dark"].map((c) => [s, c]))) {
    const name = scene.match(/(\w+)\.json/)[1];
    const page = await openPage(browser, viewPage(scene, name), { colorScheme });
    await page.keyboard.press("ArrowRight");
    await settled(page);
    await page.waitForTimeout(300);
    const poor = await page.evaluate(() => {
      const parse = (s) => s.match(/[\d.]+/g).map(Number);
      const light = ([r, g, b]) => {
        const [x, y, z] = [r, g, b].map((c) => ((c /= 255) <= 0.03928 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4));
        return 0.2126 * x + 0.7152 * y + 0.0722 * z;
      };
      const ground = (e) => {
        for (; e; e = e.parentElement) {
          const c = parse(getComputedStyle(e).backgroundColor);
          if (c.length < 4 || c[3] > 0) return c;
        }
        return [255, 255, 255];
      };
      const out = [];
      for (const e of document.querySelectorAll(
        "h1, p, dt, dd, span, b, strong, summary, label, output, select, li, i.number",
      )) {
        if (!e.textContent.trim() || !e.checkVisibility()) continue;
        const [a, b] = [light(parse(getComputedStyle(e).color)), light(ground(e))].sort((x, y) => y - x);
        const ratio = (a + 0.05) / (b + 0.05);
        if (ratio < 4.5) out.push(`${e.className || e.tagName} "${e.textContent.slice(0, 20)}" ${ratio.toFixed(2)}`);
      }
      return out;
    });
    assert.deepEqual(poor, [], `${scene} ${colorScheme}`);
    await screenshot(page, `${name}-${colorScheme}`);
    await page.close();
  }
});

test("a phone shows picture, time and answer without scrolling sideways", async () => {
  for (const [name, viewport] of [
    ["phone", { width: 390, height: 844 }],
    ["phone-wide", { width: 844, height: 390 }],
  ]) {
    const page = await openPage(browser, viewPage("examples/lid.json", "lid"), {
      viewport,
      hasTouch: true,
      isMobile: true,
      deviceScaleFactor: 2,
    });
    assert.equal(await page.evaluate(() => document.documentElement.scrollWidth <= window.innerWidth), true, name);
    assert.ok(await page.locator("#play").isVisible());
    const picture = await page.locator("canvas.picture").boundingBox();
    assert.ok(picture.width >= 0.5 * viewport.width && picture.height >= 150, `${name}: ${JSON.stringify(picture)}`);
    const button = await page.locator("#next").boundingBox();
    assert.ok(button.width >= 34 && button.y + button.height <= viewport.height, `${name}: ${JSON.stringify(button)}`);
    await page.tap("#next");
    await settled(page);
    assert.match(await page.textContent("#event"), /event 1 of/);
    await screenshot(page, name);
    await page.close();
  }
});

test("an overlap at the start is said, and shown", async () => {
  const file = sceneFile("overlap", [
    {
      name: "one",
      polygon: [
        [0, 0],
        [2, 0],
        [2, 2],
        [0, 2],
      ],
    },
    {
      name: "two",
      polygon: [
        [1, 1],
        [3, 1],
        [3, 3],
      ],
    },
  ]);
  const page = await openPage(browser, viewPage(file, "overlap"));
  assert.equal(await page.textContent("#headline"), "Overlap at the start");
  await page.keyboard.press("ArrowRight");
  assert.deepEqual(page.problems, []);
  await page.close();
});

test("names are text, never markup", async () => {
  const name = '</script><img src=x onerror="window.hit = 1">';
  const file = sceneFile("markup", [
    {
      name,
      polygon: [
        [0, 0],
        [2, 0],
        [2, 2],
      ],
    },
    {
      name: "two",
      polygon: [
        [5, 1],
        [6, 1],
        [6, 3],
      ],
    },
  ]);
  const page = await openPage(browser, viewPage(file, "markup"));
  assert.equal(await page.textContent("h1"), "markup");
  assert.ok((await page.getAttribute(".picture", "aria-label")).startsWith(`${name} and two`));
  assert.equal(await page.evaluate(() => window.hit), undefined);
  assert.deepEqual(page.problems, []);
  await page.close();
});

/**
 * What a browser reads in a picture of pixels: how many frames, how long they take in milliseconds, which share of the
 * values of its first and last frame is another one than in the page's picture at these instants, and which share
 * differs between the two.
 */
const decoded = (page, file, type, instants) =>
  page.evaluate(
    async ([base64, type, instants]) => {
      const decoder = new ImageDecoder({
        data: await (await fetch(`data:${type};base64,${base64}`)).arrayBuffer(),
        type,
      });
      await decoder.tracks.ready;
      await decoder.completed;
      const count = decoder.tracks.selectedTrack.frameCount;
      const { player, stage } = window.taut;
      let size;
      const pixels = (picture) => {
        const canvas = Object.assign(document.createElement("canvas"), size);
        const context = canvas.getContext("2d", { alpha: false });
        context.imageSmoothingQuality = "high";
        context.drawImage(picture, 0, 0, size.width, size.height);
        return context.getImageData(0, 0, size.width, size.height).data;
      };
      const frames = [];
      let duration = 0;
      for (let frameIndex = 0; frameIndex < count; ++frameIndex) {
        const { image } = await decoder.decode({ frameIndex });
        duration += (image.duration ?? 0) / 1000;
        size = { width: image.displayWidth, height: image.displayHeight };
        if (frameIndex === 0 || frameIndex === count - 1) frames.push(pixels(image));
        image.close();
      }
      const shares = (a, b) => a.reduce((sum, v, i) => sum + (Math.abs(v - b[i]) > 24 ? 1 : 0), 0) / a.length;
      const differences = instants.map((t, k) => {
        player.seek(t);
        stage.draw();
        return shares(frames[k], pixels(stage.canvas));
      });
      return { count, duration, ...size, differences, moved: shares(frames[0], frames.at(-1)) };
    },
    [readFileSync(file).toString("base64"), type, instants],
  );

test("scene and pictures are saved, at rest and moving", async () => {
  const page = await openPage(browser, viewPage("examples/lid.json", "lid"));
  const scene = JSON.parse(readFileSync(await save(page, "#export", "viewed.json"), "utf8"));
  assert.deepEqual(
    scene.bodies.map((body) => body.name),
    ["bin", "lid"],
  );
  const lines = (file) => (readFileSync(file, "utf8").match(/#c2187a/g) ?? []).length;
  assert.equal(lines(await save(page, "#svg", "viewed.svg")), 0, "bodies alone");
  await page.keyboard.press("p");
  assert.ok(lines(await save(page, "#svg", "viewed.svg")) > 0, "with the edges between them");
  // The page does not know that it is a sweep, whose contact is at an angle.
  const same = (file, ...more) =>
    assert.ok(
      readFileSync(file, "utf8").replaceAll("contact at t = 106.602", "contact at 106.602°") ===
        run("draw", "examples/lid.json", "--animate", ...more),
      "another picture than the command's",
    );
  same(await save(page, "#moving-svg", "viewed_moving.svg"));
  await page.keyboard.press("p");
  same(await save(page, "#moving-svg", "viewed_moving.svg"), "--plain");

  await page.evaluate(() => window.taut.player.seek(50));
  const png = await decoded(page, await save(page, "#png", "viewed.png"), "image/png", [50]);
  assert.deepEqual(png.differences, [0]);
  const file = await save(page, "#gif", "viewed.gif");
  assert.equal(await shownTime(page), 50, "the instant from before is shown again");
  const ends = await page.evaluate(() => [window.taut.player.start, window.taut.player.limit]);
  const gif = await decoded(page, file, "image/gif", ends);
  assert.equal(gif.count, 76);
  assert.ok(Math.abs(gif.duration - 6000) < 1, String(gif.duration));
  assert.ok(gif.width === 720 && gif.moved > 0.01, "the lid moves");
  for (const share of gif.differences) assert.ok(share < 1e-3, String(share));
  // The list closes by itself, and by the keyboard.
  await page.click("#save summary");
  await page.keyboard.press("Escape");
  assert.equal(await page.evaluate(() => document.querySelector("#save").open), false);
  assert.deepEqual(page.problems, []);
  await page.close();
});

test("the viewer's page is the playground, too, about the same scene", async () => {
  const page = await openPage(browser, viewPage("examples/worlds/room.json", "room-to-edit"));
  await page.click("#edit");
  await page.waitForFunction(() => window.playground && window.taut.player.finished);
  assert.equal(await page.textContent("h1"), "room");
  assert.equal(await page.$("#example"), null, "there are no examples in this page");
  const t = await page.evaluate(() => window.taut.player.known);
  await page.selectOption("#body", "2");
  await page.click("#mode-keyframes");
  await page.fill("#time-end", "8");
  await page.keyboard.press("Enter");
  await page.waitForFunction(() => window.taut.player.finished && window.playground.state.scene.time[1] === 8);
  assert.equal(await page.evaluate(() => window.taut.player.known), t);
  await page.goBack();
  await page.waitForFunction(() => !window.playground && window.taut?.player.finished);
  assert.ok(await page.$("#edit"));
  assert.deepEqual(page.problems, []);
  await page.close();
});

test("names lie on no body", async () => {
  const page = await openPage(browser, viewPage("examples/lid.json", "lid"));
  // The lid lies on the bin: its name is above it, and that of the bin beside it.
  const places = await page.evaluate(() => {
    const context = document.querySelector(".picture").getContext("2d");
    const drawn = [];
    const fillText = context.fillText.bind(context);
    context.fillText = (text, x, y) => (drawn.push([text, x, y]), fillText(text, x, y));
    window.taut.stage.draw();
    const inBody = (x, y) => {
      const [r, g, b] = context.getImageData(x, y, 1, 1).data;
      return r > 150 && g < 130 && b < 90;
    };
    return drawn.filter(([text]) => text === "bin").map(([, x, y]) => inBody(x - 6, y - 4));
  });
  assert.deepEqual(places, [false]);
  assert.deepEqual(page.problems, []);
  await page.close();
});

test("two bodies of 5,000 vertices: the time that a frame takes", async (t) => {
  for (const kind of ["combs", "gears", "spiral"]) {
    const file = join(artefacts, `large-${kind}.json`);
    run("gen", kind, "-n", "5000", "-o", file);
    const sizes = JSON.parse(readFileSync(file, "utf8")).bodies.map((b) => b.polygon.length);
    assert.ok(Math.min(...sizes) >= 4990, String(sizes));
    const page = await openPage(browser, viewPage(file, `large-${kind}`));
    const times = (await page.evaluate(() => window.taut.measure(60))).sort((a, b) => a - b);
    assert.equal(times.length, 60);
    const frames = await page.evaluate(async () => {
      const { player } = window.taut;
      player.show(-1);
      player.play(true);
      const begun = performance.now();
      let count = 0;
      while (performance.now() - begun < 3000) {
        await new Promise((done) => requestAnimationFrame(done));
        ++count;
      }
      player.play(false);
      return { perSecond: count / 3, detail: window.taut.stage.painter.detail, moved: player.t > player.start };
    });
    assert.ok(frames.moved);
    const answer = check(file);
    assert.equal(await page.evaluate(() => window.taut.player.replay.count), answer.events);
    t.diagnostic(
      `${kind} (${sizes.join(" + ")} vertices, ${answer.events} events), canvas 940 x 706: to a new instant ` +
        `and down to the pixels, median ${times[30].toFixed(1)} ms, 9 of 10 below ${times[54].toFixed(1)} ms; playing, ` +
        `${frames.perSecond.toFixed(0)} frames a second at detail ${frames.detail.toFixed(2)}`,
    );
    await page.evaluate(() => window.taut.player.seek((window.taut.player.start + window.taut.player.limit) / 2));
    await screenshot(page, `large-${kind}`);
    await page.close();
  }
});
