// Colours of the picture. Blue and orange for the bodies, magenta for what joins them, teal for reflex corners: told
// apart with every common form of colour blindness; what fails and what touches is marked by shape as well.

export interface Colours {
  paper: string;
  ink: string;
  muted: string;
  line: string;
  bodyFill: [string, string];
  bodyLine: [string, string];
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
  certificates: string;
  events: string;
}

const light: Colours = {
  paper: "#ffffff",
  ink: "#16202b",
  muted: "#5b6875",
  line: "#d5dce3",
  bodyFill: ["#2f5d8a", "#b3622a"],
  bodyLine: ["#12304d", "#5e2d0c"],
  faceTint: ["58,134,200", "230,126,34"],
  root: "rgba(90,104,118,0.10)",
  tiling: "#5f6b76",
  pq: "#b8106f",
  convex: "#16202b",
  reflex: "#00796b",
  failing: "rgba(255,196,0,0.55)",
  failingEdge: "#7a5600",
  gone: "#6b7680",
  come: "#7b1fd1",
  contact: "#c4161c",
  fault: "#c4161c",
  certificates: "#b8106f",
  events: "#2f5d8a",
};

const dark: Colours = {
  paper: "#10161d",
  ink: "#e8edf2",
  muted: "#9aa8b5",
  line: "#2c3844",
  bodyFill: ["#3f7fc0", "#cf7a3a"],
  bodyLine: ["#a9d2fb", "#ffcfa3"],
  faceTint: ["74,150,220", "235,140,60"],
  root: "rgba(170,185,200,0.10)",
  tiling: "#8393a2",
  pq: "#ff6fbf",
  convex: "#f2f5f8",
  reflex: "#3fd6c0",
  failing: "rgba(255,205,40,0.45)",
  failingEdge: "#ffd54a",
  gone: "#93a1ae",
  come: "#c79bff",
  contact: "#ff6b66",
  fault: "#ff6b66",
  certificates: "#ff6fbf",
  events: "#6fb1f2",
};

export type ThemeChoice = "auto" | "light" | "dark";

export function isDark(choice: ThemeChoice): boolean {
  return choice === "dark" || (choice === "auto" && matchMedia("(prefers-color-scheme: dark)").matches);
}

export const coloursOf = (choice: ThemeChoice): Colours => (isDark(choice) ? dark : light);
