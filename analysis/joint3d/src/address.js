// SPDX-License-Identifier: GPL-3.0-or-later
// The state in the address, so that a reload loses nothing and the address is a link.
import { fromFragment, toFragment } from "./state.js";

const OFTEN = 500; // ms: a browser takes only so many changes of an address

/** Keeps the address up to the state; onState() after a reader has given another address. Returns write(). */
export function keepAddress(app, onState) {
  const write = () => {
    if (!app.ready || document.body.classList.contains("embedded")) return;
    const fragment = `#${toFragment(app.state)}`;
    if (fragment === app.ownFragment) return;
    app.ownFragment = fragment;
    history.replaceState(null, "", fragment);
  };
  setInterval(write, OFTEN);
  window.addEventListener("pagehide", write);
  window.addEventListener("hashchange", () => {
    if (location.hash === app.ownFragment || !location.hash.includes("=")) return;
    app.state = fromFragment(location.hash);
    onState();
  });
  return write;
}
