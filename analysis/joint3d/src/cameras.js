// SPDX-License-Identifier: GPL-3.0-or-later
// Where a camera stands for each view of the joint. Joint frame: x the patient's right, y anterior, z superior.
import { Vector3 } from "three";

/** Unit vector from the joint to the camera. side: "left" or "right". */
export function towardsCamera(view, side) {
  const lateral = side === "left" ? -1 : 1;
  const ways = {
    anterior: [0, 1, 0],
    posterior: [0, -1, 0],
    medial: [-lateral, 0, 0],
    lateral: [lateral, 0, 0],
    superior: [0, -1e-4, 1], // the patient's front is up
    inferior: [0, 1e-4, -1],
    free: [-0.62 * lateral, 0.98, 0.22],
  };
  return new Vector3(...ways[view]).normalize();
}

/** The ball about the joint that a picture shows: { centre, radius }, of the vertices within `reach` mm of the centre. */
export function extent(meshes, reach) {
  const low = new Vector3(Infinity, Infinity, Infinity);
  const high = low.clone().negate();
  const x = new Vector3();
  meshes.forEach((mesh) => {
    const positions = mesh.geometry.getAttribute("position");
    for (let k = 0; k < positions.count; k += 1) {
      x.fromBufferAttribute(positions, k);
      if (x.lengthSq() > reach * reach) continue;
      x.applyMatrix4(mesh.matrixWorld);
      low.min(x);
      high.max(x);
    }
  });
  if (low.x > high.x) return { centre: new Vector3(), radius: reach };
  return { centre: low.clone().add(high).multiplyScalar(0.5), radius: low.distanceTo(high) / 2 };
}
