// SPDX-License-Identifier: GPL-3.0-or-later
// Plots in SVG: the area over the gaps, the smallest gap along a motion, and what maps over two angles share.
import { colourOf, css } from "./colours.js";
import { drawn, roundedDown } from "./elements.js";

const [WIDTH, HEIGHT] = [320, 170];
const AREA = { left: 40, right: 8, top: 10, bottom: 34 };

const scale = (low, high, from, to) => (value) => from + ((value - low) / (high - low)) * (to - from);

/** Round steps, about `count` of them. */
function ticks(low, high, count) {
  const rough = (high - low) / count;
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((k) => k * power).find((value) => value >= rough);
  const first = Math.ceil(low / step);
  return Array.from({ length: Math.floor(high / step) - first + 1 }, (_, k) => (first + k) * step);
}

function frame(svg, x, y, { xs, ys, xTitle, yTitle }) {
  const bottom = HEIGHT - AREA.bottom;
  const parts = [];
  ys.forEach((value) => parts.push(
    drawn("line", { x1: AREA.left, x2: WIDTH - AREA.right, y1: y(value), y2: y(value), class: "grid" }),
    drawn("text", { x: AREA.left - 4, y: y(value) + 3.5, class: "tick end" }, String(Number(value.toPrecision(4))))));
  xs.forEach((value) => parts.push(
    drawn("line", { x1: x(value), x2: x(value), y1: bottom, y2: bottom + 3, class: "axis" }),
    drawn("text", { x: x(value), y: bottom + 14, class: "tick middle" }, String(Number(value.toPrecision(4))))));
  parts.push(
    drawn("line", { x1: AREA.left, x2: WIDTH - AREA.right, y1: bottom, y2: bottom, class: "axis" }),
    drawn("text", { x: (AREA.left + WIDTH - AREA.right) / 2, y: HEIGHT - 4, class: "title middle" }, xTitle),
    drawn("text", { transform: `translate(10 ${(AREA.top + bottom) / 2}) rotate(-90)`, class: "title middle" }, yTitle));
  svg.replaceChildren(...parts);
}

export const MAP = { width: 320, left: 40, right: 8, top: 8, bottom: 34 };

/** The labels of a map that is so high. x, y: where an angle is; xs, ys: the angles that are named. */
export function mapLabels(height, { x, y, xs, ys, xTitle, yTitle }) {
  const tick = (angle, at) => drawn("text", { class: "tick middle", ...at }, String(angle));
  const middle = (MAP.top + height - MAP.bottom) / 2;
  return [...xs.map((angle) => tick(angle, { x: x(angle), y: height - MAP.bottom + 14 })),
    ...ys.map((angle) => tick(angle, { x: MAP.left - 14, y: y(angle) + 3.5 })),
    drawn("text", { class: "title middle", x: (MAP.left + MAP.width) / 2, y: height - 4 }, xTitle),
    drawn("text", { class: "title middle", transform: `translate(10 ${middle}) rotate(-90)` }, yTitle)];
}

/** A histogram of the library between two gaps: { from, to, area } of each bar, mm and mm², all that is smaller or larger in one bar at either end. */
export function barsBetween(low, high, { first_mm: first, bin_mm: width }, { area_mm2: areas, below_mm2: below, beyond_mm2: beyond }) {
  const bins = Array.from(areas, (area, k) => ({ from: first + k * width, to: first + (k + 1) * width, area }));
  const sum = (start, of) => of.reduce((all, { area }) => all + area, start);
  return [{ from: low - 1, to: low, area: sum(below, bins.filter(({ from }) => from < low)) }, ...bins.filter(({ from }) => from >= low && from < high),
    { from: high, to: high + 1, area: sum(beyond, bins.filter(({ from }) => from >= high)) }];
}

