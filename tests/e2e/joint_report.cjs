// SPDX-License-Identifier: GPL-3.0-or-later
// joint_report.cjs: `impinge report` of a generated hip in a real browser: on a phone, a desk and on paper. Environment: IMPINGE,
// the program; HIP, the folder of a right hip.
"use strict";
const assert = require("node:assert/strict");
const { execFileSync } = require("node:child_process");
const fs = require("node:fs");
const os = require("node:os");
const path = require("node:path");
const { pathToFileURL } = require("node:url");
const { faultsOf, launch } = require("./watched_page.cjs");

const FOLDER = fs.mkdtempSync(path.join(os.tmpdir(), "impinge-report-"));
process.on("exit", () => fs.rmSync(FOLDER, { recursive: true, force: true }));

function made() {
  const files = ["ball.ply", "socket.ply"].map((name) => path.join(process.env.HIP, name));
  execFileSync(process.env.IMPINGE, ["report", ...files, "--side", "right", "--width", "0.4", "--out", FOLDER], { stdio: "pipe" });
  return pathToFileURL(path.join(FOLDER, "report.html")).href;
}

async function open(browser, address, width) {
  const context = await browser.newContext({ viewport: { width, height: 900 } });
  const page = await context.newPage();
  const faults = await faultsOf(page);
  await page.goto(address);
  await page.waitForSelector("body.drawn");
  return { page, faults, close: () => context.close() };
}

/** How many colours each picture of the bones has, of one in hundred places. */
const coloursOf = (page) => page.$$eval(".stills img", (images) => images.map((image) => {
  const canvas = document.createElement("canvas");
  [canvas.width, canvas.height] = [72, 54];
  const pen = canvas.getContext("2d");
  pen.drawImage(image, 0, 0, 72, 54);
  const data = new Uint32Array(pen.getImageData(0, 0, 72, 54).data.buffer);
  return new Set(data).size;
}));

async function fits(browser, address, width) {
  const { page, faults, close } = await open(browser, address, width);
  const wide = await page.evaluate(() => document.documentElement.scrollWidth);
  assert.ok(wide <= width, `${wide} px at ${width}`);
  for (const colours of await coloursOf(page)) assert.ok(colours > 100, `a picture of ${colours} colours`);
  const smallest = await page.$$eval("section > svg text", (texts) => Math.min(...texts.map((text) => text.getBoundingClientRect().height)));
  assert.ok(smallest > 8, `letters of ${smallest} px`);
  const turned = await page.evaluate(() => document.getElementById("view").toDataURL());
  await page.click('#controls button[value="lateral"]');
  await page.waitForFunction((before) => document.getElementById("view").toDataURL() !== before, turned);
  assert.deepEqual(faults, []);
  await close();
}

async function prints(browser, address) {
  const { page, close } = await open(browser, address, 1000);
  const pdf = (await page.pdf({ preferCSSPageSize: true, printBackground: true })).toString("latin1");
  const pages = pdf.match(/\/Type\s*\/Page\b/g).length;
  assert.ok(pages <= 4, `${pages} pages`);
  await close();
}

/** What the page says is what the document says. */
async function says(browser, address) {
  const { page, close } = await open(browser, address, 1600);
  const { answer, joint } = JSON.parse(fs.readFileSync(path.join(FOLDER, "summary.json")));
  const rows = await page.$$eval("#limits-table tbody tr", (all) => all.map((row) => row.textContent));
  const limits = answer.limits.limits.filter((limit) => limit.centre === "ball" && limit.threshold_mm === 0);
  assert.equal(rows.length, limits.length);
  limits.forEach((limit, k) => { if (limit.state === "limited") assert.ok(rows[k].includes(`${Math.floor(10 * limit.low_deg) / 10}`), rows[k]); });
  const glance = await page.textContent("#glance");
  assert.ok(glance.includes(`${answer.gaps.smallest_gap.gap_mm.toFixed(2)} mm`), glance);
  const warnings = await page.textContent("#warnings");
  joint.warnings.forEach((line) => assert.ok(warnings.includes(line.slice(-40)), line));
  assert.equal(await page.locator("#measures-table tbody tr").count(), answer.measures.measures.length);
  const measures = await page.textContent("#measures-table");
  answer.measures.measures.forEach((row) => assert.ok(measures.includes(row.published_source ?? ""), row.published_source));
  await close();
}

async function main() {
  const address = made();
  const browser = await launch();
  await fits(browser, address, 400);
  await fits(browser, address, 1600);
  await prints(browser, address);
  await says(browser, address);
  await browser.close();
}

main().catch((error) => { console.log(error.stack); process.exit(1); });
