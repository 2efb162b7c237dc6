// SPDX-License-Identifier: GPL-3.0-or-later
// The joint in three dimensions. Vertices come about the centre of rotation in the frame of the input; the root turns that
// into the joint frame, in which cameras and light stand. Drawn when something changes, never in a loop.
import {
  BufferAttribute, BufferGeometry, Color, DirectionalLight, Group, HemisphereLight, Mesh,
  MeshBasicMaterial, PerspectiveCamera, Points, PointsMaterial, Scene, SphereGeometry, Vector3, WebGLRenderer,
} from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { extent, towardsCamera } from "./cameras.js";
import { GapSurface } from "./gap_surface.js";
import { drawCompass } from "./labels.js";
import { schematicPelvis } from "./pelvis.js";
import { RimClock, sightIn } from "./rim_clock.js";

const REGION = 1.45; // head radii: what belongs to the joint, as in the real joints' region files
const WIDER = 2.2; // how much farther off one sees a pelvis
const REACH = 3.2; // head radii: what a picture must show

/** Faces with a corner within `reach` of the centre. */
function facesNear(positions, faces, reach) {
  const near = [];
  const inside = (k) => Math.hypot(positions[3 * k], positions[3 * k + 1], positions[3 * k + 2]) <= reach;
  for (let k = 0; k < faces.length; k += 3) {
    if (inside(faces[k]) || inside(faces[k + 1]) || inside(faces[k + 2])) near.push(faces[k], faces[k + 1], faces[k + 2]);
  }
  return new Uint32Array(near);
}

const cloud = (colour) => {
  const points = new Points(new BufferGeometry(), new PointsMaterial({ color: colour, size: 2, sizeAttenuation: false }));
  points.matrixAutoUpdate = false;
  return points;
};

export class SceneView {
  constructor(canvas, compass) {
    Object.assign(this, { canvas, compass, side: "right", onTurned: () => {}, onLost: () => {} });
    this.renderer = new WebGLRenderer({ canvas, antialias: true, preserveDrawingBuffer: true });
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    this.scene = new Scene();
    this.scene.background = new Color("#eef2f5");
    this.camera = new PerspectiveCamera(26, 1, 1, 4000);
    this.camera.up.set(0, 0, 1);
    this.lamp = new DirectionalLight(0xffffff, 1.5);
    this.root = new Group();
    this.root.matrixAutoUpdate = false;
    this.scene.add(new HemisphereLight(0xffffff, 0xc8ccd2, 2.1), this.lamp, this.lamp.target, this.root);
    this.addParts();
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.addEventListener("change", () => this.draw());
    this.controls.addEventListener("start", () => this.onTurned());
    canvas.addEventListener("webglcontextlost", () => this.onLost(true));
    canvas.addEventListener("webglcontextrestored", () => { this.onLost(false); this.draw(); });
    new ResizeObserver(() => this.fit()).observe(canvas.parentElement);
  }

  addParts() {
    this.ball = new GapSurface("ball");
    this.socket = new GapSurface("socket");
    this.points = { ball: cloud("#0b3d2a"), socket: cloud("#0d2b52") };
    this.clock = new RimClock();
    this.nearest = new Group();
    [["#fff", 1.5, 11], ["#d4006a", 1.0, 12]].forEach(([colour, radius, order]) => {
      const dot = new Mesh(new SphereGeometry(radius, 20, 12), new MeshBasicMaterial({ color: colour, depthTest: false, transparent: true }));
      dot.renderOrder = order;
      this.nearest.add(dot);
    });
    this.pelvis = new Group();
    this.pelvis.visible = false;
    this.root.add(this.ball.mesh, this.socket.mesh, this.points.ball, this.points.socket, this.clock.group, this.nearest, this.pelvis);
  }

  /** joint: the library's reply to `joint`; generated: a hip of parameters, which has no bones but its joint. */
  setJoint(joint, generated) {
    this.side = joint.side ?? "right";
    this.radius = joint.fit?.radius_mm ?? 25;
    this.root.matrix.fromArray(joint.to_joint_frame);
    ["ball", "socket"].forEach((part) => {
      const { positions, faces } = joint[part];
      this[part].setMesh(positions, faces, facesNear(positions, faces, REGION * this.radius));
    });
    this.generated = generated;
    this.clock.set(joint, REGION * this.radius);
    this.pelvis.clear();
    if (generated) this.pelvis.add(schematicPelvis(this.side, this.radius));
    this.scene.updateMatrixWorld(true);
    this.subject = extent([this.ball.mesh, this.socket.mesh], REACH * this.radius);
    this.draw();
  }

