// SPDX-License-Identifier: GPL-3.0-or-later
// The limits of all named motions in one table, row by row, in the slow worker: bone about both centres, and cartilage.
import { byId, make, put, roundedDown, roundedUp } from "./elements.js";
import { motionLabel } from "./names.js";

const WAIT = 350; // ms of rest before they are worked out again
const COLUMNS = [["ball", false], ["socket", false], ["ball", true]]; // about whose centre, and with cartilage
const CSV = ["joint", "motion", "threshold_mm", "centre", "state", "low_deg", "high_deg", "centre_low_deg", "centre_high_deg", "half_mm_gap_deg", "clock", "what", "play_low_deg",
  "play_high_deg", "hangs_on_less_than_half_mm"];

/** One limit, short, and in full where a reader points at it. */
function shortly({ state, low_deg: low, high_deg: high, clock, what }) {
  const words = {
    limited: [`${roundedDown(low, 1)}°`, `between ${roundedDown(low, 4)}° and ${roundedUp(high, 4)}°${clock ? `, at ${clock} o’clock` : ""}`],
    free: ["free", `none up to ${roundedDown(low, 0)}°`],
    blocked: ["at once", "reached before the motion begins"],
    unknown: [`> ${roundedDown(low, 1)}°`, `none up to ${roundedDown(low, 1)}°; nothing is known beyond`],
  };
  const [text, title] = words[state];
  return [text, [title, what].filter(Boolean).join("; ")];
}

/** What of the meshes makes limits too large, as the program says it; the library's replies to `limits`, of which all say the same. */
export function missingWords([{ ball_cut_mm: cut, rim_in_head_mm: deep } = {}]) {
  return [cut && `The ball’s bone is cut off ${cut.toFixed(1)} mm from the centre, through its neck: what is missing beyond, of a femur trochanters and shaft, stops no motion, `
    + "so that limits may be too large; give the whole bone.",
  deep && `The rim lies in the head as scanned, up to ${roundedUp(deep, 1)} mm deep: there it meets the neck late, or not at all.`].filter(Boolean).join(" ");
}

/** limits.csv of [{ limits }], as the library told them; joint: its name; shift: of the ball, in words, or nothing. */
export function limitsCsv(joint, rows, shift = "") {
  const quoted = (text) => (/[",\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text);
  const lines = rows.flatMap(({ limits }) => limits.map((limit) => {
    const hangs = limit.hangs_on_less_than_half_mm ? "yes" : "no";
    const cells = { ...limit, hangs_on_less_than_half_mm: hangs, joint: quoted(joint), what: quoted([shift, limit.what].filter(Boolean).join("; ")) };
    return CSV.map((column) => cells[column] ?? "").join();
  }));
  return [CSV.join(), ...lines, ""].join("\n");
}

export class LimitsPanel {
  /** ask(request): the library's reply to `limits`; shape(): shift and cartilage of the pose; onPose(motion), start and limit; fault(error). */
  constructor(app, { ask, shape, onPose, fault }) {
    Object.assign(this, { app, ask, onPose, fault, shape: () => ({ ...shape(), rim: app.state.rim }), rows: [], run: 0, timer: 0, known: false, of: "", halted: false });
    byId("all-limits").addEventListener("toggle", () => this.begin());
    byId("limits-rim").addEventListener("change", ({ target }) => { app.state.rim = target.checked; this.posed(); this.write(); });
    byId("limits-cancel").addEventListener("click", () => (this.halted ? this.begin(true) : this.halt()));
  }

  setCatalogue({ motions, rim }) {
    this.motions = motions;
    byId("limits-rim-say").textContent = rim;
    this.write();
  }

  /** Of another joint: nothing is known. */
  forget() {
    this.known = false;
    this.stop();
  }

  stop() {
    this.run += 1;
    Object.assign(this, { rows: [], of: "", halted: false });
    this.write();
  }

  /** A reader has cancelled it; what is there stays, and may be gone on with. */
  halt() {
    this.run += 1;
    this.halted = true;
    this.write();
  }

  /** The joint is there, and what is more urgent has been answered. */
  ready() {
    this.known = true;
    this.begin();
  }

  /** Another pose; only its shift and the cartilage count. */
  posed() {
    if (!this.of || this.of === JSON.stringify(this.shape())) return;
    this.stop();
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.begin(), WAIT);
  }

  complete() {
    return this.rows.length === this.motions?.length;
  }

  async begin(resume = false) {
    if (!this.known || (this.of && !resume) || !byId("all-limits").open) return;
    const mine = (this.run += 1);
    const shape = this.shape();
    Object.assign(this, { of: JSON.stringify(shape), halted: false });
    this.write();
    for (const motion of this.motions.slice(this.rows.length)) {
      try {
        const found = await this.ask({ ...shape, motions: [motion.name] });
        if (mine !== this.run) return;
        this.rows.push({ motion, ...found });
        this.write();
      } catch (error) {
        if (mine === this.run) this.fault(error);
        return;
      }
    }
  }

  cell(motion, limit) {
    if (!limit) return make("td", { textContent: "–" });
    const [text, title] = shortly(limit);
    const mark = limit.hangs_on_less_than_half_mm ? [" ±"] : [];
    if (limit.state !== "limited") return make("td", { title }, text, ...mark);
    const go = make("button", { type: "button", className: "plain", textContent: text, title, onclick: () => this.onPose(motion, limit.low_deg) });
    return make("td", { title }, go, ...mark, ...(limit.clock ? [make("span", { className: "clock", textContent: limit.clock })] : []));
  }

  write() {
    byId("limits-rim").checked = this.app.state.rim;
    byId("limits-of").textContent = this.app.state.rim ? "rim alone" : "bone";
    const done = this.rows.length;
    byId("limits-rows").replaceChildren(...(this.motions ?? []).map((motion, k) => {
      const limits = this.rows[k]?.limits;
      const of = ([about, cartilage]) => limits.find((each) => each.centre === about && each.threshold_mm > 0 === cartilage);
      const cells = limits ? COLUMNS.map((column) => this.cell(motion, of(column))) : [make("td", { colSpan: 3, textContent: k === done && this.of && !this.halted ? "…" : "" })];
      return make("tr", {}, make("th", { scope: "row" }, motionLabel(motion), ...(limits?.[0].meets ? [make("span", { className: "clock", textContent: limits[0].meets })] : [])), ...cells);
    }));
    put("limits-missing", missingWords(this.rows));
    byId("save-limits").disabled = !this.motions || !this.complete();
    const going = Boolean(this.of) && !this.complete();
    byId("limits-work").hidden = !going;
    byId("limits-cancel").textContent = this.halted ? "Go on" : "Cancel";
    byId("limits-say").textContent = going ? `${this.halted ? "Cancelled" : "Working"}, ${done} of ${this.motions.length}${this.halted ? "." : " …"}` : "";
  }
}
