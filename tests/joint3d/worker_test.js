// SPDX-License-Identifier: GPL-3.0-or-later
// The worker of the page: its protocol, and that what goes wrong leaves the joint as it was.
'use strict';

const assert = require('node:assert/strict');
const path = require('node:path');
const { before, beforeEach, test } = require('node:test');

const { serve } = require(path.join(__dirname, '../../analysis/joint3d/src/worker.js'));

let engine;
let send;
let replies;
let reached; // of questions that say how far they are

async function one(kind, request = {}) {
  await send({ id: replies.length, kind, ...request });
  return replies.at(-1);
}

before(async () => {
  engine = require(process.env.JOINT3D_ENGINE)();
  await engine;
});

beforeEach(async () => {
  replies = [];
  reached = [];
  // As postMessage() does: what is handed over is gone on this side.
  const post = (reply, transfer) => (reply.ok === undefined ? reached : replies).push(structuredClone(reply, { transfer }));
  send = serve(engine, post);
  const reply = await one('joint', { source: 'preset', name: 'cam', parameters: {} });
  assert.equal(reply.error, undefined);
});

test('the catalogue is that of the library', async () => {
  const catalogue = await one('presets');
  assert.deepEqual(
    catalogue.presets.map((preset) => preset.name),
    ['normal', 'cam', 'pincer', 'mixed', 'dysplastic', 'patient_a', 'patient_b'],
  );
  assert.equal(catalogue.parameters.length, 39);
  assert.equal(new Set(catalogue.parameters.map(({ meaning }) => meaning)).size, 39);
  for (const { key, least, most } of catalogue.parameters) {
    assert.ok(least < most);
    for (const preset of catalogue.presets) assert.ok(preset.parameters[key] >= least && preset.parameters[key] <= most);
  }
  assert.deepEqual(catalogue.recorded.find((range) => range.motion === 'flexion').patient_a, 103.1);
  assert.ok(catalogue.motions.some((motion) => motion.name === 'fadir' && motion.start.flexion === 90));
  assert.ok(catalogue.schemes.length >= 13);
  for (const scheme of catalogue.schemes) assert.ok(scheme.label && scheme.precisions.includes(1), scheme.name);
});

// In floats and in 16 bits other kernels answer: as those of doubles, but for the rounding of numbers of up to 100 mm.
test('every scheme and storage of the catalogue answers', async () => {
  const { schemes } = await one('presets');
  const gaps = async (scheme, storage) => {
    assert.equal((await one('tables', { scheme, precision_deg: 2, storage })).error, undefined);
    const { ball_gap: ball, socket_gap: socket, smallest_gap: smallest } = await one('pose', { pose: { flexion: 80 } });
    return { all: [...ball, ...socket], least: smallest.gap_mm };
  };
  const { smallest_gap: smallest } = await one('pose', { pose: { flexion: 80 } });
  for (const { name } of schemes.filter((scheme) => scheme.name !== 'conchoid')) {
    const exact = await gaps(name, 'double');
    assert.ok(Math.abs(exact.least - smallest.gap_mm) < 0.3, `${name} ${exact.least}`);
    for (const [storage, most] of [['float', 2e-5], ['uint16', (0.5 * 100) / 65534]]) {
      const { all } = await gaps(name, storage);
      const same = (gap, k) => (Number.isNaN(gap) ? Number.isNaN(exact.all[k]) : Math.abs(gap - exact.all[k]) <= most);
      assert.ok(all.every(same), `${name} ${storage}: gap ${all.findIndex((gap, k) => !same(gap, k))}`);
    }
  }
});

// A point of every entry that meets the surface; the head, which is closed, is met by all.
test('the sample points of tables of every size are there', async () => {
  for (const [scheme, precision_deg, entries] of [['rsid', 1, 65160], ['cube_gnomonic', 0.35, 402486]]) {
    const tables = await one('tables', { scheme, precision_deg, storage: 'uint16' });
    const { ball, socket, ...reply } = await one('points');
    assert.equal(reply.entries, tables.entries);
    assert.equal(ball.length, 3 * tables.entries);
    assert.ok(socket.length > 0.4 * ball.length && socket.length < 0.7 * ball.length, `${socket.length} of ${ball.length}`);
    assert.equal(tables.entries, entries);
    for (const points of [ball, socket]) {
      for (let k = 0; k < points.length; k += 3000) assert.ok(Math.hypot(points[k], points[k + 1], points[k + 2]) > 10);
    }
  }
});

