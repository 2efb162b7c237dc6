// SPDX-License-Identifier: GPL-3.0-or-later
// What the page shows, as plain data, and the same as a link fragment. Angles in degrees, lengths in mm.

export const ANGLES = ["flexion", "abduction", "internal_rotation"];
export const VIEWS = ["free", "anterior", "posterior", "medial", "lateral", "superior"];
export const DRAWINGS = ["filled", "lines", "blended"];
export const COLOURS = ["levels", "safe"];
export const SHOWN = ["ball", "socket", "pelvis", "clock", "points", "smallest"];

export function firstState() {
  return {
    joint: { name: "patient_a", side: "right", parameters: {} }, // of the library's presets; parameters that differ from it
    motion: { flexion: 0, abduction: 0, internal_rotation: 0 },
    offset: [0, 0, 0], // of the ball, to the right, forward, up
    cartilage: 4,
    tables: { scheme: "cube_gnomonic", precision_deg: 0.35, storage: "uint16" },
    look: { view: "free", drawing: "filled", colours: "levels", shown: ["ball", "socket", "clock", "smallest"] },
    sweep: "flexion",
  };
}

const short = (value) => String(Math.round(value * 1e6) / 1e6);
const pairs = (object) => Object.entries(object).map(([key, value]) => `${key}:${short(value)}`).join(",");

/** The state as "joint=cam&flexion=90": only the hip's own words, so that one can read and write it. */
export function toFragment(state) {
  const words = new URLSearchParams();
  words.set("joint", state.joint.name);
  words.set("side", state.joint.side);
  if (Object.keys(state.joint.parameters).length) words.set("set", pairs(state.joint.parameters));
  ANGLES.forEach((angle) => words.set(angle, short(state.motion[angle])));
  if (state.offset.some(Boolean)) words.set("offset", state.offset.map(short).join(","));
  words.set("cartilage", short(state.cartilage));
  words.set("scheme", state.tables.scheme);
  words.set("precision", short(state.tables.precision_deg));
  words.set("storage", state.tables.storage);
  words.set("view", state.look.view);
  words.set("drawing", state.look.drawing);
  words.set("colours", state.look.colours);
  words.set("show", state.look.shown.join(","));
  words.set("sweep", state.sweep);
  return words.toString().replaceAll("%2C", ",").replaceAll("%3A", ":");
}

const oneOf = (list, word, otherwise) => (list.includes(word) ? word : otherwise);

function number(text, least, most, otherwise) {
  const value = text === null || text.trim() === "" ? NaN : Number(text);
  return value >= least && value <= most ? value : otherwise;
}

function readPairs(text) {
  const entries = (text ?? "").split(",").map((pair) => pair.split(":"));
  return Object.fromEntries(entries.filter(([key, value]) => key && value && Number.isFinite(Number(value)))
    .map(([key, value]) => [key, Number(value)]));
}

/** A state from a fragment; what is missing or makes no sense is as at first. The library judges names and ranges. */
export function fromFragment(fragment) {
  const words = new URLSearchParams(fragment.replace(/^#/, ""));
  const state = firstState();
  const { joint, motion, tables, look } = state;
  joint.name = words.get("joint") ?? joint.name;
  joint.side = oneOf(["left", "right"], words.get("side"), joint.side);
  joint.parameters = readPairs(words.get("set"));
  ANGLES.forEach((angle) => { motion[angle] = number(words.get(angle), -180, 180, 0); });
  const offset = (words.get("offset") ?? "").split(",").map((text) => number(text, -50, 50, 0));
  if (offset.length === 3) state.offset = offset;
  state.cartilage = number(words.get("cartilage"), 0, 20, state.cartilage);
  tables.scheme = words.get("scheme") ?? tables.scheme;
  tables.precision_deg = number(words.get("precision"), 0.01, 90, tables.precision_deg);
  tables.storage = oneOf(["uint16", "float", "double"], words.get("storage"), tables.storage);
  look.view = oneOf(VIEWS, words.get("view"), look.view);
  look.drawing = oneOf(DRAWINGS, words.get("drawing"), look.drawing);
  look.colours = oneOf(COLOURS, words.get("colours"), look.colours);
  if (words.has("show")) look.shown = words.get("show").split(",").filter((word) => SHOWN.includes(word));
  state.sweep = words.get("sweep") ?? state.sweep;
  return state;
}
