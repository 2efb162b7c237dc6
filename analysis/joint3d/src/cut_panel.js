// SPDX-License-Identifier: GPL-3.0-or-later
// The least radial cut of the femur with which required motions are reached: how much, and the femur before and after it.
import { ChangePanel } from "./change_panel.js";
import { byId, legWords, make, oneOfButtons, roundedDown, roundedUp } from "./elements.js";

const ends = ([low, high], places, unit) => `${roundedDown(low, places)} to ${roundedUp(high, places)} ${unit}`;

/** A limit of a part of a required path; required: how far, degrees. Of an unknown one nothing is known beyond its low end. */
export function reached({ state, low_deg: low }, required) {
  if (state === "free" || low >= required) return state === "limited" ? `yes, to ${roundedDown(low, 1)}°` : "yes";
  return state === "blocked" ? "no" : `${state === "limited" ? "" : "not before "}${roundedDown(low, 1)}°`;
}

export class CutPanel extends ChangePanel {
  /** onCut(cut): the library's reply to `resect` when the femur is shown after it, else null. */
  constructor(app, open, onCut) {
    super(app, open, { id: "cut", kind: "resect", number: "clearance" });
    this.onCut = onCut;
    this.after = false;
    byId("cut").addEventListener("toggle", () => { if (this.found) this.switchTo(byId("cut").open && !byId("cut-shown").hidden); });
    this.showSwitch = oneOfButtons(byId("cut-shown"), (value) => this.switchTo(value === "after"));
  }

  question() {
    return { require: this.motions(), clearance_mm: this.app.state.clearance };
  }

  clear() {
    byId("cut-found").hidden = true;
    this.switchTo(false);
  }

  switchTo(after) {
    this.after = after;
    this.showSwitch(after ? "after" : "before");
    this.onCut(after ? this.found : null);
  }

  draw() {
    const { volume_mm3: volume, area_mm2: area, depth_mm: depth, neck, legs } = this.found;
    byId("cut-found").hidden = false;
    const nothing = volume[1] <= 0;
    const rows = nothing ? [["To remove", "nothing"]] : [["Volume", ends(volume, 0, "mm³")], ["Area", ends(area, 0, "mm²")], ["Largest depth", ends(depth, 2, "mm")]];
    if (neck) rows.push(["Neck left whole", `${roundedDown(neck.after_mm, 1)} of ${roundedDown(neck.before_mm, 1)} mm`]);
    byId("cut-numbers").replaceChildren(...rows.map(([name, amount]) => make("div", {}, make("dt", { textContent: name }), make("dd", { textContent: amount }))));
    byId("cut-rows").replaceChildren(...legs.map(({ words, required_deg: required, before, after }) => make("tr", {},
      make("th", { scope: "row", textContent: legWords(words) }),
      make("td", { textContent: reached(before, required) }), make("td", { textContent: reached(after, required) }))));
    byId("cut-shown").hidden = nothing;
    if (!nothing) this.switchTo(true);
  }
}
