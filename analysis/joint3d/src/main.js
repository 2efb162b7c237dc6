// SPDX-License-Identifier: GPL-3.0-or-later
// Joint3D: what the reader does becomes questions to the library, and its answers what the reader sees. Two workers run the
// library: one answers poses at once, the other bounds and sweeps, which take longer.
import { EngineClient, newestOnly } from "./engine_client.js";
import { byId } from "./elements.js";
import { exportPanel } from "./export_panel.js";
import { FemurDrag } from "./femur_drag.js";
import { FilesPanel } from "./files_panel.js";
import { JointPanel } from "./joint_panel.js";
import { lookBar, showLegend } from "./look_bar.js";
import { RANGES, motionPanel } from "./motion_panel.js";
import { Player } from "./player.js";
import { drawHistogram } from "./plots.js";
import { showReadouts } from "./readouts.js";
import { SceneView } from "./scene_view.js";
import { SlowWorker } from "./slow_worker.js";
import { firstState, fromFragment } from "./state.js";
import { SweepPanel } from "./sweep_panel.js";
import { TablesPanel } from "./tables_panel.js";

const REST = 350; // ms without a change before what takes longer begins
const app = { state: fromFragment(location.hash), drag: "view", files: null, ready: false, making: new Set() };

function say(text, kind = "fault") {
  byId("message").hidden = !text;
  byId("message").className = kind;
  byId("message-text").textContent = text;
}

/** Within another page, "embedded" among the words of the fragment leaves the picture alone. */
const frame = () => document.body.classList.toggle("embedded", new URLSearchParams(location.hash.slice(1)).has("embedded"));

/** While a joint or tables are made, the picture says so. kind: which of them. */
function busy(kind, more) {
  app.making[more ? "add" : "delete"](kind);
  byId("stage").setAttribute("aria-busy", String(app.making.size > 0));
}

const fault = (error) => say(typeof error === "string" ? error : error.message);

