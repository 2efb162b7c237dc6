// SPDX-License-Identifier: GPL-3.0-or-later
// A joint in words: its name, centre, size, and what the library remarks on its meshes.
import { byId } from "./elements.js";

const count = (faces) => (faces.length / 3).toLocaleString("en");

/** joint: the library's reply to `joint`; files: the names of a reader's meshes, else null. */
export function showJoint(joint, files) {
  const name = files ?? byId("preset").selectedOptions[0]?.textContent ?? "";
  byId("joint-name").textContent = `${name}, ${joint.side ?? "side unknown"}`;
  const centre = joint.centre.map((x) => x.toFixed(2)).join(", ");
  byId("centre-say").textContent = joint.fit
    ? `Centre fitted at ${centre} mm: radius ${joint.fit.radius_mm.toFixed(2)} mm, residual ${joint.fit.residual_mm.toFixed(2)} mm.`
    : `Centre at ${centre} mm.`;
  byId("remarks").textContent = joint.warnings.join("\n") || "Nothing to remark.";
  if (files) byId("remarks").parentElement.open = joint.warnings.length > 0;
  byId("faces").textContent = `${count(joint.ball.faces)} + ${count(joint.socket.faces)}`;
}

/** One line about remarks on a reader's meshes, the first of them in full, or none. */
export function remarkLine({ warnings }, files) {
  if (!files || !warnings.length) return "";
  const more = warnings.length - 1;
  return `${warnings[0]}${more ? `; ${more === 1 ? "one remark" : `${more} remarks`} more under “About the meshes”` : ""}.`;
}
