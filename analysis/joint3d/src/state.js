// SPDX-License-Identifier: GPL-3.0-or-later
// What the page shows, as plain data, and the same as a link fragment. Angles in degrees, lengths in mm.

export const ANGLES = ["flexion", "abduction", "internal_rotation"];
export const TURNS = { // of each motion: the angle that changes, and which way
  flexion: ["flexion", 1], extension: ["flexion", -1],
  abduction: ["abduction", 1], adduction: ["abduction", -1],
  internal_rotation: ["internal_rotation", 1], external_rotation: ["internal_rotation", -1],
};
const VIEWS = ["free", "anterior", "posterior", "medial", "lateral", "superior", "inferior"];
const DRAWINGS = ["filled", "lines", "blended"];
export const COLOURS = ["levels", "safe"];
export const OWN = "own"; // the name of a reader's own joint
const SHOWN = ["ball", "socket", "pelvis", "clock", "points", "smallest"];

export function firstState() {
  return {
    joint: { name: "patient_a", side: "right", parameters: {} }, // of the library's presets, or OWN; parameters that differ from it
    motion: { flexion: 0, abduction: 0, internal_rotation: 0 },
    offset: [0, 0, 0], // of the ball, to the right, forward, up
    cartilage: 4,
    tables: { scheme: "cube_gnomonic", precision_deg: 0.35, storage: "uint16" },
    look: { view: "free", drawing: "filled", colours: "levels", shown: ["ball", "socket", "clock", "smallest"],
      camera: null }, // where a reader has turned it to: x, y, z of the camera and of what it looks at, mm, joint frame
    sweep: "flexion",
    rim: false, // limits of all motions: of the rim alone
    held: false, // the other angles of the pose, while one grows
    required: "flexion=90, internal_rotation=30", // motions that a cut or another orientation is to reach, ";" between them
    clearance: 0.5, // that a cut leaves
    tilt: 0, // of the pelvis backwards, for the map of orientations
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
  if (state.look.camera) words.set("camera", state.look.camera.map((x) => x.toFixed(1)).join(","));
  words.set("sweep", state.sweep);
  if (state.held) words.set("held", "1");
  if (state.rim) words.set("rim", "1");
  const first = firstState();
  if (state.required !== first.required) words.set("require", state.required);
  if (state.clearance !== first.clearance) words.set("clearance", short(state.clearance));
  if (state.tilt !== first.tilt) words.set("tilt", short(state.tilt));
  return words.toString().replaceAll("%2C", ",").replaceAll("%3A", ":");
}

const oneOf = (list, word, otherwise) => (list.includes(word) ? word : otherwise);

function number(text, least, most, otherwise) {
  const value = text === null || text.trim() === "" ? NaN : Number(text);
  return value >= least && value <= most ? value : otherwise;
}

/** So many numbers of at most that size, or null. */
function numbers(text, count, most) {
  const values = (text ?? "").split(",").map((each) => number(each, -most, most, NaN));
  return values.length === count && values.every(Number.isFinite) ? values : null;
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
  state.offset = numbers(words.get("offset"), 3, 50) ?? state.offset;
  state.cartilage = number(words.get("cartilage"), 0, 20, state.cartilage);
  tables.scheme = words.get("scheme") ?? tables.scheme;
  tables.precision_deg = number(words.get("precision"), 0.01, 90, tables.precision_deg);
  tables.storage = oneOf(["uint16", "float", "double"], words.get("storage"), tables.storage);
  look.view = oneOf(VIEWS, words.get("view"), look.view);
  look.drawing = oneOf(DRAWINGS, words.get("drawing"), look.drawing);
  look.colours = oneOf(COLOURS, words.get("colours"), look.colours);
  if (words.has("show")) look.shown = words.get("show").split(",").filter((word) => SHOWN.includes(word));
  look.camera = numbers(words.get("camera"), 6, 1e4);
  state.sweep = words.get("sweep") ?? state.sweep;
  state.held = words.get("held") === "1";
  state.rim = words.get("rim") === "1";
  state.required = words.get("require") ?? state.required;
  state.clearance = number(words.get("clearance"), 0.01, 10, state.clearance);
  state.tilt = number(words.get("tilt"), -90, 90, state.tilt);
  return state;
}
