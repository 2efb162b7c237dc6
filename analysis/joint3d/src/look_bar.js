// SPDX-License-Identifier: GPL-3.0-or-later
// How the joint is drawn: view, filled or lines or blended, colours, what is shown, and the legend.
import { legendRows } from "./colours.js";
import { cutRows } from "./cut_surface.js";
import { byId, make, oneOfButtons, swatchOf } from "./elements.js";

const TURN = 8; // degrees a key press
const KEYS = {
  ArrowLeft: [-TURN, 0], ArrowRight: [TURN, 0], ArrowUp: [0, TURN], ArrowDown: [0, -TURN],
  "+": [0, 0, 0.9], "=": [0, 0, 0.9], "-": [0, 0, 1 / 0.9],
};

/** onLook() when something about the drawing has changed. Returns show(). */
export function lookBar(app, view, onLook) {
  const showView = oneOfButtons(byId("views"), (value) => {
    Object.assign(app.state.look, { view: value, camera: null });
    view.eye.lookFrom(value);
  });
  const showDrawing = oneOfButtons(byId("drawings"), (value) => { app.state.look.drawing = value; onLook(); });
  const showDrag = oneOfButtons(byId("drags"), (value) => app.setDrag(value));
  byId("colours").addEventListener("change", ({ target }) => { app.state.look.colours = target.value; onLook(); });
  const boxes = [...document.querySelectorAll("#shown input")];
  boxes.forEach((box) => box.addEventListener("change", () => {
    app.state.look.shown = boxes.filter((each) => each.checked).map((each) => each.value);
    onLook();
  }));
  view.onTurned = () => {
    if (!app.ready) return; // the camera stands nowhere yet
    app.state.look.camera = view.eye.place();
    if (app.state.look.view === "free") return;
    app.state.look.view = "free";
    showView("free");
  };
  view.canvas.addEventListener("keydown", (event) => {
    const turn = KEYS[event.key];
    if (!turn || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    view.eye.orbit(...turn);
  });
  return () => {
    showView(app.state.look.view);
    showDrawing(app.state.look.drawing);
    showDrag(app.drag);
    byId("colours").value = app.state.look.colours;
    boxes.forEach((box) => { box.checked = app.state.look.shown.includes(box.value); });
  };
}

let written = "";

/** Rows of the legend of what is drawn. parts: of the SceneView; colours: of the library's reply to `pose`. */
export const shownRows = ({ isCut, cut }, scale, colours) => (isCut ? cutRows(cut.deepest) : legendRows(scale, colours));

export function showLegend(parts, scale, colours) {
  const rows = shownRows(parts, scale, colours);
  byId("legend-of").textContent = parts.isCut ? "Depth of the cut" : "Gap (radial)";
  byId("stage-cut").hidden = !parts.isCut;
  const key = JSON.stringify(rows);
  if (key === written) return;
  written = key;
  byId("legend-rows").replaceChildren(...rows.map((row) => make("li", {}, swatchOf(row), make("span", { textContent: row.text }))));
}