/** gap_histogram and colours: of the library's reply to `pose`. */
export function drawHistogram(svg, { gap_histogram: bins, colours }, colourScale) {
  const [low, high] = [-3, 12];
  const [ball, socket] = [bins.ball, bins.socket].map((of) => barsBetween(low, high, bins, of));
  const most = Math.max(1, ...ball.map(({ area }, k) => area + socket[k].area));
  const x = scale(low - 1, high + 1, AREA.left, WIDTH - AREA.right);
  const y = scale(0, most * 1.05, HEIGHT - AREA.bottom, AREA.top);
  frame(svg, x, y, { xs: [0, 3, 6, 9], ys: ticks(0, most, 3), xTitle: "gap, mm", yTitle: "area, mm²" });
  [[low - 0.5, `≤ ${low}`], [high + 0.5, `≥ ${high}`]].forEach(([gap, words]) =>
    svg.append(drawn("text", { x: x(gap), y: HEIGHT - AREA.bottom + 14, class: "tick middle" }, words.replace("-", "−"))));
  ball.forEach(({ from: left, to: right, area }, k) => {
    const bar = (from, to, surface) => drawn("rect", {
      x: x(left) + 0.4, width: x(right) - x(left) - 0.8, y: y(to), height: Math.max(y(from) - y(to), 0),
      fill: css(colourOf((left + right) / 2, colourScale, surface, colours[surface])), class: "bar" });
    svg.append(bar(0, area, "ball"), bar(area, area + socket[k].area, "socket"));
  });
  svg.append(drawn("line", { x1: x(0), x2: x(0), y1: AREA.top, y2: HEIGHT - AREA.bottom, class: "zero" }));
}

/** The widest stretch that is worth a look: to 15 degrees beyond the limit, and what the pose has now. */
function lastAngle({ angles, limits: [limit] }, at) {
  const wanted = limit.state === "limited" ? limit.high_deg + 15 : angles.at(-1);
  return Math.min(Math.max(wanted, 30, at ?? 0), angles.at(-1));
}

/**
 * sweep: the library's reply; look: { title, cartilage, at } with the angle of the pose now, or null. Returns the angle
 * under a place of the plot, as a share of its width.
 */
export function drawSweep(svg, sweep, { title, cartilage, at }) {
  const end = lastAngle(sweep, at);
  const seen = [...sweep.angles.keys()].filter((k) => sweep.angles[k] <= end + 1e-6 && !Number.isNaN(sweep.smallest[k]));
  const values = seen.map((k) => sweep.smallest[k]);
  const [low, high] = [Math.max(Math.min(-0.5, ...values), -2.5), Math.max(cartilage, ...values) * 1.08 + 0.1];
  const x = scale(0, end, AREA.left, WIDTH - AREA.right);
  const y = scale(low, high, HEIGHT - AREA.bottom, AREA.top);
  const inside = (value) => Math.min(Math.max(value, low), high);
  frame(svg, x, y, { xs: ticks(0, end, 5), ys: ticks(low, high, 4), xTitle: `${title}, °`, yTitle: "smallest gap, mm" });
  const across = (value, name) => drawn("line", { x1: AREA.left, x2: WIDTH - AREA.right, y1: y(value), y2: y(value), class: name });
  svg.append(across(0, "zero"));
  if (cartilage > 0) svg.append(across(cartilage, "cartilage"));
  const way = seen.map((k) => `${Number.isNaN(sweep.smallest[k - 1] ?? NaN) ? "M" : "L"}${x(sweep.angles[k])} ${y(inside(sweep.smallest[k]))}`);
  svg.append(drawn("path", { d: way.join(" "), class: "curve" })); // broken where the surfaces do not face each other
  const [limit] = sweep.limits;
  if (limit.state === "limited") {
    const place = x(limit.low_deg);
    const right = place > WIDTH - 90;
    svg.append(drawn("line", { x1: place, x2: place, y1: AREA.top, y2: HEIGHT - AREA.bottom, class: "limit" }),
      drawn("text", { x: place + (right ? -4 : 4), y: AREA.top + 9, class: `limit-text ${right ? "end" : ""}` },
        `limit ${roundedDown(limit.low_deg, 2)}°`));
  }
  if (at !== null && at >= 0 && at <= end) {
    const gap = sweep.smallest[sweep.angles.reduce((best, each, k) => (Math.abs(each - at) < Math.abs(sweep.angles[best] - at) ? k : best), 0)];
    if (!Number.isNaN(gap)) svg.append(drawn("circle", { cx: x(at), cy: y(inside(gap)), r: 4, class: "now" }));
  }
  return (share) => Math.min(Math.max(((share * WIDTH - AREA.left) / (WIDTH - AREA.left - AREA.right)) * end, 0), end);
}
