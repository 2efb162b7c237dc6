// SPDX-License-Identifier: GPL-3.0-or-later
// The smallest gap along a motion, with the limit that no step can jump over.
import { byId, fillChoice, make, roundedDown, roundedUp } from "./elements.js";
import { inWords } from "./messages.js";
import { motionLabel } from "./names.js";
import { drawSweep } from "./plots.js";
import { TURNS } from "./state.js";

const WAIT = 350; // ms of rest before a motion is swept again
const LARGEST = 150; // degrees that are swept
const WITHIN = 0.5; // mm: kErrorOfInput of the library

/** The pose at an angle of a motion. */
export function poseAlong(motion, degrees) {
  const [angle, sign] = TURNS[motion.growing];
  return { ...motion.start, [angle]: motion.start[angle] + sign * Math.round(degrees * 1e4) / 1e4 };
}

/** A proven range of angles. */
function range(low, high) {
  if (high === null) return low === 0 ? "not known" : `not before ${roundedDown(low, 1)}°`;
  return `at ${roundedDown(low, 1)}° to ${roundedUp(high, 1)}°`;
}

/** Where the limit is for another centre than the one at hand, and with play of the ball. */
function ofOtherCentres(limit) {
  const centre = range(limit.centre_low_deg, limit.centre_high_deg);
  const play = range(limit.play_low_deg, limit.play_high_deg);
  return ` With any centre within ${WITHIN} mm: ${centre}; with that much play of the ball: ${play}.`;
}

function halfMillimetre({ half_mm_gap_deg: half, what }) {
  const gap = half === null ? "" : ` The gap falls to ${WITHIN} mm at ${roundedDown(half, 1)}°.`;
  const [sensitive] = what.match(/sensitive to [^;]*/) ?? [];
  return sensitive ? `${gap} This limit is ${sensitive}, by more than 5°.` : gap;
}

const UNKNOWN = {
  "end of ball": "where the motion leaves the ball’s mesh",
  graze: "where surfaces graze",
  opening: "where whether one bone is inside the other hangs on an opening of a mesh",
};

function unknownBeyond({ low_deg: low, unknown_by: by }) {
  const where = UNKNOWN[by];
  return `up to ${roundedDown(low, 1)}° (certified), ${where}; nothing is known beyond`;
}

/** With more of the ball an impinged pose stays one: a limit beyond its mesh can only come earlier. */
function ofTheRest({ state, leaves_ball_mesh_deg: leaves }) {
  if (state !== "limited" || leaves === null) return "";
  return ` The ball’s mesh ends under the socket from ${roundedDown(leaves, 1)}° on: what is missing may come first.`;
}

function whatTouches({ centre, threshold_mm: threshold }) {
  if (threshold > 0) return `Layers of cartilage, ${threshold} mm in all, as the vertices see them,`;
  return centre === "ball" ? "Bones" : "About the socket’s centre, bones";
}

/** A certified limit in words. */
export function limitWords(limit) {
  const { state, low_deg: low, high_deg: high, clock, meets } = limit;
  const words = {
    limited: `first touch between ${roundedDown(low, 4)}° and ${roundedUp(high, 4)}°${clock ? `, at ${clock} o’clock` : ""}, ${meets} (certified: no contact is skipped)`,
    free: `do not touch up to ${roundedDown(low, 0)}° (certified)`,
    blocked: "touch or overlap at the start of this motion",
    unknown: `do not touch ${unknownBeyond(limit)}`,
  };
  return `${whatTouches(limit)} ${words[state]}.${state === "blocked" ? "" : ofOtherCentres(limit) + halfMillimetre(limit) + ofTheRest(limit)}`;
}

export class SweepPanel {
  /** ask(request) answers with the library's sweep; onPose(motion) when a reader points at an angle. */
  constructor(app, ask, onPose) {
    Object.assign(this, { app, ask, onPose, sweep: null, asked: 0, timer: 0 });
    byId("sweep-motion").addEventListener("change", (event) => { app.state.sweep = event.target.value; this.again(0); });
    byId("sweep-held").addEventListener("change", (event) => { app.state.held = event.target.checked; this.again(0); });
    byId("sweep-plot").addEventListener("click", (event) => {
      const box = byId("sweep-plot").getBoundingClientRect();
      if (this.sweep) this.goTo(this.angleAt((event.clientX - box.left) / box.width));
    });
    byId("sweep-go").addEventListener("click", () => { if (this.sweep) this.goTo(this.sweep.limits[0].low_deg); });
  }

  setCatalogue({ motions }) {
    this.motions = motions;
    fillChoice(byId("sweep-motion"), motions.map((motion) => ({ value: motion.name, text: motionLabel(motion) })));
  }

  motion() {
    return this.motions.find(({ name }) => name === this.app.state.sweep) ?? this.motions[0];
  }

  growing() {
    return TURNS[this.motion().growing];
  }

  start() {
    const { motion, held } = this.app.state;
    return held ? { ...motion, [this.growing()[0]]: 0 } : this.motion().start;
  }

  show() {
    byId("sweep-motion").value = this.motion().name;
    byId("sweep-held").checked = this.app.state.held;
  }

  /** Of another joint, of which it is then asked again: not even the curve holds. */
  forget() {
    byId("sweep-plot").replaceChildren();
  }

  /** Sweeps again after a rest; until then the curve before stays, faintly, and nothing can be done with it. */
  again(wait = WAIT) {
    clearTimeout(this.timer);
    this.asked += 1; // an answer that is under way is of what was before
    this.sweep = null;
    this.wanted = this.question();
    this.timer = setTimeout(() => this.run(), wait);
    byId("sweep-plot").classList.add("old");
    byId("sweep-say").textContent = "Working …";
    byId("sweep-go").disabled = true;
  }

  /** All that the curve and the limits depend on. */
  question() {
    const { offset, cartilage } = this.app.state;
    return JSON.stringify([this.motion().name, this.start(), offset, cartilage]);
  }

  /** A pose has changed: its place is marked; with the other angles held, or another shift, the motion is another. */
  posed() {
    if (this.question() !== this.wanted) this.again();
    this.draw();
  }

  async run() {
    const mine = (this.asked += 1);
    const along = { ...this.motion(), start: this.start() };
    try {
      const sweep = await this.ask({ motions: [along.name], pose: along.start, largest_deg: LARGEST });
      if (mine !== this.asked) return;
      this.sweep = { ...sweep, along };
      byId("sweep-plot").classList.remove("old");
      this.draw();
      this.say();
    } catch (error) {
      if (mine === this.asked) byId("sweep-say").textContent = inWords(error);
    }
  }

  say() {
    const { limits } = this.sweep;
    byId("sweep-go").disabled = limits[0].state !== "limited";
    byId("sweep-say").replaceChildren(...limits.map((limit) => make("p", { textContent: limitWords(limit) })));
  }

  /** The angle of the pose along the motion, or null where another angle is not as in it. */
  at() {
    const { growing, start } = this.sweep.along;
    const [angle, sign] = TURNS[growing];
    const { motion } = this.app.state;
    const same = Object.keys(start).every((key) => key === angle || Math.abs(start[key] - motion[key]) < 1e-6);
    return same ? sign * (motion[angle] - start[angle]) : null;
  }

  draw() {
    if (!this.sweep) return;
    const look = { title: this.sweep.along.growing.replace("_", " "), cartilage: this.app.state.cartilage, at: this.at() };
    this.angleAt = drawSweep(byId("sweep-plot"), this.sweep, look);
  }

  goTo(degrees) {
    this.onPose(poseAlong(this.sweep.along, degrees));
  }
}
