// SPDX-License-Identifier: GPL-3.0-or-later
// The motion volume of a joint: what of all its rotations is free, proven, in a worker of its own that is gone when it has
// answered or another joint is shown. Worked out once a joint, when the panel is opened.
import { Apart } from "./apart.js";
import { RAMP, css } from "./colours.js";
import { byId, drawn, make, roundedDown, roundedUp } from "./elements.js";

const [WIDTH, HEIGHT] = [320, 250];
const AREA = { left: 40, right: 8, top: 8, bottom: 34 };
const MOST = 120; // degrees of rotation at the end of the colours
const percent = (share, round) => round(100 * share, 1);

const place = ({ least, step, count }, from, to) => (angle) => from + ((angle - least + step / 2) / (count * step)) * (to - from);
const index = ({ least, step, count }, angle) => Math.min(Math.max(Math.round((angle - least) / step), 0), count - 1);

/** Degrees of rotation at a flexion and an abduction that are certainly reached, and perhaps: { sure, perhaps }. */
export function rotationRange({ flexion, abduction, internal_rotation: rotation, states }, motion) {
  const first = (index(flexion, motion.flexion) * abduction.count + index(abduction, motion.abduction)) * rotation.count;
  const row = states.subarray(first, first + rotation.count);
  const of = (least) => row.reduce((sum, state) => sum + (state >= least), 0) * rotation.step;
  return { sure: of(2), perhaps: of(1) };
}

export class VolumePanel {
  /** open(): a client of the library in a worker of its own; fault(error). */
  constructor(app, open, fault) {
    Object.assign(this, { app, apart: new Apart(open), fault, joint: null, asked: false, volume: null });
    byId("volume").addEventListener("toggle", () => this.begin());
  }

  /** Another joint. request: the question that the library has answered with it. */
  follow(request) {
    this.apart.stop();
    Object.assign(this, { joint: request, asked: false, volume: null });
    byId("volume-plot").replaceChildren();
    byId("volume-say").textContent = byId("volume-here").textContent = "";
    this.begin();
  }

  async begin() {
    if (!this.joint || this.asked || !byId("volume").open) return;
    this.asked = true;
    byId("volume-say").textContent = "Working, which takes some seconds …";
    try {
      const volume = await this.apart.ask(this.joint, "volume", { width: 0.05 });
      if (!volume) return;
      this.volume = volume;
      this.draw();
      this.say();
      this.posed();
    } catch (error) {
      this.asked = false;
      byId("volume-say").textContent = "";
      this.fault(error);
    }
  }

  say() {
    const { low, high, reachable_low: least, reachable_high: most } = this.volume;
    byId("volume-say").textContent = `Of all rotations ${percent(low, roundedDown)} to ${percent(high, roundedUp)} % are free of contact, and `
      + `${percent(least, roundedDown)} to ${percent(most, roundedUp)} % can be reached from the pose of the scan without contact: proven, for the surfaces and their edges.`;
  }

  draw() {
    const { flexion, abduction } = this.volume;
    const [x, y] = [place(flexion, AREA.left, WIDTH - AREA.right), place(abduction, HEIGHT - AREA.bottom, AREA.top)];
    const [wide, high] = [x(flexion.step) - x(0), y(0) - y(abduction.step)];
    const cells = Array.from({ length: flexion.count * abduction.count }, (_, k) => {
      const motion = { flexion: flexion.least + flexion.step * Math.floor(k / abduction.count), abduction: abduction.least + abduction.step * (k % abduction.count) };
      const { sure, perhaps } = rotationRange(this.volume, motion);
      const fill = sure ? css(RAMP[Math.round(Math.min(sure / MOST, 1) * (RAMP.length - 1))]) : perhaps ? "#d8dfe5" : "#fff";
      return drawn("rect", { x: x(motion.flexion) - wide / 2, y: y(motion.abduction) - high / 2, width: wide + 0.2, height: high + 0.2, fill });
    });
    const ticks = (text, at) => drawn("text", { class: "tick middle", ...at }, String(text));
    this.mark = drawn("circle", { r: 4, class: "now" });
    byId("volume-plot").replaceChildren(...cells,
      ...[-40, 0, 40, 80, 120].map((angle) => ticks(angle, { x: x(angle), y: HEIGHT - AREA.bottom + 14 })),
      ...[-60, -30, 0, 30, 60].map((angle) => ticks(angle, { x: AREA.left - 14, y: y(angle) + 3.5 })),
      drawn("text", { class: "title middle", x: (AREA.left + WIDTH) / 2, y: HEIGHT - 4 }, "flexion, °"),
      drawn("text", { class: "title middle", transform: `translate(10 ${(AREA.top + HEIGHT - AREA.bottom) / 2}) rotate(-90)` }, "abduction, °"), this.mark);
    this.at = (motion) => [x(motion.flexion), y(motion.abduction)];
    byId("volume-key").replaceChildren(...[0, 0.5, 1].map((share) => {
      const swatch = make("span", { className: "swatch" });
      swatch.style.background = css(RAMP[Math.round(share * (RAMP.length - 1))]);
      return make("b", {}, swatch, ` ${share === 0 ? "little" : `${share * MOST}°`}${share === 1 ? " and more of rotation" : ""}`);
    }));
  }

  /** The pose at hand, in the picture. */
  posed() {
    if (!this.volume) return;
    const { motion, offset } = this.app.state;
    const { sure, perhaps } = rotationRange(this.volume, motion);
    const [x, y] = this.at(motion);
    const outside = x < AREA.left || x > WIDTH - AREA.right || y < AREA.top || y > HEIGHT - AREA.bottom;
    this.mark.setAttribute("visibility", outside ? "hidden" : "visible");
    this.mark.setAttribute("cx", x);
    this.mark.setAttribute("cy", y);
    byId("volume-here").textContent = outside ? "This pose is outside of the picture." : `Near the flexion and abduction of this pose ${sure === perhaps ? sure : `${sure} to ${perhaps}`}° of rotation can be reached.`
      + (offset.some(Boolean) ? " The volume is that of the joint without the shift of the ball." : "");
  }
}
