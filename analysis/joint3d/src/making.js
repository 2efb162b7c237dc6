// SPDX-License-Identifier: GPL-3.0-or-later
// Joints and tables, made by the library when a reader asks for others.
import { newestOnly } from "./engine_client.js";
import { busy, fault } from "./messages.js";

/** live: the client of the library; onTables(reply, request), onJoint(reply, { request, own }), onRefused(error). */
export function maker(live, { onTables, onJoint, onRefused }) {
  const making = newestOnly(({ request }) => live.ask("joint", request), (joint, _, asked) => onJoint(joint, asked), onRefused,
    () => busy("joint", false));
  return {
    /** own: a reader's meshes as FilesPanel has them, else null. Where the library refuses them, the joint before stays. */
    joint(request, own) {
      busy("joint", true);
      making({ request, own });
    },
    async tables(request) {
      busy("tables", true);
      try {
        onTables(await live.ask("tables", request), request);
      } catch (error) {
        fault(error);
      }
      busy("tables", false);
    },
  };
}