test('a joint comes with all that is drawn of it', async () => {
  const settings = { scheme: 'cube_equiangular', precision_deg: 1, storage: 'float' };
  await one('tables', settings);
  const joint = await one('joint', { source: 'preset', name: 'normal', parameters: { cam_height: 1, side: 'left' } });
  assert.equal(joint.side, 'left');
  assert.equal(joint.parameters.cam_height, 1);
  for (const part of [joint.ball, joint.socket]) {
    assert.ok(part.positions instanceof Float32Array && part.faces instanceof Uint32Array);
    assert.ok(Math.max(...part.faces) < part.positions.length / 3);
  }
  assert.equal(joint.rim_clock.length, 3 * joint.rim_hours.length);
  assert.ok(joint.rim_hours.every((hours, i) => i === 0 || hours > joint.rim_hours[i - 1]));
  const { scheme, precision_deg, storage } = joint.tables;
  assert.deepEqual({ scheme, precision_deg, storage }, settings);
  const pose = await one('pose', { pose: { flexion: 90 }, cartilage_mm: 3 });
  assert.equal(pose.ball_gap.length, joint.ball.positions.length / 3);
  assert.equal(pose.socket_gap.length, joint.socket.positions.length / 3);
  assert.equal(pose.colours.ball.length, 5);
  // Flexion turns up into forward: the column of z is (0, ...).
  assert.ok(Math.abs(pose.matrix[5]) < 1e-7 && Math.abs(Math.abs(pose.matrix[6]) - 1) < 1e-7);
});

test('limits are those of a sweep', async () => {
  const request = { motions: ['fadir'], translation: [0, 0.5, 0], cartilage_mm: 3 };
  assert.deepEqual((await one('limits', request)).limits, (await one('sweep', { ...request, step_deg: 30 })).limits);
  assert.deepEqual((await one('limits', { motions: ['flexion'] })).limits.map(({ centre, threshold_mm: mm }) => [centre, mm]), [['ball', 0], ['socket', 0]]);
  assert.equal((await one('limits', { motions: ['flexion'] })).limits[0].largest_deg, 180);
});

// A pose of which the gaps are clearly below 0 is not free; one on a motion from the scan before its limit is reachable.
// No square of the map claims more rotation than limits and gaps leave, nor blocks what they show to be free.
test('the volume agrees with gaps and limits', async () => {
  const volume = await one('volume', { width: 0.2 });
  assert.equal(volume.error, undefined);
  assert.ok(reached.length > 2 && reached.every(({ open }, k) => open <= (reached[k - 1]?.open ?? 1)) && reached.at(-1).open <= 0.2, 'how far it is');
  const { share_low: low, share_high: high, reachable_low: least, reachable_high: most, map } = volume;
  assert.ok(0 < least && least <= low + 1e-6 && low < high && most <= high + 1e-6 && high < 1 && high - low <= 0.2 + 1e-6, JSON.stringify([least, low, most, high]));
  const { range_deg: ranges, step, flexion, abduction } = map;
  assert.deepEqual([step, flexion, abduction], [5, [-45, 150], [-75, 75]]);
  assert.equal(ranges.length, 39 * 30);
  const seen = { free: 0, blocked: 0 };
  for (let k = 0; k < ranges.length; k += 7) {
    const pose = { flexion: -42.5 + 5 * Math.floor(k / 30), abduction: -72.5 + 5 * (k % 30) };
    const { smallest_gap: { gap_mm: gap } } = await one('pose', { pose });
    const name = `${JSON.stringify(pose)}: ${ranges[k]}, ${gap} mm`;
    if (gap > 0.3) assert.notEqual(ranges[k], -1, name);
    if (gap < -0.3) assert.ok(ranges[k] < 0, name);
    seen.blocked += ranges[k] === -1;
    if (ranges[k] < 0) continue;
    seen.free += 1;
    if (seen.free % 8) continue;
    const free = [];
    for (const way of ['internal_rotation', 'external_rotation']) free.push((await one('limits', { motions: [way], pose, largest_deg: 90 })).limits[0]);
    assert.ok(ranges[k] <= free.reduce((sum, { high_deg: end, state }) => sum + (state === 'limited' ? end : 90), 0) + 1e-3, `${name}, ${JSON.stringify(free.map(({ high_deg: end }) => end))}`);
  }
  assert.ok(seen.free > 10 && seen.blocked > 10, JSON.stringify(seen));
});

