// SPDX-License-Identifier: GPL-3.0-or-later
// The femur after a cut, coloured by how deep it goes.
import { BufferAttribute, BufferGeometry, Color, DoubleSide, Mesh, MeshLambertMaterial } from "three";
import { BEYOND, RAMP, along, css } from "./colours.js";
import { roundedUp } from "./elements.js";
import { setGeometry } from "./gap_surface.js";

const WHOLE = BEYOND.ball;
const RAMPED = [WHOLE, ...[...RAMP].reverse()]; // the deeper the darker; without a step at the edge of the cut

/** Rows of the legend, as legendRows(). deepest: mm. The socket has one colour beside a cut femur: gaps are those before the cut. */
export const cutRows = (deepest) => [{ colours: [css(WHOLE)], text: "femur, not cut" }, { colours: RAMPED.map(css), text: `cut, up to ${roundedUp(deepest, 1)} mm deep` },
  { colours: [css(BEYOND.socket)], text: "socket" }];

export class CutSurface {
  constructor() {
    this.material = new MeshLambertMaterial({ side: DoubleSide, vertexColors: true });
    this.mesh = new Mesh(new BufferGeometry(), this.material);
    this.mesh.matrixAutoUpdate = false;
    this.mesh.renderOrder = 1;
    this.mesh.visible = false;
  }

  /** cut: the library's reply to `resect`. */
  set({ positions, faces, depth, depth_mm: [, deepest] }) {
    this.deepest = deepest;
    const colours = new Float32Array(positions.length);
    const colour = new Color();
    depth.forEach((mm, k) => {
      const [red, green, blue] = along(RAMPED, mm / deepest);
      colour.setRGB(red / 255, green / 255, blue / 255, "srgb").toArray(colours, 3 * k);
    });
    setGeometry(this.mesh, { position: new BufferAttribute(positions, 3), color: new BufferAttribute(colours, 3) }, new BufferAttribute(faces, 1));
  }
}
