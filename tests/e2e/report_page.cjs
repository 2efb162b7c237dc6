// SPDX-License-Identifier: GPL-3.0-or-later
// report_page.cjs REPORT: uses the report in a real browser as a reader does. Prints what is wrong; exit code 1 if anything is.
"use strict";
const assert = require("node:assert/strict");
const path = require("node:path");
const { pathToFileURL } = require("node:url");
const { chromium } = require("../../analysis/node_modules/playwright-core");

const QUIET = ["--disable-background-networking", "--disable-component-update", "--disable-sync", "--disable-quic",
  "--no-first-run", "--no-sandbox", "--use-angle=swiftshader"];

async function watched(browser, width, height) {
  const page = await browser.newPage({ viewport: { width, height } });
  const faults = [];
  page.on("console", (message) => { if (message.type() === "error") faults.push(message.text()); });
  page.on("pageerror", (error) => faults.push(error.message));
  page.on("request", (request) => {
    if (!/^(file|data|blob):/.test(request.url())) faults.push(`asks for ${request.url()}`);
  });
  return { page, faults };
}

const shownRows = (page) => page.locator("#verdicts tbody tr:not([hidden])").count();

async function filters(page) {
  const all = await shownRows(page);
  assert.ok(all > 100, `${all} verdicts`);
  await page.selectOption("#filter-verdict", "differs");
  const differing = await shownRows(page);
  assert.ok(differing > 0 && differing < all, `${differing} of ${all} differ`);
  assert.equal(await page.locator('#verdicts tbody tr:not([hidden]):not([data-verdict="differs"])').count(), 0);
  await page.fill("#filter-text", "no such text anywhere");
  assert.equal(await shownRows(page), 0);
  assert.match(await page.textContent("#count"), /^0 of \d+ rows$/);
  await page.fill("#filter-text", "");
  await page.selectOption("#filter-verdict", "");
  assert.equal(await shownRows(page), all);
}

async function exploring(page) {
  const plot = page.locator("#explore-plot");
  await plot.scrollIntoViewIfNeeded();
  const shown = () => plot.evaluate((place) => place.data.filter((trace) => trace.visible !== "legendonly").length);
  const before = await shown();
  assert.ok(before > 10, `${before} methods`);
  await plot.locator(".legendtoggle").first().click();
  await page.waitForFunction(
    (count) => document.getElementById("explore-plot").data.filter((t) => t.visible !== "legendonly").length < count, before);
  const title = () => plot.evaluate((place) => place.layout.yaxis.title.text);
  const first = await title();
  await page.selectOption("#explore-cost", "bytes");
  assert.notEqual(await title(), first);
  assert.ok(await shown() < before, "a hidden method came back with another axis");
  const scenes = await page.locator("#explore-scene option").count();
  assert.ok(scenes > 1, `${scenes} scenes`);
  await page.selectOption("#explore-scene", { index: 1 });
  assert.ok(await shown() > 0);
}

async function main() {
  const browser = await chromium.launch({ executablePath: "/usr/bin/chromium", args: QUIET });
  try {
    for (const [width, height] of [[1440, 900], [390, 844]]) {
      const { page, faults } = await watched(browser, width, height);
      await page.goto(pathToFileURL(path.resolve(process.argv[2])).href);
      await filters(page);
      await exploring(page);
      const wide = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
      assert.ok(wide <= 0, `at ${width} pixels the page is ${wide} too wide`);
      assert.deepEqual(faults, [], `at ${width} pixels`);
      await page.close();
    }
  } finally {
    await browser.close();
  }
}

main().catch((error) => {
  console.log(error.message);
  process.exitCode = 1;
});
