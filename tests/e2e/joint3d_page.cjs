// SPDX-License-Identifier: GPL-3.0-or-later
// joint3d_page.cjs PAGE [TEST...]: uses Joint3D in a real browser, every control of it. Exit code 1 if anything is wrong.
"use strict";
const fs = require("node:fs");
const { assert, difference, open, picture, posed, run, smallest, text, type, value } = require("./joint3d_browser.cjs");

const DESKTOP = [1000, 640];
const pressed = (page, group) => page.getAttribute(`#${group} button[aria-pressed="true"]`, "value");
const message = (page) => page.waitForSelector("#message:not([hidden])").then(() => text(page, "message-text"));

/** Remembers which controls get events, to be asked at the end. */
const watchControls = (page) => page.evaluate(() => {
  window.used = new Set();
  const name = ({ id, value, parentElement }) => id || `${parentElement.id || parentElement.parentElement.id} ${value}`;
  window.controls = () => [...document.querySelectorAll("button, select, input")].map(name);
  ["click", "input", "change"].forEach((kind) => document.addEventListener(kind, ({ target }) => {
    if (target.matches("button, select, input")) window.used.add(name(target));
  }, true));
});

async function startsColoured(page) {
  const gap = await smallest(page);
  assert.ok(gap > 0 && gap < 6, `smallest gap ${gap}`);
  const before = await picture(page);
  const yellow = before.filter(([red, green, blue]) => red > 170 && green > 140 && blue < 130).length / before.length;
  assert.ok(yellow > 0.02, `${yellow} of the picture is yellow`);
  await page.focus("#slide-flexion");
  await posed(page, async () => { for (let k = 0; k < 15; k += 1) await page.keyboard.press("PageUp"); });
  assert.ok(await value(page, "value-flexion") > 50);
  assert.ok(difference(before, await picture(page)) > 0.05, "the slider moves nothing");
  assert.match(await text(page, "motion"), /extension/);
}

async function motions(page) {
  for (const [key, angle] of [["flexion", 90], ["abduction", -12.5], ["internal_rotation", 20]]) {
    await type(page, key, angle);
    assert.equal(await value(page, `slide-${key}`), angle);
    await page.focus(`#slide-${key}`);
    await posed(page, () => page.keyboard.press("ArrowRight"));
    assert.ok(Math.abs(await value(page, `value-${key}`) - angle - 0.1) < 1e-6);
  }
  const deep = await smallest(page);
  await posed(page, () => page.click("#reset-pose"));
  assert.equal(await value(page, "value-flexion"), 0);
  const free = await smallest(page);
  assert.ok(free > deep, `${free} in the pose of the scan, ${deep} in flexion, adduction and rotation`);
  await page.click("#motion details summary");
  for (const [key, shift] of [["right", -1], ["forward", 3], ["up", 0.5]]) {
    await type(page, `offset-${key}`, shift);
    await page.focus(`#slide-offset-${key}`);
    await posed(page, () => page.keyboard.press("ArrowLeft"));
  }
  assert.ok(await smallest(page) < free - 1, "a shift of 3 mm brings no surface nearer");
  await posed(page, () => page.click("#reset-pose"));
  assert.equal(await value(page, "value-offset-forward"), 0);
  assert.equal(await smallest(page), free);
}

async function recorded(page) {
  await page.selectOption("#play-motion", "patient_a flexion");
  await posed(page, async () => {
    await page.click("#play");
    await page.waitForFunction(() => Number(document.getElementById("value-flexion").value) > 3);
    assert.equal(await text(page, "play"), "Pause");
    await page.click("#play");
  });
  const stopped = await value(page, "value-flexion");
  await page.waitForTimeout(150);
  assert.equal(await value(page, "value-flexion"), stopped, "it moves on after Pause");
  await posed(page, () => page.fill("#play-at", "50"));
  assert.ok(Math.abs(await value(page, "value-flexion") - 103.1) < 0.06, "half way is the angle of Table 11");
  await page.selectOption("#play-motion", "patient_b all");
  await posed(page, () => page.fill("#play-at", "7"));
  assert.ok(await value(page, "value-abduction") > 20);
  await posed(page, () => page.click("#reset-pose"));
}

