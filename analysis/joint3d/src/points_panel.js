// SPDX-License-Identifier: GPL-3.0-or-later
// The sample points of the tables (thesis, Figures 40 and 49), made when they are to be seen and not before.
import { byId } from "./elements.js";

const APART = 0.4; // mm: closer points run together in a picture of the whole joint
const many = (number) => number.toLocaleString("en");

export class PointsPanel {
  /** radius(): of the head, mm; ask(): the library's reply to `points`; onPoints(reply, apart) with their distance on the head, mm, or null where there are none; fault(error). */
  constructor(app, ask, { radius, onPoints, fault }) {
    Object.assign(this, { app, ask, radius, onPoints, fault, asked: 0, made: false });
  }

  wanted() {
    return this.app.state.look.shown.includes("points");
  }

  /** Another joint or other tables: older points are wrong. */
  again() {
    this.asked += 1;
    this.made = false;
    this.onPoints(null, 1);
    this.show();
  }

  /** Brings them up to the state. */
  async show() {
    byId("points-say").hidden = !this.wanted();
    if (!this.wanted() || this.made) return;
    const mine = (this.asked += 1);
    this.made = true;
    byId("points-say").textContent = "Making the sample points …";
    try {
      const points = await this.ask();
      if (mine !== this.asked) return;
      const apart = this.radius() * this.app.state.tables.precision_deg * (Math.PI / 180);
      this.onPoints(points, apart);
      this.say(points, apart);
    } catch (error) {
      if (mine === this.asked) this.fault(error);
    }
  }

  say({ entries, ball, socket }, apart) {
    byId("points-say").textContent = `All ${many(entries)} directions of each table: ${many(ball.length / 3)} meet the femur, `
      + `${many(socket.length / 3)} the socket, about ${apart.toFixed(2)} mm apart on the head.${apart < APART ? " Zoom in to tell them apart." : ""}`;
  }
}
