// SPDX-License-Identifier: GPL-3.0-or-later
// What the panels share that ask what would have to change so that motions are reached: the motions, of the state.
import { ApartPanel } from "./apart.js";
import { byId } from "./elements.js";

const NO_GUIDE = "Nothing here may guide a treatment.";

export class ChangePanel extends ApartPanel {
  /** number: of the state, which has a field of its own. */
  constructor(app, open, { id, kind, number }) {
    super(open, { id, kind });
    Object.assign(this, { app, number });
    byId(`${id}-${number}`).addEventListener("change", ({ target }) => { app.state[number] = Number(target.value); this.again(); });
    byId(`${id}-required`).addEventListener("change", ({ target }) => this.require(target.value));
    byId(`${id}-pose`).addEventListener("click", () => this.require(wordsOf(app.state.motion)));
    byId(`${id}-notice`).textContent = NO_GUIDE;
  }

  require(words) {
    this.app.state.required = words;
    this.onRequired();
  }

  /** As the library reads them. */
  motions() {
    return this.app.state.required.replace(/\s/g, "").split(";").filter(Boolean);
  }

  /** Brings the fields up to the state. */
  show() {
    byId(`${this.id}-required`).value = this.app.state.required;
    byId(`${this.id}-${this.number}`).value = this.app.state[this.number];
  }

  again(other) {
    this.show();
    super.again(other);
  }
}

/** Angles that are not 0 as the library reads them. */
function wordsOf(motion) {
  return Object.entries(motion).filter(([, value]) => value).map(([key, value]) => `${key}=${Math.round(value * 100) / 100}`).join(", ");
}
