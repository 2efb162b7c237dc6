// SPDX-License-Identifier: GPL-3.0-or-later
// Joint3D: what the reader does becomes questions to the library, and its answers what the reader sees. Two workers run the
// library: one answers poses at once, the other what takes longer.
import { EngineClient } from "./engine_client.js";
import { byId } from "./elements.js";
import { exportPanel } from "./export_panel.js";
import { FemurDrag } from "./femur_drag.js";
import { FilesPanel } from "./files_panel.js";
import { JointPanel } from "./joint_panel.js";
import { remarkLine, showJoint } from "./joint_words.js";
import { lookBar } from "./look_bar.js";
import { maker } from "./making.js";
import { fault, say } from "./messages.js";
import { inRange, motionPanel } from "./motion_panel.js";
import { Player } from "./player.js";
import { PointsPanel } from "./points_panel.js";
import { Poses } from "./poses.js";
import { Proof } from "./proof.js";
import { SceneView } from "./scene_view.js";
import { SlowWorker } from "./slow_worker.js";
import { firstState, fromFragment } from "./state.js";
import { SweepPanel } from "./sweep_panel.js";
import { TablesPanel } from "./tables_panel.js";

const REST = 350; // ms without a change before what takes longer begins
const app = { state: fromFragment(location.hash), drag: "view", files: null, ready: false };

/** Within another page, "embedded" among the words of the fragment leaves the picture alone. */
const frame = () => document.body.classList.toggle("embedded", new URLSearchParams(location.hash.slice(1)).has("embedded"));

function start() {
  const source = byId("engine").textContent;
  const lost = (message) => fault(`The engine has stopped (${message}); load the page again.`);
  const live = new EngineClient(source, lost);
  const view = new SceneView(byId("view"), byId("compass"));
  const slow = new SlowWorker(new EngineClient(source, lost), { rest: REST, fault, onBound });
  const proof = new Proof((request) => slow.ask("verdicts", request), fault);
  const poses = new Poses(app, view, { ask: (request) => live.ask("pose", request), fault,
    onPose: (request) => { proof.posed(request); sweep.posed(); } });
  const pose = () => poses.again();
  const make = maker(live, { onTables, onJoint, onRefused });

  const motion = motionPanel(app, pose);
  const moved = () => { motion(); pose(); };
  const sweep = new SweepPanel(app, (request) => slow.ask("sweep", { ...poses.shape(), ...request }),
    (angles) => { app.player.stop(); app.state.motion = angles; moved(); });
  const tables = new TablesPanel(app, () => make.tables({ ...app.state.tables }));
  const points = new PointsPanel(app, () => slow.ask("points"), { fault, radius: () => view.parts.radius,
    onPoints: (found, apart) => view.setPoints(found, apart) });
  app.player = new Player(app, moved);
  const showLook = lookBar(app, view, () => { view.setLook(app.state.look); points.show(); pose(); });
  const joints = new JointPanel(app, () => make.joint(joints.request(), null));
  new FilesPanel((request) => {
    app.player.stop();
    make.joint(request, `${request.ball.name} and ${request.socket.name}`);
  }, fault);
  exportPanel(app, view, (request) => live.ask("export", { ...request, pose: poses.request() }), fault);
  const drag = new FemurDrag(view, (change) => {
    app.player.stop();
    Object.entries(change).forEach(([key, by]) => { app.state.motion[key] = inRange(key, app.state.motion[key] + by); });
    moved();
  });

  function onBound(bound) {
    tables.bounded(bound);
    proof.begin(poses.request());
  }

  /** news: { joint } or { tables }, as asked of the library. */
  function follow(news) {
    proof.forget();
    slow.follow(news);
    points.again();
    sweep.again(REST);
    pose();
  }

  function onTables(filled, request) {
    tables.filled(filled, false);
    follow({ tables: request });
  }

  function onRefused(error) {
    fault(error);
    if (app.ready) return;
    app.state.joint = firstState().joint; // a link that asks for no possible hip
    joints.show();
    make.joint(joints.request(), null);
  }

  function onJoint(joint, { request, files }) {
    const kind = `${request.source} ${request.name ?? ""} ${joint.side}`;
    const other = files || kind !== app.kind;
    if (app.ready) say(remarkLine(joint, files), "warning");
    Object.assign(app, { files, kind, ready: true });
    poses.begin(joint.ball.positions.length / 3);
    view.setJoint(joint, !files);
    view.setLook(app.state.look);
    if (other) view.eye.lookFrom(app.state.look.view);
    tables.filled(joint.tables, true);
    showJoint(joint, files);
    sweep.forget();
    follow({ joint: request });
  }

  app.setDrag = (what) => {
    app.drag = what;
    drag.active = what === "femur";
    view.canvas.classList.toggle("moves", drag.active);
  };
  view.onLost = (gone) => say(gone ? "The graphics were lost; they come back by themselves." : "", "warning");
  byId("message-close").addEventListener("click", () => say(""));

  async function begin() {
    motion();
    [joints, tables, sweep].forEach((panel) => panel.show());
    showLook();
    app.kind = null;
    make.joint(joints.request(), null);
    if (JSON.stringify(app.state.tables) !== JSON.stringify(firstState().tables)) await make.tables({ ...app.state.tables });
  }

  window.addEventListener("hashchange", () => {
    if (location.hash === app.ownFragment) return;
    app.state = fromFragment(location.hash);
    frame();
    begin();
  });
  live.ask("presets").then((catalogue) => {
    [joints, tables, sweep].forEach((panel) => panel.setCatalogue(catalogue));
    app.player.setMotions(catalogue.recorded);
    return begin();
  }).then(() => document.body.classList.add("ready")).catch(fault);
}

try {
  frame();
  start();
} catch (error) {
  fault(/WebGL/i.test(error.message) ? "This browser shows no WebGL 2, which the picture needs; another browser, or its settings, may." : error);
}