// Gaps, curve and limit are along rays from the ball's own centre: a shift that brings bones together at the start is a limit
// at the start, and before a limit no gap is below 0 by more than the error of the tables.
test('a limit is that of the shifted ball', async () => {
  const states = new Set();
  const { error_mm: error } = await one('tables', { scheme: 'cube_gnomonic', precision_deg: 0.5, storage: 'float' });
  const asked = { motions: ['abduction'], largest_deg: 130, step_deg: 5, cartilage_mm: 4 };
  const without = await one('sweep', asked);
  assert.deepEqual(without.limits.map(({ centre, threshold_mm: mm }) => [centre, mm]), [['ball', 0], ['socket', 0], ['ball', 4]]);
  for (const translation of [[-5, 0, 1], [0.5, 1, 0.5], [0, 1.5, -2]]) {
    const { angles, smallest: curve, limits } = await one('sweep', { ...asked, translation });
    const [limit] = limits;
    const name = `${translation} ${limit.state} ${limit.low_deg}`;
    states.add(limit.state);
    const { smallest_gap: smallest } = await one('pose', { translation });
    assert.equal(Math.fround(smallest.gap_mm), curve[0], name);
    if (Math.abs(smallest.gap_mm) > 2 * error) assert.equal(limit.state === 'blocked', smallest.gap_mm < 0, name);
    angles.forEach((angle, i) => {
      if (angle < limit.low_deg) assert.ok(curve[i] > -2 * error, `${name}: ${curve[i]} at ${angle}`);
    });
    assert.ok(limits.every(({ centre }) => centre === 'ball'), name);
  }
  const shifted = { translation: [0, 1.5, -2], pose: { flexion: 40 } };
  assert.ok(Math.abs((await one('verdicts', shifted)).smallest_gap_between_mm[0] - (await one('pose', shifted)).smallest_gap.gap_mm) < 2 * error);
  assert.equal((await one('sweep', asked)).limits[0].low_deg, without.limits[0].low_deg);
  assert.ok(states.has('blocked') && states.has('limited'), [...states].join());
  assert.equal((await one('sweep', { motions: ['fadir'], largest_deg: 60 })).angles.length, 61, 'a degree a step, where none is asked for');
});

// What it says besides is that of the program (tests/python/test_documents.py).
test('a cut moves each vertex by its depth', async () => {
  const { ball: { positions: old } } = await one('joint', { source: 'preset', name: 'cam', parameters: {} });
  const cut = await one('resect', { require: ['flexion=90,internal_rotation=30'] });
  assert.equal(cut.error, undefined);
  assert.equal(cut.depth.length, cut.positions.length / 3);
  for (let k = 0; k < old.length; k += 3) {
    const moved = Math.hypot(...[0, 1, 2].map((c) => old[k + c] - cut.positions[k + c]));
    assert.ok(Math.abs(moved - cut.depth[k / 3]) < 1e-4, `vertex ${k / 3} moved by ${moved}, not ${cut.depth[k / 3]} mm`);
  }
  assert.ok(cut.depth.some((depth) => depth > 0.1));
});

test('headers of Slicer say the axes', async () => {
  const { ball, socket } = await one('joint', { source: 'preset', name: 'cam', parameters: {} });
  const turned = ({ positions, faces }) => ({ positions: Float64Array.from(positions, (x, k) => (k % 3 < 2 ? -x : x)), faces });
  const head = (words) => new TextEncoder().encode(`ply\nformat ascii 1.0\ncomment ${words}\nelement vertex 3\nend_header\n`);
  const files = (of, other, axes) => ({ source: 'files', side: 'right', centre: [0, 0, 0], axes,
    ball: { name: 'femur.ply', ...turned(ball), head: head(of) }, socket: { name: 'pelvis.ply', ...turned(socket), head: head(other) } });
  const said = async (...words) => { const { axes, axes_from: from, doubts, error } = await one('joint', files(...words)); return error ?? [axes, from, doubts]; };
  assert.deepEqual(await said('SPACE=LPS', 'SPACE=LPS', null), ['LPS', 'header', 0]);
  assert.deepEqual(await said('SPACE=LPS', 'nothing', null), ['LPS', 'header', 0]);
  assert.deepEqual(await said('nothing', 'nothing', 'LPS'), ['LPS', 'given', 0]);
  assert.deepEqual((await said('nothing', 'nothing', null)).slice(0, 2), ['RAS', 'assumed']);
  assert.match(await said('SPACE=LPS', 'SPACE=RAS', null), /^pelvis.ply: its header says SPACE=RAS, and that of the ball SPACE=LPS; export both/);
  const beside = files('SPACE=LPS', 'nothing', null);
  beside.socket.parts = [{ name: 'spur.ply', ...turned(socket), head: head('SPACE=RAS') }];
  assert.match((await one('joint', beside)).error, /^spur.ply: its header says SPACE=RAS, and that of the ball SPACE=LPS/);
  assert.match(await said('SPACE=LPS', 'SPACE=LPS', 'RAS'), /^femur.ply: its header says SPACE=LPS, and the field Axes says RAS; leave/);
});

