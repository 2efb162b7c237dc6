// SPDX-License-Identifier: GPL-3.0-or-later
// The numbers of a pose.
import { byId, put } from "./elements.js";

const SPOKEN = 1200; // ms of rest before a screen reader is told

const area = (mm2) => `${mm2 < 10 ? mm2.toFixed(1) : Math.round(mm2)} mm²`;
const zone = ({ clock_from: from, clock_to: to }) => (from === to ? "all round" : `${from} to ${to}`);
export const zones = (list) => (list?.length ? [...list.slice(0, 3).map(zone), ...(list.length > 3 ? ["…"] : [])].join(", ") : "–");
const signed = (gap) => gap.toFixed(2).replace("-", "−");

/** The smallest gap of the library's reply to `pose`, in a line. */
export const gapWords = (smallest) => (smallest
  ? `Smallest gap ${signed(smallest.gap_mm)} mm, ${whereIs(smallest)}`
  : "The surfaces do not face each other");

const whereIs = ({ surface, clock, gap_mm: gap }) => `on the ${surface}${clock ? `, at ${clock} o’clock` : ""}${gap < 0 ? ": depth along the ray from the centre" : ""}`;

let timer = 0;

/** pose: the library's reply; took: ms from asking to the answer. */
export function showReadouts(pose, took) {
  const { smallest_gap: smallest, impingement } = pose;
  const [bone, cartilage] = [impingement.at(0), impingement.at(-1)];
  const both = ({ ball, socket }) => area(ball.area_mm2 + socket.area_mm2);
  put("smallest-gap", smallest ? signed(smallest.gap_mm) : "–");
  put("smallest-where", smallest ? whereIs(smallest) : "the surfaces do not face each other");
  put("stage-gap", smallest ? `${signed(smallest.gap_mm)} mm` : "no gap");
  byId("stage-state").textContent = smallest && smallest.gap_mm <= 0 ? "bones overlap" : "smallest gap";
  byId("stage-readout").classList.toggle("impinged", Boolean(smallest && smallest.gap_mm <= 0));
  put("bone-area", both(bone));
  put("bone-clock", zones(bone.socket.clock_zones));
  put("cartilage-area", both(cartilage));
  put("cartilage-clock", zones(cartilage.socket.clock_zones));
  put("met", `${pose.vertices_with_gap.reduce((sum, each) => sum + each).toLocaleString("en")} of ${(pose.ball_gap.length + pose.socket_gap.length).toLocaleString("en")}`);
  put("scan-ms", `${pose.ms.toFixed(2)} ms`);
  put("round-ms", `${took.toFixed(1)} ms`);
  clearTimeout(timer);
  timer = setTimeout(() => speak(smallest), SPOKEN);
}

function speak(smallest) {
  byId("spoken").textContent = smallest
    ? `Smallest gap ${smallest.gap_mm.toFixed(2)} millimetres${smallest.clock ? ` at ${smallest.clock} o’clock` : ""}`
    : "No gap";
}
