/** What taut refuses, or cannot decide: `kind` is "input", "undecided" or "internal". */
export class TautError extends Error {
  constructor({ kind, place, problem, hint }) {
    super((place ? `${place}: ` : "") + problem + (hint ? `\nhint: ${hint}` : ""));
    this.name = "TautError";
    this.kind = kind;
    this.place = place;
    this.problem = problem;
    this.hint = hint;
  }
}
