// SPDX-License-Identifier: GPL-3.0-or-later
// A schematic hip bone about a generated socket, so that a reader sees which way is up. It is drawn, never scanned.
import {
  BufferGeometry, CatmullRomCurve3, DoubleSide, Float32BufferAttribute, Group, Mesh, MeshLambertMaterial, SphereGeometry, TubeGeometry, Vector3,
} from "three";

// In head radii, right side: x lateral, y anterior, z superior, about the centre of the head.
const CREST = [[-1.2, 2.1, 2.2], [-0.1, 2.3, 3.4], [0.2, 1.2, 4.5], [-0.2, -0.5, 5.0], [-1.2, -2.2, 4.4], [-1.9, -2.9, 3.2]];
const ROOT = [[-1.0, 1.1, 0.9], [-0.8, 0.9, 1.3], [-0.8, 0.4, 1.5], [-0.9, -0.2, 1.5], [-1.2, -0.9, 1.3], [-1.5, -1.5, 1.1]];
const PUBIS = [[-1.1, 0.8, -0.2], [-1.9, 1.3, -0.5], [-2.8, 1.6, -0.9], [-3.4, 1.5, -1.3], [-3.4, 1.2, -1.9]];
const ISCHIUM = [[-1.1, -0.9, -0.5], [-1.1, -1.4, -1.6], [-1.2, -1.2, -2.5], [-1.8, -0.4, -2.7], [-2.7, 0.5, -2.4], [-3.4, 1.2, -1.9]];
const BACK = [[-1.5, -1.5, 1.1], [-1.3, -1.5, 0.3], [-1.1, -0.9, -0.5]];

/** A sheet between two curves. */
function wing(root, crest) {
  const [across, along] = [14, 40];
  const positions = [];
  const faces = [];
  for (let j = 0; j <= across; j += 1) {
    for (let k = 0; k <= along; k += 1) {
      const x = root.getPoint(k / along).lerp(crest.getPoint(k / along), j / across);
      x.x -= 0.35 * Math.sin((Math.PI * j) / across); // the hollow of the wing
      positions.push(x.x, x.y, x.z);
      if (j < across && k < along) {
        const at = j * (along + 1) + k;
        faces.push(at, at + 1, at + along + 1, at + 1, at + along + 2, at + along + 1);
      }
    }
  }
  const geometry = new BufferGeometry().setAttribute("position", new Float32BufferAttribute(positions, 3)).setIndex(faces);
  geometry.computeVertexNormals();
  return geometry;
}

/** The bone for a head of that radius, mm; a left one is the mirror image. */
export function schematicPelvis(side, radius) {
  const curve = (points) => new CatmullRomCurve3(points.map((x) => new Vector3(...x)));
  const material = new MeshLambertMaterial({ color: "#d8d1c3", side: DoubleSide, transparent: true, opacity: 0.6 });
  const end = (point, thickness) => new SphereGeometry(thickness, 14, 10).translate(...point);
  const tube = (points, thickness) => [new TubeGeometry(curve(points), 48, thickness, 14), end(points[0], thickness), end(points.at(-1), thickness)];
  const shapes = [wing(curve(ROOT), curve(CREST)), ...tube(CREST, 0.16), ...tube(PUBIS, 0.27), ...tube(ISCHIUM, 0.29), ...tube(BACK, 0.27)];
  const bone = new Group();
  bone.add(...shapes.map((shape) => new Mesh(shape, material)));
  bone.scale.set(side === "left" ? -radius : radius, radius, radius);
  bone.children.forEach((mesh) => { mesh.renderOrder = 3; });
  return bone;
}
