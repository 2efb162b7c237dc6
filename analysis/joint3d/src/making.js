// SPDX-License-Identifier: GPL-3.0-or-later
// Joints and tables, made by the library when a reader asks for others. A reader's own joint may take long: that can be cancelled.
import { byId } from "./elements.js";
import { newestOnly } from "./engine_client.js";
import { busy, fault } from "./messages.js";

const SOON = 2; // s after which it is said how long it takes

/** live: the client of the library; onTables(reply, request), onJoint(reply, { request, own }), onRefused(error). */
export function maker(live, { onTables, onJoint, onRefused }) {
  let timer = 0;
  let made = null; // the questions whose joint and tables the library has
  let filled = null;
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
  return {
    /** own: a reader's meshes as FilesPanel has them, else null. Where the library refuses them, or a reader cancels, the joint before stays. */
    joint(request, own) {
      busy("joint", true);
      wait(own && made);
      making({ request, own });
    },
    async tables(request) {
      busy("tables", true);
      try {
        onTables(await live.ask("tables", request), request);
        filled = request;
      } catch (error) {
        fault(error);
      }
      busy("tables", false);
    },
  };
}
