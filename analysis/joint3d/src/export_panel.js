// SPDX-License-Identifier: GPL-3.0-or-later
// Files out of the page: a picture, gaps as CSV and PLY from the library's own writers, and the state as a link.
import { byId, make } from "./elements.js";
import { toFragment } from "./state.js";

function save(blob, name) {
  const link = make("a", { href: URL.createObjectURL(blob), download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

/** ask(request): the library's reply to `export`; fault(message). */
export function exportPanel(app, view, ask, fault) {
  const bytes = (request) => async () => {
    try {
      const file = await ask(request);
      save(new Blob([file.bytes], { type: "application/octet-stream" }), file.name);
    } catch (error) {
      fault(error.message);
    }
  };
  byId("save-picture").addEventListener("click", async () => save(await view.picture(), "joint3d.png"));
  byId("save-csv").addEventListener("click", bytes({ format: "csv", surface: "both" }));
  byId("save-ball").addEventListener("click", bytes({ format: "ply", surface: "ball" }));
  byId("save-socket").addEventListener("click", bytes({ format: "ply", surface: "socket" }));
  byId("copy-link").addEventListener("click", async () => {
    const fragment = `#${toFragment(app.state)}`;
    app.ownFragment = fragment;
    history.replaceState(null, "", fragment);
    byId("link").value = location.href;
    byId("link-row").hidden = false;
    byId("link").select();
    const note = app.files ? " Your meshes are not in it: they stay on this computer." : "";
    try {
      await navigator.clipboard.writeText(location.href);
      byId("link-say").textContent = `Copied.${note}`;
    } catch {
      byId("link-say").textContent = `Copy it from here.${note}`;
    }
  });
}
