// SPDX-License-Identifier: GPL-3.0-or-later
// What is proven about the pose at hand. The slow worker bounds the tables once and then decides pose after pose, the newest
// alone, so that no pose waits for a proof.
import { boundLength, byId, put, roundedDown, roundedUp } from "./elements.js";
import { newestOnly } from "./engine_client.js";

const signed = (gap) => gap.replace("-", "−");
const between = (low, high) => (low === high ? `${low} mm` : `${low} to ${high} mm`);
const vertices = (count) => (count === 1 ? "1 vertex" : `${count.toLocaleString("en")} vertices`);

/** Which vertices have no bound, and what was done about them. */
function why(unbounded, measured) {
  const without = unbounded ? `${vertices(unbounded)} without a bound: the cell of the table ends at a rim there or sees the surface nearly edge-on. ` : "";
  return `${without}${vertices(measured)} that might have the smallest gap ${measured === 1 ? "was" : "were"} measured on the faces themselves.`;
}

export class Proof {
  /** ask(request): the library's reply to `verdicts`; fault(error). */
  constructor(ask, fault) {
    this.bounded = false;
    this.asking = newestOnly(ask, (found, _, request) => {
      if (!this.bounded || JSON.stringify(request) !== this.wanted) return; // of a pose before
      this.shown = this.wanted;
      this.show(found);
    }, (error) => {
      clearInterval(this.clock);
      put("bound", "–");
      fault(error);
    });
  }

  /** Other tables, of which nothing is known. */
  forget() {
    this.bounded = false;
    this.unknown();
  }

  unknown() {
    this.shown = null;
    ["undecided", "smallest-proven", "bound-half"].forEach((id) => put(id, "–"));
    byId("bound-why").hidden = true;
    this.wait(Date.now());
  }

  /** Says how long it has taken: a second for a generated hip, half a minute for whole bones. */
  wait(began) {
    clearInterval(this.clock);
    const tell = () => put("bound", `proving … ${Math.round((Date.now() - began) / 1000)} s`);
    tell();
    this.clock = setInterval(tell, 1000);
  }

  /** The tables are bounded; request: the pose at hand. */
  begin(request) {
    this.bounded = true;
    this.posed(request);
  }

  posed(request) {
    if (!this.bounded) return;
    this.wanted = JSON.stringify(request);
    if (this.shown && this.shown !== this.wanted) this.unknown(); // what stands there is of another pose
    this.asking(request);
  }

  show({ clear, impinged, undecided, vertices_without_bound: unbounded, vertices_measured_on_the_faces: measured, largest_mm: largest, median_mm: median,
    smallest_gap_between_mm: [low, high] }) {
    const known = clear + impinged + undecided > unbounded;
    clearInterval(this.clock);
    put("bound-half", known ? `± ${boundLength(median)}` : "–");
    put("bound", known ? `± ${boundLength(largest)}` : "none proven");
    put("undecided", unbounded ? `${undecided} (${unbounded} without a bound)` : String(undecided));
    put("smallest-proven", low === null ? "–" : between(signed(roundedDown(low, 3)), signed(roundedUp(high, 3))));
    put("bound-why", why(unbounded, measured));
    byId("bound-why").hidden = !measured;
  }
}
