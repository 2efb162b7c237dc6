// SPDX-License-Identifier: GPL-3.0-or-later
// Gaps to colours. The thesis' five levels come from the library (hip/gap_levels.hpp); the other scale is a ramp from
// dark blue to yellow whose lightness grows steadily, so that no kind of colour vision and no grey print loses it.

export const RAMP = [[0, 32, 77], [42, 60, 110], [87, 92, 109], [125, 124, 120], [166, 157, 117], [209, 192, 96], [255, 234, 70]];
export const BEYOND = { ball: [226, 230, 222], socket: [221, 227, 234] };
export const RANGE = { low: -1, high: 15, steps: 2048 }; // mm

/** The colour at a share, 0 to 1, of a way along colours. */
export function along(colours, share) {
  const place = Math.min(Math.max(share, 0), 1) * (colours.length - 1);
  const k = Math.min(Math.floor(place), colours.length - 2);
  return colours[k].map((value, c) => Math.round(value + (colours[k + 1][c] - value) * (place - k)));
}

export const PLAIN = "plain"; // the scale of a surface that shows no gaps

/** A colour of a gap in mm, [red, green, blue] to 255. levels: those of the surface, from the library. */
export function colourOf(gap, scale, surface, levels) {
  if (scale === PLAIN) return BEYOND[surface];
  if (scale === "levels") return (levels.find((level) => level.up_to === null || gap <= level.up_to) ?? levels.at(-1)).rgb;
  const cartilage = levels.at(-2).up_to;
  if (gap > cartilage) return BEYOND[surface];
  return cartilage > 0 ? along(RAMP, gap / cartilage) : RAMP[0];
}

/** Colours of RANGE in equal steps, as bytes of red, green, blue, 255. */
export function colourTable(scale, surface, levels) {
  const bytes = new Uint8Array(4 * RANGE.steps);
  for (let k = 0; k < RANGE.steps; k += 1) {
    const gap = RANGE.low + ((k + 0.5) / RANGE.steps) * (RANGE.high - RANGE.low);
    bytes.set([...colourOf(gap, scale, surface, levels), 255], 4 * k);
  }
  return bytes;
}

const mm = (value) => Number(value.toFixed(1));
export const css = (rgb) => `rgb(${rgb.join(" ")})`;

/** Rows of the legend: { colours, text }, of one colour or several of a gradient, from contact outwards. */
export function legendRows(scale, colours) {
  const [ball, socket] = [colours.ball, colours.socket];
  const limit = ball.at(-2).up_to;
  const rows = [];
  if (scale === "levels") {
    ball.slice(0, -1).forEach((level, k) => rows.push({
      colours: [css(level.rgb)], text: k ? `${mm(ball[k - 1].up_to)} to ${mm(level.up_to)} mm` : "bones touch or overlap" }));
  } else {
    rows.push({ colours: [css(RAMP[0])], text: "bones touch or overlap" });
    if (limit > 0) rows.push({ colours: RAMP.map(css), text: `0 to ${mm(limit)} mm` });
  }
  const beyond = (surface, levels) => css(scale === "levels" ? levels.at(-1).rgb : BEYOND[surface]);
  rows.push({ colours: [beyond("ball", ball)], text: `ball, over ${mm(limit)} mm` });
  rows.push({ colours: [beyond("socket", socket)], text: `socket, over ${mm(limit)} mm` });
  rows.push({ colours: [css(colours.no_gap_rgb)], text: "no surface opposite" });
  return rows;
}
