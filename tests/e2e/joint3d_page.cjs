// SPDX-License-Identifier: GPL-3.0-or-later
// joint3d_page.cjs PAGE [TEST...]: uses Joint3D in a real browser, every control of it. Exit code 1 if anything is wrong.
// A page that is loaded asks its library for some seconds of work, the limits of all motions above all: so few are loaded, and
// that panel is folded where nobody looks at it. Environment: IMPINGE, the program.
"use strict";
const { execFileSync } = require("node:child_process");
const fs = require("node:fs");
const path = require("node:path");
const { pathToFileURL } = require("node:url");
const { FOLDER, assert, choose, difference, madePair, message, open, picture, posed, run, settled, smallest, text, type, value } = require("./joint3d_browser.cjs");

const DESKTOP = [1000, 640];
const QUICK = { folded: ["all-limits"] };
const pressed = (page, group) => page.getAttribute(`#${group} button[aria-pressed="true"]`, "value");
const fold = (page, id) => page.click(`#${id} > summary`);

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
  await type(page, "internal_rotation", -123.4); // beyond what the slider begins with
  assert.equal(await value(page, "slide-internal_rotation"), -123.4);
  await posed(page, () => page.click("#reset-pose"));
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
  for (const view of ["free", "anterior", "posterior", "medial", "lateral", "superior", "inferior"]) {
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
  assert.equal(keys.length, 39);
  await page.evaluate((all) => all.forEach((key) => { // to and fro at once: one hip is made
    const [slide, number] = ["slide", "value"].map((kind) => document.getElementById(`${kind}-${key}`));
    const held = number.value;
    slide.stepUp();
    slide.dispatchEvent(new Event("input", { bubbles: true }));
    number.value = held;
    number.dispatchEvent(new Event("input", { bubbles: true }));
  }), keys);
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
  for (const scheme of ["usid", "icosahedral_sine"]) { // tests/joint3d/worker_test.js has them all
    await change(() => page.selectOption("#scheme", scheme));
    assert.ok(Math.abs(await smallest(page) - gap) < 0.2, `${scheme} has a gap of ${await smallest(page)}, not ${gap}`);
  }
  await change(() => page.selectOption("#scheme", "rsid"));
  assert.equal(await filled(), "65,160", "the thesis' Table 2");
  await change(() => page.selectOption("#storage", "double"));
  assert.match(await page.textContent("#tables-rows"), /× (3\.[5-9]|4)/);
  await page.click('#views [value="anterior"]');
  const bare = await picture(page);
  await page.click('#shown label:has-text("sample points")');
  await page.waitForFunction(() => /^All/.test(document.getElementById("points-say").textContent));
  assert.ok(difference(bare, await picture(page)) > 0.01, "no sample points");
  assert.match(await text(page, "points-say"), /All 65,160 directions of each table: 65,160 meet the femur, [\d,]+ the socket/);
  await page.click('#shown label:has-text("sample points")');
  assert.ok(await page.isHidden("#points-say"));
  assert.ok(difference(bare, await picture(page)) < 0.0002, "they do not go");
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
  assert.match(await text(page, "sweep-say"), /Bones first touch between [\d.]+° and [\d.]+°, at \d+:\d\d o’clock, [a-z ]+ \(certified: no contact is skipped\)/);
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

const fflate = () => import("../../analysis/node_modules/three/examples/jsm/libs/fflate.module.js");

/** What a button gives to be kept: { name, bytes }. */
async function download(page, id) {
  const [file] = await Promise.all([page.waitForEvent("download"), page.click(`#${id}`)]);
  return { name: file.suggestedFilename(), bytes: fs.readFileSync(await file.path()) };
}

/** The table of all motions: its limits are those of the panel of one motion, and its file has a line for each (tests/python/test_same_answers.py reads it). */
async function allLimits(page, saved) {
  await fold(page, "all-limits"); // opens it
  await page.waitForFunction(() => /^Working, [1-9]/.test(document.getElementById("limits-say").textContent));
  await page.click("#limits-cancel");
  const done = await text(page, "limits-say");
  assert.match(done, /^Cancelled, \d+ of 12\.$/);
  await page.waitForTimeout(300);
  assert.equal(await text(page, "limits-say"), done, "it goes on");
  await page.click("#limits-cancel");
  await page.waitForFunction(() => !document.getElementById("save-limits").disabled);
  const motions = await page.locator("#limits-rows tr").count();
  const { name, bytes } = await saved("save-limits");
  assert.equal(name, "limits_patient_a_stand_in_right.csv");
  const [head, ...lines] = bytes.toString().trim().split("\n").map((line) => line.split(/,(?=(?:[^"]*"[^"]*")*[^"]*$)/));
  assert.equal(head.join(), "joint,motion,threshold_mm,centre,state,low_deg,high_deg,centre_low_deg,centre_high_deg,half_mm_gap_deg,clock,what,play_low_deg,play_high_deg,hangs_on_less_than_half_mm");
  assert.ok(motions === 12 && lines.length === 3 * motions && lines.every((line) => line.length === head.length), `${lines.length} lines`);
  const bone = lines.find((line) => line[1] === "internal_rotation_at_90" && line[3] === "ball" && line[2] === "0");
  await page.selectOption("#sweep-motion", "internal_rotation_at_90");
  await page.waitForFunction(() => !document.getElementById("sweep-plot").classList.contains("old") && /Bones/.test(document.getElementById("sweep-say").textContent));
  const [low, high] = (await text(page, "sweep-say")).match(/between ([\d.]+)° and ([\d.]+)°/).slice(1).map(Number);
  assert.ok(Number(bone[5]) >= low && Number(bone[6]) <= high, `${bone} ${low} ${high}`);
  await posed(page, () => page.locator("#limits-rows tr", { hasText: "Internal rotation at 90" }).locator("button").first().click());
  assert.equal(await value(page, "value-flexion"), 90);
  assert.ok(Math.abs(await value(page, "value-internal_rotation") - low) < 0.01);
  assert.ok(Math.abs(await smallest(page)) < 0.1, `a gap of ${await smallest(page)} at the limit`);
  assert.match(await text(page, "measures-rows"), /CCD.*126\.\d° ± \d\.\d°Published: median 122\.2°, quartiles 117\.9° and 125\.6° of 1,070 femora, by CT \(Hartel 2016\)/);
  await posed(page, () => page.click("#reset-pose"));
  await page.check("#limits-rim");
  await page.waitForFunction(() => document.getElementById("limits-of").textContent === "rim alone" && !document.getElementById("save-limits").disabled);
  assert.match(await text(page, "limits-rim-say"), /^the rim alone: where the socket's bone within 2\.5 mm of its rim/);
  const rim = await saved("save-limits");
  assert.equal(rim.name, "limits_rim_patient_a_stand_in_right.csv");
  const [all, alone] = [bytes, rim.bytes].map((csv) => csv.toString().match(/(?<=,0,ball,\w+,)[\d.]+/g).map(Number));
  assert.ok(alone.length === 12 && alone.every((low, k) => low > all[k] - 1e-3), `${alone} before ${all}`);
  await page.uncheck("#limits-rim");
  await type(page, "flexion", 45);
}

async function exporting(page) {
  const { strFromU8, unzipSync } = await fflate();
  await type(page, "flexion", 45);
  const saved = (id) => download(page, id);
  const image = await saved("save-picture");
  assert.equal(image.name, "joint3d_patient_a_stand_in_right_flexion_45.png");
  assert.equal(image.bytes.subarray(1, 4).toString(), "PNG");
  const [wide, high] = [16, 20].map((at) => image.bytes.readUInt32BE(at));
  const drawn = await page.evaluate(() => { const { width, height } = document.getElementById("view"); return [width, height]; });
  assert.ok(wide === drawn[0] && high > drawn[1] + 80, `a picture of ${wide} x ${high} has no room for words below ${drawn}`);
  const zip = await saved("save-csv");
  assert.equal(zip.name, "gaps_patient_a_stand_in_right_flexion_45.zip");
  const packed = unzipSync(new Uint8Array(zip.bytes));
  const csv = strFromU8(packed["gaps.csv"]).trim().split("\n");
  assert.equal(csv[0], "surface,vertex,x,y,z,gap_mm");
  const made = JSON.parse(strFromU8(packed["gaps.json"]));
  assert.equal(made.pose_deg.flexion, 45);
  assert.equal(made.joint.preset, "patient_a");
  assert.equal(made.smallest_gap.gap_mm.toFixed(2), await text(page, "smallest-gap"));
  assert.match(`${made.program} ${made.commit}`, /^impinge \d+\.\d+\.\d+ ([0-9a-f]{40}|unknown)$/);
  const gaps = csv.slice(1).map((line) => line.split(",")[5]).filter(Boolean).map(Number);
  assert.equal(Math.min(...gaps).toFixed(2), await text(page, "smallest-gap"));
  for (const part of ["ball", "socket"]) {
    const { name, bytes } = await saved(`save-${part}`);
    assert.equal(name, `${part}_patient_a_stand_in_right_flexion_45.ply`);
    assert.match(bytes.subarray(0, 400).toString("latin1"), /^ply\nformat binary_little_endian 1.0\n[^]*gap/);
  }
  await allLimits(page, saved);
  await page.click("#about > summary");
  assert.match(await text(page, "about"), /impinge \d.*commit.*General Public License/);
  await page.click("#copy-link");
  return { fragment: new URL(await page.inputValue("#link")).hash, gap: await text(page, "smallest-gap") };
}

/** Files that stand beside a joint: a body that a flexed femur meets, and landmarks. */
function besideFiles() {
  const body = path.join(FOLDER, "spine.obj");
  const corners = [[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]].map((corner) => corner.map((x, k) => 6 * x + [25, 60, -5][k]));
  const faces = [[1, 3, 5], [3, 2, 5], [2, 4, 5], [4, 1, 5], [3, 1, 6], [2, 3, 6], [4, 2, 6], [1, 4, 6]];
  fs.writeFileSync(body, [...corners.map((x) => `v ${x.join(" ")}`), ...faces.map((x) => `f ${x.join(" ")}`), ""].join("\n"));
  const trochanter = path.join(FOLDER, "trochanter.obj");
  fs.writeFileSync(trochanter, fs.readFileSync(body, "utf8").replace(/^v (\S+) (\S+) (\S+)$/gm, (_, x, y, z) => `v ${x} ${Number(y) - 60} ${Number(z) - 60}`));
  const landmarks = path.join(FOLDER, "points.csv");
  fs.writeFileSync(landmarks, "label,x,y,z\nasis_right,20,40,80\nasis_left,-180,40,80\npubic_tubercle_right,-60,20,-10\npubic_tubercle_left,-100,20,-10\n");
  return { body, trochanter, landmarks };
}

/** The report is the program's, and draws the bones. */
async function report(page) {
  const { ball, socket } = madePair("cam");
  await posed(page, () => page.click("#reset-pose"));
  await page.click("#save-report");
  await page.evaluate(() => document.getElementById("keep-cancel").click());
  assert.equal(await text(page, "keep-say"), "Cancelled.");
  const { name, bytes } = await download(page, "save-report");
  assert.equal(name, "report_ball_and_socket_right.html");
  const file = path.join(FOLDER, name);
  fs.writeFileSync(file, bytes);
  execFileSync(process.env.IMPINGE, ["report", ball, socket, "--side", "right", "--out", path.join(FOLDER, "report")], { stdio: "pipe" });
  const read = (html) => html.toString().split("<script")[0].replace(/commit [\w-]+/, "");
  assert.equal(read(bytes), read(fs.readFileSync(path.join(FOLDER, "report", "report.html"))));
  const made = await page.context().newPage();
  await made.goto(pathToFileURL(file).href);
  await made.waitForSelector("body.drawn");
  await made.close();
}

/** Parts and landmarks are taken with the joint, told, kept in a saved session, and left out again. */
async function besides(page) {
  const { body, trochanter, landmarks } = besideFiles();
  await page.click("#more > summary");
  await page.setInputFiles("#file-ball_parts", trochanter);
  await page.setInputFiles("#file-socket_parts", body);
  await page.setInputFiles("#file-landmarks", landmarks);
  await posed(page, () => page.click("#use-files"));
  assert.match(await text(page, "files-say"), /By the landmarks the pelvis is tilted by 12\.5° in the scan; angles are counted from the pose of the scan\./);
  const faces = await text(page, "faces");
  await type(page, "flexion", 33);
  const { name, bytes } = await download(page, "save-session");
  assert.equal(name, "session_ball_and_socket_right_flexion_33.zip");
  const { strFromU8, unzipSync } = await fflate();
  const packed = unzipSync(new Uint8Array(bytes));
  assert.deepEqual(Object.keys(packed).sort(), ["ball.ply", "points.csv", "session.json", "socket.ply", "spine.obj", "trochanter.obj"]);
  assert.ok(Buffer.from(packed["ball.ply"]).equals(fs.readFileSync(madePair("cam").ball)), "not the file that was given");
  const folder = path.join(FOLDER, "session"); // which the program reads
  fs.mkdirSync(folder);
  Object.entries(packed).forEach(([file, content]) => fs.writeFileSync(path.join(folder, file), content));
  const said = JSON.parse(strFromU8(packed["session.json"]));
  const program = execFileSync(process.env.IMPINGE, ["touch", said.ball, said.socket, "--config", "session.json", "--pose", "flexion=33"], { cwd: folder, encoding: "utf8" });
  assert.match(program, /tilt 12\.5 degrees/);
  await page.click("#no-more");
  await posed(page, () => page.click("#use-files"));
  assert.notEqual(await text(page, "faces"), faces);
  assert.ok(await page.isHidden("#no-more"));
  await posed(page, () => page.selectOption("#preset", "normal"));
  await type(page, "flexion", 0);
  const file = path.join(FOLDER, name);
  fs.writeFileSync(file, bytes);
  await posed(page, () => page.setInputFiles("#open-session", file));
  await page.waitForFunction((all) => document.getElementById("faces").textContent === all, faces);
  assert.deepEqual([await value(page, "value-flexion"), await text(page, "name-socket_parts"), await text(page, "name-landmarks")], [33, "spine.obj", "points.csv"]);
  assert.match(await text(page, "joint-name"), /ball.ply and socket.ply, right/);
  await page.setInputFiles("#open-session", body);
  assert.match(await message(page), /^spine.obj: it is no session; choose a session/);
  await page.click("#message-close");
  await page.click("#no-more");
  await posed(page, () => page.click("#use-files"));
}

/** A joint that takes long to make is cancelled: the one before stays, and moves. */
async function cancelled(page) {
  const before = await text(page, "joint-name");
  const folder = path.join(FOLDER, "large");
  execFileSync(process.env.IMPINGE, ["hip", "cam", "--set", "side=right", "--faces", "60000", "--out", folder], { stdio: "pipe" });
  await page.setInputFiles("#file-ball", path.join(folder, "ball.ply"));
  await page.setInputFiles("#file-socket", path.join(folder, "socket.ply"));
  const faces = await text(page, "faces");
  await page.click("#use-files");
  await page.waitForSelector('#stage[aria-busy="true"]');
  await page.evaluate(() => document.getElementById("stage-cancel").click());
  await page.waitForSelector('#stage[aria-busy="false"]');
  assert.deepEqual([await text(page, "joint-name"), await text(page, "faces")], [before, faces]);
  const gap = await smallest(page);
  await type(page, "flexion", 80);
  assert.notEqual(await smallest(page), gap, "the joint before does not move");
  await posed(page, () => page.click("#reset-pose"));
}

/** What a panel works out can be cancelled and taken up again. */
async function halted(page, id) {
  const press = (words) => page.waitForFunction(([panel, wanted]) => { // in the page: it is pressed before the work is done
    const button = document.getElementById(`${panel}-cancel`);
    const there = !button.parentElement.hidden && button.textContent === wanted;
    if (there) button.click();
    return there;
  }, [id, words]);
  await press("Cancel");
  await page.evaluate((panel) => document.getElementById(panel).dispatchEvent(new Event("toggle")), id); // as of a panel that opened late
  assert.match(await page.textContent(`#${id} .working`), /Cancelled\.Work it out$/);
  await press("Work it out");
  assert.match(await page.textContent(`#${id} .working`), /^\d+ s.*Cancel$/);
}

/** A reader's own joint, of so few faces that what is worked out of it is quick. */
async function ownJoint(page) {
  await fold(page, "all-limits");
  await page.click("#frame > summary");
  for (const [id, choice] of [["file-side", "left"], ["file-side", "right"], ["unit", "cm"], ["unit", "mm"]]) await page.selectOption(`#${id}`, choice);
  await page.fill("#axes", "ras");
  await page.check("#centre-typed");
  await page.fill("#centre", "0, 0, 0.5");
  await choose(page, madePair("cam"));
  assert.match(await text(page, "joint-name"), /ball.ply and socket.ply, right/);
  assert.match(await text(page, "centre-say"), /Centre at 0.00, 0.00, 0.50 mm/);
  await page.uncheck("#centre-typed");
  await posed(page, () => page.click("#use-files"));
  assert.match(await text(page, "centre-say"), /Centre fitted at .*: radius 24.00 mm/);
  assert.match(await text(page, "files-say"), /^Taken, with/);
  await report(page);
  await besides(page);
  await cancelled(page);
  await choose(page, madePair("cam"));
  await posed(page, () => page.click("#reset-pose"));
}

/** Another one in its place. */
async function otherJoint(page) {
  await choose(page, madePair("normal"));
}

async function everyControl(browser) {
  const { page, faults, close } = await open(browser, DESKTOP, QUICK);
  await watchControls(page);
  for (const part of [startsColoured, motions, recorded, dragging, looks, hips, refusals, tables, sweeps]) await part(page);
  const { fragment, gap } = await exporting(page);
  for (const part of [ownJoint, orientation, cut, motionVolume]) await part(page);
  const unused = await page.evaluate(() => window.controls().filter((name) => !window.used.has(name)));
  assert.deepEqual(unused.filter((name) => name !== "link"), [], "never used");
  assert.deepEqual(faults, []);
  await close();
  const second = await open(browser, DESKTOP, { ...QUICK, fragment });
  assert.equal(await value(second.page, "value-flexion"), 45);
  assert.equal(await text(second.page, "smallest-gap"), gap, "a link shows another state");
  await second.close();
}

async function keyboardAlone(page) {
  const reached = new Set();
  for (let k = 0; k < 240; k += 1) {
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
}

/** A phone that opens the page has half of its screen for the picture, none of it under the legend, and tables folded. */
async function onAPhone(page) {
  const context = await page.context().browser().newContext({ viewport: { width: 400, height: 860 } });
  const phone = await context.newPage();
  await phone.goto(page.url().replace(/#.*/, ""));
  await settled(phone);
  const box = (id) => phone.locator(id).boundingBox();
  await phone.locator("#about").scrollIntoViewIfNeeded();
  const [view, legend] = [await box("#view"), await box("#legend")];
  assert.ok(view.y >= 0 && view.height >= 428 && view.y + view.height <= legend.y + 1 && legend.y + legend.height <= 560, JSON.stringify([view, legend]));
  for (const [id, open] of [["files", true], ["motion", true], ["numbers", true], ["all-limits", false], ["tables", false], ["measures", false]])
    assert.equal(await phone.evaluate((each) => document.getElementById(each).open, id), open, id);
  for (const row of await phone.locator("#legend li").all()) { const { x, width } = await row.boundingBox(); assert.ok(x >= 0 && x + width <= 400, "a row of the legend is cut off"); }
  await context.close();
}

async function everyWidth(page) {
  assert.match(await page.textContent("header .notice"), /no medical device/);
  await fold(page, "spread");
  await onAPhone(page);
  for (const size of [[1440, 900], [1024, 768], [400, 800], [390, 844], [844, 390]]) {
    await page.setViewportSize({ width: size[0], height: size[1] });
    await picture(page); // drawn anew
    const wide = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
    assert.ok(wide <= 0, `at ${size} the page is ${wide} too wide`);
    const view = await page.locator("#view").boundingBox();
    assert.ok(view.width * view.height > 0.3 * size[0] * size[1] && view.height <= size[1], `the picture has ${JSON.stringify(view)}`);
    assert.match(await text(page, "joint-name"), /right/);
    assert.ok(await page.isVisible("header .notice"));
    await page.locator("#copy-link").scrollIntoViewIfNeeded();
    assert.ok(await page.isVisible("#copy-link"));
    assert.ok(await page.isHidden("#histogram"), "a panel does not fold");
    await page.emulateMedia({ media: "print" });
    for (const pressed of [".bar", "#keep", "#files"]) assert.ok(await page.isHidden(pressed), `${pressed} is printed`);
    assert.ok(await page.isVisible("#view") && await page.isVisible("#smallest-gap"), "the picture or its gap is not printed");
    await page.emulateMedia({ media: "screen" });
  }
}

async function lostGraphics(page) {
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
}

async function asksNobody(page) {
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
}

/** What stands round the joint: keys, widths, print, and a browser in trouble. */
async function surroundings(browser) {
  const { page, faults, close } = await open(browser, DESKTOP, QUICK);
  for (const part of [keyboardAlone, everyWidth]) await part(page);
  assert.deepEqual(faults, []);
  await page.setViewportSize({ width: DESKTOP[0], height: DESKTOP[1] });
  await lostGraphics(page);
  assert.deepEqual(faults.filter((fault) => !/context/i.test(fault)), []);
  await asksNobody(page);
  await close();
}

/** The colours of the squares of the program's own map, flexion by flexion from the least abduction. */
function volumeOfProgram(hip) {
  const { ball, socket } = madePair(hip);
  const folder = path.join(FOLDER, "volume");
  execFileSync(process.env.IMPINGE, ["volume", ball, socket, "--side", "right", "--width", "0.05", "--out", folder], { stdio: "pipe" });
  const squares = [...fs.readFileSync(path.join(folder, "volume.svg"), "utf8").matchAll(/<rect x="(\d+)" y="(\d+)" width="5" height="5" fill="([^"]+)"/g)];
  return squares.map(([, x, y, fill]) => [Number(x), Number(y), fill]).sort((a, b) => a[0] - b[0] || b[1] - a[1]).map(([, , fill]) => fill);
}

/** Worked out when the panel is opened; the ring is where the pose is, and another joint has another volume. */
async function motionVolume(page) {
  await choose(page, madePair("cam"));
  await type(page, "flexion", 90);
  assert.equal(await page.locator("#volume-plot rect").count(), 0);
  const shares = async () => {
    await page.waitForFunction(() => /%/.test(document.getElementById("volume-say").textContent));
    return (await text(page, "volume-say")).match(/[\d.]+(?= to|\s%)/g).map(Number);
  };
  await fold(page, "volume");
  await halted(page, "volume");
  await page.waitForFunction(() => /% of all rotations are undecided, 5 % may be/.test(document.querySelector("#volume .working").textContent));
  const [low, high, least, most] = await shares();
  assert.ok(0 < least && least <= low && low < high && high - low < 5.2 && most <= high, `${low} to ${high}, ${least} to ${most}`);
  assert.deepEqual(await page.locator("#volume-plot rect").evaluateAll((all) => all.map((rect) => rect.getAttribute("fill"))), volumeOfProgram("cam"));
  assert.match(await text(page, "volume-key"), /^rotation without contact, internal and external together, degrees: 0 30 60 90 120\+ blocked undecided$/);
  const ring = () => page.getAttribute("#volume-plot circle", "cx").then(Number);
  const [before, here] = [await ring(), await text(page, "volume-here")];
  await type(page, "flexion", 0);
  assert.ok(await ring() < before - 50, "the ring stands still");
  assert.notEqual(await text(page, "volume-here"), here);
  await otherJoint(page);
  const [other] = await shares();
  assert.ok(other > low, `${other} % of the normal hip, ${low} % of one with a cam`);
}

/** A cut is worked out when the panel is opened, and anew for other motions; the femur before and after it is shown. */
async function cut(page) {
  await page.click('#views [value="anterior"]');
  await posed(page, () => page.click('#shown label:has-text("socket")')); // which hides where it goes
  await fold(page, "cut");
  await page.fill("#cut-required", "flexion=90, internal_rotation=30");
  await page.press("#cut-required", "Enter");
  await halted(page, "cut");
  const found = () => page.waitForSelector("#cut-found:not([hidden])");
  const volume = async () => { await found(); return (await page.textContent("#cut-numbers dd")).match(/[\d.]+/g).map(Number); };
  const [low, high] = await volume();
  assert.ok(0 < low && low < high, `${low} to ${high} mm³`);
  const rows = (await page.locator("#cut-rows tr").allTextContents()).map((row) => row.replace(/\s+/g, " "));
  assert.match(rows[0], /^flexion to 90°yesyes/);
  assert.match(rows[1], /^internal rotation to 30° at flexion 90[\d.]+°yes, to 30/);
  assert.match(await text(page, "cut-notice"), /may guide a treatment/);
  const legend = async () => `${await text(page, "legend-of")}: ${await text(page, "legend-rows")}`;
  assert.match(await legend(), /^Depth of the cut: femur, not cutcut, up to [\d.]+ mm deepsocket$/);
  assert.ok(await page.isVisible("#stage-cut"), "a gap before the cut beside the femur after it");
  const deep = (places) => places.filter(([red, , blue]) => red < 90 && blue > red + 25).length; // the darkest blue
  const after = deep(await picture(page));
  await page.click('#cut-shown [value="before"]');
  const before = deep(await picture(page));
  assert.match(await legend(), /^Gap \(radial\): bones touch or overlap/);
  assert.ok(await page.isHidden("#stage-cut"));
  assert.ok(after > before + 5, `the femur looks the same after the cut: ${after} and ${before} places are dark blue`);
  await page.click('#cut-shown [value="after"]');
  await page.fill("#cut-required", "flexion=90, internal_rotation=20");
  await page.press("#cut-required", "Enter");
  await page.waitForFunction((was) => document.querySelector("#cut-numbers dd").textContent !== was, `${low} to ${high} mm³`);
  const [, less] = await volume();
  assert.ok(less < low, `${less} mm³ for less motion, ${low} for more`);
  assert.equal(await page.inputValue("#orientation-required"), "flexion=90, internal_rotation=20");
  await page.fill("#cut-clearance", "1");
  await page.press("#cut-clearance", "Enter");
  await page.waitForFunction((most) => Number(document.querySelector("#cut-numbers dd")?.textContent.match(/\d+/)) > most, less);
  await page.click("#cut-pose"); // that of the scan
  await page.waitForFunction(() => /a required motion turns something/.test(document.getElementById("cut-say").textContent));
  await page.fill("#cut-required", "bend=20");
  await page.press("#cut-required", "Enter");
  await page.waitForFunction(() => /unknown motion 'bend'/.test(document.getElementById("cut-say").textContent));
  assert.ok(await page.isHidden("#cut-found"));
  await page.fill("#cut-required", "flexion=30");
  await page.press("#cut-required", "Enter");
  await found();
  assert.equal(await page.textContent("#cut-numbers dd"), "nothing");
  assert.ok(await page.isHidden("#cut-shown"));
  await otherJoint(page); // worked out anew
  await found();
  await fold(page, "cut");
  assert.match(await legend(), /^Gap/, "the femur stays cut beside a folded panel");
  await posed(page, () => page.click('#shown label:has-text("socket")'));
}

/** Pointer, finger and keys read from the map which motion is blocked; the text is told to screen readers. */
async function whatIsBlocked(page) {
  const here = () => text(page, "orientation-here");
  assert.equal(await page.getAttribute("#orientation-here", "role"), "status");
  await page.focus("#orientation-plot");
  const start = await here();
  assert.match(start, /^At inclination 5\d\.\d° and anteversion 1\d\.\d°: All required motions are free\.$/);
  await page.press("#orientation-plot", "ArrowDown");
  const version = (words) => Number(words.match(/anteversion (−?-?[\d.]+)/)[1]);
  assert.ok(Math.abs(version(start) - version(await here()) - 1) < 0.11);
  for (let k = 0; k < 80 && !/Blocked/.test(await here()); k += 1) await page.press("#orientation-plot", "ArrowDown");
  const blocked = /^At .*: Blocked: (flexion to 90°|internal rotation to 10° at flexion 90)\.$/;
  assert.match(await here(), blocked);
  const { x, y, width, height } = await page.locator("#orientation-plot").boundingBox();
  await page.mouse.move(x + width * 0.2, y + height * 0.8);
  const moved = await here();
  assert.match(moved, blocked);
  await page.mouse.move(x + width * 0.2, y + height * 0.99); // beside the map
  assert.equal(await here(), moved);
  assert.equal(await page.locator("#orientation-plot .mark").count(), 1);
}

/** Words and colours of the map are those of the program's own. */
async function likeTheProgram(page, required) {
  const { ball, socket } = madePair("cam");
  const folder = path.join(FOLDER, "orient");
  execFileSync(process.env.IMPINGE, ["orient", ball, socket, "--side", "right", "--require", required, "--resolution", "0.75", "--out", folder], { stdio: "pipe" });
  const svg = fs.readFileSync(path.join(folder, "orientation.svg"), "utf8");
  const key = (await text(page, "orientation-key")).split(/; (?=the dot)|(?<=a turn by [\d.]+) ?| (?=blocked|undecided|the ball)/);
  const fills = await page.locator("#orientation-plot rect[fill]").evaluateAll((all) => [...new Set(all.map((rect) => rect.getAttribute("fill")))]);
  for (const words of [...key, ...fills, "anteversion, degrees", "inclination, degrees"]) assert.ok(svg.includes(words), `${words} is not in ${svg.replace(/<path.*>/g, "")}`);
}

/** The map of orientations, with the socket as it is. */
async function orientation(page) {
  await fold(page, "orientation");
  await page.fill("#orientation-required", "flexion=90, internal_rotation=10");
  await page.press("#orientation-required", "Enter");
  await halted(page, "orientation");
  const said = async () => {
    await page.waitForFunction(() => /square degrees/.test(document.getElementById("orientation-say").textContent));
    return text(page, "orientation-say");
  };
  const first = await said();
  assert.match(first, /^As it is, at inclination 5\d\.\d° and anteversion 1\d\.\d°: free\. Free are \d+ to \d+ of 8100 square degrees, \d+\.\d unknown\.$/);
  const of = async () => (await page.locator("#orientation-plot rect[fill]").evaluateAll((all) => all.map((rect) => rect.getAttribute("fill")))).reduce((count, fill) => count.set(fill, 1), new Map()).size;
  assert.ok(await of() >= 2, "one colour");
  assert.equal(await page.locator("#orientation-plot circle").count(), 2);
  await whatIsBlocked(page);
  await type(page, "flexion", 90);
  await type(page, "internal_rotation", 40);
  await page.click("#orientation-pose");
  assert.equal(await page.inputValue("#orientation-required"), "flexion=90, internal_rotation=40");
  const blocked = await said();
  assert.match(blocked, /: blocked\..* Nearest free: inclination [\d.]+°, anteversion -?[\d.]+°, by a turn of the socket by [\d.]+° about the axis /);
  await likeTheProgram(page, "flexion=90,internal_rotation=40");
  await page.fill("#orientation-tilt", "10");
  await page.press("#orientation-tilt", "Enter");
  await page.waitForFunction((was) => !["", was].includes(document.getElementById("orientation-say").textContent), blocked);
  assert.match(await text(page, "orientation-notice"), /may guide a treatment/);
  await fold(page, "orientation");
  await posed(page, () => page.click("#reset-pose"));
}

run([everyControl, surroundings]);
