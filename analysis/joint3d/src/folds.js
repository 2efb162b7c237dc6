// SPDX-License-Identifier: GPL-3.0-or-later
// Which panels a reader has opened and folded, kept over a reload of this tab.

const NAME = "joint3d-folds";
const PHONE = "(max-width: 46rem)"; // as style.css has it: tables and plots are folded at first
const OPEN_ON_A_PHONE = ["files", "motion", "numbers"];

function read() {
  try {
    return JSON.parse(sessionStorage.getItem(NAME)) ?? {};
  } catch {
    return {}; // a browser that keeps nothing
  }
}

export function keepFolds() {
  const kept = read();
  const small = matchMedia(PHONE).matches;
  document.querySelectorAll("details.panel").forEach((panel) => {
    panel.open = kept[panel.id] ?? (small ? OPEN_ON_A_PHONE.includes(panel.id) : panel.open);
    panel.addEventListener("toggle", () => {
      kept[panel.id] = panel.open;
      try {
        sessionStorage.setItem(NAME, JSON.stringify(kept));
      } catch { /* the same */ }
    });
  });
}
