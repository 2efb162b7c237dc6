// SPDX-License-Identifier: GPL-3.0-or-later
// Which joint: a reader's own one, or a preset of the library with its side and each of its parameters.
import { byId, fillChoice, make, sliderRow } from "./elements.js";
import { labelOf, presetLabel } from "./names.js";
import { OWN } from "./state.js";

const GROUPS = [
  ["Cam", ["cam_"]],
  ["Head and neck", ["head_", "neck_", "femoral_", "shaft_", "conchoid_"]],
  ["Socket", ["joint_space", "inclination", "version", "half_opening", "lateral_", "wall_"]],
  ["Pincer", ["pincer_"]],
  ["Trochanters and spine", ["greater_", "lesser_", "aiis_"]],
  ["Fossa and centre", ["fossa_", "shift_"]],
];
const UNITS = { deg: ["°", 1], h: ["h", 0.25], mm: ["mm", 0.1], 1: ["", 0.01] }; // and steps of a slider
const WAIT = 120; // ms without a change before a joint is built again

export class JointPanel {
  /** onChange() when another joint is asked for. */
  constructor(app, onChange) {
    Object.assign(this, { app, onChange, shows: new Map(), timer: 0 });
    byId("preset").addEventListener("change", () => this.choose(byId("preset").value));
    byId("side").addEventListener("change", () => { app.state.joint.side = byId("side").value; this.onChange(); });
    byId("reset-parameters").addEventListener("click", () => this.choose(app.state.joint.name));
  }

  setCatalogue({ presets, parameters }) {
    this.presets = presets;
    fillChoice(byId("preset"), presets.map(({ name }) => ({ value: name, text: presetLabel(name) })));
    GROUPS.forEach(([title, beginnings], k) => {
      const rows = make("div");
      byId("parameters").append(make("details", { open: k === 0 }, make("summary", { textContent: title }), rows));
      parameters.filter(({ key }) => beginnings.some((beginning) => key.startsWith(beginning))).forEach((parameter) => {
        const [unit, step] = UNITS[parameter.unit];
        const row = { ...parameter, key: `parameter-${parameter.key}`, label: labelOf(parameter.key), unit, step };
        this.shows.set(parameter.key, sliderRow(rows, row, (value) => this.set(parameter.key, value)));
      });
    });
  }

  preset() {
    return this.presets.find(({ name }) => name === this.app.state.joint.name);
  }

  /** What the page calls the joint that the state names. */
  name() {
    return this.preset() ? presetLabel(this.preset().name) : this.app.own?.label ?? "";
  }

  choose(name) {
    const side = this.presets.find((each) => each.name === name)?.side ?? this.app.own.side;
    this.app.state.joint = { name, side, parameters: {} };
    this.show();
    this.onChange();
  }

  set(key, value) {
    this.app.state.joint.parameters[key] = value;
    clearTimeout(this.timer);
    byId("stage").setAttribute("aria-busy", "true");
    this.timer = setTimeout(() => this.onChange(), WAIT);
  }

  /** Brings the controls up to the state. A reader's own joint is one of the choice, and has no parameters. */
  show() {
    clearTimeout(this.timer); // a change of what was there before
    const { joint } = this.app.state;
    const own = joint.name === OWN;
    const choice = byId("preset");
    choice.querySelector(`option[value="${OWN}"]`)?.remove();
    if (this.app.own) choice.prepend(make("option", { value: OWN, textContent: `Your own: ${this.app.own.label}` }));
    choice.value = joint.name;
    byId("side").value = joint.side;
    byId("generated").hidden = byId("side").hidden = own;
    byId("own-say").hidden = !own;
    const values = { ...this.preset()?.parameters, ...joint.parameters };
    this.shows.forEach((show, key) => { if (key in values) show(values[key]); });
  }

  /** The question to the library about a generated hip. */
  request() {
    const { name, side, parameters } = this.app.state.joint;
    return { source: "preset", name, parameters: { ...parameters, side } };
  }
}
