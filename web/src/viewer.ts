// The page of `taut view`: one scene, kept in the page itself. It has the playground inside, too.
import { h } from "./dom";
import { Engine, TautError, inParts, type Scene } from "./engine";
import { FaultMessage } from "./faultmessage";
import { Player } from "./player";
import { Playground } from "./playground";
import type { Asked } from "./questions";
import { SaveMenu } from "./saving";
import { Workbench } from "./workbench";

interface Data {
  touch: "open" | "closed";
  at?: number;
  title?: string;
  /** Questions that are asked from the beginning. */
  ask?: Asked;
  scene: Scene;
}

/** With this behind its address, or with a scene as the playground shares it, the page is the playground. */
const playgroundMark = "#playground";
const isPlayground = (): boolean => location.hash === playgroundMark || location.hash.startsWith("#s=");

function viewer(player: Player, data: Data): void {
  const workbench = new Workbench(player);
  workbench.title = data.title ?? null;
  workbench.questions.asked = data.ask ?? {};
  const message = new FaultMessage();
  const menu = new SaveMenu(workbench, {
    name: () => data.title ?? "scene",
    scene: () => data.scene,
    refuse: (error, what) => message.show(error, what),
  });
  const edit = h(
    "a",
    { class: "button", id: "edit", href: playgroundMark, title: "Change the scene, in this page" },
    "Open in playground",
  );
  workbench.headerTools.append(menu.element, edit);
  workbench.stage.element.append(message.element);
  player.open(inParts(data.scene), data.touch === "closed", data.at);
  document.body.replaceChildren(workbench.element);
  workbench.opened();
  Object.assign(window, { taut: workbench });
}

async function main(): Promise<void> {
  const data = JSON.parse(document.getElementById("taut-data")!.textContent!) as Data;
  const player = new Player(await Engine.load());
  const was = isPlayground();
  addEventListener("hashchange", () => {
    if (isPlayground() !== was) location.reload();
  });
  if (!was) return viewer(player, data);
  const playground = new Playground(player);
  document.body.replaceChildren(playground.element);
  await playground.begin({ scene: data.scene, touch: data.touch, title: data.title ?? null });
}

main().catch((error: unknown) => {
  const lines = error instanceof TautError ? [error.message, error.fault.hint] : [String(error)];
  document.body.replaceChildren(
    h("main", { class: "fatal" }, h("h1", {}, "This scene cannot be shown"), ...lines.map((l) => h("p", {}, l))),
  );
});
