// SPDX-License-Identifier: GPL-3.0-or-later
// The camera: where it stands, and how a reader moves it. In the joint frame.
import { PerspectiveCamera, Vector3 } from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { towardsCamera } from "./cameras.js";

const WIDER = 2.3; // how much farther off one sees a pelvis
const HIGHER = 0.35; // and how much higher, in radii of the joint: most of it is above
const UP = new Vector3(0, 0, 1);

export class ViewCamera {
  /** onMove() when it has moved; onTurned() when a reader has turned it. */
  constructor(canvas, onMove, onTurned) {
    Object.assign(this, { onMove, onTurned, subject: null, wide: false });
    this.camera = new PerspectiveCamera(26, 1, 1, 4000);
    this.camera.up.copy(UP);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.addEventListener("change", onMove);
    this.controls.addEventListener("end", onTurned);
  }

  /** subject: what a picture shows, as of extent(). */
  setSubject(subject, side) {
    Object.assign(this, { subject, side });
  }

  resize(width, height) {
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.height = height;
  }

  /** Pixels of a millimetre at the joint. */
  pixelsPerMm() {
    const distance = this.camera.position.distanceTo(this.controls.target);
    return this.height / (2 * distance * Math.tan((this.camera.fov / 2) * (Math.PI / 180)));
  }

  /** From farther off, so that a pelvis is in the picture, or back. */
  widen(wide) {
    if (wide === this.wide) return;
    this.wide = wide;
    const arm = this.camera.position.clone().sub(this.controls.target);
    if (this.subject) this.controls.target.addScaledVector(UP, (wide ? 1 : -1) * HIGHER * this.subject.radius);
    this.camera.position.copy(this.controls.target).addScaledVector(arm, wide ? WIDER : 1 / WIDER);
    this.controls.update();
  }

  /** Stands at a view, far enough for the subject. */
  lookFrom(view) {
    if (!this.subject) return;
    const { centre, radius } = this.subject;
    const half = (this.camera.fov / 2) * (Math.PI / 180);
    const narrow = Math.atan(Math.tan(half) * Math.min(this.camera.aspect, 1));
    const distance = ((this.wide ? WIDER : 1) * radius) / Math.sin(narrow);
    this.controls.target.copy(centre).addScaledVector(UP, this.wide ? HIGHER * radius : 0);
    this.camera.position.copy(this.controls.target).addScaledVector(towardsCamera(view, this.side), distance);
    this.camera.far = distance + 20 * radius;
    this.camera.near = Math.max(distance - 8 * radius, distance / 50);
    this.camera.updateProjectionMatrix();
    this.controls.update();
    this.onMove();
  }

  /** Where it stands and what it looks at, mm. */
  place() {
    return [...this.camera.position.toArray(), ...this.controls.target.toArray()];
  }

  /** Stands where it stood. place: as of place(). */
  standAt(place) {
    this.camera.position.fromArray(place);
    this.controls.target.fromArray(place, 3);
    this.controls.update();
    this.onMove();
  }

  /** Turns about the joint, degrees, and moves nearer or farther. */
  orbit(right, up, nearer = 1) {
    const arm = this.camera.position.clone().sub(this.controls.target);
    arm.applyAxisAngle(UP, (-right * Math.PI) / 180);
    const across = UP.clone().cross(arm).normalize();
    const tilted = arm.clone().applyAxisAngle(across, (-up * Math.PI) / 180);
    if (Math.abs(tilted.z) < 0.999 * tilted.length()) arm.copy(tilted);
    this.camera.position.copy(this.controls.target).addScaledVector(arm, nearer);
    this.controls.update();
    this.onTurned();
    this.onMove();
  }
}
