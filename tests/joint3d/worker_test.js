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

// Answers in the order of the messages, as postMessage() delivers them.
function ask(...messages) {
  const first = replies.length;
  messages.forEach((message, i) => send({ id: first + i, ...message }));
  return new Promise((resolve) => {
    const look = () => (replies.length >= first + messages.length ? resolve(replies.slice(first)) : setTimeout(look, 1));
    look();
  });
}

async function one(kind, request = {}) {
  return (await ask({ kind, ...request }))[0];
}

before(async () => {
  engine = require(process.env.JOINT3D_ENGINE)();
  await engine;
});

beforeEach(async () => {
  replies = [];
  // As postMessage() does: what is handed over is gone on this side.
  const post = (reply, transfer) => replies.push(structuredClone(reply, { transfer }));
  send = serve(engine, post, setImmediate);
  const reply = await one('joint', { source: 'preset', name: 'cam', parameters: {} });
  assert.equal(reply.error, undefined);
});

test('the catalogue is that of the library', async () => {
  const catalogue = await one('presets');
  assert.deepEqual(
    catalogue.presets.map((preset) => preset.name),
    ['normal', 'cam', 'pincer', 'mixed', 'dysplastic', 'patient_a', 'patient_b'],
  );
  assert.equal(catalogue.parameters.length, 30);
  for (const { key, least, most, step } of catalogue.parameters) {
    assert.ok(least < most && step > 0);
    for (const preset of catalogue.presets) assert.ok(preset.parameters[key] >= least && preset.parameters[key] <= most);
  }
  assert.deepEqual(catalogue.recorded.find((range) => range.motion === 'flexion').patient_a, 103.1);
  assert.ok(catalogue.motions.some((motion) => motion.name === 'fadir' && motion.start.flexion === 90));
  assert.ok(catalogue.schemes.length >= 13);
  for (const scheme of catalogue.schemes) assert.ok(scheme.label && scheme.precisions.includes(1), scheme.name);
});

test('every scheme and storage of the catalogue answers', async () => {
  const { schemes } = await one('presets');
  const { smallest } = await one('pose', { flexion: 80 });
  for (const scheme of schemes.filter(({ name }) => name !== 'conchoid')) {
    for (const storage of ['uint16', 'float', 'double']) {
      const tables = await one('tables', { scheme: scheme.name, precision_deg: 2, storage });
      assert.equal(tables.error, undefined);
      const pose = await one('pose', { flexion: 80 });
      assert.ok(Math.abs(pose.smallest.gap_mm - smallest.gap_mm) < 0.3, `${scheme.name} ${pose.smallest.gap_mm}`);
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
  assert.equal(joint.clock_marks.hours.length, 12);
  const { scheme, precision_deg, storage } = joint.tables;
  assert.deepEqual({ scheme, precision_deg, storage }, settings);
  const pose = await one('pose', { flexion: 90, cartilage_mm: 3 });
  assert.equal(pose.ball_gap.length, joint.ball.positions.length / 3);
  assert.equal(pose.socket_gap.length, joint.socket.positions.length / 3);
  assert.equal(pose.colours.ball.length, 5);
  assert.equal(pose.histogram.edges.length, pose.histogram.counts.length + 1);
  // Flexion turns up into forward: the column of z is (0, ...).
  assert.ok(Math.abs(pose.matrix[5]) < 1e-7 && Math.abs(Math.abs(pose.matrix[6]) - 1) < 1e-7);
});

test('only the newest pose that waits is looked at', async () => {
  const poses = [10, 20, 30].map((flexion) => ({ kind: 'pose', flexion }));
  const answers = await ask(...poses, { kind: 'presets' });
  assert.deepEqual(
    answers.map(({ ok, stale }) => [ok, stale]),
    [
      [false, true],
      [false, true],
      [true, undefined],
      [true, undefined],
    ],
  );
  assert.deepEqual(
    answers.map(({ id }) => id),
    [1, 2, 3, 4],
  );
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
  'another place': [{ socket: octahedron('far.stl', 1, [900, 0, 0]) }, /^far.stl: lies .* check that both meshes are in mm/],
  'centre outside': [{ centre: [300, 0, 0] }, /^head.stl: fills only .* give a centre inside as X, Y, Z/],
  'centre of text': [{ centre: [1, 2] }, /a point is three numbers/],
  side: [{ side: 'middle' }, /^side 'middle' is neither left nor right$/],
  axes: [{ axes: 'RAX' }, /^axis code 'RAX' has an unknown letter/],
};

for (const [name, [change, message]] of Object.entries(bad)) {
  test(`a joint that cannot be is refused, and the older one stays: ${name}`, async () => {
    const { smallest } = await one('pose', { flexion: 60 });
    const request = { source: 'files', side: null, centre: [0, 0, 0], ball: whole, socket: round, ...change };
    const refused = await one('joint', request);
    assert.equal(refused.ok, false);
    assert.match(refused.error, message);
    assert.deepEqual((await one('pose', { flexion: 60 })).smallest, smallest);
  });
}

test('other questions that cannot be answered are refused in one line', async () => {
  const asked = [
    ['joint', { source: 'preset', name: 'nobody' }, /^there is no hip 'nobody'; there are normal, /],
    ['joint', { source: 'preset', name: 'cam', parameters: { cam_height: 99 } }, /^parameter cam_height = 99 is outside/],
    ['tables', { scheme: 'nothing' }, /^unknown scheme 'nothing'; there are /],
    ['tables', { scheme: 'rsid', precision_deg: 0.35 }, /^an RSID precision divides 180 degrees/],
    ['tables', { precision_deg: 0.01 }, /choose a coarser precision/],
    ['tables', { storage: 'int8' }, /^unknown storage 'int8'/],
    ['pose', { flexion: 999 }, /^flexion is no angle/],
    ['pose', { cartilage_mm: -1 }, /^cartilage has/],
    ['sweep', { motion: 'waving' }, /^unknown motion 'waving'; there are /],
    ['dance', {}, /^unknown question 'dance'$/],
  ];
  for (const [kind, request, message] of asked) {
    const reply = await one(kind, request);
    assert.equal(reply.ok, false, kind);
    assert.match(reply.error, message);
    assert.ok(!reply.error.includes('\n'));
  }
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

test('a unit that no joint has is remarked on, and so is a ball that is a cap', async () => {
  const request = { source: 'files', side: null, centre: [0, 0, 0] };
  const warned = async (ball, socket) => (await one('joint', { ...request, ball, socket })).warnings.join();
  assert.equal(await warned(whole, round), '');
  for (const unit of [0.001, 0.1])
    assert.match(await warned(octahedron('head.stl', 20 * unit), octahedron('cup.stl', 24 * unit)), /^head.stl: has a radius of .* lengths are read as mm/);
  const three = { ...whole, faces: whole.faces.slice(0, 9) };
  assert.match(await warned(three, round), /^head.stl: is a cap, 3\d % of the view/);
});