const flat = { name: 'flat.stl', positions: new Float64Array(9), faces: null };
// An octahedron with x, y and z multiplied by so much.
function octahedron(name, size, at = [0, 0, 0]) {
  const corners = [[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]];
  const faces = [0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5];
  const positions = corners.flatMap((corner) => corner.map((x, k) => size * x + at[k]));
  return { name, positions: new Float64Array(positions), faces: new Uint32Array(faces) };
}
const soupOf = ({ name, positions, faces }) => ({
  name,
  positions: Float64Array.from([...faces].flatMap((v) => [...positions.subarray(3 * v, 3 * v + 3)])),
  faces: null,
});
const whole = octahedron('head.stl', 20);
const round = octahedron('cup.stl', 24);

const bad = {
  'no area': [{ ball: flat }, /^flat.stl: none of its faces has an area; export the surface again$/],
  'no faces': [{ ball: { ...whole, positions: new Float64Array(0), faces: null } }, /^head.stl: has no faces, only points; triangulate/],
  'a vertex that is not there': [
    { socket: { ...round, faces: new Uint32Array([0, 1, 99]) } },
    /^cup.stl: a face names a vertex that is not there/,
  ],
  'half a face': [{ socket: { ...round, faces: new Uint32Array([0, 1]) } }, /^cup.stl: ends within a point or a face/],
  'no number': [{ ball: { ...whole, positions: whole.positions.map((x, i) => (i ? x : NaN)) } }, /^head.stl: 1 vertex has/],
  'one mesh for both': [{ socket: { ...whole, name: 'again.stl' } }, /^again.stl: is the mesh of the ball and of the socket; check ball and socket$/],
  'centimetres beside mm': [{ ball: octahedron('head.stl', 2) }, /^cup.stl: lies .* check that both meshes are in mm/],
  'centre outside': [{ centre: [300, 0, 0] }, /^head.stl: fills only .* give a centre inside as X, Y, Z/],
  'centre of text': [{ centre: [1, 2] }, /^centre: is not three numbers/],
  side: [{ side: 'middle' }, /^side 'middle' is neither left nor right$/],
  axes: [{ axes: 'RAX' }, /^axis code 'RAX' has an unknown letter/],
};

for (const [name, [change, message]] of Object.entries(bad)) {
  test(`a joint that cannot be is refused, and the older one stays: ${name}`, async () => {
    const { smallest_gap: smallest } = await one('pose', { pose: { flexion: 60 } });
    const request = { source: 'files', side: null, centre: [0, 0, 0], ball: whole, socket: round, ...change };
    const refused = await one('joint', request);
    assert.equal(refused.ok, false);
    assert.match(refused.error, message);
    assert.deepEqual((await one('pose', { pose: { flexion: 60 } })).smallest_gap, smallest);
  });
}

