// The keys, and what is seen in a few words.
import { h } from "./dom";

const keys: [string, string][] = [
  ["Space", "play or pause"],
  ["→ ←", "next or previous event"],
  ["Shift → ←", "a hundredth of the time on or back"],
  ["Home End", "start, or contact, lock or end"],
  ["+ − 0", "zoom in, zoom out, show everything"],
  ["w a s d", "move the view"],
  ["z", "zoom to the event or the contact; once more, to where curves are bands"],
  ["p", "show the proof, or the bodies alone"],
  ["f e c v b", "faces, edges of the tiling, corners, vertices, bands around curves"],
  ["t", "light or dark"],
  ["?", "this list"],
];

export function helpDialog(moreKeys: [string, string][]): HTMLDialogElement {
  const list = h("dl", { class: "keys" });
  for (const [key, what] of [...keys, ...moreKeys]) list.append(h("dt", {}, key), h("dd", {}, what));
  return h(
    "dialog",
    { "aria-label": "Keys" },
    h("h2", {}, "Keys"),
    list,
    h("p", {}, "Drag to move the view, scroll or pinch to zoom, double-click to show everything."),
    h(
      "p",
      {},
      "With the proof, bold edges join the two bodies. Only corners at such an edge can fail; each has a certificate, whose " +
        "failure is an event. While no corner fails, the bodies cannot touch.",
    ),
    h("form", { method: "dialog" }, h("button", {}, "Close")),
  );
}
