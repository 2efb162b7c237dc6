// SPDX-License-Identifier: GPL-3.0-or-later
// In which orientations of the socket required motions are free: a map over inclination and anteversion, the socket as it is, and
// the nearest free orientation. Extent, colours and words are those of the program's orientation.svg (report/orient_picture.cpp).
import { ChangePanel } from "./change_panel.js";
import { byId, drawn, keyRow, legWords, roundedDown, roundedUp } from "./elements.js";
import { MAP, mapLabels } from "./plots.js";
import { BLOCKED, UNDECIDED, mapColour } from "./volume_panel.js";

const HEIGHT = 312;
const RESOLUTION = 0.75; // degrees: finer squares are no wider than a line
const SQUARE = 5; // numbers each: inclination, anteversion, half width, state, and which part of a motion is so
const STATES = [["free", mapColour(90)], ["blocked", mapColour(BLOCKED)], ["the ball's mesh ends", "#f1e3a0"], ["undecided", mapColour(UNDECIDED)]];
const WORDS = ["All required motions are free", "Blocked", "Not known, since the ball's mesh ends under the socket", "Undecided"];
const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowDown: [0, -1], ArrowUp: [0, 1] }; // degrees of inclination and anteversion

const signed = (angle) => `${angle < 0 ? "" : "+"}${angle.toFixed(1)}`;

/** As below the program's picture. */
function nearestWords({ nearest_free: nearest }) {
  if (!nearest) return "no square of the map is free";
  return `the dot is the nearest free one: ${signed(nearest.inclination_change_deg)}, ${signed(nearest.anteversion_change_deg)}; a turn by ${nearest.turn_deg.toFixed(1)}`;
}

/** Where to turn it, and how, as the program says it. */
function turnWords({ nearest_free: nearest }) {
  if (!nearest?.turn_axis) return "";
  const least = nearest.at_least_deg < nearest.turn_deg ? `; none is free after less than ${roundedDown(nearest.at_least_deg, 1)}°` : "";
  return ` Nearest free: inclination ${nearest.inclination_deg.toFixed(1)}°, anteversion ${nearest.anteversion_deg.toFixed(1)}°, by a turn of the socket by `
    + `${nearest.turn_deg.toFixed(1)}° about the axis ${nearest.turn_axis.map((x) => x.toFixed(3)).join(", ")} of the frame of the meshes${least}.`;
}

export class OrientationPanel extends ChangePanel {
  constructor(app, open) {
    super(app, open, { id: "orientation", kind: "orient", number: "tilt" });
    const plot = byId("orientation-plot");
    for (const kind of ["pointermove", "pointerdown"]) plot.addEventListener(kind, (event) => this.point(event));
    plot.addEventListener("focus", () => this.look(this.looked ?? this.found?.as_scanned));
    plot.addEventListener("keydown", (event) => this.step(event));
  }

  question() {
    return { require: this.motions(), tilt_deg: this.app.state.tilt, resolution_deg: RESOLUTION };
  }

  clear() {
    byId("orientation-plot").replaceChildren();
    byId("orientation-key").replaceChildren();
    byId("orientation-here").textContent = "";
    this.looked = null;
  }

  /** The place under a pointer. */
  point({ clientX, clientY }) {
    if (!this.found) return;
    const { left, top, width, height } = byId("orientation-plot").getBoundingClientRect();
    this.look(this.angles(((clientX - left) / width) * MAP.width, ((clientY - top) / height) * HEIGHT));
  }

  step(event) {
    const way = ARROWS[event.key];
    if (!way || !this.looked) return;
    event.preventDefault();
    this.look({ inclination_deg: this.looked.inclination_deg + way[0], anteversion_deg: this.looked.anteversion_deg + way[1] });
  }

  /** Marks the square that holds these angles, and says what is so there and because of which motion. */
  look(angles) {
    if (!angles) return;
    const { squares, legs } = this.found;
    const holds = (k) => Math.abs(squares[k] - angles.inclination_deg) <= squares[k + 2] && Math.abs(squares[k + 1] - angles.anteversion_deg) <= squares[k + 2];
    let k = 0;
    while (k < squares.length && !holds(k)) k += SQUARE;
    if (k === squares.length) return; // beside the map
    this.looked = angles;
    const [, , , state, leg] = squares.subarray(k, k + SQUARE);
    for (const [name, value] of Object.entries(this.rectangle(k))) this.mark.setAttribute(name, value);
    const words = `At inclination ${angles.inclination_deg.toFixed(1)}° and anteversion ${angles.anteversion_deg.toFixed(1)}°: ${WORDS[state]}${leg < 0 ? "" : `: ${legWords(legs[leg])}`}.`;
    byId("orientation-here").textContent = words;
  }

  draw() {
    const { squares, map, as_scanned: now, area_deg2: area, nearest_free: nearest } = this.found;
    const across = (MAP.width - MAP.left - MAP.right) / map.width_deg;
    const up = (HEIGHT - MAP.top - MAP.bottom) / map.width_deg;
    const x = (inclination) => MAP.left + (inclination - map.least_inclination_deg) * across;
    const y = (anteversion) => HEIGHT - MAP.bottom - (anteversion - map.least_anteversion_deg) * up;
    this.angles = (px, py) => ({ inclination_deg: map.least_inclination_deg + (px - MAP.left) / across, anteversion_deg: map.least_anteversion_deg + (HEIGHT - MAP.bottom - py) / up });
    this.rectangle = (k) => {
      const [inclination, anteversion, half] = squares.subarray(k, k + 3);
      return { x: x(inclination - half), y: y(anteversion + half), width: 2 * half * across + 0.15, height: 2 * half * up + 0.15 };
    };
    const cells = Array.from({ length: squares.length / SQUARE }, (_, k) => drawn("rect", { ...this.rectangle(SQUARE * k), fill: STATES[squares[SQUARE * k + 3]][1] }));
    this.mark = drawn("rect", { class: "mark" });
    byId("orientation-plot").replaceChildren(...cells,
      ...mapLabels(HEIGHT, { x, y, xs: [0, 15, 30, 45, 60, 75, 90], ys: [-30, -15, 0, 15, 30, 45, 60], xTitle: "inclination, degrees", yTitle: "anteversion, degrees" }),
      ...[[nearest, "nearest"], [now, "now"]].filter(([at]) => at).map(([at, name]) => drawn("circle", { r: 4, class: name, cx: x(at.inclination_deg), cy: y(at.anteversion_deg) })), this.mark);
    const there = STATES.filter((_, state) => [area.free, area.blocked, area.unknown, area.open][state] > 0);
    byId("orientation-key").replaceChildren(`the ring is the socket as scanned; ${nearestWords(this.found)}`, ...there.map(([text, colour]) => keyRow({ colours: [colour], text })));
    this.say(`As it is, at inclination ${now.inclination_deg.toFixed(1)}° and anteversion ${now.anteversion_deg.toFixed(1)}°: `
      + `${now.state === "open" ? "undecided" : now.state}. Free are ${roundedDown(area.free, 0)} to ${roundedUp(area.free + area.open, 0)} of ${map.width_deg ** 2} square degrees, ${area.unknown.toFixed(1)} unknown.${turnWords(this.found)}`);
  }
}
