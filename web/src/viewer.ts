// The page of `taut view`: one scene, kept in the page itself.
import { h } from "./dom";
import { Engine, TautError, inParts, type Scene } from "./engine";
import { Player } from "./player";
import type { Asked } from "./questions";
import { Workbench } from "./workbench";

interface Data {
  touch: "open" | "closed";
  at?: number;
  title?: string;
  /** Questions that are asked from the beginning. */
  ask?: Asked;
  scene: Scene;
}

async function main(): Promise<void> {
  const data = JSON.parse(document.getElementById("taut-data")!.textContent!) as Data;
  const player = new Player(await Engine.load());
  const workbench = new Workbench(player);
  workbench.title = data.title ?? null;
  workbench.questions.asked = data.ask ?? {};
  player.open(inParts(data.scene), data.touch === "closed", data.at);
  document.body.replaceChildren(workbench.element);
  workbench.opened();
  Object.assign(window, { taut: workbench });
}

main().catch((error: unknown) => {
  const lines = error instanceof TautError ? [error.message, error.fault.hint] : [String(error)];
  document.body.replaceChildren(
    h("main", { class: "fatal" }, h("h1", {}, "This scene cannot be shown"), ...lines.map((l) => h("p", {}, l))),
  );
});
