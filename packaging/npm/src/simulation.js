// Simulations: the kinetic data structure, advanced in time, with plans that may change.
import { bodyScene, collected, functionsOf, motionScene, optionsText, sceneText } from "./object.js";

const making = Symbol("making");

/** check() online. objects.d.ts says what its members mean. */
export class Simulation {
  #functions;
  #id;
  #standing;
  #time;
  /** Of bodies by their numbers; those that were removed keep theirs. */
  #bodies;

  static async create(scene, options = {}) {
    const text = sceneText(scene);
    const functions = await functionsOf("taut_simulation");
    return new Simulation(making, functions, text, options);
  }

  constructor(secret, functions, text, options) {
    if (secret !== making) throw new TypeError("write await Simulation.create(scene)");
    this.#functions = functions;
    const { value, standing } = functions("open", [text, optionsText(options)]);
    this.#id = value;
    this.#standing = standing;
    const { time, bodies } = JSON.parse(text);
    this.#time = time;
    this.#bodies = bodies.map(({ name }) => name);
    collected.register(this, () => functions("close", [], value), this);
  }

  #call(name, texts = [], ...numbers) {
    const { value, standing } = this.#functions(name, texts, this.#id, ...numbers);
    this.#standing = standing;
    return value;
  }

  #place(name) {
    const place = this.#bodies.indexOf(name);
    if (place < 0) throw new RangeError(`there is no body ${JSON.stringify(name)}`);
    return place;
  }

  get state() {
    return this.#standing.state;
  }
  get reason() {
    return this.#standing.reason ?? "";
  }
  get time() {
    return this.#standing.time;
  }
  get events() {
    return this.#standing.events;
  }
  get certificates() {
    return this.#standing.certificates;
  }
  get certificatesMax() {
    return this.#standing.certificates_max;
  }
  get contact() {
    return this.#standing.contact ?? null;
  }
  get contactAgain() {
    return this.#standing.contact_again;
  }
  get contacts() {
    return this.#standing.contacts;
  }
  get pair() {
    return this.#standing.pair ?? null;
  }
  get also() {
    return this.#standing.also;
  }
  get overlapPoint() {
    return this.#standing.overlap_point ?? null;
  }
  get coverage() {
    return this.#standing.coverage;
  }

  nextEvent() {
    return this.#call("next_event");
  }
  step() {
    return this.#call("step");
  }
  advanceTo(t) {
    this.#call("advance", [], t);
    return this.state;
  }
  resume() {
    this.#call("resume");
    return this.state;
  }
  stop(name, { gap = 0 } = {}) {
    this.#call("stop", [], this.#place(name), gap);
  }
  push(name, { hinge, direction, step, gap = 0 }) {
    if ((hinge === undefined) === (direction === undefined)) throw new TypeError("give a hinge or a direction");
    const [x, y] = hinge ?? direction;
    this.#call("push", [], this.#place(name), hinge ? 1 : 0, x, y, step, gap);
  }
  setMotion(name, motion) {
    this.#call("set_motion", [motionScene(motion, this.#time)], this.#place(name));
  }

  /** Calls `onContact` for each contact, and goes on unless it returns false. */
  advanceMany(t, onContact) {
    while (this.advanceTo(t) === "contact") {
      const contacts = [this.contact, ...this.also.map(({ t, contact }) => ({ t, contact }))];
      const goOn = contacts.map((contact) => onContact(contact) !== false);
      if (goOn.includes(false) || this.state !== "contact") break;
      this.resume();
    }
    return this.state;
  }

  addBody({ relative_to: parent = "", ...body }) {
    const place = this.#call("add_body", [bodyScene(body, this.#time), parent]);
    this.#bodies[place] = body.name;
  }
  removeBody(name) {
    const place = this.#place(name);
    this.#call("remove_body", [], place);
    this.#bodies[place] = null;
  }
  ignore(a, b) {
    this.#call("ignore", [], this.#place(a), this.#place(b));
  }
  setParent(name, parent, motion) {
    const [body, other] = [this.#place(name), parent === null ? -1 : this.#place(parent)];
    this.#call("set_parent", [motionScene(motion, this.#time)], body, other);
  }

  /** Of the contact, or of `also[which - 1]`. */
  relativeVelocity(which = 0) {
    return this.#call("relative_velocity", [], which);
  }
  record() {
    return this.#call("record");
  }
  tiling() {
    return this.#call("tiling");
  }

  free() {
    collected.unregister(this);
    this.#functions("close", [], this.#id);
  }
}
