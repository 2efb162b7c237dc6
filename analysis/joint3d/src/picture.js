// SPDX-License-Identifier: GPL-3.0-or-later
// A picture that says what it shows: the joint, and below it names, pose and gap, the legend and the directions of the body.
import { compassLines } from "./labels.js";

const [INK, SOFT] = ["#1b2530", "#566472"];
const [MARGIN, LINE, COLUMN] = [14, 20, 205]; // CSS pixels
const FONT = (size, weight = 400) => `${weight} ${size}px system-ui, sans-serif`;

/** The words of a line in as many lines as the width asks for. */
function wrapped(pen, text, width) {
  const lines = [""];
  text.split(" ").forEach((word) => {
    const longer = `${lines.at(-1)} ${word}`.trim();
    if (lines.at(-1) && pen.measureText(longer).width > width) lines.push(word);
    else lines[lines.length - 1] = longer;
  });
  return lines;
}

function drawLegend(pen, rows, top, columns) {
  const each = Math.ceil(rows.length / columns);
  rows.forEach(({ colours, text }, k) => {
    const [x, y] = [MARGIN + Math.floor(k / each) * COLUMN, top + (k % each) * LINE];
    const fill = pen.createLinearGradient(x, 0, x + 26, 0);
    colours.forEach((colour, c) => fill.addColorStop(colours.length > 1 ? c / (colours.length - 1) : 0, colour));
    pen.fillStyle = fill;
    pen.fillRect(x, y - 10, 26, 12);
    pen.fillStyle = INK;
    pen.fillText(text, x + 34, y);
  });
  return each * LINE;
}

function drawCompass(pen, camera, x, y) {
  pen.textAlign = "center";
  pen.textBaseline = "middle";
  pen.font = FONT(11, 600);
  compassLines(camera).forEach((line) => {
    pen.globalAlpha = line.shade === "far" ? 0.35 : 1;
    pen.strokeStyle = SOFT;
    pen.beginPath();
    pen.moveTo(x, y);
    pen.lineTo(x + line.x, y + line.y);
    pen.stroke();
    pen.fillStyle = INK;
    pen.fillText(line.name, x + line.text[0], y + line.text[1]);
  });
  pen.globalAlpha = 1;
}

/** A PNG: a promise of a Blob. view: the SceneView; title and lines: what is said; rows: of legendRows(). */
export function labelledPicture(view, title, lines, rows) {
  view.drawNow();
  const scale = view.canvas.width / view.canvas.clientWidth;
  const [width, height] = [view.canvas.clientWidth, view.canvas.clientHeight];
  const sheet = document.createElement("canvas");
  const pen = sheet.getContext("2d");
  pen.font = FONT(14);
  const text = lines.flatMap((line) => wrapped(pen, line, width - 2 * MARGIN));
  const columns = Math.max(Math.min(Math.floor((width - MARGIN) / COLUMN), rows.length), 1);
  const legend = Math.ceil(rows.length / columns) * LINE;
  sheet.width = view.canvas.width;
  sheet.height = Math.round((height + 3 * MARGIN + LINE * (text.length + 1) + legend) * scale);
  pen.scale(scale, scale);
  pen.fillStyle = "#fff";
  pen.fillRect(0, 0, width, sheet.height / scale);
  pen.drawImage(view.canvas, 0, 0, width, height);
  drawCompass(pen, view.eye.camera, width - 52, height - 52);
  pen.textAlign = "left";
  pen.textBaseline = "alphabetic";
  pen.fillStyle = INK;
  pen.font = FONT(15, 650);
  pen.fillText(title, MARGIN, height + MARGIN + 10, width - 2 * MARGIN);
  pen.font = FONT(14);
  text.forEach((line, k) => pen.fillText(line, MARGIN, height + MARGIN + 10 + LINE * (k + 1)));
  pen.font = FONT(13);
  drawLegend(pen, rows, height + 2 * MARGIN + 10 + LINE * (text.length + 1), columns);
  return new Promise((resolve) => sheet.toBlob(resolve, "image/png"));
}
