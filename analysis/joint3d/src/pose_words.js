// SPDX-License-Identifier: GPL-3.0-or-later
// A pose in words, for pictures and the names of files.

const ANGLES = [["flexion", "Flexion", "Extension"], ["abduction", "Abduction", "Adduction"], ["internal_rotation", "Internal rotation", "External rotation"]];
const short = (value) => String(Math.round(Math.abs(value) * 100) / 100);
const given = (motion) => ANGLES.map(([key, more, less]) => ({ value: motion[key], word: motion[key] < 0 ? less : more })).filter(({ value }) => value);

/** "ball shifted by 0.0, 0.0, 1.0 mm to the right, forward, up", or nothing. */
export const shiftWords = (offset) => (offset.some(Boolean) ? `ball shifted by ${offset.map((x) => x.toFixed(1).replace("-", "−")).join(", ")} mm to the right, forward, up` : "");

/** "Flexion 90°, adduction 15°", "all angles 0". motion: of the state, degrees; offset: mm to the right, forward, up. */
export function poseWords({ motion, offset }) {
  const angles = given(motion).map(({ value, word }, k) => `${k ? word.toLowerCase() : word} ${short(value)}°`).join(", ") || "All angles 0";
  return [angles, shiftWords(offset)].filter(Boolean).join("; ");
}

/** "cam_right_flexion_90": what a file of that joint and pose is called. name: of the joint; side: or null. */
export function fileStem(name, side, { motion, offset }) {
  const words = [name.replace(/\.\w+(?= and |$)/g, ""), side ?? "", ...given(motion).flatMap(({ value, word }) => [word, short(value)]), offset.some(Boolean) ? "shifted" : ""];
  return words.join(" ").normalize("NFKD").replace(/\p{M}/gu, "").replace(/[^\w.]+/g, "_").replace(/^_+|_+$/g, "").toLowerCase();
}