async function dragging(page) {
  const box = await page.locator("#view").boundingBox();
  const [x, y] = [box.x + 0.42 * box.width, box.y + 0.55 * box.height];
  const drag = async (right, down) => {
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x + right / 2, y + down / 2, { steps: 3 });
    await page.mouse.move(x + right, y + down, { steps: 3 });
    await page.mouse.up();
  };
  await page.click('#views [value="anterior"]');
  await page.click('#drags [value="femur"]');
  await posed(page, () => drag(-60, 0)); // a right femur, to the left of the picture: away from the midline
  assert.ok(await value(page, "value-abduction") > 3, `abduction ${await value(page, "value-abduction")}`);
  assert.equal(await pressed(page, "views"), "anterior", "the view turned, too");
  await page.click('#drags [value="view"]');
  const before = await picture(page);
  await drag(120, 30);
  assert.equal(await pressed(page, "views"), "free");
  assert.ok(difference(before, await picture(page)) > 0.005, "the view did not turn");
  await posed(page, () => page.click("#reset-pose"));
}

async function looks(page) {
  const pictures = [];
  for (const view of ["free", "anterior", "posterior", "medial", "lateral", "superior"]) {
    await page.click(`#views [value="${view}"]`);
    pictures.push(await picture(page));
    assert.equal(await pressed(page, "views"), view);
  }
  for (let k = 1; k < pictures.length; k += 1) assert.ok(difference(pictures[k - 1], pictures[k]) > 0.005, `view ${k}`);
  await page.click('#views [value="medial"]');
  for (const drawing of ["lines", "blended", "filled"]) {
    const before = await picture(page);
    await posed(page, () => page.click(`#drawings [value="${drawing}"]`));
    assert.ok(difference(before, await picture(page)) > 0.02, drawing);
  }
  for (const [part, least] of [["femur", 0.01], ["socket", 0.05], ["pelvis", 0.05], ["clock", 0.001], ["smallest gap", 0.0002]]) {
    const before = await picture(page);
    await posed(page, () => page.click(`#shown label:has-text("${part}")`));
    assert.ok(difference(before, await picture(page)) > least, `${part} changes nothing`);
    await posed(page, () => page.click(`#shown label:has-text("${part}")`));
    assert.ok(difference(before, await picture(page)) < 0.0002, `${part} does not come back`);
  }
  const before = await picture(page);
  await posed(page, () => page.selectOption("#colours", "safe"));
  assert.ok(difference(before, await picture(page)) > 0.05, "the other colours are the same");
  assert.match(await text(page, "legend-rows"), /0 to 4 mm/);
  await posed(page, () => page.selectOption("#colours", "levels"));
  await type(page, "cartilage", 6);
  assert.match(await text(page, "legend-rows"), /bones touch or overlap0 to 2 mm2 to 4 mm4 to 6 mmball, over 6 mmsocket, over 6 mmno surface/);
  await posed(page, () => page.fill("#slide-cartilage", "4"));
}

/** Those of the first tables, 0.35 degrees apart. */
async function samplePoints(page) {
  await page.click('#views [value="anterior"]');
  const bare = await picture(page);
  await page.click('#shown label:has-text("sample points")');
  await page.waitForFunction(() => /^All/.test(document.getElementById("points-say").textContent));
  assert.match(await text(page, "points-say"), /All 402,486 directions of each table: 402,486 meet the femur, 2\d\d,\d{3} the socket/);
  assert.ok(difference(bare, await picture(page)) > 0.05, "no sample points");
  await page.click('#shown label:has-text("sample points")');
  assert.ok(difference(bare, await picture(page)) < 0.0002, "they do not go");
}

