// SPDX-License-Identifier: GPL-3.0-or-later
// report_page.cjs REPORT: uses the report in a real browser as a reader does. Prints what is wrong; exit code 1 if anything is.
"use strict";
const assert = require("node:assert/strict");
const { address, faultsOf, launch } = require("./watched_page.cjs");

const shownRows = (page) => page.locator("#verdicts tr[data-verdict]:not([hidden])").count();

/** Follows a link to a part of the page, which must open it. */
async function follow(page, name) {
  await page.evaluate((id) => { location.hash = id; }, name);
  await page.waitForFunction((id) => document.getElementById(id).open, name);
}

/** The first screen has totals, main plot, stability and links; the whole page, as loaded, is short. */
async function firstScreen(page) {
  const screens = await page.evaluate(() => document.documentElement.scrollHeight / innerHeight);
  assert.ok(screens < 12, `the page has ${screens} screens`);
  assert.equal(await page.locator("main details[open]").count(), 0);
  for (const name of [".pdf", "joint3d.html", "README.md"]) assert.ok(await page.locator(`header a[href$="${name}"]`).count() > 0, name);
  const wide = await page.evaluate(() => innerWidth > 1000);
  for (const place of wide ? [".totals", ".first figure >> nth=0", ".first figure >> nth=1", '.first a[href="#claims"]'] : [".totals"]) {
    const box = await page.locator(place).boundingBox();
    assert.ok(box.y + box.height <= page.viewportSize().height + 20, `${place} ends at ${box.y + box.height}`);
  }
  const counted = await page.locator(".totals li").evaluateAll((tiles) => Object.fromEntries(
    tiles.map((tile) => [tile.querySelector(".verdict").textContent, Number(tile.querySelector("b").textContent)])));
  const listed = await page.locator("#differing tbody tr").count();
  assert.equal(listed, (counted.differs ?? 0) + (counted["thesis-misprint"] ?? 0), "the tiles say otherwise than the table");
}

async function opening(page) {
  await page.click("#open-all");
  assert.equal(await page.locator("main details:not([open])").count(), 0);
  await page.click("#open-all");
  assert.equal(await page.locator("main details[open]").count(), 0);
}

async function filters(page) {
  await follow(page, "verdicts-all");
  const all = await shownRows(page);
  assert.ok(all > 100, `${all} verdicts`);
  await page.selectOption("#filter-verdict", "differs");
  const differing = await shownRows(page);
  assert.ok(differing > 0 && differing < all, `${differing} of ${all} differ`);
  assert.equal(await page.locator('#verdicts tr[data-verdict]:not([hidden]):not([data-verdict="differs"])').count(), 0);
  await page.fill("#filter-text", "no such text anywhere");
  assert.equal(await shownRows(page), 0);
  assert.match(await page.textContent("#count"), /^0 of \d+ rows: no verdict is like that/);
  await page.fill("#filter-text", "");
  await page.selectOption("#filter-verdict", "");
  assert.equal(await shownRows(page), all);
}

async function exploring(page) {
  await follow(page, "explore");
  const plot = page.locator("#explore-plot");
  await plot.locator(".legendtoggle").first().waitFor();
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
  assert.ok(scenes > 0, "no scene");
  await page.selectOption("#explore-scene", { index: scenes - 1 }); // a real joint, if there is one
  await page.selectOption("#explore-storage", "float");
  assert.ok(await shown() > 0);
}

/** The picture of the joint, coarsely. */
const picture = (frame) => frame.evaluate(async () => {
  await new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
  const canvas = document.createElement("canvas");
  [canvas.width, canvas.height] = [80, 50];
  const pen = canvas.getContext("2d");
  pen.drawImage(document.getElementById("view"), 0, 0, 80, 50);
  return [...pen.getImageData(0, 0, 80, 50).data];
});

/** How many places of the picture an action changes much. */
async function changed(frame, action) {
  const before = await picture(frame);
  await action();
  const after = await picture(frame);
  return after.filter((value, k) => Math.abs(value - before[k]) > 30).length;
}

async function drawFinger(page, from, to) {
  const session = await page.context().newCDPSession(page);
  const touch = (type, ...points) =>
    session.send("Input.dispatchTouchEvent", { type, touchPoints: points.map(([x, y]) => ({ x, y })) });
  await touch("touchStart", from);
  for (let k = 1; k <= 5; k += 1) await touch("touchMove", from.map((start, i) => start + (k / 5) * (to[i] - start)));
  await touch("touchEnd");
}

const gap = (frame) => frame.textContent("#stage-gap");

async function turning(page) {
  await follow(page, "turn");
  const place = page.locator("#turn-place");
  await place.scrollIntoViewIfNeeded();
  assert.equal(await page.locator("#turn-place iframe").count(), 0, "Joint3D is awake before it is asked for");
  await page.click("#turn-start");
  const frame = await (await page.waitForSelector("#turn-place iframe")).contentFrame();
  const posed = (count) => frame.waitForFunction(
    (least) => document.body?.classList.contains("ready") && Number(document.body.dataset.poses) > least, count);
  await posed(0);
  assert.match(await frame.textContent("#legend"), /mm/);
  assert.ok(!await frame.isVisible("#motion") && await frame.isVisible("#view"), "the frame shows more than the joint");
  const box = await place.boundingBox();
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  const byMouse = await changed(frame, async () => {
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x + 90, y + 20, { steps: 5 });
    await page.mouse.up();
  });
  assert.ok(byMouse > 100, `the mouse changes ${byMouse} places`);
  const byTouch = await changed(frame, () => drawFinger(page, [x, y], [x - 70, y + 30]));
  assert.ok(byTouch > 100, `a finger changes ${byTouch} places`);
  const byKeys = await changed(frame, async () => {
    await frame.focus("#view");
    for (let k = 0; k < 5; k += 1) await page.keyboard.press("ArrowRight");
  });
  assert.ok(byKeys > 100, `the arrow keys change ${byKeys} places`);
  const before = await gap(frame);
  const poses = await frame.evaluate(() => Number(document.body.dataset.poses));
  await page.selectOption("#turn-joint", { index: 1 });
  await posed(poses);
  await frame.waitForFunction((text) => document.getElementById("stage-gap").textContent !== text, before);
  await page.check("#turn-panels");
  await frame.waitForFunction(() => document.body && !document.body.classList.contains("embedded"));
  await page.emulateMedia({ media: "print" });
  assert.ok(await page.isVisible("#turn-place img") && !await page.isVisible("#turn-place iframe"), "in print");
  await page.emulateMedia({ media: "screen" });
}

/** A link to the last figure opens what it is folded in and leads there; a click makes it larger. */
async function figures(page) {
  const figure = page.locator(".artefact figure img").last();
  const id = await figure.evaluate((picture) => picture.closest("details").id);
  await follow(page, id);
  await figure.evaluate((picture) => picture.decode());
  assert.ok(await page.locator(`[id="${id}"]`).evaluate((part) => Math.abs(part.getBoundingClientRect().top) < innerHeight), `#${id} leads elsewhere`);
  const width = () => figure.evaluate((picture) => picture.getBoundingClientRect().width);
  const before = await width();
  await figure.click();
  assert.ok(await width() > 1.2 * before, "a click makes no figure larger");
}

async function main() {
  const browser = await launch();
  try {
    for (const [width, height] of [[1300, 900], [390, 844]]) {
      const page = await browser.newPage({ viewport: { width, height } });
      const faults = await faultsOf(page);
      await page.goto(address());
      await firstScreen(page);
      await opening(page);
      await filters(page);
      await exploring(page);
      await turning(page);
      await figures(page);
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
