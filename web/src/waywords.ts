// What is said of ways.
import type { Feature } from "./engine";
import type { FoundWay, WayJoint, WayProblem } from "./wayproblem";
import type { Verdict } from "./workbench";
import { featureText, roundText } from "./words";

const counted = (n: number): string => `${n.toLocaleString("en")} ${n === 1 ? "cell" : "cells"}`;

/** Within what: a proof that there is none holds no farther. */
function rangesText(problem: WayProblem): string {
  const text = ({ name, range, periodic }: WayJoint): string =>
    periodic ? `any ${name}` : `${name} from ${roundText(range[0])} to ${roundText(range[1])}`;
  return problem.read.joints.map(text).join(", ");
}

const lengthText = ({ way, shortest_at_least: least }: { way: number; shortest_at_least: number }): string =>
  `It is ${roundText(way)} long; no way is shorter than ${roundText(least)}.`;

export function wayVerdict(problem: WayProblem | null, found: FoundWay | null, fault: string[] | null): Verdict {
  if (fault) return { headline: "No answer", outcome: "invalid", lines: fault };
  if (!problem) return { headline: "No problem", outcome: "invalid", lines: [] };
  if (!found)
    return { headline: "Looking for a way", outcome: "running", lines: ["Start and goal can be moved meanwhile."] };
  const { answer } = found;
  const by = answer.exact ? "Decided by exact signs." : `Decided with ${counted(answer.cell_count)}.`;
  if (answer.outcome === "path") {
    const count = answer.waypoints!.length;
    return {
      headline: "There is a way",
      outcome: "free",
      lines: [
        `Every instant of it is proved free: ${count} waypoints, evenly from each to the next. ${by}`,
        ...(answer.length ? [lengthText(answer.length)] : []),
      ],
    };
  }
  if (answer.outcome === "none") {
    const proof = answer.exact
      ? "by exact signs"
      : `by a partition of all joint values into ${counted(answer.cell_count)}`;
    return {
      headline: "There is no way",
      outcome: "contact",
      lines: [`No motion of any shape leads there: proved ${proof}.`, `Within ${rangesText(problem)}.`],
    };
  }
  const { tight, reason = "" } = answer;
  const place = tight
    ? `${tight.pair.join(" and ")} have too little room where ${Object.entries(tight.values)
        .map(([name, value]) => `${name} = ${roundText(value)}`)
        .join(", ")}: see the picture.`
    : "";
  const text = (feature: Feature, edge: boolean): string =>
    featureText(feature, problem.read.bodies.find(({ name }) => name === feature.body)!.parts, edge);
  const between = (tight?.features ?? []).map(
    ({ vertex, edge }) => `Between ${text(vertex, false)} and ${text(edge, true)}.`,
  );
  return { headline: "Undecided", outcome: "undecided", lines: [reason, place, ...between, by].filter(Boolean) };
}
