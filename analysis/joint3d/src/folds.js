// SPDX-License-Identifier: GPL-3.0-or-later
// Which panels a reader has opened and folded, kept over a reload of this tab.

const NAME = "joint3d-folds";

function read() {
  try {
    return JSON.parse(sessionStorage.getItem(NAME)) ?? {};
  } catch {
    return {}; // a browser that keeps nothing
  }
}

export function keepFolds() {
  const kept = read();
  document.querySelectorAll("details.panel").forEach((panel) => {
    panel.open = kept[panel.id] ?? panel.open;
    panel.addEventListener("toggle", () => {
      kept[panel.id] = panel.open;
      try {
        sessionStorage.setItem(NAME, JSON.stringify(kept));
      } catch { /* the same */ }
    });
  });
}