test('other questions that cannot be answered are refused in one line', async () => {
  const asked = [
    ['joint', { source: 'preset', name: 'nobody' }, /^there is no hip 'nobody'; there are normal, /],
    ['joint', { source: 'preset', name: 'cam', parameters: { cam_height: 99 } }, /^parameter cam_height = 99 is outside/],
    ['tables', { scheme: 'nothing' }, /^unknown scheme 'nothing'; there are /],
    ['tables', { scheme: 'rsid', precision_deg: 0.35 }, /^an RSID precision divides 180 degrees/],
    ['tables', { precision_deg: 0.01 }, /^precision_deg: 0.01 is out of range; give a number 0.2 or more$/],
    ['tables', { storage: 'int8' }, /^storage: there is no 'int8'; there are double, float, uint16$/],
    ['pose', { pose: { flexion: 999 } }, /^pose: an angle is not within 180 degrees of 0$/],
    ['pose', { cartilage_mm: -1 }, /^cartilage_mm: -1 is out of range/],
    ['sweep', { motions: ['waving'] }, /^unknown motion 'waving'; there are /],
    ['dance', {}, /^unknown question 'dance'$/],
  ];
  for (const [kind, request, message] of asked) {
    const reply = await one(kind, request);
    assert.equal(reply.ok, false, kind);
    assert.match(reply.error, message);
    assert.ok(!reply.error.includes('\n'));
  }
});

// Of the cam: what stands beside the ball blocks a motion that the ball alone does not; landmarks turn the frame and are told.
test('parts and landmarks come from files', async () => {
  const { ball, socket } = await one('joint', { source: 'preset', name: 'cam', parameters: {} });
  const named = (name, { positions, faces }) => ({ name, positions: Float64Array.from(positions), faces });
  const request = { source: 'files', side: 'right', centre: [0, 0, 0], ball: named('femur.ply', ball), socket: named('pelvis.ply', socket) };
  const limit = async () => (await one('limits', { motions: ['flexion'] })).limits[0];
  assert.equal((await one('joint', request)).error, undefined);
  const alone = await limit();
  assert.equal(alone.state, 'limited');
  const beside = { ...request, ball: { ...request.ball, parts: [octahedron('trochanter.ply', 8, [25, 0, -60])] }, socket: { ...request.socket, parts: [octahedron('spine.ply', 6, [25, 60, -5])] } };
  assert.equal((await one('joint', beside)).error, undefined);
  const withParts = await limit();
  assert.ok(withParts.high_deg < alone.low_deg, JSON.stringify([alone, withParts]));
  assert.match(withParts.what, /trochanter/);
  assert.match((await one('joint', { ...request, socket: { ...request.socket, parts: [{ ...octahedron('spine.ply', 6), faces: new Uint32Array([0, 1, 99]) }] } })).error, /^spine.ply: /);
  const rows = { asis_right: [20, 40, 80], asis_left: [-180, 40, 80], pubic_tubercle_right: [-60, 20, -10], pubic_tubercle_left: [-100, 20, -10] };
  const text = ['label,x,y,z', ...Object.entries(rows).map(([label, place]) => [label, ...place].join())].join('\n');
  const marked = await one('joint', { ...request, landmarks: { name: 'points.csv', text } });
  assert.equal(marked.error, undefined);
  assert.ok(Math.abs(marked.frames.pelvic_tilt_deg - Math.atan2(20, 90) * 180 / Math.PI) < 1e-9, marked.frames.pelvic_tilt_deg);
  assert.equal(marked.frames.scanned_flexion_deg, null);
  assert.equal((await one('joint', request)).frames, null);
  assert.match((await one('joint', { ...request, landmarks: { name: 'points.csv', text: 'label,x,y,z\nnose,1,2,3' } })).error, /^points.csv: its labels are of no landmark: nose; call them asis_right/);
});

test('triangles without shared corners are welded, and the centre is found', async () => {
  // Both hips of the same numbers, once with corners shared and once without.
  const { ball, socket, side } = await one('joint', { source: 'preset', name: 'normal', parameters: {} });
  const named = (name, mesh) => ({ name, positions: Float64Array.from(mesh.positions), faces: mesh.faces });
  const shared = { source: 'files', side, centre: null, ball: named('b', ball), socket: named('s', socket) };
  const joint = await one('joint', shared);
  assert.equal(joint.error, undefined);
  assert.ok(joint.fit.residual_mm < 0.1 && Math.abs(joint.fit.radius_mm - 24) < 0.1, JSON.stringify(joint.fit));
  assert.ok(Math.hypot(...joint.centre) < 0.1);
  const soup = await one('joint', { ...shared, ball: soupOf(named('b', ball)), socket: soupOf(named('s', socket)) });
  assert.equal(soup.ball.positions.length, joint.ball.positions.length);
  assert.ok(soup.centre.every((x, k) => Math.abs(x - joint.centre[k]) < 0.05));
});
