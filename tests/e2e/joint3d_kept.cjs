// SPDX-License-Identifier: GPL-3.0-or-later
// joint3d_kept.cjs PAGE: what a reader did in Joint3D is not lost, and what is wrong with own meshes is told and mended.
// Environment: IMPINGE, the program.
"use strict";
const fs = require("node:fs");
const path = require("node:path");
const { address, faultsOf } = require("./watched_page.cjs");
const { FOLDER, assert, choose, madePair, message, open, posed, run, settled, smallest, text, type, value } = require("./joint3d_browser.cjs");

const SIZE = [1000, 640];
const joint = (page) => text(page, "joint-name");

/** How many tabs' meshes this browser keeps. */
const keys = (page) => page.evaluate(() => new Promise((done) => {
  const opening = indexedDB.open("joint3d", 1);
  opening.onupgradeneeded = () => opening.transaction.abort();
  opening.onerror = () => done(0);
  opening.onsuccess = () => { opening.result.transaction("meshes").objectStore("meshes").getAllKeys().onsuccess = ({ target }) => { opening.result.close(); done(target.result.length); }; };
}));

/** Waits until the address says so: it follows the page twice a second, and a reload takes it as it is then. */
const written = (page, ...words) => page.waitForFunction((all) => all.every((each) => location.hash.includes(each)), words);

/** Waits until the page's meshes are kept; another page's are not, in a browser of its own. */
async function kept(page) {
  for (let k = 0; k < 200 && await keys(page) === 0; k += 1) await page.waitForTimeout(50);
  assert.equal(await keys(page), 1, "the meshes are not kept");
}

