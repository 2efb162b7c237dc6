// SPDX-License-Identifier: GPL-3.0-or-later
// A mesh coloured by its gaps. Colours are looked up for each pixel, so the levels end where the gap passes their
// thresholds, not at the vertices.
import { BufferAttribute, BufferGeometry, Color, DataTexture, DoubleSide, Mesh, MeshLambertMaterial, SRGBColorSpace } from "three";
import { RANGE, colourTable, css } from "./colours.js";

const VERTEX = `
attribute vec2 gap; // mm, and 1 where the other surface is met, else 0 and 0
varying vec2 seenGap;
`;
// Where some corner of a face has no gap, the others' is taken.
const FRAGMENT = `
uniform sampler2D scale;
uniform vec3 nothing;
uniform bool unlit;
varying vec2 seenGap;
vec3 gapColour() {
  if (seenGap.y < 0.5) return nothing;
  float place = (seenGap.x / seenGap.y - float(${RANGE.low})) / float(${RANGE.high - RANGE.low});
  return texture2D(scale, vec2(clamp(place, 0.0, 1.0), 0.5)).rgb;
}
`;

function scaleTexture() {
  const texture = new DataTexture(new Uint8Array(4 * RANGE.steps).fill(217), RANGE.steps, 1);
  texture.colorSpace = SRGBColorSpace;
  texture.needsUpdate = true;
  return texture;
}

/** Gives a mesh other vertices, by their attributes, and faces. */
export function setGeometry(mesh, attributes, faces) {
  mesh.geometry.dispose();
  mesh.geometry = new BufferGeometry().setIndex(faces);
  Object.entries(attributes).forEach(([name, attribute]) => mesh.geometry.setAttribute(name, attribute));
  mesh.geometry.computeVertexNormals();
}

export class GapSurface {
  constructor(surface) {
    this.surface = surface;
    this.uniforms = { scale: { value: scaleTexture() }, nothing: { value: new Color(0xd9d9d9) }, unlit: { value: false } };
    this.material = new MeshLambertMaterial({ side: DoubleSide, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 });
    this.material.onBeforeCompile = (shader) => {
      Object.assign(shader.uniforms, this.uniforms);
      shader.vertexShader = VERTEX + shader.vertexShader.replace("#include <begin_vertex>",
        "#include <begin_vertex>\nseenGap = gap;");
      shader.fragmentShader = FRAGMENT + shader.fragmentShader.replace("#include <color_fragment>",
        "#include <color_fragment>\ndiffuseColor.rgb = gapColour();")
        .replace("#include <opaque_fragment>", "if (unlit) outgoingLight = diffuseColor.rgb;\n#include <opaque_fragment>");
    };
    this.mesh = new Mesh(new BufferGeometry(), this.material);
    this.mesh.matrixAutoUpdate = false;
    this.mesh.renderOrder = surface === "ball" ? 1 : 2;
  }

  /** positions: x, y, z of each vertex, mm; faces: three corners each; near: those faces that belong to the joint. */
  setMesh(positions, faces, near) {
    this.faces = new BufferAttribute(faces, 1);
    this.near = new BufferAttribute(near, 1);
    const gap = new BufferAttribute(new Float32Array((positions.length / 3) * 2), 2);
    setGeometry(this.mesh, { position: new BufferAttribute(positions, 3), gap }, this.faces);
  }

  showWhole(whole) {
    if (this.faces) this.mesh.geometry.setIndex(whole ? this.faces : this.near);
  }

  setGaps(gaps) {
    const attribute = this.mesh.geometry.getAttribute("gap");
    for (let k = 0; k < gaps.length; k += 1) {
      const met = !Number.isNaN(gaps[k]);
      attribute.array[2 * k] = met ? gaps[k] : 0;
      attribute.array[2 * k + 1] = met ? 1 : 0;
    }
    attribute.needsUpdate = true;
  }

  setColours(scale, levels, none) {
    this.uniforms.scale.value.image.data.set(colourTable(scale, this.surface, levels));
    this.uniforms.scale.value.needsUpdate = true;
    this.uniforms.nothing.value.setStyle(css(none));
  }

  /** drawing: filled, lines or blended (thesis, Figure 44). */
  setDrawing(drawing) {
    const blended = drawing === "blended";
    this.material.wireframe = drawing === "lines";
    this.uniforms.unlit.value = drawing === "lines"; // a line has no side that faces a lamp
    this.material.transparent = blended;
    this.material.opacity = blended ? (this.surface === "ball" ? 0.85 : 0.45) : 1;
    this.material.depthWrite = !blended || this.surface === "ball";
    this.material.needsUpdate = true;
  }
}
