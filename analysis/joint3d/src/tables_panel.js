// SPDX-License-Identifier: GPL-3.0-or-later
// Scheme, precision and storage of the tables, switched live, and what that changes in size, time and error.
import { boundLength, byId, fillChoice, length, make } from "./elements.js";

const bytesText = (bytes) => (bytes >= 1e6 ? `${(bytes / 1e6).toFixed(2)} MB` : `${(bytes / 1e3).toFixed(1)} kB`);
const ROWS = [
  ["Entries a table", (t) => t.entries.toLocaleString("en"), (t) => t.entries],
  ["Memory, both tables", (t) => bytesText(t.bytes), (t) => t.bytes],
  ["Time to fill both", (t) => `${t.fill_ms.toFixed(1)} ms`, (t) => t.fill_ms],
  ["Largest error measured", (t) => t.error_mm === null ? "–" : length(t.error_mm), (t) => t.error_mm],
  ["Proven, any direction", (t) => (t.bound_mm === undefined ? "proving …" : t.bound_mm === null ? "none for this scheme" : boundLength(t.bound_mm)), (t) => t.bound_mm],
];

/** "×1.9" where both are known and differ. */
function change(now, before) {
  if (!Number.isFinite(now) || !Number.isFinite(before) || before <= 0 || now <= 0) return "";
  const ratio = now / before;
  return Math.abs(ratio - 1) < 0.005 ? "same" : `× ${ratio.toPrecision(ratio < 1 ? 2 : 3)}`;
}

export class TablesPanel {
  constructor(app, onChange) {
    Object.assign(this, { app, now: null, before: null });
    const set = (key, read) => (event) => {
      app.state.tables[key] = read(event.target.value);
      if (key === "scheme") this.precisions();
      onChange();
    };
    byId("scheme").addEventListener("change", set("scheme", String));
    byId("precision").addEventListener("change", set("precision_deg", Number));
    byId("storage").addEventListener("change", set("storage", String));
  }

  setCatalogue({ schemes }) {
    this.schemes = schemes;
    fillChoice(byId("scheme"), schemes.map(({ name, label }) => ({ value: name, text: label })));
  }

  /** The precisions of the chosen scheme; the state takes the nearest to its own. */
  precisions() {
    const { tables } = this.app.state;
    const scheme = this.schemes.find(({ name }) => name === tables.scheme) ?? this.schemes[0];
    const nearest = (a, b) => (Math.abs(b - tables.precision_deg) < Math.abs(a - tables.precision_deg) ? b : a);
    tables.precision_deg = scheme.precisions.includes(tables.precision_deg) ? tables.precision_deg : scheme.precisions.reduce(nearest);
    fillChoice(byId("precision"), scheme.precisions.map((value) => ({ value: String(value), text: `${value}°` })));
    byId("precision").value = String(tables.precision_deg);
  }

  show() {
    const { tables } = this.app.state;
    byId("scheme").value = tables.scheme;
    byId("storage").value = tables.storage;
    this.precisions();
  }

  /** Tables as the library filled them; those before stand beside where only the settings changed. */
  filled(tables, otherJoint) {
    this.before = otherJoint ? null : this.now;
    this.now = { ...tables, bound_mm: undefined };
    this.write();
  }

  bounded(bound) {
    if (this.now) this.now.bound_mm = bound;
    this.write();
  }

  write() {
    const rows = ROWS.map(([label, text, value]) => make("tr", {},
      make("th", { textContent: label, scope: "row" }),
      make("td", { textContent: this.before ? text(this.before) : "" }),
      make("td", { className: "now", textContent: text(this.now) }),
      make("td", { className: "change", textContent: this.before ? change(value(this.now), value(this.before)) : "" })));
    byId("tables-rows").replaceChildren(...rows);
    byId("tables-now").classList.toggle("alone", !this.before);
  }
}