/** The pair as OBJ files, each corner as of change(x, y, z, part). */
function pair(name, change = (x, y, z) => [x, y, z], said = {}) {
  const made = madePair("normal");
  const files = {};
  for (const part of ["ball", "socket"]) {
    const [head, body] = fs.readFileSync(made[part], "latin1").split("end_header\n");
    const bytes = Buffer.from(body, "latin1");
    const [vertices, faces] = ["vertex", "face"].map((what) => Number(head.match(new RegExp(`element ${what} (\\d+)`))[1]));
    const double = /property double x/.test(head);
    assert.ok(/binary_little_endian/.test(head) && head.match(/property/g).length === 4, head);
    const size = double ? 8 : 4;
    const at = (k) => (double ? bytes.readDoubleLE(k * size) : bytes.readFloatLE(k * size));
    const lines = Array.from({ length: vertices }, (_, k) => `v ${change(at(3 * k), at(3 * k + 1), at(3 * k + 2), part).join(" ")}`);
    for (let k = 0, place = 3 * size * vertices; k < faces; k += 1, place += 13)
      lines.push(`f ${[1, 5, 9].map((offset) => bytes.readUInt32LE(place + offset) + 1).join(" ")}`);
    files[part] = path.join(FOLDER, `${name}-${part}.obj`);
    fs.writeFileSync(files[part], `${said[part] ? `# ${said[part]}\n` : ""}${lines.join("\n")}\n`);
  }
  return files;
}

/** Before the library answers there is a line, and nothing can be pressed that would fail. */
async function firstSecond(browser) {
  const page = await browser.newPage();
  const faults = await faultsOf(page);
  await page.goto(address(), { waitUntil: "commit" });
  await page.waitForSelector("#right", { state: "attached" });
  const first = await page.evaluate(() => ({ poses: document.body.dataset.poses ?? null, inert: ["left", "right"].every((id) => document.getElementById(id).inert),
    line: getComputedStyle(document.getElementById("stage"), "::after").content, opacity: getComputedStyle(document.getElementById("stage"), "::after").animationDelay }));
  assert.deepEqual({ ...first, line: "" }, { poses: null, inert: true, line: "", opacity: "0s" });
  assert.match(first.line, /library is starting/);
  await page.click("#play", { timeout: 300, force: true }).catch(() => {});
  await settled(page);
  assert.equal(await page.evaluate(() => document.querySelectorAll("[inert]").length), 0);
  assert.notEqual(await page.getAttribute("#stage", "aria-busy"), "true");
  await page.waitForTimeout(500);
  assert.deepEqual(faults, []);
  await page.close();
}

/** A page whose worker breaks the policy must fail these tests: that they see it is tested, too. */
async function faultsAreSeen(browser) {
  const broken = path.join(FOLDER, "broken.html");
  fs.writeFileSync(broken, fs.readFileSync(path.resolve(process.argv[2]), "utf8").replace("self.fetch = undefined;", ""));
  const page = await browser.newPage();
  const faults = await faultsOf(page);
  await page.goto(`file://${broken}`);
  await settled(page);
  assert.ok(faults.some((fault) => /Content Security Policy/.test(fault)), faults.join("\n"));
  await page.close();
}

async function reload(browser) {
  const { page, faults, close } = await open(browser, SIZE);
  await posed(page, () => page.selectOption("#preset", "cam"));
  await posed(page, () => page.fill("#value-parameter-cam_height", "3"));
  await type(page, "flexion", 77);
  await page.focus("#view");
  for (let k = 0; k < 4; k += 1) await page.keyboard.press("ArrowLeft");
  await posed(page, () => page.click('#drawings [value="blended"]'));
  const seen = () => Promise.all([joint(page), smallest(page), value(page, "value-flexion"), value(page, "value-parameter-cam_height"),
    page.getAttribute('#drawings [aria-pressed="true"]', "value"), page.textContent("#compass")]);
  const camera = () => page.evaluate(() => new URLSearchParams(location.hash.slice(1)).get("camera"));
  const before = await seen();
  await page.waitForTimeout(1200); // the address follows twice a second
  const stood = await camera();
  assert.match(stood, /^(-?[\d.]+,){5}-?[\d.]+$/);
  await page.reload();
  await settled(page);
  assert.deepEqual(await seen(), before);
  assert.equal(await camera(), stood, "the camera stands elsewhere");
  await page.focus(".skip");
  await page.keyboard.press("Enter");
  await page.waitForTimeout(300);
  assert.deepEqual(await seen(), before, "the skip link changes the session");
  assert.equal(await page.evaluate(() => document.activeElement.closest("details").id), "motion");
  const fragment = await page.evaluate(() => location.hash);
  await posed(page, () => page.selectOption("#preset", "normal"));
  await page.evaluate((hash) => { location.hash = hash; }, fragment); // a link in the page that is open
  await page.waitForFunction((name) => document.getElementById("joint-name").textContent === name, before[0]);
  await page.waitForTimeout(1200);
  assert.equal(await camera(), stood, "a link loses its camera");
  assert.deepEqual(faults, []);
  await close();
}

async function ownMeshes(browser) {
  const { page, faults, close } = await open(browser, SIZE);
  await choose(page, pair("good"));
  await type(page, "flexion", 60);
  const before = [await joint(page), await smallest(page)];
  assert.match(before[0], /good-ball.obj and good-socket.obj, right/);
  assert.match(await page.locator("#preset option:checked").textContent(), /Your own: good-ball/);
  assert.ok(await page.isHidden("#generated"), "parameters of a hip that is not shown");
  await kept(page);
  await written(page, "joint=own", "flexion=60");
  await page.reload();
  await settled(page);
  assert.deepEqual([await joint(page), await smallest(page)], before, "a reload loses them");
  await posed(page, () => page.selectOption("#preset", "cam"));
  assert.match(await joint(page), /Cam/);
  await posed(page, () => page.fill("#value-parameter-cam_height", "1"));
  await written(page, "joint=cam");
  await page.reload();
  await settled(page);
  await posed(page, () => page.selectOption("#preset", "own"));
  assert.deepEqual([await joint(page), await smallest(page)], before, "a hip of parameters discards them");
  await written(page, "joint=own");
  const fragment = await page.evaluate(() => location.hash);
  const other = await open(browser, SIZE, { fragment }); // another browser: nothing is kept there
  assert.match(await message(other.page), /not here/);
  assert.match(await joint(other.page), /Patient A/);
  await other.close();
  assert.deepEqual(faults, []);
  await close();
}

/** Gone with the tab: the next page of the same browser deletes it. */
async function closedTabs(browser) {
  const context = await browser.newContext();
  const first = await context.newPage();
  await first.goto(address());
  await settled(first);
  await choose(first, pair("good"));
  await kept(first);
  await first.close();
  const second = await context.newPage();
  await second.goto(`${address()}#joint=own`);
  await settled(second);
  assert.equal(await keys(second), 0);
  assert.match(await message(second), /not here/);
  await context.close();
}

async function mended(browser) {
  const { page, faults, close } = await open(browser, SIZE);
  await choose(page, pair("good"));
  const right = await smallest(page);
  assert.ok(await page.isHidden("#message"), "a banner about a sound joint");
  assert.match(await text(page, "files-say"), /^Taken, with/);
  await choose(page, pair("metres", (x, y, z) => [x / 1000, y / 1000, z / 1000]));
  assert.match(await message(page), /^This cannot be right: .*lengths are read as mm/);
  await posed(page, () => page.click('#message-actions button:has-text("Lengths are in m")'));
  assert.ok(await page.isHidden("#message") && Math.abs(await smallest(page) - right) < 0.02, `${await smallest(page)}, not ${right}`);
  await page.selectOption("#unit", "mm");
  await choose(page, pair("dicom", (x, y, z) => [-x, -y, z]));
  assert.match(await message(page), /^This cannot be right: .*which no right socket does/);
  await posed(page, () => page.click('#message-actions button:has-text("Its axes are LPS")'));
  assert.ok(await page.isHidden("#message") && Math.abs(await smallest(page) - right) < 0.02);
  assert.ok(await page.isVisible("#axes"), "axes that were changed are hidden");
  await page.fill("#axes", "als"); // any code, in any case
  await choose(page, pair("turned", (x, y, z) => [y, -x, z]));
  assert.ok(await page.isHidden("#message"), await text(page, "message-text"));
  assert.ok(Math.abs(await smallest(page) - right) < 0.02);
  await page.fill("#axes", "RAX");
  await page.click("#use-files");
  assert.match(await message(page), /axis code 'RAX' has an unknown letter/);
  await page.fill("#axes", "RAS");
  await choose(page, pair("far", (x, y, z, part) => [part === "socket" ? x - 60 : x, y, z]));
  assert.match(await message(page), /^This cannot be right: .*nowhere nearer to the ball than \d+ mm as scanned/);
  assert.deepEqual(faults, []);
  await close();
}

/** Limits, volume and measures, each as the page says it: numbers, and the words without them. */
async function answers(page) {
  const ids = ["limits-rows", "volume-say", "measures-rows"];
  await page.waitForFunction(() => !document.getElementById("save-limits").disabled && /%/.test(document.getElementById("volume-say").textContent)
    && /CCD/.test(document.getElementById("measures-rows").textContent));
  const said = (await Promise.all(ids.map((id) => text(page, id)))).join(" | ");
  return { words: said.replace(/[\d.]+/g, "#"), numbers: said.match(/\d+(\.\d+)?/g).map(Number) };
}

/** Files by 3D Slicer say their axes, over a reload too, and go to limits, volume and measures with nothing asked; axes that contradict them are refused. */
async function slicer(browser) {
  const { page, faults, close } = await open(browser, SIZE);
  await choose(page, pair("good"));
  await page.click("#volume > summary");
  const right = await smallest(page);
  const truth = await answers(page);
  assert.ok(truth.numbers.length > 60, truth.words);
  const head = { ball: "3D Slicer output. SPACE=LPS", socket: "SPACE=LPS" };
  await choose(page, pair("slicer", (x, y, z) => [-x, -y, z], head));
  assert.ok(await page.isHidden("#message"), await text(page, "message-text"));
  assert.match(await text(page, "files-say"), /^Taken, axes LPS as the headers say, with/);
  assert.ok(Math.abs(await smallest(page) - right) < 0.02);
  const found = await answers(page);
  assert.equal(found.words, truth.words);
  found.numbers.forEach((number, k) => assert.ok(Math.abs(number - truth.numbers[k]) < 0.11, `${number}, ${truth.numbers[k]} of the same joint`));
  await kept(page);
  await written(page, "joint=own");
  await page.reload();
  await settled(page);
  assert.match(await text(page, "files-say"), /axes LPS as the headers say/);
  await page.click("#frame > summary");
  await page.fill("#axes", "RAS");
  await page.click("#use-files");
  assert.match(await message(page), /slicer-ball.obj: its header says SPACE=LPS, and the field Axes says RAS; leave the field Axes out/);
  assert.deepEqual(faults, []);
  await close();
}

/** Panels stay as a reader has left them. */
async function folds(browser) {
  const { page, faults, close } = await open(browser, SIZE);
  const opened = () => page.evaluate(() => [...document.querySelectorAll("details.panel")].filter((panel) => panel.open).map((panel) => panel.id));
  const first = await opened();
  await page.click("#motion > summary");
  await page.click("#volume > summary");
  await page.waitForTimeout(200);
  await page.reload();
  await settled(page);
  assert.deepEqual((await opened()).sort(), [...first.filter((id) => id !== "motion"), "volume"].sort());
  await page.waitForFunction(() => document.querySelectorAll("#volume-plot rect").length > 0);
  assert.deepEqual(faults, []);
  await close();
}

run([firstSecond, faultsAreSeen, reload, ownMeshes, closedTabs, mended, slicer, folds]);
