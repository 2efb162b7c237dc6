// SPDX-License-Identifier: GPL-3.0-or-later
// Small helpers for the page's elements.

export const byId = (id) => document.getElementById(id);

/** Writes a text only where it is another. */
export const put = (id, text) => { if (byId(id).textContent !== text) byId(id).textContent = text; };

/** A small length in mm, as one reads it. */
export const length = (mm) => (mm < 0.1 ? `${Number((1000 * mm).toPrecision(3))} µm` : `${mm.toPrecision(3)} mm`);

/** Of the decimal numbers with that many places the next to a value that is no higher (way -1) or no lower (way 1). */
function outward(value, places, way) {
  const shown = Number(value.toFixed(places));
  const step = way * shown < way * value ? way * 10 ** -places : 0;
  return (shown + step + 0).toFixed(places); // no minus before a zero
}

/** Ends of what is proven are shown outward: a low end no higher than it is, a high one and a bound no lower. */
export const roundedDown = (value, places) => outward(value, places, -1);
export const roundedUp = (value, places) => outward(value, places, 1);

/** A proven bound in mm, to three digits. */
export const boundLength = (mm) => length(Number(roundedUp(mm, mm > 0 ? Math.max(2 - Math.floor(Math.log10(mm)), 0) : 0)));

/** A part of a required path, in the library's words, shortly. */
export const legWords = (words) => words.replaceAll("_", " ").replace(" from 0 to", " to").replace(" degrees", "°");

/** An element with properties and children; properties with "-" are attributes. */
export function make(tag, properties = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(properties)) {
    if (name.includes("-") || name === "role" || name === "list") element.setAttribute(name, value);
    else element[name] = value;
  }
  element.append(...children);
  return element;
}

/** The swatch of a row of a legend: one colour, or a gradient of several. */
export function swatchOf({ colours: [first, ...others] }) {
  const swatch = make("span", { className: `swatch ${others.length ? "wide" : ""}`, "aria-hidden": "true" });
  swatch.style.background = others.length ? `linear-gradient(90deg, ${[first, ...others].join()})` : first;
  return swatch;
}

/** A row of a legend in a line of text: { colours, text }. */
export const keyRow = (row) => make("b", {}, swatchOf(row), ` ${row.text}`);

/** An SVG element with attributes. */
export function drawn(tag, attributes = {}, text = null) {
  const element = document.createElementNS("http://www.w3.org/2000/svg", tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  if (text !== null) element.textContent = text;
  return element;
}

/** The options of a choice, from { value, text } or groups { label, options }. */
export function fillChoice(select, entries) {
  const option = ({ value, text }) => make("option", { value, textContent: text });
  select.replaceChildren(...entries.map((entry) =>
    entry.options ? make("optgroup", { label: entry.label }, ...entry.options.map(option)) : option(entry)));
}

/** Buttons of which one is pressed. onChoose(value) is called when a reader presses another. */
export function oneOfButtons(group, onChoose) {
  const buttons = [...group.querySelectorAll("button")];
  const show = (value) => buttons.forEach((button) =>
    button.setAttribute("aria-pressed", String(button.value === value)));
  buttons.forEach((button) => button.addEventListener("click", () => { show(button.value); onChoose(button.value); }));
  return show;
}

/**
 * A slider with a number beside it for one value. ends: what its ends mean; meaning: of the value, in words; widest: how far
 * the slider grows for values beyond it, else not at all. Returns a function that shows a value without telling.
 */
export function sliderRow(place, { key, label, unit, least, most, step, ends, meaning, widest = [least, most] }, onChange) {
  const id = `value-${key}`;
  const range = make("input", { type: "range", id: `slide-${key}`, min: least, max: most, step, "aria-label": `${label}, ${unit}` });
  const number = make("input", { type: "number", id, min: widest[0], max: widest[1], step, "aria-label": `${label}, ${unit}, as a number` });
  const unitText = make("span", { className: "unit", textContent: unit });
  const row = make("div", { className: "slider" }, make("label", { htmlFor: range.id, textContent: label }),
    make("span", { className: "typed" }, number, unitText), range);
  if (ends) row.append(make("span", { className: "ends", "aria-hidden": "true" },
    make("span", { textContent: ends[0] }), make("span", { textContent: ends[1] })));
  if (meaning) row.append(make("p", { className: "meaning", id: `meaning-${key}`, textContent: meaning }));
  if (meaning) range.setAttribute("aria-describedby", `meaning-${key}`);
  place.append(row);
  const reach = (value) => { // by steps of ten, so that its ends are round; no farther than `widest`
    range.min = Math.max(Math.min(range.min, 10 * Math.floor(value / 10)), widest[0]);
    range.max = Math.min(Math.max(range.max, 10 * Math.ceil(value / 10)), widest[1]);
  };
  let told = NaN; // what the others know
  const tell = (value) => { told = value; onChange(value); };
  const show = (value) => {
    told = value;
    const text = String(Math.round(value * 100) / 100);
    reach(value);
    range.value = text;
    if (document.activeElement !== number || Number(number.value) !== value) number.value = text;
  };
  range.addEventListener("input", () => { number.value = range.value; tell(Number(range.value)); });
  number.addEventListener("input", () => {
    if (number.value === "" || !number.validity.valid && !number.validity.stepMismatch) return;
    reach(Number(number.value));
    range.value = number.value;
    tell(Number(number.value));
  });
  number.addEventListener("change", () => { // out of range: the nearest that is allowed
    const value = Math.min(Math.max(Number(number.value) || 0, widest[0]), widest[1]);
    const news = value !== told;
    show(value);
    if (news) onChange(value);
  });
  return show;
}
