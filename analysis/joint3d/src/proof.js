// SPDX-License-Identifier: GPL-3.0-or-later
// What is proven about the pose at hand. The slow worker bounds the tables once and then decides pose after pose, the newest
// alone, so that no pose waits for a proof.
import { byId, length } from "./elements.js";
import { newestOnly } from "./engine_client.js";

const put = (id, text) => { if (byId(id).textContent !== text) byId(id).textContent = text; };
const signed = (gap) => gap.toFixed(3).replace("-", "−");

export class Proof {
  /** ask(request): the library's reply to `verdicts`; fault(error). */
  constructor(ask, fault) {
    this.bounded = false;
    this.asking = newestOnly(ask, (found) => { if (this.bounded) this.show(found); }, (error) => {
      clearInterval(this.clock);
      fault(error);
    });
  }

  /** Other tables, of which nothing is known. */
  forget() {
    this.bounded = false;
    ["undecided", "smallest-proven", "bound-half"].forEach((id) => put(id, "–"));
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
    if (this.bounded) this.asking(request);
  }

  show({ clear, impinged, undecided, unbounded, largest_mm: largest, median_mm: median, low_mm: low, high_mm: high }) {
    const known = clear + impinged + undecided > unbounded;
    clearInterval(this.clock);
    put("bound-half", known ? `± ${length(median)}` : "–");
    put("bound", known ? `± ${length(largest)}` : "none proven");
    put("undecided", unbounded ? `${undecided} (${unbounded} without a bound)` : String(undecided));
    put("smallest-proven", known ? `${signed(low)} to ${signed(high)} mm` : "–");
  }
}
