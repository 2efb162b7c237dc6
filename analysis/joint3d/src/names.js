// SPDX-License-Identifier: GPL-3.0-or-later
// What the library has names for, as a reader sees it.

/** "Neck shaft angle" of neck_shaft_angle. */
export const labelOf = (name) => name[0].toUpperCase() + name.slice(1).replaceAll("_", " ");

export const presetLabel = (name) => (name.startsWith("patient_") ? `Patient ${name.at(-1).toUpperCase()} (stand-in)` : labelOf(name));

/** "Internal rotation at 45 degrees of flexion", "FADIR (at 90 of flexion and 15 of adduction)". */
export function motionLabel({ name, growing, meaning }) {
  if (name !== growing && name.startsWith(growing)) return `${labelOf(growing)} ${meaning}`;
  return `${name === growing ? labelOf(name) : name.toUpperCase()} (${meaning})`;
}
