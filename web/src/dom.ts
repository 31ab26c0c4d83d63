// Small helpers for building pages.

type Child = Node | string | null | undefined;

/** An element; attributes that begin with "on" are listeners, `true` sets a bare attribute. */
export function h<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  attributes: Record<string, unknown> = {},
  ...children: Child[]
): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (name.startsWith("on")) element.addEventListener(name.slice(2), value as EventListener);
    else if (value === true) element.setAttribute(name, "");
    else if (value !== false && value !== undefined && value !== null) element.setAttribute(name, String(value));
  }
  for (const child of children) if (child !== null && child !== undefined) element.append(child);
  return element;
}

/** A sample of a colour of the picture. */
export function swatch(name: string, shape = ""): HTMLElement {
  return h("i", { class: `swatch ${shape} c-${name}`, "aria-hidden": "true" });
}

/** Icons of 20 by 20, drawn for this page. */
const paths = {
  play: "M6 4l10 6-10 6z",
  pause: "M5 4h4v12H5zM11 4h4v12h-4z",
  next: "M4 4l8 6-8 6zM13 4h3v12h-3z",
  previous: "M16 4l-8 6 8 6zM4 4h3v12H4z",
  first: "M17 4l-6 6 6 6zM10 4l-6 6 6 6zM2 4h1.8v12H2z",
  last: "M3 4l6 6-6 6zM10 4l6 6-6 6zM16.2 4H18v12h-1.8z",
  plus: "M9 4h2v5h5v2h-5v5H9v-5H4V9h5z",
  minus: "M4 9h12v2H4z",
  // A frame around what is in it; full screens have open corners.
  fit: "M2.5 4h15v12h-15zM4.2 5.7v8.6h11.6V5.7zM7 8h6v4H7z",
  // A disc, half of it dark.
  theme: "M10 2a8 8 0 1 1 0 16 8 8 0 0 1 0-16zM10 3.8a6.2 6.2 0 1 0 0 12.4z",
  help: "M10 2a8 8 0 1 1 0 16 8 8 0 0 1 0-16zm0 1.8a6.2 6.2 0 1 0 0 12.4 6.2 6.2 0 0 0 0-12.4zM9.2 13.2h1.7v1.7H9.2zM10 5.4c1.8 0 3 1.1 3 2.6 0 1.1-.6 1.7-1.3 2.2-.6.4-.8.7-.8 1.3v.5H9.2v-.7c0-1.2.6-1.8 1.3-2.3.5-.4.7-.6.7-1 0-.6-.5-1-1.2-1s-1.3.4-1.3 1.2H7c0-1.7 1.2-2.8 3-2.8z",
} as const;
export type Icon = keyof typeof paths;

export function icon(name: Icon): SVGSVGElement {
  const svg = document.createElementNS("http://www.w3.org/2000/svg", "svg");
  svg.setAttribute("viewBox", "0 0 20 20");
  svg.setAttribute("aria-hidden", "true");
  const path = document.createElementNS("http://www.w3.org/2000/svg", "path");
  path.setAttribute("d", paths[name]);
  svg.append(path);
  return svg;
}

export function iconButton(name: Icon, label: string, action: () => void, shortcut = ""): HTMLButtonElement {
  const title = shortcut ? `${label} (${shortcut})` : label;
  return h("button", { type: "button", class: "icon", "aria-label": label, title, onclick: action }, icon(name));
}

export function setIcon(button: HTMLButtonElement, name: Icon, label: string, shortcut = ""): void {
  if (button.dataset.icon === name) return;
  button.dataset.icon = name;
  button.replaceChildren(icon(name));
  button.setAttribute("aria-label", label);
  button.title = shortcut ? `${label} (${shortcut})` : label;
}

/** Sizes a canvas to its box in device pixels; returns the ratio. */
export function fitCanvas(canvas: HTMLCanvasElement, width: number, height: number): number {
  const ratio = Math.min(window.devicePixelRatio || 1, 2);
  const w = Math.max(1, Math.round(width * ratio));
  const ht = Math.max(1, Math.round(height * ratio));
  if (canvas.width !== w) canvas.width = w;
  if (canvas.height !== ht) canvas.height = ht;
  return ratio;
}