async function hips(page) {
  const presets = await page.locator("#preset option").evaluateAll((options) => options.map((option) => option.value));
  for (const name of ["normal", "cam", "pincer", "mixed", "patient_a", "patient_b"]) assert.ok(presets.includes(name), name);
  await posed(page, () => page.selectOption("#preset", "patient_b"));
  assert.equal(await page.inputValue("#side"), "left");
  await posed(page, () => page.selectOption("#preset", "cam"));
  assert.match(await text(page, "joint-name"), /Cam, right/);
  await posed(page, () => page.selectOption("#side", "left"));
  assert.match(await text(page, "joint-name"), /Cam, left/);
  await type(page, "flexion", 100);
  const high = await smallest(page);
  await posed(page, () => page.fill("#value-parameter-cam_height", "1"));
  assert.ok(await smallest(page) > high, "a lower cam leaves no more room");
  await page.locator("#parameters details").evaluateAll((all) => all.forEach((details) => { details.open = true; }));
  const keys = await page.locator('#parameters input[type="range"]').evaluateAll((all) => all.map(({ id }) => id.slice(6)));
  assert.equal(keys.length, 30);
  for (const key of keys) { // to and fro: the last change is the one that counts
    const held = await page.inputValue(`#value-${key}`);
    await page.focus(`#slide-${key}`);
    await page.keyboard.press("ArrowRight");
    await page.fill(`#value-${key}`, held);
  }
  await posed(page, () => page.click("#reset-parameters"));
  assert.equal(await value(page, "value-parameter-cam_height"), 4.5);
  await posed(page, () => page.fill("#value-parameter-wall_thickness", "6"));
  await posed(page, () => page.selectOption("#preset", "patient_a"));
  await posed(page, () => page.click("#reset-pose"));
}

async function refusals(page) {
  const before = [await smallest(page), await text(page, "joint-name")];
  await page.fill("#value-parameter-head_radius", "60"); // larger than its neck is long
  assert.match(await message(page), /radius|neck|head/);
  assert.deepEqual([await smallest(page), await text(page, "joint-name")], before);
  await page.click("#message-close");
  assert.ok(await page.isHidden("#message"));
  await posed(page, () => page.click("#reset-parameters"));
}

async function tables(page) {
  const schemes = await page.locator("#scheme option").evaluateAll((options) => options.map((option) => option.value));
  assert.ok(schemes.length > 10, `${schemes.length} schemes`);
  const filled = () => page.textContent("#tables-rows tr:first-child .now");
  const change = async (action) => {
    const before = await page.textContent("#tables-rows");
    await posed(page, action);
    await page.waitForFunction((old) => document.getElementById("tables-rows").textContent !== old, before);
  };
  const gap = await smallest(page);
  await change(() => page.selectOption("#precision", "1"));
  for (const scheme of schemes.filter((name) => name !== "cube_gnomonic")) {
    await change(() => page.selectOption("#scheme", scheme));
    assert.ok(Math.abs(await smallest(page) - gap) < 0.2, `${scheme} has a gap of ${await smallest(page)}, not ${gap}`);
  }
  await change(() => page.selectOption("#scheme", "rsid"));
  assert.equal(await filled(), "65,160", "the thesis' Table 2");
  await change(() => page.selectOption("#storage", "double"));
  assert.match(await page.textContent("#tables-rows"), /× (3\.[5-9]|4)/);
  const bare = await picture(page);
  await page.click('#shown label:has-text("sample points")');
  await page.waitForFunction(() => /^All/.test(document.getElementById("points-say").textContent));
  assert.ok(difference(bare, await picture(page)) > 0.01, "no sample points");
  assert.match(await text(page, "points-say"), /All 65,160 directions of each table: 65,160 meet the femur/);
  await page.click('#shown label:has-text("sample points")');
  assert.ok(await page.isHidden("#points-say"));
  await change(() => page.selectOption("#scheme", "cube_gnomonic"));
  await page.waitForFunction(() => /µm|mm|none/.test(document.querySelector("#tables-rows tr:last-child .now").textContent));
  await page.waitForFunction(() => /^\d+$/.test(document.getElementById("undecided").textContent));
  await change(() => page.selectOption("#storage", "uint16"));
}