function start() {
  const source = byId("engine").textContent;
  const lost = (message) => fault(`The engine has stopped (${message}); load the page again.`);
  const live = new EngineClient(source, lost);
  const view = new SceneView(byId("view"), byId("compass"));
  let bound; // undefined while it is not known, null where there is none

  const poseRequest = () => ({
    ...app.state.motion,
    translation: view.fromJointFrame(app.state.offset),
    cartilage_mm: app.state.cartilage,
  });
  const askPose = newestOnly(
    (request) => live.ask("pose", request),
    (pose, took) => {
      if (!app.ready || pose.ball_gap.length !== app.vertices) return; // of a joint that is no more
      Object.assign(app, { pose, took });
      const scale = app.state.look.colours;
      view.setPose(pose, scale);
      showLegend(scale, pose.colours);
      drawHistogram(byId("histogram"), pose, scale);
      showReadouts(pose, took, bound);
      sweep.posed();
      document.body.dataset.poses = String(Number(document.body.dataset.poses ?? 0) + 1);
    },
    fault);
  const pose = () => { if (app.ready) askPose(poseRequest()); };
  const shown = () => { view.setLook(app.state.look); pose(); };

  const motion = motionPanel(app, pose);
  const sweep = new SweepPanel(app,
    (request) => slow.sweep(request),
    (angles) => { app.player.stop(); app.state.motion = angles; motion(); pose(); });
  const tables = new TablesPanel(app, () => fillTables());
  app.player = new Player(app, () => { motion(); pose(); });
  const showLook = lookBar(app, view, shown);

  const slow = new SlowWorker(new EngineClient(source, lost), {
    rest: REST,
    fault,
    onBound: (found) => {
      bound = found;
      tables.bounded(bound);
      if (app.pose) showReadouts(app.pose, app.took, bound);
    },
  });
  function follow(news) {
    bound = undefined;
    slow.follow(news);
    sweep.again(REST);
  }

  async function fillTables() {
    const request = { ...app.state.tables };
    busy("tables", true);
    try {
      const filled = await live.ask("tables", request);
      tables.filled(filled, false);
      view.setPoints(filled);
      follow({ tables: request });
      pose();
    } catch (error) {
      fault(error);
    }
    busy("tables", false);
  }

  /** Another joint; where the library refuses it, the one before stays. */
  const askJoint = newestOnly(({ request }) => live.ask("joint", request), takeJoint, refused,
    () => busy("joint", false));
  function useJoint(request, files) {
    busy("joint", true);
    askJoint({ request, files });
  }

  function refused(error) {
    fault(error);
    if (app.ready) return;
    app.state.joint = firstState().joint; // a link that asks for no possible hip
    joints.show();
    useJoint(joints.request(), null);
  }

  function takeJoint(joint, _, { request, files }) {
    const kind = `${request.source} ${request.name ?? ""} ${joint.side}`;
    const starts = !app.ready;
    const other = files || kind !== app.kind;
    Object.assign(app, { files, kind, vertices: joint.ball.positions.length / 3, ready: true });
    view.setJoint(joint, !files);
    view.setLook(app.state.look);
    view.setPoints(joint.tables);
    if (other) view.lookFrom(app.state.look.view);
    tables.filled(joint.tables, true);
    showJoint(joint);
    sweep.forget();
    follow({ joint: request });
    const remarks = joint.warnings.length;
    if (files && remarks) say(`${files}: ${remarks === 1 ? "one remark" : `${remarks} remarks`} under “About the meshes”.`, "warning");
    else if (!starts) say("");
    pose();
  }

  function showJoint(joint) {
    const name = app.files ?? byId("preset").selectedOptions[0]?.textContent ?? "";
    byId("joint-name").textContent = `${name}, ${joint.side ?? "side unknown"}`;
    const centre = joint.centre.map((x) => x.toFixed(2)).join(", ");
    byId("centre-say").textContent = joint.fit
      ? `Centre fitted at ${centre} mm: radius ${joint.fit.radius_mm.toFixed(2)} mm, residual ${joint.fit.residual_mm.toFixed(2)} mm.`
      : `Centre at ${centre} mm.`;
    byId("remarks").textContent = joint.warnings.join("\n") || "Nothing to remark.";
    if (app.files) byId("remarks").parentElement.open = joint.warnings.length > 0;
    byId("faces").textContent = `${(joint.ball.faces.length / 3).toLocaleString("en")} + ${(joint.socket.faces.length / 3).toLocaleString("en")}`;
  }

  const joints = new JointPanel(app, () => useJoint(joints.request(), null));
  new FilesPanel((request) => {
    app.player.stop();
    useJoint(request, `${request.ball.name} and ${request.socket.name}`);
  }, fault);
  exportPanel(app, view, (request) => live.ask("export", { ...request, pose: poseRequest() }), fault);
  const drag = new FemurDrag(view, (change) => {
    app.player.stop();
    Object.entries(change).forEach(([key, by]) => {
      const [least, most] = RANGES[key];
      app.state.motion[key] = Math.min(Math.max(app.state.motion[key] + by, least), most);
    });
    motion();
    pose();
  });
  app.setDrag = (what) => {
    app.drag = what;
    drag.active = what === "femur";
    view.canvas.classList.toggle("moves", drag.active);
  };
  view.onLost = (gone) => say(gone ? "The graphics were lost; they come back by themselves." : "", "warning");

  const showAll = () => { motion(); joints.show(); tables.show(); sweep.show(); showLook(); };
  byId("message-close").addEventListener("click", () => say(""));
  window.addEventListener("hashchange", () => {
    if (location.hash === app.ownFragment) return;
    app.state = fromFragment(location.hash);
    frame();
    begin();
  });

  async function begin() {
    showAll();
    app.kind = null;
    useJoint(joints.request(), null);
    if (JSON.stringify(app.state.tables) !== JSON.stringify(firstState().tables)) await fillTables();
  }

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
