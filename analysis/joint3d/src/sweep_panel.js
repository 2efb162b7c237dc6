// SPDX-License-Identifier: GPL-3.0-or-later
// The smallest gap along a motion, with the limit that no step can jump over.
import { byId, fillChoice } from "./elements.js";
import { drawSweep } from "./plots.js";

const WAIT = 350; // ms of rest before a motion is swept again
const SIGNS = { extension: -1, adduction: -1, external_rotation: -1 };
const ANGLES = { extension: "flexion", adduction: "abduction", external_rotation: "internal_rotation" };

const degrees = (low, high) => {
  const [a, b] = [low.toFixed(4), high.toFixed(4)];
  return a === b ? `at ${a}°` : `between ${a}° and ${b}°`;
};

export class SweepPanel {
  /** ask(request) answers with the library's sweep; onPose(motion) when a reader points at an angle. */
  constructor(app, ask, onPose) {
    Object.assign(this, { app, ask, onPose, sweep: null, asked: 0, timer: 0 });
    byId("sweep-motion").addEventListener("change", (event) => { app.state.sweep = event.target.value; this.again(0); });
    byId("sweep-held").addEventListener("change", () => this.again(0));
    byId("sweep-plot").addEventListener("click", (event) => {
      const box = byId("sweep-plot").getBoundingClientRect();
      if (this.sweep) this.goTo(this.angleAt((event.clientX - box.left) / box.width));
    });
    byId("sweep-go").addEventListener("click", () => { if (this.sweep) this.goTo(this.sweep.limit.low_deg); });
  }

  setCatalogue({ motions }) {
    this.motions = motions;
    fillChoice(byId("sweep-motion"), motions.map(({ name, label, meaning }) => ({ value: name, text: `${label} (${meaning})` })));
  }

  motion() {
    return this.motions.find(({ name }) => name === this.app.state.sweep) ?? this.motions[0];
  }

  /** The angle that grows, and which way. */
  growing() {
    const { growing } = this.motion();
    return { angle: ANGLES[growing] ?? growing, sign: SIGNS[growing] ?? 1 };
  }

  start() {
    const { motion } = this.app.state;
    return byId("sweep-held").checked ? { ...motion, [this.growing().angle]: 0 } : this.motion().start;
  }

  show() {
    byId("sweep-motion").value = this.motion().name;
  }

  /** Of another joint: what is shown no longer holds. */
  forget() {
    this.sweep = null;
    byId("sweep-plot").replaceChildren();
    byId("sweep-say").textContent = "Working …";
    byId("sweep-go").disabled = true;
  }

  /** Sweeps again after a rest; what is shown is then of the joint before. */
  again(wait = WAIT) {
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.run(), wait);
    byId("sweep-plot").classList.add("old");
  }

  /** A pose has changed: its place is marked; with the other angles held, the motion is another. */
  posed() {
    const held = JSON.stringify(this.start());
    if (byId("sweep-held").checked && held !== this.swept) this.again();
    this.draw();
  }

  async run() {
    const mine = (this.asked += 1);
    const start = this.start();
    try {
      const sweep = await this.ask({ motion: this.motion().name, pose: start });
      if (mine !== this.asked) return;
      Object.assign(this, { sweep, swept: JSON.stringify(start) });
      byId("sweep-plot").classList.remove("old");
      this.draw();
      this.say();
    } catch (error) {
      if (mine === this.asked) byId("sweep-say").textContent = error.message;
    }
  }

  say() {
    const { state, low_deg: low, high_deg: high, clock, deg_per_mm: each } = this.sweep.limit;
    byId("sweep-go").disabled = state !== "reached";
    const words = {
      reached: `Bones first touch ${degrees(low, high)}${clock ? `, at ${clock} o’clock` : ""}: `
        + `a certified limit, over which no step jumps.${each ? ` A millimetre of error moves it by ${each.toFixed(1)}°.` : ""}`,
      free: `Bones do not touch up to ${low.toFixed(0)}° (certified).`,
      blocked: "Bones overlap at the start of this motion.",
    };
    byId("sweep-say").textContent = words[state];
  }

  /** The angle of the pose along the motion, or null where another angle is not as in it. */
  at() {
    const { angle, sign } = this.growing();
    const start = this.start();
    const { motion } = this.app.state;
    const same = Object.keys(start).every((key) => key === angle || Math.abs(start[key] - motion[key]) < 1e-6);
    return same ? sign * (motion[angle] - start[angle]) : null;
  }

  draw() {
    if (!this.sweep) return;
    const look = { title: this.motion().label.toLowerCase(), cartilage: this.app.state.cartilage, at: this.at() };
    this.angleAt = drawSweep(byId("sweep-plot"), this.sweep, look);
  }

  goTo(degrees) {
    const { angle, sign } = this.growing();
    const start = this.start();
    this.onPose({ ...start, [angle]: start[angle] + sign * Math.round(degrees * 1e4) / 1e4 });
  }
}
