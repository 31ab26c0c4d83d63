// The page of the playground.
import { h } from "./dom";
import { Engine } from "./engine";
import { Player } from "./player";
import { Playground } from "./playground";

async function main(): Promise<void> {
  const playground = new Playground(new Player(await Engine.load()));
  document.body.replaceChildren(playground.element);
  await playground.begin();
}

main().catch((error: unknown) => {
  document.body.replaceChildren(
    h("main", { class: "fatal" }, h("h1", {}, "The playground cannot start"), h("p", {}, String(error))),
  );
});
