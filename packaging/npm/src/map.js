// One body among many that rest: a map, prepared once and asked often.
import { bodyScene, collected, functionsOf, motionScene, optionsText, sceneText } from "./object.js";

const making = Symbol("making");

/** A shape that moves among the bodies of a map: what StaticMap.prepare() gives. */
class Mover {
  constructor(map, number, name) {
    Object.assign(this, { map, number, name });
    Object.freeze(this);
  }
}

/** Bodies at rest. objects.d.ts says what its members mean. */
export class StaticMap {
  #functions;
  #id;
  #names;

  static async create(bodies, { reach = 0 } = {}) {
    const text = sceneText({ format: "taut-scene/1", time: [0, 0], bodies });
    return new StaticMap(making, await functionsOf("taut_map"), text, reach);
  }

  constructor(secret, functions, text, reach) {
    if (secret !== making) throw new TypeError("write await StaticMap.create(bodies)");
    this.#functions = functions;
    const id = functions("open", [text], reach);
    this.#id = id;
    this.#names = JSON.parse(text).bodies.map(({ name }) => name);
    collected.register(this, () => functions("close", [], id), this);
  }

  prepare({ motion, relative_to, ...body }) {
    if (this.#names.includes(body.name))
      throw new RangeError(`a body of the map is called ${JSON.stringify(body.name)}`);
    return new Mover(this, this.#functions("prepare", [bodyScene(body, [0, 0])], this.#id), body.name);
  }

  #ask(name, mover, motion, time, options) {
    if (mover?.map !== this) throw new TypeError("the mover was not prepared for this map");
    return this.#functions(name, [motionScene(motion, time), optionsText(options)], this.#id, mover.number);
  }

  check(mover, motion, time, options = {}) {
    const answer = this.#ask("check", mover, motion, time, options);
    answer.scope.bodies = [...this.#names, mover.name];
    return answer;
  }

  overlapped(mover, motion, t = 0, options = {}) {
    const found = this.#ask("overlapped", mover, motion, [t, t], options);
    return found < 0 ? null : this.#names[found];
  }

  free() {
    collected.unregister(this);
    this.#functions("close", [], this.#id);
  }
}