async function sweeps(page) {
  const limit = () => page.waitForFunction(() => !document.getElementById("sweep-plot").classList.contains("old"));
  await page.selectOption("#sweep-motion", "internal_rotation_at_90");
  await page.waitForTimeout(50);
  await limit();
  assert.match(await text(page, "sweep-say"), /Bones first touch between [\d.]+° and [\d.]+°, at \d+:\d\d o’clock: a certified limit/);
  assert.match(await text(page, "sweep-say"), /About the socket’s centre, bones .*Layers of cartilage, 4 mm in all,/);
  await posed(page, () => page.click("#sweep-go"));
  assert.equal(await value(page, "value-flexion"), 90);
  assert.ok(Math.abs(await smallest(page)) < 0.1, `a gap of ${await smallest(page)} at the limit`);
  assert.equal(await page.locator("#sweep-plot .now").count(), 1);
  const turned = await value(page, "value-internal_rotation");
  await posed(page, () => page.click("#sweep-plot", { position: { x: 80, y: 60 } }));
  assert.ok(await value(page, "value-internal_rotation") < turned);
  await page.click("#sweep-held");
  await page.selectOption("#sweep-motion", "flexion");
  await page.waitForTimeout(50);
  await limit();
  await page.click("#sweep-held");
  await page.waitForTimeout(50);
  await limit();
  await posed(page, () => page.click("#reset-pose"));
  await shifted(page, limit);
}

/** A shift that makes bones overlap is a limit at the start, and about the ball's own centre alone. */
async function shifted(page, limit) {
  await type(page, "offset-up", 6);
  assert.ok(await smallest(page) < 0, `a gap of ${await smallest(page)} with the ball 6 mm higher`);
  await page.waitForTimeout(50);
  await limit();
  assert.match(await text(page, "sweep-say"), /^Bones touch or overlap at the start of this motion/);
  assert.doesNotMatch(await text(page, "sweep-say"), /socket’s centre/);
  await page.waitForFunction(() => /mm$/.test(document.getElementById("smallest-proven").textContent));
  assert.equal(Number((await text(page, "smallest-proven")).match(/[−\d.]+/)[0].replace("−", "-")).toFixed(1), (await smallest(page)).toFixed(1));
  assert.match(await text(page, "bound-why"), /measured on the faces/);
  await posed(page, () => page.click("#reset-pose"));
  await page.waitForTimeout(50);
  await limit();
}

async function exporting(page) {
  await type(page, "flexion", 45);
  const saved = async (id) => {
    const [download] = await Promise.all([page.waitForEvent("download"), page.click(`#${id}`)]);
    return { name: download.suggestedFilename(), bytes: fs.readFileSync(await download.path()) };
  };
  const image = await saved("save-picture");
  assert.equal(image.bytes.subarray(1, 4).toString(), "PNG");
  assert.ok(image.bytes.length > 10000);
  const csv = (await saved("save-csv")).bytes.toString().trim().split("\n");
  assert.equal(csv[0], "surface,vertex,x,y,z,gap_mm");
  const gaps = csv.slice(1).map((line) => line.split(",")[5]).filter(Boolean).map(Number);
  assert.equal(Math.min(...gaps).toFixed(2), await text(page, "smallest-gap"));
  for (const part of ["ball", "socket"]) {
    const { name, bytes } = await saved(`save-${part}`);
    assert.equal(name, `${part}.ply`);
    assert.match(bytes.subarray(0, 400).toString("latin1"), /^ply[^]*gap/);
  }
  await page.click("#copy-link");
  return { fragment: new URL(await page.inputValue("#link")).hash, gap: await text(page, "smallest-gap") };
}

async function everyControl(browser) {
  const { page, faults, close } = await open(browser, DESKTOP);
  await watchControls(page);
  for (const part of [startsColoured, motions, recorded, dragging, looks, samplePoints, hips, refusals, tables, sweeps]) await part(page);
  const { fragment, gap } = await exporting(page);
  const files = /^(file-|axes|centre|use-files)/; // with meshes, in joint3d_bones.cjs
  const unused = await page.evaluate(() => window.controls().filter((name) => !window.used.has(name)));
  assert.deepEqual(unused.filter((name) => !files.test(name) && name !== "link"), [], "never used");
  assert.deepEqual(faults, []);
  await close();
  const second = await open(browser, DESKTOP, fragment);
  assert.equal(await value(second.page, "value-flexion"), 45);
  assert.equal(await text(second.page, "smallest-gap"), gap, "a link shows another state");
  await second.close();
}

