// SPDX-License-Identifier: GPL-3.0-or-later
// Words in the picture: hours round the rim, and the cross of directions.
import { CanvasTexture, Sprite, SpriteMaterial, Vector3 } from "three";
import { drawn } from "./elements.js";

/** A word that keeps its size on the screen; height is a share of the picture's. */
export function wordSprite(word, colour, height) {
  const canvas = document.createElement("canvas");
  [canvas.width, canvas.height] = [256, 128];
  const pen = canvas.getContext("2d");
  pen.scale(2, 2);
  pen.font = "600 44px system-ui, sans-serif";
  pen.textAlign = "center";
  pen.textBaseline = "middle";
  pen.lineWidth = 10;
  pen.lineJoin = "round";
  pen.strokeStyle = "#fff";
  pen.strokeText(word, 64, 34);
  pen.fillStyle = colour;
  pen.fillText(word, 64, 34);
  const material = new SpriteMaterial({ map: new CanvasTexture(canvas), depthTest: false, sizeAttenuation: false });
  const sprite = new Sprite(material);
  sprite.scale.set(2 * height, height, 1);
  sprite.renderOrder = 10;
  return sprite;
}

const WAYS = [["R", 1, 0, 0], ["L", -1, 0, 0], ["A", 0, 1, 0], ["P", 0, -1, 0], ["S", 0, 0, 1], ["I", 0, 0, -1]];

/** Where the patient's right, front and top are, as the camera sees them, the farthest first: { name, x, y, shade, text } with the end of a line from 0, 0 and the place of its name. */
export function compassLines(camera) {
  return WAYS.map(([name, ...way]) => ({ name, at: new Vector3(...way).transformDirection(camera.matrixWorldInverse) }))
    .sort((a, b) => a.at.z - b.at.z)
    .map(({ name, at }) => ({ name, x: 26 * at.x, y: -26 * at.y, shade: at.z > -0.2 ? "near" : "far" }))
    .filter(({ x, y }) => Math.hypot(x, y) >= 9)
    .map((line) => ({ ...line, text: [line.x, line.y].map((end) => end * (1 + 9 / Math.hypot(line.x, line.y))) }));
}

/** Shows them in the SVG. */
export function drawCompass(svg, camera) {
  svg.replaceChildren(...compassLines(camera).flatMap(({ name, x, y, shade, text }) => [
    drawn("line", { x1: 0, y1: 0, x2: x, y2: y, class: shade }),
    drawn("text", { x: text[0], y: text[1], class: shade }, name)]));
}
