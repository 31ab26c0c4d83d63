// What is wrong with a scene or a file, in words over the picture.
import { h } from "./dom";
import { TautError } from "./engine";
import type { Culprit, FaultMarks } from "./frame";

export class FaultMessage {
  readonly element = h("div", { class: "message", role: "alert", hidden: true, id: "message" });

  show(error: unknown, prefix = ""): void {
    const lines = error instanceof TautError ? [prefix, error.message, error.fault.hint] : [prefix, String(error)];
    this.element.replaceChildren(...lines.filter((l) => l).map((l) => h("p", {}, l)));
    this.element.hidden = false;
  }

  hide(): void {
    this.element.hidden = true;
  }
}

/** The culprits, to be marked in the picture. */
export function culprits(error: unknown): FaultMarks[] {
  if (!(error instanceof TautError) || error.fault.body < 0) return [];
  const { body, vertices, edges, vertexRings, edgeRings } = error.fault;
  const located = (indices: number[], rings: [number, number][]): Culprit[] =>
    indices.map((index, k) => ({ part: rings[k][0], ring: rings[k][1], index }));
  return [{ body, vertices: located(vertices, vertexRings), edges: located(edges, edgeRings) }];
}
