// SPDX-License-Identifier: GPL-3.0-or-later
// What the panels share that ask what would have to change so that motions are reached: the motions, of the state, and an
// answer that is worked out when the panel is open, and anew when the joint or the question is another.
import { Apart } from "./apart.js";
import { byId } from "./elements.js";
import { inWords } from "./messages.js";

export const NO_GUIDE = "Nothing here may guide a treatment.";

export class ChangePanel {
  /** id: of the panel, whose elements begin with it. kind: of the question. */
  constructor(app, open, { id, kind }) {
    Object.assign(this, { app, apart: new Apart(open), id, kind, joint: null, found: null, asked: null });
    byId(id).addEventListener("toggle", () => this.begin());
    byId(`${id}-required`).addEventListener("change", ({ target }) => this.require(target.value));
    byId(`${id}-pose`).addEventListener("click", () => this.require(wordsOf(app.state.motion)));
    byId(`${id}-notice`).textContent = NO_GUIDE;
  }

  require(words) {
    this.app.state.required = words;
    this.onRequired();
  }

  /** Brings the fields up to the state. */
  show() {
    byId(`${this.id}-required`).value = this.app.state.required;
  }

  /** Another joint. request: the question that the library has answered with it. */
  follow(request) {
    this.joint = request;
    this.again(true);
  }

  /** Another question, or joint: what is shown no longer holds. */
  again(other = false) {
    this.show();
    if (!other && JSON.stringify(this.question()) === this.asked) return;
    this.apart.stop();
    Object.assign(this, { found: null, asked: null });
    this.clear();
    byId(`${this.id}-say`).textContent = "";
    this.begin();
  }

  async begin() {
    if (!this.joint || this.asked || !byId(this.id).open) return;
    const question = this.question();
    this.asked = JSON.stringify(question);
    byId(`${this.id}-say`).textContent = "Working, which takes some seconds …";
    try {
      const found = await this.apart.ask(this.joint, this.kind, question);
      if (!found) return;
      this.found = found;
      byId(`${this.id}-say`).textContent = "";
      this.draw();
    } catch (error) {
      byId(`${this.id}-say`).textContent = `${inWords(error)}.`.replace(/\.\.$/, ".");
    }
  }
}

/** Angles that are not 0 as the library reads them. */
export function wordsOf(motion) {
  return Object.entries(motion).filter(([, value]) => value).map(([key, value]) => `${key}=${Math.round(value * 100) / 100}`).join(", ");
}
