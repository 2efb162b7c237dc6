// SPDX-License-Identifier: GPL-3.0-or-later
// Error against cost of every method: scene and axes by choice, lines by the legend (Plotly). It is drawn once its part of the page is open.
"use strict";
{
  const lines = JSON.parse(document.getElementById("explore-data").textContent);
  const chosen = Object.fromEntries(
    ["scene", "storage", "error", "cost"].map((name) => [name, document.getElementById(`explore-${name}`)]));
  const place = document.getElementById("explore-plot");
  const narrow = matchMedia("(max-width: 40rem)");
  const titleOf = (select) => select.selectedOptions[0].textContent;

  const traceOf = (line) => ({
    x: line[chosen.error.value],
    y: line[chosen.cost.value],
    text: line.setting,
    name: line.name.replace(/, (float|uint16)$/, ""),
    mode: "lines+markers",
    marker: { color: line.colour, symbol: line.marker, size: 8 },
    line: { color: line.colour, width: 1, dash: line.kind === "library" ? "dot" : "solid" },
    hovertemplate: `<b>%{fullData.name}</b> %{text}<br>%{x:.3~g}: ${titleOf(chosen.error)}` +
      `<br>%{y:.3~g}: ${titleOf(chosen.cost)}<extra></extra>`,
  });

  // Exact methods stand far to the left of all others: at first only the others are in view.
  const EXACT = 1e-3;
  function view(traces) {
    const errors = traces.flatMap((trace) => trace.x.filter((x, i) => x > EXACT && trace.y[i] !== null));
    return errors.length ? [Math.log10(Math.min(...errors)) - 0.2, Math.log10(Math.max(...errors)) + 0.2] : undefined;
  }

  const axis = (title) => ({ title: { text: title }, type: "log", exponentformat: "power", gridcolor: "#d8dee4" });

  function draw() {
    const shown = lines.filter((line) => line.scene === chosen.scene.value && ["none", chosen.storage.value].includes(line.storage)).map(traceOf)
      .filter((trace) => trace.x.some((x, i) => x !== null && trace.y[i] !== null));
    Plotly.react(place, shown, {
      xaxis: { ...axis(titleOf(chosen.error)), range: view(shown) },
      yaxis: axis(titleOf(chosen.cost)),
      height: narrow.matches ? 900 : 640,
      margin: { l: 70, r: 10, t: 40, b: 60 }, // at the top, of the buttons,
      font: { family: "system-ui, sans-serif", color: "#1b1f24" },
      legend: narrow.matches ? { orientation: "h", y: -0.15 } : { font: { size: 11 } },
      hovermode: "closest",
      uirevision: chosen.scene.value, // what is hidden stays so when the axes change
    }, { responsive: true, displaylogo: false });
  }

  /** Unpacks Plotly, once. */
  let loaded;
  const load = () => loaded ??= (async () => {
    const bytes = Uint8Array.from(atob(document.getElementById("explore-library").textContent), (letter) => letter.charCodeAt(0));
    const script = document.createElement("script");
    script.text = await new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"))).text();
    document.head.append(script);
  })();

  const part = document.getElementById("explore");
  const drawIfOpen = async () => {
    if (!part.open) return;
    await load();
    draw();
  };
  Object.values(chosen).forEach((select) => select.addEventListener("change", drawIfOpen));
  narrow.addEventListener("change", drawIfOpen);
  part.addEventListener("toggle", drawIfOpen);
}
