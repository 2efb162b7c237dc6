// SPDX-License-Identifier: GPL-3.0-or-later
// Joints and tables, made by the library when a reader asks for others. A reader's own joint may take long: that can be cancelled.
import { byId } from "./elements.js";
import { Stale, newestOnly } from "./engine_client.js";
import { busy, fault } from "./messages.js";
import { firstState } from "./state.js";

const SOON = 2; // s after which it is said how long it takes

const FIRST = firstState().tables; // as the library has them at first
const same = (one, other) => JSON.stringify(one) === JSON.stringify(other);

/** live: the client of the library; onTables(reply, request), onJoint(reply, asked), onRefused(error, asked), also where a reader has cancelled: a Stale error. */
export function maker(live, { onTables, onJoint, onRefused }) {
  let timer = 0;
  let made = null; // the questions whose joint and tables the library has
  let filled = null;
  let wanted = FIRST; // the tables that were asked for last
  const wait = (on) => {
    clearInterval(timer);
    let seconds = 0;
    byId("stage-work").hidden = true;
    if (on) timer = setInterval(() => {
      seconds += 1;
      byId("stage-work").hidden = seconds < SOON;
      byId("stage-seconds").textContent = String(seconds);
    }, 1000);
  };
  const making = newestOnly(({ request }) => live.ask("joint", request), (joint, _, asked) => { made = asked.request; onJoint(joint, asked); }, onRefused,
    () => { busy("joint", false); wait(false); });
  byId("stage-cancel").addEventListener("click", () => {
    if (!made || byId("stage").getAttribute("aria-busy") !== "true") return;
    live.restart();
    live.ask("joint", made).catch(fault);
    if (filled) live.ask("tables", filled).catch(fault);
  });

  /** Tables of these settings, unless the library has them or will. */
  async function tables(request) {
    if (same(request, wanted)) return;
    wanted = request;
    busy("tables", true);
    let again = false;
    try {
      const reply = await live.ask("tables", request);
      filled = request;
      onTables(reply, request);
    } catch (error) {
      const newest = request === wanted;
      again = newest && error instanceof Stale;
      if (newest) wanted = filled ?? FIRST;
      if (!(error instanceof Stale)) fault(error);
    }
    busy("tables", false);
    if (again) await tables(request);
  }

  return {
    /** asked: { request, own, joint }; own: a reader's meshes as FilesPanel has them, else null; joint: of the state. Where the library refuses them, or a reader cancels, the joint before stays. */
    joint(asked) {
      busy("joint", true);
      wait(asked.own && made);
      making(asked);
    },
    tables,
  };
}
