// SPDX-License-Identifier: GPL-3.0-or-later
// What is measured of the meshes of a joint.
import { byId, make } from "./elements.js";
import { inWords } from "./messages.js";

const NAMES = {
  head_radius: "Radius of the head", head_neck_offset: "Head-neck offset", neck_shaft_angle: "Neck-shaft angle (CCD)",
  femoral_torsion: "Torsion of the femur", inclination: "Inclination of the socket", version: "Version of the socket",
  half_opening: "Half opening of the socket", lateral_centre_edge: "Lateral centre-edge angle (LCE)",
  alpha_notzli: "Alpha in one plane (Nötzli)", socket_radius: "Radius of the socket", coverage: "Share of directions within the rim",
};
const ALPHA = "alpha_at_";
const hour = (measure) => measure.replace(ALPHA, "").replace("_", ":");
const name = (measure) => NAMES[measure] ?? `Alpha at ${hour(measure)} o’clock`;
const number = (value, unit) => ({ deg: `${value.toFixed(1)}°`, 1: `${(100 * value).toFixed(1)} %` })[unit] ?? `${value.toFixed(2)} ${unit}`;
const amount = ({ value, uncertainty, unit }) => `${number(value, unit)} ± ${number(uncertainty, unit)}`.replace("-", "−");
/** What is published of the measure, for the reader to hold it against; nothing where nothing is. */
function published({ unit, published_mean: mean, published_sd: sd, published_median: median, published_lower_quartile: lower,
  published_upper_quartile: upper, published_of: of, published_source: source }) {
  if (source === null) return [];
  const spread = mean === null ? `median ${number(median, unit)}, quartiles ${number(lower, unit)} and ${number(upper, unit)}` : `mean ${number(mean, unit)}, SD ${number(sd, unit)}`;
  return [make("dd", { className: "published", title: source, textContent: `Published: ${spread} of ${of} (${source.split(",")[0]})`.replaceAll("+-", "±") })];
}

const REFUSED = "refused: ";
const whyRefused = ({ value, state }) => (value === null ? state.replace(REFUSED, "") : null);

/** What is refused, by the reason: "Left out: Version of the socket (the mesh has no rim).", or nothing. */
export function refusedWords(measures) {
  const reasons = [...new Set(measures.map(whyRefused).filter(Boolean))];
  const named = (why) => {
    const group = measures.filter((each) => whyRefused(each) === why).map(({ measure }) => measure);
    const hours = group.filter((measure) => measure.startsWith(ALPHA)).map(hour);
    const others = group.filter((measure) => !measure.startsWith(ALPHA)).map(name);
    return [...others, ...(hours.length ? [`Alpha at ${hours.join(", ")} o’clock`] : [])].join(", ");
  };
  const words = reasons.map((why) => `${named(why)} (${why})`).join("; ");
  return words && `Left out: ${words}.`;
}

export class MeasuresPanel {
  /** ask(): the library's reply to `measure`. */
  constructor(ask) {
    Object.assign(this, { ask, asked: 0 });
  }

  /** Of another joint. */
  async again() {
    const mine = (this.asked += 1);
    byId("measures-rows").replaceChildren();
    byId("measures-say").textContent = "Measuring …";
    const { measures, fault } = await this.ask().catch((error) => ({ measures: [], fault: `Left out: ${inWords(error)}.` }));
    if (mine !== this.asked) return;
    byId("measures-rows").replaceChildren(...measures.filter(({ value }) => value !== null).map((each) =>
      make("div", {}, make("dt", { textContent: name(each.measure) }), make("dd", { textContent: amount(each) }), ...published(each))));
    byId("measures-say").textContent = fault ?? refusedWords(measures);
  }
}
