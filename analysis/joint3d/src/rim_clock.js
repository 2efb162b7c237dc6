// SPDX-License-Identifier: GPL-3.0-or-later
// The clock of the library (hip/clock.hpp), drawn round the rim: a line and the twelve hours.
import { BufferAttribute, BufferGeometry, Group, LineBasicMaterial, LineSegments } from "three";
import { wordSprite } from "./labels.js";

const INK = "#26323d";
const BEHIND = 6; // mm behind the middle of the hours: from there on they are faint

/** The index of the hour on the dial that is nearest to a whole one. */
function nearestHour(hours, hour) {
  const apart = (k) => Math.abs(((hours[k] - hour + 18) % 12) - 6);
  return [...hours.keys()].reduce((best, k) => (apart(k) < apart(best) ? k : best), 0);
}

/** The pieces of the rim within `reach` of the centre: that of a whole pelvis runs far from it. */
function pieces(rim, reach) {
  const places = Array.from({ length: rim.length / 3 }, (_, k) => [...rim.slice(3 * k, 3 * k + 3)]);
  const near = (x) => Math.hypot(...x) < reach;
  const ends = places.map((x, k) => [x, places[(k + 1) % places.length]]);
  return new Float32Array(ends.filter((pair) => pair.every(near)).flat(2));
}

export class RimClock {
  constructor() {
    this.lines = [[true, 1], [false, 0.2]].map(([depthTest, opacity]) => { // what is behind shows faintly
      const line = new LineSegments(new BufferGeometry(), new LineBasicMaterial({ color: INK, depthTest, transparent: true, opacity }));
      line.renderOrder = 9;
      return line;
    });
    this.hours = new Group();
    this.group = new Group();
    this.group.add(...this.lines, this.hours);
  }

  /** rim_clock and rim_hours of the library's reply to `joint`; reach: what belongs to the joint, mm from its centre. */
  set({ rim_clock: rim, rim_hours: hours }, reach) {
    this.hours.children.forEach(({ material }) => {
      material.map.dispose();
      material.dispose();
    });
    this.hours.clear();
    const line = new BufferGeometry().setAttribute("position", new BufferAttribute(pieces(rim, reach), 3));
    this.lines[0].geometry.dispose();
    this.lines.forEach((each) => { each.geometry = line; });
    for (let hour = 1; hour <= 12 && hours.length; hour += 1) {
      const sprite = wordSprite(String(hour), INK, 0.021);
      sprite.position.fromArray(rim, 3 * nearestHour(hours, hour)).multiplyScalar(1.06).clampLength(0, reach);
      this.hours.add(sprite);
    }
  }

  /** Makes hours on the far side of the rim faint. sight: where the camera looks, in the frame of the rim. */
  fade(sight) {
    const depths = this.hours.children.map((sprite) => sprite.position.dot(sight));
    const middle = depths.reduce((sum, depth) => sum + depth, 0) / depths.length;
    this.hours.children.forEach(({ material }, k) => { material.opacity = depths[k] > middle + BEHIND ? 0.3 : 1; });
  }
}
