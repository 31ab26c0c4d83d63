// What the playground does to the bodies of a scene as a whole.
import type { Editor } from "./editing";
import type { Scene } from "./engine";
import { heightsText } from "./heights";
import type { Player } from "./player";
import type { Workbench } from "./workbench";
import {
  withBody,
  withHeights,
  withHole,
  withIgnored,
  withName,
  withoutBody,
  withoutIgnored,
  withParent,
} from "./worldedits";
import { WorldPanel } from "./worldpanel";

export interface WorldEditingHost {
  /** Takes up the scene, chooses the body, and says what was done. */
  change(scene: Scene, note: string, body: number): void;
  say(note: string): void;
}

export class WorldEditing {
  readonly panel: WorldPanel;

  constructor(
    private readonly player: Player,
    private readonly editor: Editor,
    private readonly workbench: Workbench,
    private readonly host: WorldEditingHost,
  ) {
    this.panel = new WorldPanel({
      rename: (name) => this.rename(name.trim()),
      addBody: () => this.addBody(),
      removeBody: () => this.removeBody(),
      cutHole: () => this.cutHole(),
      setParent: (name) => this.setParent(name),
      setHeights: (z) => {
        const { scene, body } = this.editor;
        this.host.change(
          withHeights(scene, body, z),
          `${scene.bodies[body].name} reaches through ${heightsText(z)}.`,
          body,
        );
      },
      ignore: (other) => {
        const { scene, body } = this.editor;
        this.host.change(withIgnored(scene, scene.bodies[body].name, other), "", body);
      },
    });
    workbench.tree.host.askAgain = (k) => this.host.change(withoutIgnored(this.editor.scene, k), "", this.editor.body);
  }

  private rename(name: string): void {
    const { scene, body } = this.editor;
    const before = scene.bodies[body].name;
    if (name === "" || name === before) return this.panel.show(scene, body);
    this.host.change(withName(scene, body, name), `${before} has another name.`, body);
  }

  /** In the middle of the view, a sixteenth of it wide. */
  private addBody(): void {
    const { camera } = this.workbench.stage;
    const at = camera.world(camera.width / 2, camera.height / 2);
    const scene = withBody(this.editor.scene, at, Math.min(camera.width, camera.height) / 16 / camera.scale);
    const index = scene.bodies.length - 1;
    this.host.change(scene, `${scene.bodies[index].name} is there. Drag it by Shape, and give it keyframes.`, index);
  }

  private removeBody(): void {
    const { scene, body } = this.editor;
    if (scene.bodies.length < 2) return;
    this.workbench.stage.hidden.clear();
    this.host.change(withoutBody(scene, body), `${scene.bodies[body].name} is gone.`, Math.max(0, body - 1));
  }

  private cutHole(): void {
    const { scene, body } = this.editor;
    const { name } = scene.bodies[body];
    const inner = this.innerOf(body);
    if (!inner || !(inner[2] > 0)) return this.host.say(`No room for a hole was found in ${name}.`);
    this.host.change(withHole(scene, body, inner), `${name} has a hole where it has most room.`, body);
  }

  /** Null while the scene is not valid. */
  private innerOf(body: number): [number, number, number, number] | null {
    try {
      return this.player.engine.shapes(JSON.stringify(this.editor.scene)).inner[body];
    } catch {
      return null;
    }
  }

  private setParent(name: string | null): void {
    const { scene, body } = this.editor;
    const own = scene.bodies[body].name;
    const { scene: changed, stays } = withParent(scene, body, name, this.player.engine.poses(scene.time[0]));
    const note = name === null ? `${own} is seen from the world.` : `${own} moves with ${name}.`;
    const jump = stays ? "" : " Its motion is a formula, which is now seen from there: it may start elsewhere.";
    this.host.change(changed, note + jump, body);
  }
}
