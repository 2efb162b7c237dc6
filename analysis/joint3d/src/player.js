// SPDX-License-Identifier: GPL-3.0-or-later
// The recorded motions of the thesis' Table 11, played: from the pose of the scan to the recorded angle and back.
import { byId, fillChoice } from "./elements.js";
import { labelOf } from "./names.js";
import { TURNS } from "./state.js";

const SPEED = 30; // degrees a second

export class Player {
  /** onMove() after the state's motion was changed. */
  constructor(app, onMove) {
    Object.assign(this, { app, onMove, playing: false, steps: [], done: 0 });
    this.scrub = byId("play-at");
    byId("play").addEventListener("click", () => (this.playing ? this.stop() : this.play()));
    byId("play-motion").addEventListener("change", () => { this.stop(); this.done = 0; this.scrub.value = 0; });
    this.scrub.addEventListener("input", () => {
      this.stop();
      this.load();
      this.done = (Number(this.scrub.value) / 100) * this.length();
      this.pose();
    });
  }

  setMotions(recorded) {
    const of = (patient, word) => ({
      label: `Patient ${word}, Table 11`,
      options: [
        ...recorded.map((motion) => ({ value: `${patient} ${motion.motion}`, text: `${labelOf(motion.motion)} to ${motion[patient]}°` })),
        { value: `${patient} all`, text: "all six, one after the other" },
      ],
    });
    this.recorded = recorded;
    fillChoice(byId("play-motion"), [of("patient_a", "A"), of("patient_b", "B")]);
    byId("play-motion").value = "patient_a flexion";
  }

  load() {
    const [patient, wanted] = byId("play-motion").value.split(" ");
    const chosen = this.recorded.filter(({ motion }) => wanted === "all" || motion === wanted);
    this.steps = chosen.map((motion) => ({ axis: TURNS[motion.motion], most: motion[patient] }));
  }

  length() {
    return this.steps.reduce((sum, { most }) => sum + 2 * most, 0);
  }

  play() {
    this.load();
    if (this.done >= this.length()) this.done = 0;
    this.playing = true;
    this.label();
    let before = performance.now();
    const frame = (now) => {
      if (!this.playing) return;
      this.done += (Math.max(now - before, 0) / 1000) * SPEED;
      before = now;
      const end = this.done >= this.length();
      if (end) this.done = this.length();
      this.pose();
      if (end) this.stop();
      else requestAnimationFrame(frame);
    };
    requestAnimationFrame(frame);
  }

  stop() {
    this.playing = false;
    this.label();
  }

  label() {
    byId("play").textContent = this.playing ? "Pause" : "Play";
    byId("play").setAttribute("aria-pressed", String(this.playing));
  }

  /** The pose after `done` degrees of the way. */
  pose() {
    const motion = { flexion: 0, abduction: 0, internal_rotation: 0 };
    let left = this.done;
    for (const { axis: [key, sign], most } of this.steps) {
      if (left <= 2 * most) {
        motion[key] = sign * (left <= most ? left : 2 * most - left);
        break;
      }
      left -= 2 * most;
    }
    this.scrub.value = String((100 * this.done) / this.length());
    this.app.state.motion = motion;
    this.onMove();
  }
}
