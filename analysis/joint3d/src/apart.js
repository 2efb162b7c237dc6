// SPDX-License-Identifier: GPL-3.0-or-later
// One question at a time to the library in a worker of its own, which is gone when it has answered, and when its answer no
// longer matters; and panels that ask one.
import { byId } from "./elements.js";
import { inWords } from "./messages.js";

class Apart {
  /** open(): a client of the library in a worker of its own. */
  constructor(open) {
    Object.assign(this, { open, client: null, run: 0 });
  }

  stop() {
    this.run += 1;
    this.client?.worker.terminate();
    this.client = null;
  }

  /** The library's answer about a joint, the request that makes it; null where another question, or stop(), came first. */
  async ask(joint, kind, request) {
    this.stop();
    const mine = this.run;
    this.client = this.open();
    try {
      await this.client.ask("joint", joint);
      const answer = await this.client.ask(kind, request);
      return mine === this.run ? answer : null;
    } catch (error) {
      if (mine !== this.run) return null;
      throw error;
    } finally {
      if (mine === this.run) this.stop();
    }
  }
}

/** A panel with question(), clear() and draw(): asked when it is open, and anew when the joint or the question is another. */
export class ApartPanel {
  /** open(): a client of the library in a worker of its own; id: of the panel, whose elements begin with it; kind: of the question. */
  constructor(open, { id, kind }) {
    Object.assign(this, { apart: new Apart(open), id, kind, joint: null, found: null, asked: null });
    byId(id).addEventListener("toggle", () => this.begin());
  }

  say(text) {
    byId(`${this.id}-say`).textContent = text;
  }

  /** Another joint. request: the question that the library has answered with it. */
  follow(request) {
    this.joint = request;
    this.again(true);
  }

  /** Another question, or joint: what is shown no longer holds. */
  again(other = false) {
    if (!other && JSON.stringify(this.question()) === this.asked) return;
    this.apart.stop();
    Object.assign(this, { found: null, asked: null });
    this.clear();
    this.say("");
    this.begin();
  }

  async begin() {
    if (!this.joint || this.asked || !byId(this.id).open) return;
    const question = this.question();
    this.asked = JSON.stringify(question);
    this.say("Working, which takes some seconds …");
    try {
      const found = await this.apart.ask(this.joint, this.kind, question);
      if (!found) return;
      this.found = found;
      this.say("");
      this.draw();
    } catch (error) {
      this.say(`${inWords(error)}.`.replace(/\.\.$/, "."));
    }
  }
}
