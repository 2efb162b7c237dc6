// SPDX-License-Identifier: GPL-3.0-or-later
// joint3d_bones.cjs PAGE: gives Joint3D meshes by dialog and by drop, and holds its numbers against those of `impinge`.
// Environment: IMPINGE, the program; IMPINGE_BONES, where it is set, a folder of real joints.
"use strict";
const { execFileSync } = require("node:child_process");
const fs = require("node:fs");
const path = require("node:path");
const { FOLDER, assert, choose, madePair, message, open, posed, run, smallest, text, type } = require("./joint3d_browser.cjs");

const SIZE = [1000, 640];

const TABLES = "#scheme=rsid&precision=0.5&storage=double"; // those of `impinge`

/** What `impinge` says of the joint in flexion, of such tables. */
function programSays({ ball, socket, side, axes }) {
  return JSON.parse(execFileSync(process.env.IMPINGE, ["gaps", ball, socket, "--side", side, "--axes", axes, "--pose", "flexion=90",
    "--scheme", "rsid", "--precision", "0.5", "--outputs", "gaps", "--json"], { stdio: "pipe", maxBuffer: 1 << 26 }));
}

/** Files into the page by dropping them on the page. */
async function drop(page, files) {
  const contents = files.map((file) => [path.basename(file), fs.readFileSync(file).toString("base64")]);
  await page.evaluate((named) => {
    const dataTransfer = new DataTransfer();
    named.forEach(([name, base64]) => dataTransfer.items.add(new File([Uint8Array.from(atob(base64), (c) => c.charCodeAt(0))], name)));
    ["dragover", "drop"].forEach((kind) => document.body.dispatchEvent(new DragEvent(kind, { dataTransfer, bubbles: true, cancelable: true })));
  }, contents);
}

async function holdAgainstProgram(page, joint) {
  await type(page, "flexion", 90);
  const { joint: { centre: { position } }, answer: { smallest_gap: found } } = programSays(joint);
  const gap = found.gap_mm;
  assert.ok(Math.abs(await smallest(page) - gap) <= 0.005 + 1e-6, `${joint.ball}: ${await smallest(page)} in the page, ${gap} by the program`);
  assert.match(await text(page, "smallest-where"), new RegExp(found.surface));
  if (found.clock) assert.ok((await text(page, "smallest-where")).includes(found.clock), found.clock);
  const centre = (await text(page, "centre-say")).match(/-?[\d.]+(?=[, ])/g).slice(0, 3).map(Number);
  position.forEach((value, k) => assert.ok(Math.abs(value - centre[k]) < 0.006, `centre ${centre}, by the program ${position}`));
}

async function ownMeshes(browser) {
  const { page, faults, close } = await open(browser, SIZE, { fragment: TABLES });
  const pair = { ...madePair("cam"), side: "right", axes: "RAS" };
  await choose(page, pair);
  assert.match(await text(page, "joint-name"), /ball.ply and socket.ply, right/);
  await holdAgainstProgram(page, pair);
  await page.click("#frame > summary");
  await page.check("#centre-typed");
  await page.fill("#centre", "0, 0, 0.5");
  await posed(page, () => page.click("#use-files"));
  assert.match(await text(page, "centre-say"), /Centre at 0.00, 0.00, 0.50 mm/);
  await page.uncheck("#centre-typed");
  await posed(page, () => drop(page, [pair.socket, pair.ball]));
  assert.match(await text(page, "centre-say"), /fitted/);
  assert.deepEqual(faults, []);
  await close();
}

const TETRAHEDRON = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]];
const BAD = [
  ["text.ply", "this is no mesh"],
  ["cut.ply", "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\n"],
  ["empty.obj", "# nothing\n"],
  ["points.obj", `${TETRAHEDRON.map((x) => `v ${x.join(" ")}`).join("\n")}\n`],
  ["nan.obj", "v 0 0 nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"],
  ["short.stl", "solid"],
  ["picture.png", "no mesh either"],
  ["flat.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"],
];

async function badFiles(browser) {
  const { page, faults, close } = await open(browser, SIZE);
  const pair = madePair("cam");
  const before = [await text(page, "joint-name"), await smallest(page)];
  for (const [name, content] of BAD) {
    const file = path.join(FOLDER, name);
    fs.writeFileSync(file, content);
    await page.setInputFiles("#file-ball", file);
    await page.setInputFiles("#file-socket", pair.socket);
    await page.click("#use-files");
    const words = await message(page);
    assert.ok(words.length > 20 && /[;:]/.test(words), `${name}: ${words}`);
    console.log(`  ${words}`);
    assert.deepEqual([await text(page, "joint-name"), await smallest(page)], before, name);
    await page.click("#message-close");
  }
  await drop(page, [pair.ball, pair.ball]);
  assert.match(await message(page), /^ball.ply: is the mesh of the ball and of the socket; check ball and socket$/);
  assert.deepEqual([await text(page, "joint-name"), await smallest(page)], before, "one mesh for both");
  await page.click("#message-close");
  await drop(page, [pair.ball, pair.ball, pair.socket]);
  assert.match(await message(page), /3 files were dropped/);
  await page.click("#message-close");
  await page.setInputFiles("#file-ball", pair.ball);
  await page.setInputFiles("#file-socket", pair.socket);
  await page.click("#frame > summary");
  await page.check("#centre-typed");
  await page.fill("#centre", "1, 2");
  await page.click("#use-files");
  assert.match(await message(page), /three numbers/);
  await page.uncheck("#centre-typed");
  await posed(page, () => page.click("#use-files"));
  assert.match(await text(page, "joint-name"), /ball.ply/, "it takes no good files after bad ones");
  assert.deepEqual(faults, []);
  await close();
}

async function realJoints(browser) {
  const bones = process.env.IMPINGE_BONES;
  const { page, faults, close } = await open(browser, SIZE, { fragment: TABLES });
  await page.click("#frame > summary");
  for (const name of ["cargen_left", "libhip_m4_left", "vsd_z013_right"]) {
    const folder = path.join(bones, name);
    const { side, axes } = JSON.parse(fs.readFileSync(path.join(folder, "subject.json")));
    const joint = { ball: path.join(folder, "femoral_head.ply"), socket: path.join(folder, "acetabulum_facing.ply"), side,
      axes: /left/.test(axes.split(",")[0]) ? "LPS" : "RAS" };
    await posed(page, () => page.click("#reset-pose"));
    await page.selectOption("#file-side", side);
    await page.fill("#axes", joint.axes);
    await posed(page, () => drop(page, [joint.ball, joint.socket]));
    assert.match(await text(page, "joint-name"), /femoral_head.ply and acetabulum_facing.ply/);
    await holdAgainstProgram(page, joint);
  }
  assert.deepEqual(faults, []);
  await close();
}

const tests = [ownMeshes, badFiles];
if (process.env.IMPINGE_BONES) tests.push(realJoints);
else console.log("realJoints is left out: IMPINGE_BONES names no folder of real joints");
run(tests);
