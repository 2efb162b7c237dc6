// SPDX-License-Identifier: GPL-3.0-or-later
// The joint in three dimensions, in the joint frame. Drawn when something changes, never in a loop.
import { Color, DirectionalLight, HemisphereLight, Scene, Vector3, WebGLRenderer } from "three";
import { JointParts } from "./joint_parts.js";
import { drawCompass } from "./labels.js";
import { ViewCamera } from "./view_camera.js";

const LARGEST = 16e6; // pixels of a picture, whatever the zoom

export class SceneView {
  constructor(canvas, compass) {
    Object.assign(this, { canvas, compass, spacing: 1, onTurned: () => {}, onLost: () => {} });
    this.renderer = new WebGLRenderer({ canvas, antialias: true, preserveDrawingBuffer: true });
    this.scene = new Scene();
    this.scene.background = new Color("#eef2f5");
    this.lamp = new DirectionalLight(0xffffff, 1.5);
    this.parts = new JointParts();
    this.scene.add(new HemisphereLight(0xffffff, 0xc8ccd2, 2.1), this.lamp, this.lamp.target, this.parts.root);
    this.eye = new ViewCamera(canvas, () => this.draw(), () => this.onTurned());
    canvas.addEventListener("webglcontextlost", () => this.onLost(true));
    canvas.addEventListener("webglcontextrestored", () => { this.onLost(false); this.draw(); });
    new ResizeObserver(() => this.fit()).observe(canvas.parentElement);
    window.addEventListener("resize", () => this.fit()); // of a zoom, too
  }

  /** joint: the library's reply to `joint`; generated: a hip of parameters. */
  setJoint(joint, generated) {
    this.parts.setJoint(joint, generated);
    this.eye.setSubject(this.parts.extent(), this.parts.side);
    this.draw();
  }

  /** places: { ball, socket } or null; spacing: about how far apart they are, mm. */
  setPoints(places, spacing) {
    this.parts.points.set(places);
    this.spacing = spacing;
    this.draw();
  }

  /** pose: the library's reply to `pose`. */
  setPose(pose, scale) {
    this.parts.setPose(pose, scale);
    this.draw();
  }

  /** cut: the library's reply to `resect`, whose ball is then shown, or null. */
  setCut(cut) {
    this.parts.setCut(cut);
    this.draw();
  }

  /** look: drawing, and which parts are shown. */
  setLook(look) {
    this.parts.setLook(look);
    this.eye.widen(look.shown.includes("pelvis") && this.parts.hasPelvis());
    this.draw();
  }

  fit() {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    if (!width || !height) return;
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, Math.sqrt(LARGEST / (width * height))));
    this.renderer.setSize(width, height, false);
    this.eye.resize(width, height);
    this.drawNow();
  }

  draw() {
    if (this.asked) return;
    this.asked = true;
    requestAnimationFrame(() => { this.asked = false; this.drawNow(); });
  }

  drawNow() {
    const { camera, controls } = this.eye;
    this.lamp.position.copy(camera.position).add(new Vector3(0, 0, 0.5 * camera.position.length()));
    this.lamp.target.position.copy(controls.target);
    this.parts.clock.fade(this.parts.fromJointFrame(camera.getWorldDirection(new Vector3())));
    this.parts.points.fit(this.spacing * this.eye.pixelsPerMm() * this.renderer.getPixelRatio());
    this.renderer.render(this.scene, camera);
    drawCompass(this.compass, camera);
  }
}
