// SPDX-License-Identifier: GPL-3.0-or-later
// One question at a time to the library in a worker of its own, which is gone when it has answered, and when its answer no
// longer matters; and panels that ask one.
import { byId, make } from "./elements.js";
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
  async ask(joint, kind, request, onReached) {
    this.stop();
    const mine = this.run;
    this.client = this.open();
    try {
      await this.client.ask("joint", joint);
      const answer = await this.client.ask(kind, request, onReached);
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
    Object.assign(this, { apart: new Apart(open), id, kind, joint: null, found: null, asked: null, seconds: 0, timer: 0 });
    byId(id).addEventListener("toggle", () => this.begin());
    this.bar = make("progress", { max: 1, "aria-label": "How far it is" });
    this.words = make("span", { className: "soft" });
    this.button = make("button", { type: "button", id: `${id}-cancel`, textContent: "Cancel", onclick: () => (this.asked ? this.cancel() : this.begin()) });
    this.row = make("p", { className: "row working", hidden: true }, this.bar, this.words, this.button);
    byId(`${id}-say`).after(this.row);
  }

  /** What is done of the work, 0 to 1, and in words, where the library says so: { share, words }. open: as it says. */
  progress() {
    return null;
  }

  /** How far it is, or nothing where nothing is worked out. */
  tell(open) {
    const far = open === undefined ? null : this.progress(open);
    if (far) this.bar.value = far.share;
    else this.bar.removeAttribute("value");
    this.far = far?.words ?? "";
    this.write();
  }

  write() {
    this.words.textContent = `${this.seconds} s${this.far && `: ${this.far}`}`;
  }

  work(on) {
    clearInterval(this.timer);
    this.row.hidden = !on;
    if (!on) return;
    this.seconds = 0;
    this.bar.hidden = false;
    this.button.textContent = "Cancel";
    this.tell();
    this.timer = setInterval(() => { this.seconds += 1; this.write(); }, 1000);
  }

  cancel() {
    this.apart.stop();
    this.asked = null;
    this.work(false);
    this.row.hidden = false;
    this.bar.hidden = true;
    this.words.textContent = "Cancelled.";
    this.button.textContent = "Work it out";
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
    this.work(false);
    this.begin();
  }

  async begin() {
    if (!this.joint || this.asked || !byId(this.id).open) return;
    const question = this.question();
    this.asked = JSON.stringify(question);
    this.work(true);
    try {
      const found = await this.apart.ask(this.joint, this.kind, question, (open) => this.tell(open));
      if (!found) return;
      this.work(false);
      this.found = found;
      this.draw();
    } catch (error) {
      this.work(false);
      this.say(`${inWords(error)}.`.replace(/\.\.$/, "."));
    }
  }
}
