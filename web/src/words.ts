// What things are called.
import type { Answer, Body, Coverage, Feature, Lock, Ring, Scene } from "./engine";
import { partsOf } from "./shapes";
import type { MapEvent, Repair } from "./replay";

export const repairNames: Record<Repair, string> = {
  convex_flip: "convex, flip",
  convex_triangle: "convex, triangle",
  reflex_a: "reflex, case (a)",
  reflex_b: "reflex, case (b)",
  reflex_c: "reflex, case (c)",
  collision: "contact",
};

const stories: Record<Repair, string> = {
  convex_flip: "A convex corner has closed. Its longer edge goes; an edge between the far ends comes.",
  convex_triangle: "A convex corner has closed, and with it the whole triangle. Its longest edge goes.",
  reflex_a: "A reflex corner has straightened. Case (a): the edge u-w comes and cuts off a new triangle.",
  reflex_b: "A reflex corner has straightened. Case (b): the edge v-w goes, u-w comes.",
  reflex_c: "A reflex corner has straightened. Case (c): the edge u-v goes, u-w comes.",
  collision: "A vertex has reached an edge of the other body: the contact.",
};

export function story(event: MapEvent): string {
  let s = stories[event.repair];
  if (event.pinchRule) s += " A pinch edge decided the case.";
  if (event.threeCorners) s += " All three corners of the triangle failed at once.";
  if (event.bridging) s += " It happened while the gap between two pieces of the motion was bridged.";
  return s;
}

const shortest = (x: number): string => {
  const s = x.toPrecision(17);
  if (s.includes("e") || !s.includes(".")) return s.replace(/\.?0+(?=e|$)/, (m) => (m.includes(".") ? "" : m));
  return s.replace(/\.?0+$/, "");
};

/** The digits that both ends of an enclosure share, as `taut check` writes them. */
export function timeText(lo: number, hi: number): string {
  if (lo === hi) return String(lo);
  const a = shortest(lo);
  const b = shortest(hi);
  let n = 0;
  while (n < a.length && a[n] === b[n]) ++n;
  const common = a.slice(0, n);
  const digits = common.replace(/\D/g, "").length;
  if (digits < 5 || !common.includes(".") || a.includes("e") || b.includes("e")) return `[${lo}, ${hi}]`;
  return common + "…";
}

/** About `digits` digits, for tables. */
export function roundText(x: number, digits = 6): string {
  return String(Number(x.toPrecision(digits)));
}

/** A fixed number of decimals that suits the scene's time. */
export function clockText(t: number, scene: Scene): string {
  const whole = scene.time[1] - scene.time[0];
  const decimals = Math.min(12, Math.max(0, 4 - Math.floor(Math.log10(whole || 1))));
  return t.toFixed(decimals);
}

/** The number of pairs about which an answer says nothing. */
export const untested = (c: Coverage): number => c.ignored + c.moving_alike + c.at_rest + c.layers + c.not_reached;

export function headline(answer: Answer, running: boolean): string {
  switch (answer.outcome) {
    case "free":
      return untested(answer.coverage) > 0 ? "Free, of what was tested" : "Free";
    case "untested":
      return "Nothing was tested";
    case "contact":
      return `Contact at t = ${timeText(...answer.t!)}`;
    case "locked":
      return `Locks at t = ${timeText(...answer.lock!.t)}`;
    case "overlap_at_start":
      return "Overlap at the start";
    case "undecided":
      return running ? "Working" : "Undecided";
  }
}

/** Which ring of a body of several; empty for others. */
export function ringText({ part = 0, ring = 0 }: { part?: number; ring?: number }, parts: number): string {
  return (ring > 0 ? `hole ${ring} of ` : "") + (parts > 1 ? `part ${part} of ` : "");
}

/** By how much the bodies of a contact are turned then; empty if they are not. */
export function turnedText(player: {
  scene: Scene;
  status: { answer: Answer };
  known: number;
  engine: { poses(t: number): { c: number; s: number }[] };
}): string {
  const { contact } = player.status.answer;
  if (!contact) return "";
  const poses = player.engine.poses(player.known);
  const turned = [...new Set([contact.vertex.body, contact.edge.body])].flatMap((name) => {
    const pose = poses[player.scene.bodies.findIndex((body) => body.name === name)];
    const degrees = pose ? (Math.atan2(pose.s, pose.c) * 180) / Math.PI : 0;
    return Math.abs(degrees) < 1e-9 ? [] : [`${name} by ${roundText(degrees, 6)}°`];
  });
  return turned.length > 0 ? `Turned there: ${turned.join(", ")}.` : "";
}

