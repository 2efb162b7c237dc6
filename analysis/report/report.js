// SPDX-License-Identifier: GPL-3.0-or-later
// Filters of the verdict table (where, verdict, and free text), and figures that grow.
"use strict";
const rows = [...document.querySelectorAll("#verdicts tbody tr")];
const artefact = document.getElementById("filter-artefact");
const verdict = document.getElementById("filter-verdict");
const text = document.getElementById("filter-text");
const count = document.getElementById("count");

function matches(row) {
  return (!artefact.value || row.dataset.artefact === artefact.value) &&
    (!verdict.value || row.dataset.verdict === verdict.value) &&
    row.textContent.toLowerCase().includes(text.value.toLowerCase());
}

function show() {
  rows.forEach((row) => { row.hidden = !matches(row); });
  count.textContent = `${rows.filter((row) => !row.hidden).length} of ${rows.length} rows`;
}

[artefact, verdict].forEach((choice) => choice.addEventListener("change", show));
text.addEventListener("input", show);
show();

// A figure fills the width of the page; a click shows it twice as wide, or back.
document.querySelectorAll("figure img").forEach((picture) =>
  picture.addEventListener("click", () => picture.classList.toggle("large")));