async function keyboardAlone(browser) {
  const { page, faults, close } = await open(browser, DESKTOP);
  const reached = new Set();
  for (let k = 0; k < 140; k += 1) {
    await page.keyboard.press("Tab");
    const at = await page.evaluate(() => {
      const { id, value, tagName, className } = document.activeElement;
      const { outlineStyle, outlineWidth } = getComputedStyle(document.activeElement);
      return { name: tagName === "BODY" ? tagName : id || value || className || tagName, seen: outlineStyle !== "none" && parseFloat(outlineWidth) > 0 };
    });
    if (at.name === "BODY") break;
    assert.ok(at.seen, `one does not see that ${at.name} is focused`);
    reached.add(at.name);
    if (at.name === "view") await page.keyboard.press("ArrowLeft");
  }
  for (const id of ["skip", "view", "anterior", "blended", "femur", "slide-flexion", "play", "preset", "file-ball", "scheme", "save-picture"])
    assert.ok(reached.has(id), `Tab does not reach ${id}`);
  assert.deepEqual(await page.evaluate(() => [...document.querySelectorAll("button, select, input")]
    .filter((control) => !(control.labels?.length || control.ariaLabel || control.textContent.trim())).map(({ id }) => id)), [], "no label");
  assert.deepEqual(faults, []);
  await close();
}

async function everyWidth(browser) {
  for (const size of [[1440, 900], [1024, 768], [390, 844]]) {
    const { page, faults, close } = await open(browser, size);
    const wide = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
    assert.ok(wide <= 0, `at ${size} the page is ${wide} too wide`);
    const view = await page.locator("#view").boundingBox();
    assert.ok(view.width * view.height > 0.3 * size[0] * size[1] && view.height <= size[1], `the picture has ${JSON.stringify(view)}`);
    assert.match(await text(page, "joint-name"), /right/);
    assert.ok(await page.isVisible("header .notice"));
    assert.match(await page.textContent("header .notice"), /no medical device/);
    await page.locator("#copy-link").scrollIntoViewIfNeeded();
    assert.ok(await page.isVisible("#copy-link"));
    await page.click("#spread > summary");
    assert.ok(await page.isHidden("#histogram"), "a panel does not fold");
    assert.deepEqual(faults, []);
    await close();
  }
}

async function lostGraphics(browser) {
  const { page, faults, close } = await open(browser, DESKTOP);
  const before = await picture(page);
  await page.evaluate(() => {
    window.graphics = document.getElementById("view").getContext("webgl2").getExtension("WEBGL_lose_context");
    window.graphics.loseContext();
  });
  assert.match(await message(page), /graphics were lost/);
  await page.evaluate(() => window.graphics.restoreContext());
  await page.waitForSelector("#message", { state: "hidden" });
  assert.ok(difference(before, await picture(page)) < 0.01, "the picture is another");
  await type(page, "flexion", 60);
  assert.ok(difference(before, await picture(page)) > 0.05, "the picture stands still");
  assert.deepEqual(faults.filter((fault) => !/context/i.test(fault)), []);
  await close();
}

async function asksNobody(browser) {
  const { page, close } = await open(browser, DESKTOP);
  const refused = await page.evaluate(async () => {
    const rules = [];
    document.addEventListener("securitypolicyviolation", (event) => rules.push(event.effectiveDirective));
    await fetch("https://localhost/").catch(() => {});
    new Image().src = "https://localhost/image.png";
    setTimeout(() => { try { new Function("return 1")(); } catch { rules.push("eval"); } });
    await new Promise((done) => setTimeout(done, 300));
    return rules.join();
  });
  for (const rule of ["connect-src", "img-src", "eval"]) assert.ok(refused.includes(rule), `${rule} is allowed: ${refused}`);
  await close();
}

run([everyControl, keyboardAlone, everyWidth, lostGraphics, asksNobody]);
