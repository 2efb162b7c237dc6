// SPDX-License-Identifier: GPL-3.0-or-later
// What is drawn of a joint: both surfaces, their sample points, the clock, the smallest gap and a pelvis. Vertices come about
// the centre of rotation in the frame of the input; the root turns that into the joint frame.
import { Group, Mesh, MeshBasicMaterial, SphereGeometry, Vector3 } from "three";
import { extent } from "./cameras.js";
import { BEYOND, PLAIN } from "./colours.js";
import { CutSurface } from "./cut_surface.js";
import { GapSurface } from "./gap_surface.js";
import { schematicPelvis } from "./pelvis.js";
import { RimClock } from "./rim_clock.js";
import { SamplePoints } from "./sample_points.js";

const REGION = 1.45; // head radii: what belongs to the joint, as in the real joints' region files
const REACH = 3.2; // head radii: what a picture must show
const LARGE = 4; // head radii: a socket that reaches farther has a pelvis
const SURFACES = ["ball", "socket"];

/** Faces with a corner within `reach` of the centre. */
function facesNear(positions, faces, reach) {
  const near = [];
  const inside = (k) => Math.hypot(positions[3 * k], positions[3 * k + 1], positions[3 * k + 2]) <= reach;
  for (let k = 0; k < faces.length; k += 3) {
    if (inside(faces[k]) || inside(faces[k + 1]) || inside(faces[k + 2])) near.push(faces[k], faces[k + 1], faces[k + 2]);
  }
  return new Uint32Array(near);
}

function nearestMark() {
  const mark = new Group();
  [["#fff", 1.5, 11], ["#d4006a", 1.0, 12]].forEach(([colour, radius, order]) => {
    const dot = new Mesh(new SphereGeometry(radius, 20, 12), new MeshBasicMaterial({ color: colour, depthTest: false, transparent: true }));
    dot.renderOrder = order;
    mark.add(dot);
  });
  return mark;
}

export class JointParts {
  constructor() {
    Object.assign(this, { ball: new GapSurface("ball"), socket: new GapSurface("socket"), cut: new CutSurface(), isCut: false, points: new SamplePoints(), clock: new RimClock() });
    Object.assign(this, { nearest: nearestMark(), pelvis: new Group(), root: new Group(), side: "right", radius: 25 });
    this.root.matrixAutoUpdate = false;
    this.pelvis.visible = false;
    const { ball, socket } = this.points.parts;
    this.root.add(this.ball.mesh, this.cut.mesh, this.socket.mesh, ball, socket, this.clock.group, this.nearest, this.pelvis);
  }

  /** joint: the library's reply to `joint`; generated: a hip of parameters, which has no bones but its joint. */
  setJoint(joint, generated) {
    Object.assign(this, { generated, side: joint.side ?? "right", radius: joint.fit?.radius_mm ?? joint.parameters?.head_radius ?? 25 });
    this.root.matrix.fromArray(joint.to_joint_frame);
    SURFACES.forEach((part) => {
      const { positions, faces } = joint[part];
      this[part].setMesh(positions, faces, facesNear(positions, faces, REGION * this.radius));
    });
    this.clock.set(joint, REGION * this.radius);
    this.pelvis.clear();
    this.addPelvis();
    this.root.updateMatrixWorld(true);
  }

  /** Whether there is more of a pelvis to be seen than the socket. */
  hasPelvis() {
    if (this.generated) return true;
    const { array } = this.socket.mesh.geometry.getAttribute("position");
    for (let k = 0; k < array.length; k += 3) if (Math.hypot(array[k], array[k + 1], array[k + 2]) > LARGE * this.radius) return true;
    return false;
  }

  /** A drawn one, when it is first seen. */
  addPelvis() {
    if (this.generated && this.pelvis.visible && !this.pelvis.children.length) this.pelvis.add(schematicPelvis(this.side, this.radius));
  }

  extent() {
    return extent([this.ball.mesh, this.socket.mesh], REACH * this.radius);
  }

  /** pose: the library's reply to `pose`. */
  setPose(pose, scale) {
    [this.ball, this.cut].forEach(({ mesh }) => mesh.matrix.fromArray(pose.matrix));
    this.points.parts.ball.matrix.fromArray(pose.matrix);
    this.ball.setGaps(pose.ball_gap);
    this.socket.setGaps(pose.socket_gap);
    this.setColours(pose.colours, scale);
    this.met = Boolean(pose.smallest_gap);
    if (this.met) this.nearest.position.fromArray(pose.place);
    this.showBall();
  }

  setColours(colours, scale) {
    const key = JSON.stringify([colours, scale, this.isCut]);
    if (key === this.colourKey) return;
    Object.assign(this, { colourKey: key, colours, scale });
    this.ball.setColours(scale, colours.ball, colours.no_gap_rgb);
    if (this.isCut) this.socket.setColours(PLAIN, colours.socket, BEYOND.socket);
    else this.socket.setColours(scale, colours.socket, colours.no_gap_rgb);
  }

  /** look: drawing, and which parts are shown. */
  setLook({ drawing, shown }) {
    const has = (word) => shown.includes(word);
    SURFACES.forEach((part) => {
      this[part].setDrawing(drawing);
      this[part].mesh.visible = has(part);
      this.points.show(part, has("points") && has(part));
    });
    this.ballShown = has("ball");
    this.cut.material.wireframe = drawing === "lines";
    this.ball.showWhole(true);
    this.socket.showWhole(this.generated || has("pelvis"));
    this.pelvis.visible = has("pelvis");
    this.addPelvis();
    this.clock.group.visible = has("clock");
    this.marked = has("smallest");
    this.showBall();
  }

  /** The ball after a cut, the library's reply to `resect`; null: as it is. */
  setCut(cut) {
    this.isCut = Boolean(cut);
    if (cut) this.cut.set(cut);
    this.showBall();
    if (this.colours) this.setColours(this.colours, this.scale);
  }

  /** The ball or what a cut leaves of it, and the mark of a gap that is of the whole one. */
  showBall() {
    this.nearest.visible = Boolean(this.marked && this.met && !this.isCut);
    this.ball.mesh.visible = this.ballShown && !this.isCut;
    this.cut.mesh.visible = this.ballShown && this.isCut;
  }

  /** A shift or a direction given in the joint frame, in that of the input. */
  fromJointFrame(way) {
    return new Vector3(...way).applyMatrix4(this.root.matrix.clone().invert());
  }
}
