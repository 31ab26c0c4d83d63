// Colours of the picture. Blue and orange for the bodies, magenta for what joins them, teal for reflex corners: told
// apart with every common form of colour blindness; what fails and what touches is marked by shape as well.

export interface Colours {
  paper: string;
  ink: string;
  muted: string;
  line: string;
  bodyFill: string[];
  bodyLine: string[];
  /** Around bodies; empty: a darker shade of each one's own. */
  worldLine: string;
  /** Around curves: what their polygons leave between them. */
  band: string;
  bandLine: string;
  /** Red, green and blue, for faces in many strengths. */
  faceTint: [string, string];
  root: string;
  tiling: string;
  pq: string;
  convex: string;
  reflex: string;
  failing: string;
  failingEdge: string;
  gone: string;
  come: string;
  contact: string;
  fault: string;
  /** Where a mechanism stops. */
  lock: string;
  /** Where bodies are closest, and the least distance. */
  nearest: string;
  /** A distance, and what is free. */
  distance: string;
  free: string;
  certificates: string;
  events: string;
}

/** Each on light and on dark paper. */
const palette: { [Name in keyof Colours]: [Colours[Name], Colours[Name]] } = {
  paper: ["#ffffff", "#10161d"],
  ink: ["#16202b", "#e8edf2"],
  muted: ["#5b6875", "#9aa8b5"],
  line: ["#d5dce3", "#2c3844"],
  bodyFill: [
    ["#2a6f9e", "#e59345"],
    ["#2a6f9e", "#e59345"],
  ],
  bodyLine: [
    ["#032e4b", "#683e15"],
    ["#a9d2fb", "#ffcfa3"],
  ],
  worldLine: ["", "#dfe6ec"],
  band: ["rgba(255,190,0,0.42)", "rgba(255,205,40,0.42)"],
  bandLine: ["#16202b", "#e8edf2"],
  faceTint: [
    ["58,134,200", "230,126,34"],
    ["74,150,220", "235,140,60"],
  ],
  root: ["rgba(90,104,118,0.10)", "rgba(170,185,200,0.10)"],
  tiling: ["#5f6b76", "#8393a2"],
  pq: ["#b8106f", "#ff6fbf"],
  convex: ["#16202b", "#f2f5f8"],
  reflex: ["#00796b", "#3fd6c0"],
  failing: ["rgba(255,196,0,0.55)", "rgba(255,205,40,0.45)"],
  failingEdge: ["#7a5600", "#ffd54a"],
  gone: ["#6b7680", "#93a1ae"],
  come: ["#7b1fd1", "#c79bff"],
  contact: ["#c4161c", "#ff6b66"],
  fault: ["#c4161c", "#ff6b66"],
  lock: ["#7a5600", "#ffd54a"],
  nearest: ["#7b1fd1", "#c79bff"],
  distance: ["#2f5d8a", "#6fb1f2"],
  free: ["#0f6b4f", "#5ad1a5"],
  certificates: ["#b8106f", "#ff6fbf"],
  events: ["#2f5d8a", "#6fb1f2"],
};

function shade(dark: 0 | 1): Colours {
  const chosen = Object.entries(palette).map(([name, both]) => [name, both[dark]]);
  return Object.fromEntries(chosen) as Colours;
}
const light = shade(0);
const dark = shade(1);

/** Of two bodies, as the library has those of many: fill, line, and what is written on the fill. */
export const pairStyles: [string, string, string][] = [
  ["#2a6f9e", "#032e4b", "#fff"],
  ["#e59345", "#683e15", "#000"],
];

/** For handles on a body, whichever it is. */
export const lineOf = (colours: Colours, body: number): string => colours.bodyLine[body] ?? colours.ink;

export type ThemeChoice = "auto" | "light" | "dark";

export function isDark(choice: ThemeChoice): boolean {
  return choice === "dark" || (choice === "auto" && matchMedia("(prefers-color-scheme: dark)").matches);
}

export const coloursOf = (choice: ThemeChoice): Colours => (isDark(choice) ? dark : light);
