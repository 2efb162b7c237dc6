// SPDX-License-Identifier: GPL-3.0-or-later
// Joint3D: what the reader does becomes questions to the library, and its answers what the reader sees. Two workers run the
// library: one answers poses at once, the other what takes longer.
import { keepAddress } from "./address.js";
import { EngineClient, Stale } from "./engine_client.js";
import { CutPanel } from "./cut_panel.js";
import { byId } from "./elements.js";
import { ExportPanel } from "./export_panel.js";
import { FemurDrag } from "./femur_drag.js";
import { FilesPanel, ownRequest } from "./files_panel.js";
import { keepFolds } from "./folds.js";
import { JointPanel } from "./joint_panel.js";
import { doubtOf, showJoint } from "./joint_words.js";
import { KeptMeshes } from "./kept_meshes.js";
import { LimitsPanel } from "./limits_panel.js";
import { lookBar } from "./look_bar.js";
import { maker } from "./making.js";
import { MeasuresPanel } from "./measures_panel.js";
import { fault, say } from "./messages.js";
import { inRange, motionPanel } from "./motion_panel.js";
import { OrientationPanel } from "./orientation_panel.js";
import { Player } from "./player.js";
import { PointsPanel } from "./points_panel.js";
import { Poses } from "./poses.js";
import { Proof } from "./proof.js";
import { ReportPanel } from "./report_panel.js";
import { SceneView } from "./scene_view.js";
import { readSession } from "./session_file.js";
import { SlowWorker } from "./slow_worker.js";
import { OWN, firstState, fromFragment } from "./state.js";
import { SweepPanel, poseAlong } from "./sweep_panel.js";
import { TablesPanel } from "./tables_panel.js";
import { VolumePanel } from "./volume_panel.js";

const REST = 350; // ms without a change before what takes longer begins
const NOT_KEPT = "The meshes of this address are not here: a browser keeps them for its tab alone. Choose them again under “Your own joint”, or open a session that was saved.";
const app = { state: fromFragment(location.hash), drag: "view", own: null, ready: false }; // own: a reader's meshes, as FilesPanel has them, and what they are called

/** Within another page, "embedded" among the words of the fragment leaves the picture alone. */
const frame = () => document.body.classList.toggle("embedded", new URLSearchParams(location.hash.slice(1)).has("embedded"));

