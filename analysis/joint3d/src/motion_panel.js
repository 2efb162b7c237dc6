// SPDX-License-Identifier: GPL-3.0-or-later
// Sliders and numbers of the pose, and of the cartilage.
import { byId, sliderRow } from "./elements.js";

const WIDEST = [-180, 180]; // what the library takes
const ROWS = [
  { key: "flexion", label: "Flexion", least: -90, most: 160, ends: ["extension", "flexion"] },
  { key: "abduction", label: "Abduction", least: -90, most: 90, ends: ["adduction", "abduction"] },
  { key: "internal_rotation", label: "Rotation", least: -120, most: 120, ends: ["external", "internal"] },
];
const OFFSETS = [["right", "To the right"], ["forward", "Forward"], ["up", "Up"]];

/** The nearest angle that the library takes. */
export const inRange = (angle) => Math.min(Math.max(angle, WIDEST[0]), WIDEST[1]);

/** onChange() after a value of the state has changed. Returns show(), which brings the rows up to the state. */
export function motionPanel(app, onChange) {
  const shows = ROWS.map((row) => {
    const show = sliderRow(byId("motion-rows"), { ...row, unit: "°", step: 0.1, widest: WIDEST }, (value) => {
      app.player.stop();
      app.state.motion[row.key] = value;
      onChange();
    });
    return () => show(app.state.motion[row.key]);
  });
  OFFSETS.forEach(([key, label], axis) => {
    const row = { key: `offset-${key}`, label, unit: "mm", least: -10, most: 10, step: 0.1 };
    const show = sliderRow(byId("offset-rows"), row, (value) => { app.state.offset[axis] = value; onChange(); });
    shows.push(() => show(app.state.offset[axis]));
  });
  const cartilage = { key: "cartilage", label: "Cartilage, in all", unit: "mm", least: 0, most: 12, step: 0.1 };
  const showCartilage = sliderRow(byId("cartilage-row"), cartilage, (value) => { app.state.cartilage = value; onChange(); });
  shows.push(() => showCartilage(app.state.cartilage));
  const show = () => shows.forEach((each) => each());
  byId("reset-pose").addEventListener("click", () => {
    app.player.stop();
    app.state.motion = { flexion: 0, abduction: 0, internal_rotation: 0 };
    app.state.offset = [0, 0, 0];
    show();
    onChange();
  });
  return show;
}