  /** A shift given in the joint frame, in that of the input. */
  fromJointFrame(shift) {
    return new Vector3(...shift).applyMatrix4(this.root.matrix.clone().invert()).toArray();
  }

  setPoints({ points_ball: ball, points_socket: socket }) {
    [[this.points.ball, ball], [this.points.socket, socket]].forEach(([points, places]) => {
      points.geometry.dispose();
      points.geometry = new BufferGeometry().setAttribute("position", new BufferAttribute(places, 3));
    });
    this.draw();
  }

  /** pose: the library's reply to `pose`. */
  setPose(pose, scale) {
    this.ball.mesh.matrix.fromArray(pose.matrix);
    this.points.ball.matrix.fromArray(pose.matrix);
    this.ball.setGaps(pose.ball_gap);
    this.socket.setGaps(pose.socket_gap);
    this.setColours(pose.colours, scale);
    this.met = Boolean(pose.smallest);
    this.nearest.visible = this.met && this.marked;
    if (this.met) this.nearest.position.fromArray(pose.smallest.place);
    this.draw();
  }

  setColours(colours, scale) {
    const key = JSON.stringify([colours, scale]);
    if (key === this.colourKey) return;
    this.colourKey = key;
    ["ball", "socket"].forEach((part) => this[part].setColours(scale, colours[part], colours.none));
    this.draw();
  }

  /** look: drawing, and which parts are shown. */
  setLook({ drawing, shown }) {
    const has = (word) => shown.includes(word);
    ["ball", "socket"].forEach((part) => {
      this[part].setDrawing(drawing);
      this[part].mesh.visible = has(part);
      this.points[part].visible = has("points") && has(part);
    });
    this.ball.showWhole(true);
    this.socket.showWhole(this.generated || has("pelvis"));
    if (has("pelvis") !== this.pelvis.visible) this.widen(has("pelvis"));
    this.pelvis.visible = has("pelvis");
    this.clock.group.visible = has("clock");
    this.marked = has("smallest");
    this.nearest.visible = this.marked && this.met;
    this.draw();
  }

  /** From farther off, or back. */
  widen(farther) {
    const arm = this.camera.position.clone().sub(this.controls.target);
    this.camera.position.copy(this.controls.target).addScaledVector(arm, farther ? WIDER : 1 / WIDER);
    this.controls.update();
  }

  /** Puts the camera at a view, far enough for the joint. */
  lookFrom(view) {
    if (!this.subject) return;
    const { centre, radius } = this.subject;
    const half = (this.camera.fov / 2) * (Math.PI / 180);
    const narrow = Math.atan(Math.tan(half) * Math.min(this.camera.aspect, 1));
    const distance = ((this.pelvis.visible ? WIDER : 1) * radius) / Math.sin(narrow);
    this.controls.target.copy(centre);
    this.camera.position.copy(centre).addScaledVector(towardsCamera(view, this.side), distance);
    this.camera.far = distance + 20 * radius;
    this.camera.near = Math.max(distance - 8 * radius, distance / 50);
    this.camera.updateProjectionMatrix();
    this.controls.update();
    this.draw();
  }

  /** Turns the camera about the joint, degrees, and moves it nearer or farther. */
  orbit(right, up, nearer = 1) {
    const arm = this.camera.position.clone().sub(this.controls.target);
    arm.applyAxisAngle(new Vector3(0, 0, 1), (-right * Math.PI) / 180);
    const across = new Vector3(0, 0, 1).cross(arm).normalize();
    const tilted = arm.clone().applyAxisAngle(across, (-up * Math.PI) / 180);
    if (Math.abs(tilted.z) < 0.999 * tilted.length()) arm.copy(tilted);
    this.camera.position.copy(this.controls.target).addScaledVector(arm, nearer);
    this.controls.update();
    this.onTurned();
    this.draw();
  }

  fit() {
    const { clientWidth: width, clientHeight: height } = this.canvas.parentElement;
    if (!width || !height) return;
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.drawNow();
  }

  draw() {
    if (this.asked) return;
    this.asked = true;
    requestAnimationFrame(() => { this.asked = false; this.drawNow(); });
  }

  drawNow() {
    this.lamp.position.copy(this.camera.position).add(new Vector3(0, 0, 0.5 * this.camera.position.length()));
    this.clock.fade(sightIn(this.root, this.camera));
    this.lamp.target.position.copy(this.controls.target);
    this.renderer.render(this.scene, this.camera);
    drawCompass(this.compass, this.camera);
  }

  /** The picture as a PNG: a promise of a Blob. */
  picture() {
    this.drawNow();
    return new Promise((resolve) => this.canvas.toBlob(resolve, "image/png"));
  }
}

export const identity = () => new Matrix4();
