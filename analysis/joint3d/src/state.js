// SPDX-License-Identifier: GPL-3.0-or-later
// What the page shows, as plain data, and the same as a link fragment. Angles in degrees, lengths in mm.

export const ANGLES = ["flexion", "abduction", "internal_rotation"];
export const TURNS = { // of each motion: the angle that changes, and which way
  flexion: ["flexion", 1], extension: ["flexion", -1],
  abduction: ["abduction", 1], adduction: ["abduction", -1],
  internal_rotation: ["internal_rotation", 1], external_rotation: ["internal_rotation", -1],
};
export const OWN = "own"; // the name of a reader's own joint

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

function numberIn(text, least, most) {
  const value = text.trim() === "" ? NaN : Number(text);
  return value >= least && value <= most ? value : undefined;
}

// How a value is read, undefined where it makes no sense, and written.
const TEXT = { read: (text) => text, write: String };
const FLAG = { read: (text) => text === "1", write: () => "1" };
const number = (least, most) => ({ read: (text) => numberIn(text, least, most), write: short });
const numbers = (count, most, write) => ({
  read: (text) => {
    const values = text.split(",").map((each) => numberIn(each, -most, most));
    return values.length === count && !values.includes(undefined) ? values : undefined;
  },
  write: (values) => values.map(write).join(","),
});
const oneOf = (...words) => ({ read: (text) => words.find((word) => word === text), write: String });
const someOf = (...words) => ({ read: (text) => text.split(",").filter((word) => words.includes(word)), write: (list) => list.join(",") });
const PAIRS = {
  read: (text) => Object.fromEntries(text.split(",").map((pair) => pair.split(":"))
    .filter(([key, value]) => key && value && Number.isFinite(Number(value))).map(([key, value]) => [key, Number(value)])),
  write: (object) => Object.entries(object).map(([key, value]) => `${key}:${short(value)}`).join(","),
};

const LEFT_OUT = true; // where it is as at first
const WORDS = [ // of a fragment: where it stands in the state
  ["joint", "joint.name", TEXT],
  ["side", "joint.side", oneOf("left", "right")],
  ["set", "joint.parameters", PAIRS, LEFT_OUT],
  ...ANGLES.map((angle) => [angle, `motion.${angle}`, number(-180, 180)]),
  ["offset", "offset", numbers(3, 50, short), LEFT_OUT],
  ["cartilage", "cartilage", number(0, 20)],
  ["scheme", "tables.scheme", TEXT],
  ["precision", "tables.precision_deg", number(0.01, 90)],
  ["storage", "tables.storage", oneOf("uint16", "float", "double")],
  ["view", "look.view", oneOf("free", "anterior", "posterior", "medial", "lateral", "superior", "inferior")],
  ["drawing", "look.drawing", oneOf("filled", "lines", "blended")],
  ["colours", "look.colours", oneOf("levels", "safe")],
  ["show", "look.shown", someOf("ball", "socket", "pelvis", "clock", "points", "smallest")],
  ["camera", "look.camera", numbers(6, 1e4, (x) => x.toFixed(1)), LEFT_OUT],
  ["sweep", "sweep", TEXT],
  ["held", "held", FLAG, LEFT_OUT],
  ["rim", "rim", FLAG, LEFT_OUT],
  ["require", "required", TEXT, LEFT_OUT],
  ["clearance", "clearance", number(0.01, 10), LEFT_OUT],
  ["tilt", "tilt", number(-90, 90), LEFT_OUT],
];
const valueAt = (state, path) => path.split(".").reduce((value, key) => value[key], state);

/** The state as "joint=cam&flexion=90": only the hip's own words, so that one can read and write it. */
export function toFragment(state) {
  const words = new URLSearchParams();
  WORDS.forEach(([word, path, { write }, leftOut]) => {
    const [value, first] = [state, firstState()].map((each) => valueAt(each, path));
    if (!leftOut || JSON.stringify(value) !== JSON.stringify(first)) words.set(word, write(value));
  });
  return words.toString().replaceAll("%2C", ",").replaceAll("%3A", ":");
}

/** A state from a fragment; what is missing or makes no sense is as at first. The library judges names and ranges. */
export function fromFragment(fragment) {
  const words = new URLSearchParams(fragment.replace(/^#/, ""));
  const state = firstState();
  WORDS.filter(([word]) => words.has(word)).forEach(([word, path, { read }]) => {
    const [key, holder = ""] = path.split(".").reverse();
    const value = read(words.get(word));
    if (value !== undefined) (holder ? state[holder] : state)[key] = value;
  });
  return state;
}
