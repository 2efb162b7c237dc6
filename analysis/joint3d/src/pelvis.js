// SPDX-License-Identifier: GPL-3.0-or-later
// A schematic hip bone about a generated socket, so that a reader sees which way is up. It is drawn, never scanned: balls along
// curves and sheets, smoothed into one body, and cut away about the joint, which it must not hide.
import { BufferGeometry, CatmullRomCurve3, DoubleSide, Float32BufferAttribute, Group, Mesh, MeshLambertMaterial, Vector3 } from "three";
import { makeGrid, surfaceOf } from "./surface_nets.js";

// In head radii, right side: x lateral, y anterior, z superior, about the centre of the head.
const CREST = [[-0.6, 1.75, 2.5], [-0.05, 2.1, 3.3], [0.25, 1.2, 4.5], [-0.1, -0.4, 5.0], [-1.1, -2.1, 4.5], [-2.1, -3.1, 3.3], [-2.2, -3.0, 2.5]];
const ROOT = [[-0.5, 1.25, 1.3], [-0.45, 1.0, 1.5], [-0.5, 0.5, 1.6], [-0.7, -0.2, 1.6], [-1.0, -0.9, 1.45], [-1.35, -1.5, 1.25], [-1.5, -1.75, 1.0]];
const PUBIS = [[-0.6, 1.3, 1.2], [-0.95, 1.4, 0.5], [-1.6, 1.55, 0.05], [-2.4, 1.85, -0.45], [-3.3, 2.1, -0.9], [-3.55, 1.9, -1.6]];
const RAMUS = [[-3.55, 1.9, -1.6], [-3.0, 1.2, -2.3], [-2.2, 0.3, -2.75], [-1.5, -0.6, -2.9]];
const ISCHIUM = [[-1.4, -1.5, 1.2], [-1.3, -1.5, 0.4], [-1.1, -1.6, -0.4], [-0.9, -1.6, -1.5], [-0.95, -1.3, -2.5], [-1.3, -0.8, -2.9]];
const [LOW, HIGH, STEP] = [[-4.2, -3.9, -3.6], [1.1, 2.9, 5.6], 0.13];
const CUT = 1.5; // head radii about the centre
const FAR = 0.6; // head radii: beyond it nothing is told of a ball

/** Balls along a curve: [x, y, z, radius] each; radius(share) of the way. */
function along(points, radius, count = 60) {
  const curve = new CatmullRomCurve3(points.map((x) => new Vector3(...x)));
  return Array.from({ length: count + 1 }, (_, k) => [...curve.getPoint(k / count).toArray(), radius(k / count)]);
}

/** Balls over the wing, between its root and its crest, with its hollow. */
function wing() {
  const [root, crest] = [ROOT, CREST].map((points) => along(points, () => 0, 70));
  return root.flatMap((from, k) => Array.from({ length: 41 }, (_, j) => {
    const share = j / 40;
    const x = from.slice(0, 3).map((value, axis) => value + share * (crest[k][axis] - value));
    x[0] -= 0.4 * Math.sin(Math.PI * share);
    return [...x, 0.13 + 0.15 * share ** 6 + 0.22 * (1 - share) ** 2];
  }));
}

/** Distances from the nearest ball, near it. */
function addBall({ low, step, size, strides, values }, [x, y, z, radius]) {
  const [from, to] = [-1, 1].map((way) => [x, y, z].map((c, k) =>
    Math.min(Math.max(Math.round((c + way * (radius + FAR) - low[k]) / step), 0), size[k] - 1)));
  for (let k = from[2]; k <= to[2]; k += 1) for (let j = from[1]; j <= to[1]; j += 1) for (let i = from[0]; i <= to[0]; i += 1) {
    const distance = Math.hypot(low[0] + i * step - x, low[1] + j * step - y, low[2] + k * step - z) - radius;
    const at = i + j * strides[1] + k * strides[2];
    if (distance < values[at]) values[at] = distance;
  }
}

/** Each value becomes the mean of itself and its two neighbours along each axis. */
function smooth(grid) {
  grid.strides.forEach((stride) => {
    const old = grid.values.slice();
    for (let at = stride; at < old.length - stride; at += 1) grid.values[at] = (old[at - stride] + 2 * old[at] + old[at + stride]) / 4;
  });
}

function cutAway({ low, step, size, strides, values }) {
  for (let k = 0; k < size[2]; k += 1) for (let j = 0; j < size[1]; j += 1) for (let i = 0; i < size[0]; i += 1) {
    const at = i + j * strides[1] + k * strides[2];
    values[at] = Math.max(values[at], CUT - Math.hypot(low[0] + i * step, low[1] + j * step, low[2] + k * step));
  }
}

let shape = null;

function boneGeometry() {
  if (shape) return shape;
  const grid = makeGrid(LOW, HIGH, STEP, FAR);
  const balls = [...wing(), ...along(PUBIS, (t) => 0.44 - 0.14 * Math.sin(Math.PI * t)), ...along(RAMUS, () => 0.32),
    ...along(ISCHIUM, (t) => 0.4 + 0.16 * t ** 2)];
  balls.forEach((ball) => addBall(grid, ball));
  for (let times = 0; times < 3; times += 1) smooth(grid);
  cutAway(grid);
  const { positions, faces } = surfaceOf(grid);
  shape = new BufferGeometry().setAttribute("position", new Float32BufferAttribute(positions, 3)).setIndex(faces);
  shape.computeVertexNormals();
  return shape;
}

/** The bone for a head of that radius, mm; a left one is the mirror image. One sees through it, but not into it. */
export function schematicPelvis(side, radius) {
  const look = { transparent: true, side: DoubleSide };
  const nearest = new Mesh(boneGeometry(), new MeshLambertMaterial({ ...look, colorWrite: false }));
  const seen = new Mesh(boneGeometry(), new MeshLambertMaterial({ ...look, color: "#d8cfbd", opacity: 0.55 }));
  [nearest.renderOrder, seen.renderOrder] = [5, 6];
  const bone = new Group();
  bone.add(nearest, seen);
  bone.scale.set(side === "left" ? -radius : radius, radius, radius);
  return bone;
}
