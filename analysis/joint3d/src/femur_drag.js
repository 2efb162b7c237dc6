// SPDX-License-Identifier: GPL-3.0-or-later
// Dragging the femur: the angles that make a grabbed point follow the pointer, to first order. The library turns them into
// a pose; here are only the axes of that pose (hip/motion.hpp): flexion about the pelvis' transverse axis, rotation about
// the femur's long axis, abduction about the axis square to both.
import { Matrix3, Matrix4, Raycaster, Vector2, Vector3 } from "three";

const DEGREES = 180 / Math.PI;

/** The axes of the three angles in the joint frame, each the way in which its angle grows. turn: the pose there. */
function axes(turn, side) {
  const mirror = side === "left" ? -1 : 1;
  const flexion = new Vector3(1, 0, 0);
  const rotation = new Vector3(0, 0, 1).transformDirection(turn);
  const abduction = rotation.clone().cross(flexion).normalize().multiplyScalar(-mirror);
  return [flexion, abduction, rotation.multiplyScalar(mirror)];
}

/** How much each angle changes, degrees, for a turn vector in radians: { flexion, abduction, internal_rotation }. */
function angleChange(turnVector, turn, side) {
  const [f, a, r] = axes(turn, side);
  const jacobian = new Matrix3().set(f.x, a.x, r.x, f.y, a.y, r.y, f.z, a.z, r.z);
  if (Math.abs(jacobian.determinant()) < 0.1) return null; // two axes are nearly one
  const change = turnVector.clone().applyMatrix3(jacobian.invert()).multiplyScalar(DEGREES);
  return { flexion: change.x, abduction: change.y, internal_rotation: change.z };
}

const place = (event, canvas) => {
  const box = canvas.getBoundingClientRect();
  return new Vector2(((event.clientX - box.left) / box.width) * 2 - 1, 1 - ((event.clientY - box.top) / box.height) * 2);
};

export class FemurDrag {
  /** scene: what SceneView offers; onTurn(change) receives the changes of the angles. */
  constructor(scene, onTurn) {
    Object.assign(this, { scene, onTurn, active: false, grabbed: null, caster: new Raycaster() });
    const { canvas } = scene;
    canvas.addEventListener("pointerdown", (event) => this.grab(event), true);
    canvas.addEventListener("pointermove", (event) => this.move(event));
    ["pointerup", "pointercancel"].forEach((name) => canvas.addEventListener(name, () => this.release()));
  }

  grab(event) {
    if (!this.active || event.button !== 0) return;
    this.caster.setFromCamera(place(event, this.scene.canvas), this.scene.eye.camera);
    const [hit] = this.caster.intersectObject(this.scene.parts.ball.mesh, false);
    if (!hit) return;
    this.scene.eye.controls.enabled = false;
    this.scene.canvas.setPointerCapture(event.pointerId);
    this.grabbed = { at: place(event, this.scene.canvas), point: hit.point };
  }

  move(event) {
    if (!this.grabbed) return;
    const { camera } = this.scene.eye;
    const at = place(event, this.scene.canvas);
    const from = this.grabbed.point.clone();
    const depth = from.clone().project(camera).z;
    const moved = new Vector3(at.x, at.y, depth).unproject(camera).sub(new Vector3(this.grabbed.at.x, this.grabbed.at.y, depth).unproject(camera));
    const turn = from.clone().cross(moved).divideScalar(Math.max(from.lengthSq(), 1));
    const toJoint = new Matrix4().copy(this.scene.parts.root.matrix);
    const pose = toJoint.clone().multiply(this.scene.parts.ball.mesh.matrix).multiply(toJoint.clone().invert());
    const change = angleChange(turn, pose, this.scene.parts.side);
    this.grabbed = { at, point: from.add(moved).setLength(this.grabbed.point.length()) };
    if (change) this.onTurn(change);
  }

  release() {
    if (!this.grabbed) return;
    this.grabbed = null;
    this.scene.eye.controls.enabled = true;
  }
}
