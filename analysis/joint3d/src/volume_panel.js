// SPDX-License-Identifier: GPL-3.0-or-later
// The motion volume of a joint: what of all its rotations is free, proven.
import { ApartPanel } from "./apart.js";
import { RAMP, css } from "./colours.js";
import { byId, drawn, keyRow, roundedDown, roundedUp } from "./elements.js";
import { MAP, mapLabels } from "./plots.js";

const HEIGHT = 250;
const MOST = 120; // degrees of rotation at the end of the colours
const percent = (share, round) => round(100 * share, 1);

const place = ({ least, step, count }, from, to) => (angle) => from + ((angle - least + step / 2) / (count * step)) * (to - from);
const index = ({ least, step, count }, angle) => Math.min(Math.max(Math.round((angle - least) / step), 0), count - 1);

/** Degrees of rotation at a flexion and an abduction that are certainly reached, and perhaps: { sure, perhaps }. */
function rotationRange({ flexion, abduction, internal_rotation: rotation, states }, motion) {
  const first = (index(flexion, motion.flexion) * abduction.count + index(abduction, motion.abduction)) * rotation.count;
  const row = states.subarray(first, first + rotation.count);
  const of = (least) => row.reduce((sum, state) => sum + (state >= least), 0) * rotation.step;
  return { sure: of(2), perhaps: of(1) };
}

export class VolumePanel extends ApartPanel {
  constructor(app, open) {
    super(open, { id: "volume", kind: "volume" });
    this.app = app;
  }

  question() {
    return { width: 0.05 };
  }

  clear() {
    byId("volume-plot").replaceChildren();
    byId("volume-here").textContent = "";
  }

  draw() {
    const { flexion, abduction, share_low: low, share_high: high, reachable_low: least, reachable_high: most } = this.found;
    const [x, y] = [place(flexion, MAP.left, MAP.width - MAP.right), place(abduction, HEIGHT - MAP.bottom, MAP.top)];
    const [wide, tall] = [x(flexion.step) - x(0), y(0) - y(abduction.step)];
    const cells = Array.from({ length: flexion.count * abduction.count }, (_, k) => {
      const motion = { flexion: flexion.least + flexion.step * Math.floor(k / abduction.count), abduction: abduction.least + abduction.step * (k % abduction.count) };
      const { sure, perhaps } = rotationRange(this.found, motion);
      const fill = sure ? css(RAMP[Math.round(Math.min(sure / MOST, 1) * (RAMP.length - 1))]) : perhaps ? "#d8dfe5" : "#fff";
      return drawn("rect", { x: x(motion.flexion) - wide / 2, y: y(motion.abduction) - tall / 2, width: wide + 0.2, height: tall + 0.2, fill });
    });
    this.mark = drawn("circle", { r: 4, class: "now" });
    byId("volume-plot").replaceChildren(...cells,
      ...mapLabels(HEIGHT, { x, y, xs: [-40, 0, 40, 80, 120], ys: [-60, -30, 0, 30, 60], xTitle: "flexion, °", yTitle: "abduction, °" }), this.mark);
    this.at = (motion) => [x(motion.flexion), y(motion.abduction)];
    byId("volume-key").replaceChildren(...[[0, "little"], [0.5, `${MOST / 2}°`], [1, `${MOST}° and more of rotation`]].map(([share, text]) =>
      keyRow({ colours: [css(RAMP[Math.round(share * (RAMP.length - 1))])], text })));
    this.say(`Of all rotations ${percent(low, roundedDown)} to ${percent(high, roundedUp)} % are free of contact, and `
      + `${percent(least, roundedDown)} to ${percent(most, roundedUp)} % can be reached from the pose of the scan without contact: proven, for the surfaces and their edges.`);
    this.posed();
  }

  /** The pose at hand, in the picture. */
  posed() {
    if (!this.found) return;
    const { motion, offset } = this.app.state;
    const { sure, perhaps } = rotationRange(this.found, motion);
    const [x, y] = this.at(motion);
    const outside = x < MAP.left || x > MAP.width - MAP.right || y < MAP.top || y > HEIGHT - MAP.bottom;
    this.mark.setAttribute("visibility", outside ? "hidden" : "visible");
    this.mark.setAttribute("cx", x);
    this.mark.setAttribute("cy", y);
    byId("volume-here").textContent = outside ? "This pose is outside of the picture." : `Near the flexion and abduction of this pose ${sure === perhaps ? sure : `${sure} to ${perhaps}`}° of rotation can be reached.`
      + (offset.some(Boolean) ? " The volume is that of the joint without the shift of the ball." : "");
  }
}
