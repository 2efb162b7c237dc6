// SPDX-License-Identifier: GPL-3.0-or-later
// The report of the joint at hand, the page that `impinge report` writes: made when a reader asks for it, and kept as a file.
import { ApartPanel } from "./apart.js";
import { byId } from "./elements.js";
import { about, save } from "./export_panel.js";
import { fileStem } from "./pose_words.js";
import { OWN, firstState } from "./state.js";
import { farOf } from "./volume_panel.js";

const WIDTH = 0.2; // share of all rotations that may stay undecided, as the program has it

export class ReportPanel extends ApartPanel {
  /** name(): of the joint, as the page has it. */
  constructor(app, open, name) {
    super(open, { id: "keep", kind: "report" });
    Object.assign(this, { app, name });
    byId("save-report").addEventListener("click", () => { this.again(true); super.begin(); });
  }

  /** When it is asked for alone. */
  begin() {}

  question() {
    const { motion, cartilage, joint } = this.app.state;
    const { ball, socket } = joint.name === OWN ? this.app.own : { ball: { name: `femur of ${this.name()}` }, socket: { name: "its socket" } };
    this.file = `report_${fileStem(this.name(), this.app.state.joint.side, { motion, offset: [] })}.html`;
    const asked = { pose: motion, width: WIDTH, ...(cartilage === firstState().cartilage ? {} : { cartilage_mm: cartilage }) };
    return { asked, ball: ball.name, socket: socket.name, program: `impinge ${about("version")}, commit ${about("commit").slice(0, 9)}`, viewer: byId("viewer").textContent };
  }

  progress(open) {
    return farOf(open, WIDTH);
  }

  cancel() {
    super.cancel();
    this.row.hidden = true;
    this.say("Cancelled.");
  }

  clear() {}

  draw() {
    save(this.found.html, this.file);
    this.say(`Saved as ${this.file}.`);
  }
}
