// SPDX-License-Identifier: GPL-3.0-or-later
// Points on both surfaces, as large and as strong as leaves room between them.
import { BufferAttribute, BufferGeometry, Points, PointsMaterial } from "three";

const COLOURS = { ball: "#0b3d2a", socket: "#0d2b52" };

function cloud(colour) {
  const material = new PointsMaterial({ color: colour, size: 2, sizeAttenuation: false, transparent: true, depthWrite: false });
  const points = new Points(new BufferGeometry(), material);
  points.matrixAutoUpdate = false;
  points.renderOrder = 4;
  points.frustumCulled = false; // a sphere about millions of points takes longer than to draw them
  return points;
}

export class SamplePoints {
  constructor() {
    this.parts = { ball: cloud(COLOURS.ball), socket: cloud(COLOURS.socket) };
  }

  /** places: { ball, socket }, x, y and z of each point in turn, or null for none. */
  set(places) {
    Object.entries(this.parts).forEach(([part, points]) => {
      points.geometry.dispose();
      points.geometry = new BufferGeometry().setAttribute("position", new BufferAttribute(places?.[part] ?? new Float32Array(0), 3));
    });
  }

  show(part, visible) {
    this.parts[part].visible = visible;
  }

  /** apart: pixels from one point to the next. */
  fit(apart) {
    Object.values(this.parts).forEach(({ material }) => {
      material.size = Math.min(Math.max(0.45 * apart, 1), 5);
      material.opacity = Math.min(Math.max(apart / 4, 0.12), 0.9);
    });
  }
}
