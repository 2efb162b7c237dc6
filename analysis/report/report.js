// SPDX-License-Identifier: GPL-3.0-or-later
// Filters of the verdict table (where, verdict, and free text), parts that open for a link, and figures that grow.
"use strict";
const rows = [...document.querySelectorAll("#verdicts tr[data-verdict]")];
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
  document.querySelectorAll("#verdicts tbody").forEach((group) => { // no rule without rows
    group.hidden = !group.querySelector("tr[data-verdict]:not([hidden])");
  });
  const left = rows.filter((row) => !row.hidden).length;
  count.textContent = `${left} of ${rows.length} rows${left ? "" : ": no verdict is like that; choose \u201call\u201d or clear the text"}`;
}

[artefact, verdict].forEach((choice) => choice.addEventListener("change", show));
text.addEventListener("input", show);
show();

// On a phone a row of these tables is a card, and each of its cells says what it is.
document.querySelectorAll("table.cards").forEach((table) => {
  const titles = [...table.querySelectorAll("thead th")].map((head) => head.textContent);
  table.querySelectorAll("tbody td").forEach((cell) => { cell.dataset.title = titles[cell.cellIndex]; });
});

// A link to what is folded opens it, and all that it is folded in.
function reveal() {
  const target = location.hash.length > 1 && document.getElementById(decodeURIComponent(location.hash.slice(1)));
  if (!target) return;
  for (let part = target; part; part = part.parentElement) if (part.tagName === "DETAILS") part.open = true;
  target.scrollIntoView();
}
addEventListener("hashchange", reveal);
reveal();

const all = document.getElementById("open-all");
all.addEventListener("click", () => {
  const parts = [...document.querySelectorAll("main details")];
  const open = parts.some((part) => !part.open);
  parts.forEach((part) => { part.open = open; });
  all.textContent = open ? "Close all" : "Open all";
});

// A figure fills the width of the page; a click or Enter shows it twice as wide, or back.
document.querySelectorAll("figure img").forEach((picture) => {
  const turn = () => {
    picture.classList.toggle("large");
    picture.scrollIntoView({ block: "nearest" });
  };
  picture.tabIndex = 0;
  picture.setAttribute("role", "button");
  picture.addEventListener("click", turn);
  picture.addEventListener("keydown", (event) => { if (event.key === "Enter") turn(); });
});
