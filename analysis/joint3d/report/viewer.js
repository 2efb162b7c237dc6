// SPDX-License-Identifier: GPL-3.0-or-later
// The bones of a report (libcore/report/page.hpp): pictures from the usual sides, and one that a reader turns. The page
// has the meshes with their gaps as JSON, in the form of the library's replies to Joint3D.
import { byId, make, oneOfButtons } from "../src/elements.js";
import { drawCompass } from "../src/labels.js";
import { SceneView } from "../src/scene_view.js";

const STILL = [720, 540]; // pixels
const NEAR = 0.6;
const VIEWS = ["anterior", "posterior", "medial", "lateral", "superior", "inferior"];
const PARTS = { ball: "ball", socket: "socket", pelvis: "whole pelvis", clock: "clock", smallest: "smallest gap" };
const ARRAYS = { positions: Float32Array, faces: Uint32Array, rim_clock: Float32Array, rim_hours: Float32Array, ball_gap: Float32Array, socket_gap: Float32Array };

/** Texts of base 64 under the names of arrays become these. */
function withArrays(name, value) {
  if (!(name in ARRAYS)) return value;
  const bytes = Uint8Array.from(atob(value), (letter) => letter.charCodeAt(0));
  return new ARRAYS[name](bytes.buffer);
}

/** Stands at a view, looking at the centre of rotation; near: a share of the distance from which all is seen. */
function look(view, name, near) {
  view.eye.lookFrom(name);
  const place = view.eye.place();
  view.eye.standAt([0, 1, 2].map((k) => near * (place[k] - place[k + 3])).concat([0, 0, 0]));
}

/** A picture for each figure that names what it shows, drawn with the view's own camera. */
function drawStills(view) {
  view.renderer.setPixelRatio(1);
  view.renderer.setSize(...STILL, false);
  view.eye.resize(...STILL);
  document.querySelectorAll("figure[data-view]").forEach((figure) => {
    view.setLook({ drawing: "filled", shown: figure.dataset.shown.split(" ") });
    look(view, figure.dataset.view, Number(figure.dataset.near));
    view.drawNow();
    const image = make("img", { src: view.canvas.toDataURL("image/png"), alt: figure.textContent.trim(), width: STILL[0], height: STILL[1] });
    const compass = byId("compass").cloneNode(false);
    compass.removeAttribute("id");
    drawCompass(compass, view.eye.camera);
    figure.prepend(make("div", { className: "stage" }, image, compass));
  });
}

function addControls(view) {
  const shown = new Set(["ball", "socket", "clock", "smallest"]);
  const show = () => view.setLook({ drawing: "filled", shown: [...shown] });
  const sides = make("div", { className: "group", role: "group", "aria-label": "View" },
    ...VIEWS.map((name) => make("button", { type: "button", value: name, textContent: name })));
  const press = oneOfButtons(sides, (name) => look(view, name, NEAR));
  view.onTurned = () => press("");
  const boxes = Object.entries(PARTS).filter(([name]) => name !== "pelvis" || view.parts.hasPelvis()).map(([name, label]) => {
    const box = make("input", { type: "checkbox", checked: shown.has(name) });
    box.addEventListener("change", () => { if (box.checked) shown.add(name); else shown.delete(name); show(); });
    return make("label", {}, box, ` ${label}`);
  });
  byId("controls").append(sides, ...boxes);
  show();
  look(view, "anterior", NEAR);
  press("anterior");
}

function begin() {
  const { joint, pose } = JSON.parse(byId("scene").textContent, withArrays);
  const view = new SceneView(byId("view"), byId("compass"));
  view.setJoint(joint, false);
  view.setPose(pose, "levels");
  drawStills(view);
  view.fit();
  addControls(view);
  document.body.classList.add("drawn");
}

try {
  begin();
} catch (error) {
  byId("no-views").hidden = false;
  byId("no-views").textContent = `This browser draws no bones in three dimensions (${error.message}); the maps below have the same gaps.`;
}
