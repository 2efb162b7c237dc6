// SPDX-License-Identifier: GPL-3.0-or-later
// Panels that ask one question at a time of the library in a worker of its own, which is gone when it has answered, and when its
// answer no longer matters.
import { byId, make } from "./elements.js";
import { inWords } from "./messages.js";

/** A panel with question(), clear() and draw(): asked when it is open, and anew when the joint or the question is another. */
export class ApartPanel {
  /** open(): a client of the library in a worker of its own; id: of the panel, whose elements begin with it; kind: of the question. */
  constructor(open, { id, kind }) {
    Object.assign(this, { open, id, kind, client: null, joint: null, found: null, asked: null, seconds: 0, timer: 0 });
    byId(id).addEventListener("toggle", () => this.begin());
    this.bar = make("progress", { max: 1, "aria-label": "How far it is" });
    this.words = make("span", { className: "soft" });
    this.button = make("button", { type: "button", id: `${id}-cancel`, textContent: "Cancel", onclick: () => (this.client ? this.cancel() : this.again(true)) });
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

  stop() {
    this.client?.worker.terminate();
    Object.assign(this, { client: null, asked: null });
  }

  /** Until its button is pressed or another question asked: the same question, or opening the panel, does not begin it again. */
  cancel() {
    this.client.worker.terminate();
    this.client = null;
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
    this.stop();
    this.found = null;
    this.clear();
    this.say("");
    this.work(false);
    this.begin();
  }

  async begin() {
    if (!this.joint || this.asked || !byId(this.id).open) return;
    const question = this.question();
    const client = this.open();
    Object.assign(this, { client, asked: JSON.stringify(question) });
    this.work(true);
    try {
      await client.ask("joint", this.joint);
      const found = await client.ask(this.kind, question, (open) => this.tell(open));
      if (client !== this.client) return;
      this.work(false);
      this.found = found;
      this.draw();
    } catch (error) {
      if (client !== this.client) return;
      this.work(false);
      this.say(`${inWords(error)}.`.replace(/\.\.$/, "."));
    }
    client.worker.terminate();
  }
}
