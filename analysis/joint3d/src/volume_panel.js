// SPDX-License-Identifier: GPL-3.0-or-later
// The motion volume of a joint: what of all its rotations is free, proven. Its map has the squares, colours and words of the
// program's volume.svg (report/volume_picture.cpp).
import { ApartPanel } from "./apart.js";
import { byId, drawn, keyRow, roundedDown, roundedUp } from "./elements.js";
import { MAP, mapLabels } from "./plots.js";

const HEIGHT = 250;
const DARKEST = 120; // degrees of rotation
const WIDTH = 0.05; // share of all rotations that may stay undecided
export const [BLOCKED, UNDECIDED] = [-1, -2]; // as the library marks such squares
const percent = (share, round) => round(100 * share, 1);

/** How far a volume is of which so many rotations are undecided, and so many may be: the fewer there are, the more work each takes. */
export const farOf = (open, width) => ({ share: Math.min(Math.log(open) / Math.log(width), 1), words: `${percent(open, roundedUp)} % of all rotations are undecided, ${100 * width} % may be` });

/** Of so many degrees of rotation, or of a mark. */
export function mapColour(range) {
  if (range === BLOCKED) return "#999";
  if (range === UNDECIDED) return "#fff";
  const light = 230 - Math.trunc((180 * Math.min(range, DARKEST)) / DARKEST);
  return `rgb(${Math.trunc(light / 3)},${light},235)`;
}

/** What the library found in the middle of the square that holds a flexion and an abduction: { range, middle }; range is undefined beside the map. */
export function squareAt({ range_deg: ranges, step, flexion, abduction }, motion) {
  const [column, row] = [[flexion, motion.flexion], [abduction, motion.abduction]].map(([[least, most], angle]) =>
    (angle < least || angle > most ? NaN : Math.floor((Math.min(angle, most - step / 2) - least) / step)));
  const middle = [flexion[0] + (column + 0.5) * step, abduction[0] + (row + 0.5) * step];
  return { range: ranges[column * ((abduction[1] - abduction[0]) / step) + row], middle };
}

export function squareWords({ range, middle }) {
  if (range === undefined) return "This pose is outside of the map.";
  const [flexion, abduction] = middle.map((angle) => `${String(angle).replace("-", "−")}°`);
  const there = `In the middle of this pose’s square, at flexion ${flexion} and abduction ${abduction},`;
  if (range === BLOCKED) return `${there} the hip is blocked without rotation.`;
  if (range === UNDECIDED) return `${there} it is undecided whether the hip is free without rotation.`;
  return `${there} ${roundedDown(range, 0)}° of rotation are without contact, internal and external together.`;
}

export class VolumePanel extends ApartPanel {
  constructor(app, open) {
    super(open, { id: "volume", kind: "volume" });
    this.app = app;
  }

  question() {
    return { width: WIDTH };
  }

  progress(open) {
    return farOf(open, WIDTH);
  }

  clear() {
    byId("volume-plot").replaceChildren();
    byId("volume-key").replaceChildren();
    byId("volume-here").textContent = "";
  }

  draw() {
    const { map, share_low: low, share_high: high, reachable_low: least, reachable_high: most, by_radii: byRadii } = this.found;
    const { range_deg: ranges, step, flexion, abduction } = map;
    const x = (angle) => MAP.left + ((angle - flexion[0]) / (flexion[1] - flexion[0])) * (MAP.width - MAP.left - MAP.right);
    const y = (angle) => MAP.top + ((abduction[1] - angle) / (abduction[1] - abduction[0])) * (HEIGHT - MAP.top - MAP.bottom);
    const rows = (abduction[1] - abduction[0]) / step;
    const cells = Array.from(ranges, (range, k) => {
      const [left, top] = [flexion[0] + step * Math.floor(k / rows), abduction[0] + step * (k % rows) + step];
      return drawn("rect", { x: x(left), y: y(top), width: x(step) - x(0) + 0.2, height: y(0) - y(step) + 0.2, fill: mapColour(range) });
    });
    this.mark = drawn("circle", { r: 4, class: "now" });
    byId("volume-plot").replaceChildren(...cells,
      ...mapLabels(HEIGHT, { x, y, xs: [-45, 0, 45, 90, 135], ys: [-75, -50, -25, 0, 25, 50, 75], xTitle: "flexion, degrees", yTitle: "abduction, degrees" }), this.mark);
    this.at = (motion) => [x(motion.flexion), y(motion.abduction)];
    const entries = [...[0, 30, 60, 90, DARKEST].map((range) => [range, `${range}${range === DARKEST ? "+" : ""}`]), [BLOCKED, "blocked"], [UNDECIDED, "undecided"]];
    byId("volume-key").replaceChildren("rotation without contact, internal and external together, degrees:", ...entries.map(([range, text]) => keyRow({ colours: [mapColour(range)], text })));
    this.say(`Of all rotations ${percent(low, roundedDown)} to ${percent(high, roundedUp)} % are free of contact, and `
      + `${percent(least, roundedDown)} to ${percent(most, roundedUp)} % can be reached without contact from where all angles are 0: proven, for the surfaces and their edges.`
      + (byRadii ? " Blocked includes where the ball reaches beyond the socket along a ray though no surfaces meet, as the socket is a sheet; limits may go further." : ""));
    this.posed();
  }

  /** The pose at hand, in the picture. */
  posed() {
    if (!this.found) return;
    const { motion, offset } = this.app.state;
    const square = squareAt(this.found.map, motion);
    const [x, y] = this.at(motion);
    this.mark.setAttribute("visibility", square.range === undefined ? "hidden" : "visible");
    this.mark.setAttribute("cx", x);
    this.mark.setAttribute("cy", y);
    byId("volume-here").textContent = squareWords(square) + (offset.some(Boolean) ? " The volume is that of the joint without the shift of the ball." : "");
  }
}