function start() {
  keepFolds();
  const source = byId("engine").textContent;
  const lost = () => fault("The engine has stopped; load the page again: what it shows is kept in its address.");
  const live = new EngineClient(source, lost);
  const view = new SceneView(byId("view"), byId("compass"));
  const slow = new SlowWorker(new EngineClient(source, lost), { rest: REST, fault, onBound });
  const kept = new KeptMeshes();
  const proof = new Proof((request) => slow.ask("verdicts", request), fault);
  const poses = new Poses(app, view, { ask: (request) => live.ask("pose", request), fault,
    onPose: (request) => { proof.posed(request); sweep.posed(); limits.posed(); volume.posed(); } });
  const pose = () => poses.again();
  const make = maker(live, { onTables, onJoint, onRefused });
  let shown = null; // the joint at hand, as the library has it
  let made = null; // and as it was asked for: { request, own, joint }, joint of the state

  const motion = motionPanel(app, pose);
  const moved = () => { motion(); pose(); };
  const goTo = (angles) => { app.player.stop(); app.state.motion = angles; moved(); };
  const sweep = new SweepPanel(app, (request) => slow.ask("sweep", { ...poses.shape(), ...request }), goTo);
  const limits = new LimitsPanel(app, { ask: (request) => slow.ask("limits", request), shape: () => poses.shape(), fault,
    onPose: (along, degrees) => goTo(poseAlong(along, degrees)) });
  const volume = new VolumePanel(app, () => new EngineClient(source, lost));
  const changes = [new CutPanel(app, () => new EngineClient(source, lost), (cut) => { view.setCut(cut); poses.legend(); }),
    new OrientationPanel(app, () => new EngineClient(source, lost))];
  changes.forEach((panel) => { panel.onRequired = () => changes.forEach((each) => each.again()); });
  const measures = new MeasuresPanel(() => slow.ask("measure"));
  const tables = new TablesPanel(app, () => make.tables({ ...app.state.tables }));
  const points = new PointsPanel(app, () => slow.ask("points"), { fault, radius: () => view.parts.radius,
    onPoints: (found, apart) => view.setPoints(found, apart) });
  app.player = new Player(app, moved);
  const showLook = lookBar(app, view, () => {
    view.setLook(app.state.look);
    if (app.state.look.camera) app.state.look.camera = view.eye.place(); // a pelvis asks for more room
    points.show();
    pose();
  });
  const joints = new JointPanel(app, askJoint);
  const files = new FilesPanel((own) => {
    app.player.stop();
    make.joint({ request: ownRequest(own), own, joint: { name: OWN, side: own.side, parameters: {} } });
  }, openSession, fault);
  const write = keepAddress(app, () => { frame(); begin(); });
  new ExportPanel(app, view, { write, fault, ask: (kind, request) => live.ask(kind, request), request: () => poses.request(),
    shown: () => ({ joint: shown, pose: poses.shown, at: poses.at, tables: tables.now, limits: limits.rows, name: joints.name() }) });
  const report = new ReportPanel(app, () => new EngineClient(source, lost), () => joints.name());
  const drag = new FemurDrag(view, (change) => {
    app.player.stop();
    Object.entries(change).forEach(([key, by]) => { app.state.motion[key] = inRange(app.state.motion[key] + by); });
    moved();
  });

  /** Asks for the joint that the state names. */
  function askJoint() {
    const own = app.state.joint.name === OWN ? app.own : null;
    make.joint({ request: own ? ownRequest(own) : joints.request(), own, joint: structuredClone(app.state.joint) });
  }

  function onBound(bound) {
    tables.bounded(bound);
    proof.begin(poses.request());
    limits.ready();
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

  /** The state is then again that of the joint at hand, unless a reader wants yet another by now. */
  function onRefused(error, { joint }) {
    if (!(error instanceof Stale)) fault(error);
    if (made && JSON.stringify(app.state.joint) !== JSON.stringify(joint)) return;
    app.state.joint = structuredClone(made?.joint ?? firstState().joint); // or a link asks for no possible hip
    if (made?.own) app.own = made.own;
    joints.show();
    if (!made) askJoint();
  }

  function takeOwn(own) {
    app.own = own;
    kept.keep(own).catch(() => { byId("files-say").textContent += " This browser cannot keep them: a reload loses them."; });
  }

  function onJoint(joint, asked) {
    const { request, own } = asked;
    const kind = `${request.source} ${request.name ?? ""} ${joint.side}`;
    const other = own || kind !== app.kind;
    const { text, actions } = own ? doubtOf(joint, own, (change) => files.use(change)) : { text: "", actions: [] };
    if (app.ready || text) say(text, "fault", actions);
    made = asked;
    if (own) takeOwn(own);
    if (own || app.state.joint.name !== asked.joint.name) { // a reader's own joint, or the one before has come late and named itself
      app.state.joint = structuredClone(asked.joint);
      joints.show();
    }
    if (other && app.kind !== null) app.state.look.camera = null; // a link that has just been opened keeps its own
    Object.assign(app, { kind, ready: true });
    shown = joint;
    poses.begin(joint.ball.positions.length / 3);
    view.setJoint(joint, !own);
    view.setLook(app.state.look);
    if (other) view.eye.lookFrom(app.state.look.view);
    if (app.state.look.camera) view.eye.standAt(app.state.look.camera);
    tables.filled(joint.tables, true);
    showJoint(joint, joints.name(), own);
    sweep.forget();
    limits.forget();
    follow({ joint: request });
    measures.again();
    [volume, report, ...changes].forEach((panel) => panel.follow(request));
    document.querySelectorAll("[inert]").forEach((part) => { part.inert = false; });
    delete byId("stage").dataset.busy;
  }

  app.setDrag = (what) => {
    app.drag = what;
    drag.active = what === "femur";
    view.canvas.classList.toggle("moves", drag.active);
  };
  view.onLost = (gone) => say(gone ? "The graphics were lost; they come back by themselves." : "", "warning");
  byId("open-session").addEventListener("change", ({ target }) => { if (target.files[0]) openSession(target.files[0]); });
  byId("message-close").addEventListener("click", () => say(""));
  document.querySelector(".skip").addEventListener("click", (event) => { // no other address: that is the state
    event.preventDefault();
    document.querySelector("#motion summary").focus();
  });

  /** The meshes that this tab has kept, whatever joint is shown. */
  async function recall() {
    if (!app.own) {
      app.own = await kept.found().catch(() => null) ?? null;
      if (app.own) files.restore(app.own);
    }
    if (app.own || app.state.joint.name !== OWN) return;
    app.state.joint = firstState().joint;
    say(NOT_KEPT, "warning");
  }

  /** A saved session, with its meshes. */
  async function openSession(file) {
    try {
      const { fragment, files: lists, fields } = await readSession(file);
      app.player.stop();
      if (lists) {
        files.take(lists, true);
        files.fill(fields);
        app.own = await files.own();
      }
      app.state = fromFragment(fragment);
      await begin();
    } catch (error) {
      fault(error);
    }
  }

  async function begin() {
    await recall();
    motion();
    [joints, tables, sweep].forEach((panel) => panel.show());
    showLook();
    app.kind = null;
    askJoint();
    await make.tables({ ...app.state.tables });
  }

  live.ask("presets").then((catalogue) => {
    [joints, tables, sweep, limits].forEach((panel) => panel.setCatalogue(catalogue));
    app.player.setMotions(catalogue.recorded);
    return begin();
  }).then(() => document.body.classList.add("ready")).catch(fault);
}

try {
  frame();
  start();
} catch (error) {
  byId("stage").setAttribute("aria-busy", "false");
  fault(/WebGL/i.test(error.message) ? "The picture needs WebGL 2, which this browser does not offer: change its settings or use another browser." : error);
}