/** `parts`: of each part the outline, then its holes. */
export function featureText(feature: Feature, parts: Ring[][], edge: boolean): string {
  const { part = 0, ring = 0, index, at } = feature;
  if (at !== undefined)
    return `segment ${index} (at ${roundText(at)}) of ${ringText(feature, parts.length)}${feature.body}`;
  const what = edge ? `edge ${index}-${(index + 1) % parts[part][ring].length}` : `vertex ${index}`;
  return `${what} of ${ringText(feature, parts.length)}${feature.body}`;
}

/** Which pairs were tested, and which were not; empty if there is one pair and it was tested. */
export function coverageText(c: Coverage): string {
  if (c.pairs === 1 && untested(c) === 0) return "";
  const some = (count: number, what: string): string[] => (count > 0 ? [`${count} ${what}`] : []);
  const said = [`${c.tested} tested`, ...some(c.apart, "apart by their boxes")].join(", ");
  const not = [
    ...some(c.ignored, "ignored"),
    ...some(c.at_rest, "at rest"),
    ...some(c.moving_alike, "moving alike"),
    ...some(c.layers, "on different layers"),
    ...some(c.not_reached, "not reached"),
  ];
  return `${c.pairs} ${c.pairs === 1 ? "pair" : "pairs"}: ${said}${not.length > 0 ? `; not tested: ${not.join(", ")}` : ""}.`;
}

const capital = (text: string): string => text.charAt(0).toUpperCase() + text.slice(1);

/** How well curves were known. */
function geometryLine({ geometry }: Answer): string {
  if (!geometry) return "";
  const { tolerance, segments } = geometry;
  return `Curves known to ${tolerance.toPrecision(3)}, by ${segments} straight edges.`;
}

/** As `taut check` says it; empty where it is not known whether it locks. */
function lockLine(lock: Lock | undefined): string {
  if (!lock || lock.kind === "undecided") return "";
  const free =
    lock.joints.length > 0 ? `; joints that could move there with the drives held: ${lock.joints.join(", ")}` : "";
  return `The mechanism locks at t = ${timeText(...lock.t)} (${lock.kind}): ${lock.links.join(", ")} in line${free}.`;
}

/** What is to be said of a world besides: the pair, those that come with it, and how many were asked about. */
function worldLines(answer: Answer): string[] {
  const also = (answer.also ?? []).map((pair) => `Also ${pair.bodies.join(" x ")}.`);
  return [lockLine(answer.lock), coverageText(answer.coverage), ...also, geometryLine(answer)];
}

/** What the picture of a world shows of tilings. */
export const aboutTilings = (curved: boolean): string =>
  curved
    ? "There is no tiling in this picture: taut has none of curves. Its other engine has answered."
    : "The lines are the tilings of the pairs that are near at this instant.";

export function explanation(answer: Answer, scene: Scene, freeUntil: number, running: boolean): string[] {
  const [start, end] = scene.time;
  const touch = answer.scope.touch === "closed" ? ", touching included" : "";
  switch (answer.outcome) {
    case "free":
      return [`Proved free of contact on [${start}, ${end}]${touch}.`, ...worldLines(answer)];
    case "locked":
      return [`Proved free of contact until there, on [${start}, ${freeUntil}]${touch}.`, ...worldLines(answer)];
    case "contact": {
      const { vertex, edge, point } = answer.contact!;
      const bodyOf = (f: Feature): Body => scene.bodies.find((b) => b.name === f.body)!;
      return [
        answer.pair ? `${answer.pair.join(" and ")} meet.` : "",
        `${capital(featureText(vertex, partsOf(bodyOf(vertex)), false))} meets ${featureText(edge, partsOf(bodyOf(edge)), true)} ` +
          `at (${roundText(point[0], 9)}, ${roundText(point[1], 9)}).`,
        ...(answer.grazing
          ? [`Grazing: whether they overlap or just touch is too close to tell until t = ${answer.t![1]}.`]
          : []),
        `Proved free on [${start}, ${answer.t![0]})${touch}. The scene's time ends at ${end}.`,
        ...worldLines(answer),
      ];
    }
    case "overlap_at_start":
      return [`${answer.pair!.join(" and ")} overlap already when the motion starts.`, ...worldLines(answer)];
    case "untested":
      return [answer.reason ?? ""];
    case "undecided":
      return running
        ? [`Free so far, until t = ${roundText(freeUntil)}.`]
        : [answer.reason ?? "", `Free until ${freeUntil}.`, ...worldLines(answer)];
  }
}
