// The directions in which a body can leave, as a rose: an SVG picture, whose y goes up as in the scene.
import type { DirectionArc, FreeDirections } from "./questions";
import { roundText } from "./words";

const radius = 40;

function shape(name: string, attributes: Record<string, string | number>): SVGElement {
  const element = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, String(value));
  return element;
}

const middleOf = ([lo, hi]: [number, number]): number => lo + (hi - lo) / 2;

/** From where to where an arc goes, the second angle no less than the first. */
export function spanOf({ from_deg, to_deg }: DirectionArc): [number, number] {
  const from = middleOf(from_deg);
  const to = middleOf(to_deg);
  return [from, to < from ? to + 360 : to];
}

const at = (degrees: number, r: number): string => {
  const a = (degrees * Math.PI) / 180;
  return `${(r * Math.cos(a)).toFixed(3)} ${(-r * Math.sin(a)).toFixed(3)}`;
};

/** From 0 to below 360, also where rounding comes to 360. */
const degreesText = (degrees: number): string => roundText(Number(roundText(degrees, 9)) % 360, 9);

/** In degrees, for people: "90" or "258.699 to 281.301". */
export function arcText(arc: DirectionArc): string {
  const [from, to] = spanOf(arc);
  return arc.point ? degreesText(from) : `${degreesText(from)} to ${degreesText(to)}`;
}

export function rose({ body, all, directions }: FreeDirections): SVGElement {
  const svg = shape("svg", { viewBox: "-50 -50 100 100", class: "rose", role: "img" });
  const free = all ? "every direction" : directions.length === 0 ? "none" : directions.map(arcText).join(", ");
  svg.setAttribute("aria-label", `Free directions of ${body}, in degrees: ${free}`);
  svg.append(shape("circle", { r: radius, class: all ? "rose-free" : "rose-blocked" }));
  if (!all) {
    for (const arc of directions) {
      const [from, to] = spanOf(arc);
      if (arc.point || to - from < 0.5) {
        svg.append(shape("path", { d: `M0 0L${at(middleOf([from, to]), radius)}`, class: "rose-line" }));
        continue;
      }
      const large = to - from > 180 ? 1 : 0;
      const d = `M0 0L${at(from, radius)}A${radius} ${radius} 0 ${large} 0 ${at(to, radius)}Z`;
      svg.append(shape("path", { d, class: "rose-free" }));
    }
  }
  for (const degrees of [0, 90, 180, 270])
    svg.append(shape("path", { d: `M${at(degrees, radius)}L${at(degrees, radius + 4)}`, class: "rose-tick" }));
  return svg;
}
