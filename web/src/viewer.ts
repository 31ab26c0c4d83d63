// The page of `taut view`: one scene, kept in the page itself.
import { h } from "./dom";
import { Engine, TautError, inParts, type Scene } from "./engine";
import { saveFile } from "./openandsave";
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
  const name = data.title ?? "scene";
  const tool = (id: string, label: string, title: string, action: () => void): HTMLElement =>
    h("button", { type: "button", id, title, onclick: action }, label);
  workbench.headerTools.append(
    tool("export", "Save scene", "The scene as a file for taut", () =>
      saveFile(JSON.stringify(data.scene, null, 1), `${name}.json`, "application/json"),
    ),
    tool("svg", "Save SVG", "The instant shown as a picture", () =>
      saveFile(player.engine.svg(player.t), `${name}.svg`, "image/svg+xml"),
    ),
  );
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
