// SPDX-License-Identifier: GPL-3.0-or-later
// What the tests of Joint3D share: its page in a browser, and what they do with it.
"use strict";
const assert = require("node:assert/strict");
const { execFileSync } = require("node:child_process");
const fs = require("node:fs");
const os = require("node:os");
const path = require("node:path");
const { PATIENCE, address, faultsOf, launch } = require("./watched_page.cjs");

/** A folder of this test, gone with it. */
const FOLDER = fs.mkdtempSync(path.join(os.tmpdir(), "impinge-joint3d-"));
process.on("exit", () => fs.rmSync(FOLDER, { recursive: true, force: true }));

/** Two files of a generated right hip of so few faces a surface that all answers about it are quick: { ball, socket }. */
function madePair(hip) {
  const folder = path.join(FOLDER, hip);
  if (!fs.existsSync(folder)) execFileSync(process.env.IMPINGE, ["hip", hip, "--set", "side=right", "--faces", "1500", "--out", folder], { stdio: "pipe" });
  return { ball: path.join(folder, "ball.ply"), socket: path.join(folder, "socket.ply") };
}

const settled = (page) => page.waitForFunction(() => document.body?.classList.contains("ready") && Number(document.body.dataset.poses) > 0);

/** A page at that size: { page, faults }. fragment: the state in its address; folded: panels that ask nothing, so that it takes less time. */
async function open(browser, [width, height], { fragment = "", folded = [] } = {}) {
  const context = await browser.newContext({ viewport: { width, height }, acceptDownloads: true });
  const page = await context.newPage();
  if (folded.length) await page.addInitScript((ids) => sessionStorage.setItem("joint3d-folds", JSON.stringify(Object.fromEntries(ids.map((id) => [id, false])))), folded);
  const faults = await faultsOf(page);
  await page.goto(address() + fragment);
  await settled(page);
  return { page, faults, close: () => context.close() };
}

/** Does something and waits until the poses that follow from it have been shown. */
async function posed(page, action) {
  const before = await page.evaluate(() => Number(document.body.dataset.poses));
  await action();
  await page.waitForFunction((count) => Number(document.body.dataset.poses) > count, before);
  await page.evaluate(async () => {
    let count;
    do {
      count = document.body.dataset.poses;
      await new Promise((done) => setTimeout(done, 60));
    } while (count !== document.body.dataset.poses || document.querySelector('#stage[aria-busy="true"]'));
  });
}

const value = (page, id) => page.inputValue(`#${id}`).then(Number);
const text = (page, id) => page.textContent(`#${id}`);
const message = (page) => page.waitForSelector("#message:not([hidden])").then(() => text(page, "message-text"));
const smallest = (page) => text(page, "smallest-gap").then((words) => Number(words.replace("−", "-")));

/** Types a number into the field of a value. */
const type = (page, key, number) => posed(page, () => page.fill(`#value-${key}`, String(number)));

/** Two files into the page, by dialog. */
async function choose(page, { ball, socket }) {
  await page.setInputFiles("#file-ball", ball);
  await page.setInputFiles("#file-socket", socket);
  await posed(page, () => page.click("#use-files"));
}

/** The picture, coarsely: [red, green, blue] of 160 by 100 places. It leaves the page as one word, which is much faster than numbers. */
async function picture(page) {
  const bytes = Buffer.from(await page.evaluate(async () => {
    await new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
    const canvas = document.createElement("canvas");
    [canvas.width, canvas.height] = [160, 100];
    const pen = canvas.getContext("2d");
    pen.drawImage(document.getElementById("view"), 0, 0, 160, 100);
    return Array.from(pen.getImageData(0, 0, 160, 100).data, (byte) => String.fromCharCode(byte)).join("");
  }), "latin1");
  return Array.from({ length: 16000 }, (_, k) => [...bytes.subarray(4 * k, 4 * k + 3)]);
}

/** The share of places at which two pictures differ. */
function difference(one, other) {
  const differs = (rgb, k) => rgb.some((colour, c) => Math.abs(colour - other[k][c]) > 24);
  return one.filter(differs).length / one.length;
}

/** Fails after a while: a page that never answers must not hold up the other tests. */
const overdue = () => new Promise((_, reject) => setTimeout(() => reject(new Error("takes too long")), 6 * PATIENCE).unref());

/** Runs the tests, each with the browser, and says which failed and why. Names after that of the page: these tests alone. */
async function run(tests) {
  const browser = await launch();
  let failed = 0;
  const [, , , ...names] = process.argv;
  const chosen = tests.filter(({ name }) => !names.length || names.includes(name));
  for (const test of chosen) {
    const began = Date.now();
    try {
      await Promise.race([test(browser), overdue()]);
    } catch (error) {
      failed += 1;
      process.exitCode = 1;
      console.log(`FAILED ${test.name}: ${error.stack}`);
    }
    console.log(`${test.name} ${((Date.now() - began) / 1000).toFixed(1)} s`);
  }
  await browser.close();
  console.log(`${chosen.length - failed} passed, ${failed} failed`);
}

module.exports = { FOLDER, assert, choose, difference, madePair, message, open, picture, posed, run, settled, smallest, text, type, value };
