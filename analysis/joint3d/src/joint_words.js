// SPDX-License-Identifier: GPL-3.0-or-later
// A joint in words: its name, centre, size, and what the library remarks on its meshes.
import { byId } from "./elements.js";
import { likelyUnits } from "./files_panel.js";

const count = (faces) => (faces.length / 3).toLocaleString("en");
const remarks = (number) => (number === 1 ? "one remark" : `${number} remarks`);

const thousands = (number) => number.toLocaleString("en");
const angle = (degrees) => `${degrees.toFixed(1).replace("-", "−")}°`;

/** What of whole bones is the joint: a sentence each. */
export const takenWords = (taken) => Object.entries(taken).filter(([, of]) => of).map(([part, { faces, of, within_mm: within }]) =>
  `Of the ${part === "ball" ? "femur" : "pelvis"} ${thousands(faces)} of ${thousands(of)} faces, within ${within.toFixed(1)} mm of the centre, are the ${part}; the rest counts as bone beside it.`);

/** What landmarks changed: a sentence, or none. */
export function framesWords(frames) {
  if (!frames) return [];
  const { pelvic_tilt_deg: tilt, scanned_flexion_deg: flexion, scanned_abduction_deg: abduction, scanned_internal_rotation_deg: rotation } = frames;
  const from = flexion === null ? "angles are counted from the pose of the scan"
    : `angles are counted from neutral, and the femur was scanned at flexion ${angle(flexion)}, abduction ${angle(abduction)}, internal rotation ${angle(rotation)}`;
  return [`By the landmarks the pelvis is tilted by ${angle(tilt)} in the scan; ${from}.`];
}

/** joint: the library's reply to `joint`; name: what the page calls it; own: it is of a reader's meshes. */
export function showJoint(joint, name, own) {
  byId("joint-name").textContent = `${name}, ${joint.side ?? "side unknown"}`;
  const centre = joint.centre.map((x) => x.toFixed(2)).join(", ");
  byId("centre-say").textContent = joint.fit
    ? `Centre fitted at ${centre} mm: radius ${joint.fit.radius_mm.toFixed(2)} mm, residual ${joint.fit.residual_mm.toFixed(2)} mm.`
    : `Centre at ${centre} mm.`;
  byId("remarks").textContent = joint.warnings.join("\n") || "Nothing to remark.";
  if (own) byId("remarks").parentElement.open = joint.doubts > 0;
  const axes = own && joint.axes_from === "header" ? `, axes ${joint.axes} as the headers say` : "";
  const said = `Taken${axes}, with ${joint.warnings.length ? `${remarks(joint.warnings.length)} under “About the meshes”` : "nothing to remark"}.`;
  byId("files-say").textContent = own ? [said, ...takenWords(joint.taken), ...framesWords(joint.frames)].join(" ") : "";
  byId("faces").textContent = `${count(joint.ball.faces)} + ${count(joint.socket.faces)}`;
}

const SIDES = { left: "right", right: "left" };

/** What would mend a joint with that doubt: [{ text, change }] with other fields of the panel of files. */
function cures(joint, { side, unit }) {
  if (/lengths are read as mm/.test(joint.warnings[0]) && joint.fit)
    return likelyUnits(joint.fit.radius_mm, unit).map((each) => ({ text: `Lengths are in ${each}`, change: { unit: each } }));
  if (!/lies to the (left|right) of the ball/.test(joint.warnings[0])) return [];
  const turned = joint.axes_from !== "header" && { RAS: "LPS", LPS: "RAS" }[joint.axes];
  return [{ text: `It is the ${SIDES[side]} hip`, change: { side: SIDES[side] } },
    ...(turned ? [{ text: `Its axes are ${turned}`, change: { axes: turned } }] : [])];
}

/** What makes a reader's joint itself doubtful, the first of it in full, and what would mend it, or nothing: { text, actions }. own: as of FilesPanel; use(change). */
export function doubtOf(joint, own, use) {
  if (!joint.doubts) return { text: "", actions: [] };
  const more = joint.warnings.length - 1;
  const text = `This cannot be right: ${joint.warnings[0]}${more ? `; ${remarks(more)} more under “About the meshes”` : ""}.`;
  return { text, actions: cures(joint, own).map(({ text: label, change }) => ({ text: label, act: () => use(change) })) };
}
