// SPDX-License-Identifier: GPL-3.0-or-later
// What the page says of what is proven: ends no higher or no lower than they are, and what a limit does not cover.
'use strict';

const assert = require('node:assert/strict');
const { before, test } = require('node:test');

const { pageModules } = require('./page_modules.js');

let words;

before(async () => {
  words = await pageModules('cut_panel', 'elements', 'engine_client', 'export_panel', 'files_panel', 'joint_words', 'limits_panel', 'making', 'measures_panel', 'mesh_files', 'messages', 'names', 'plots', 'pose_words', 'poses', 'proof', 'readouts', 'session_file', 'slow_worker', 'state', 'sweep_panel', 'volume_panel');
});

/** What a panel writes into, by id, in place of a document. */
function fakePage() {
  const element = (name) => ({ name, textContent: '', attributes: {}, children: [], listeners: {}, classes: new Set(), disabled: false,
    get classList() { return { add: (each) => this.classes.add(each), remove: (each) => this.classes.delete(each) }; },
    setAttribute(key, value) { this.attributes[key] = String(value); },
    getAttribute(key) { return this.attributes[key]; },
    addEventListener(kind, act) { this.listeners[kind] = act; },
    getBoundingClientRect: () => ({ left: 0, width: 320 }),
    append(...parts) { this.children.push(...parts); },
    replaceChildren(...parts) { this.children = parts; this.textContent = parts.map((part) => part.textContent).join(' '); } });
  const shown = {};
  globalThis.document = { getElementById: (id) => (shown[id] ??= element(id)), createElement: element, createElementNS: (_, name) => element(name) };
  return shown;
}

/** Questions that are answered when a test says so: ask(request), and asked with { request, answer(reply), refuse(error) }. */
function heldQuestions() {
  const asked = [];
  return { asked, ask: (request) => new Promise((answer, refuse) => asked.push({ request, answer, refuse })) };
}
const soon = (ms = 0) => new Promise((done) => setTimeout(done, ms));

const LIMIT = {
  motion: 'fadir', centre: 'ball', threshold_mm: 0, state: 'limited', low_deg: 53.56789, high_deg: 53.56791, clock: '1:20',
  centre_low_deg: 40.06, centre_high_deg: 60.04, play_low_deg: 39.06, play_high_deg: null,
  half_mm_gap_deg: 50.06, hangs_on_less_than_half_mm: false, leaves_ball_mesh_deg: null, meets: 'rim and neck', what: 'rim and neck', unknown_by: null,
};

test('ends are rounded outward', () => {
  const { roundedDown, roundedUp, boundLength } = words;
  assert.deepEqual([roundedDown(53.56, 1), roundedUp(53.54, 1), roundedDown(53.6, 1), roundedUp(53.6, 1)], ['53.5', '53.6', '53.6', '53.6']);
  assert.deepEqual([roundedDown(-0.04, 1), roundedUp(-0.04, 1), roundedDown(179.9, 0)], ['-0.1', '0.0', '179']);
  assert.deepEqual([0, 0.0123401, 0.09991, 0.09999, 0.5, 1.2301, 9.991].map(boundLength),
    ['0 µm', '12.4 µm', '0.100 mm', '0.100 mm', '0.500 mm', '1.24 mm', '10.0 mm']);
  for (let k = 1; k < 10000; k += 1) {
    const value = 200 * Math.sin(k);
    const [low, high] = [Number(roundedDown(value, k % 5)), Number(roundedUp(value, k % 5))];
    assert.ok(low <= value && value <= high && high - low < 1.000001 * 10 ** -(k % 5), `${low} ${value} ${high}`);
  }
});

test('a limit is told with ends rounded outward, for any centre and with play', () => {
  const told = words.limitWords(LIMIT);
  assert.match(told, /^Bones first touch between 53\.5678° and 53\.5680°, at 1:20 o’clock, rim and neck \(certified: no contact is skipped\)/);
  assert.match(told, /any centre within 0\.5 mm: at 40\.0° to 60\.1°; with that much play of the ball: not before 39\.0°\./);
  assert.match(told, /falls to 0\.5 mm at 50\.0°\.$/);
  const sensitive = { ...LIMIT, hangs_on_less_than_half_mm: true, what: 'rim and neck; sensitive to 0.5 mm of play; the ball’s mesh ends from 30.0' };
  assert.match(words.limitWords(sensitive), /at 50\.0°\. This limit is sensitive to 0\.5 mm of play, by more than 5°\.$/);
  const without = { ...LIMIT, half_mm_gap_deg: null };
  assert.match(words.limitWords(without), /not before 39\.0°\.$/);
  assert.match(words.limitWords({ ...sensitive, half_mm_gap_deg: null }), /not before 39\.0°\. This limit is sensitive to 0\.5 mm of play, by/);
  assert.match(words.limitWords({ ...LIMIT, centre_low_deg: 0, centre_high_deg: null }), /within 0\.5 mm: not known;/);
  assert.match(words.limitWords({ ...LIMIT, state: 'free', low_deg: 119.7 }), /up to 119°/);
  assert.match(words.limitWords({ ...LIMIT, state: 'unknown', unknown_by: 'graze' }), /up to 53\.5° \(certified\), where surfaces graze/);
  assert.match(words.limitWords({ ...LIMIT, state: 'unknown', unknown_by: 'opening' }), /hangs on an opening of a mesh; nothing is known beyond/);
});

test('a limit beyond the ball’s mesh says so', () => {
  const told = words.limitWords({ ...LIMIT, leaves_ball_mesh_deg: 30.06 });
  assert.match(told, /The ball’s mesh ends under the socket from 30\.0° on: what is missing may come first\.$/);
  const unknown = words.limitWords({ ...LIMIT, state: 'unknown', unknown_by: 'end of ball', leaves_ball_mesh_deg: 53.56789 });
  assert.match(unknown, /up to 53\.5° \(certified\), where the motion leaves the ball’s mesh; nothing is known beyond/);
  assert.doesNotMatch(unknown, /come first/);
});

test('proven gaps and bounds are rounded outward', () => {
  const shown = {};
  globalThis.document = { getElementById: (id) => (shown[id] ??= { textContent: '' }) };
  const proof = new words.Proof(() => {}, assert.fail);
  proof.show({ clear: 5, impinged: 0, undecided: 0, vertices_without_bound: 0, vertices_measured_on_the_faces: 1, largest_mm: 1.2301, median_mm: 0.0123401,
    smallest_gap_between_mm: [-0.0704, 0.0512] });
  assert.equal(shown['smallest-proven'].textContent, '−0.071 to 0.052 mm');
  assert.deepEqual(['bound', 'bound-half'].map((id) => shown[id].textContent), ['± 1.24 mm', '± 12.4 µm']);
});

test('what is proven of one pose does not stand beside another', async () => {
  const shown = fakePage();
  const { asked, ask } = heldQuestions();
  const proof = new words.Proof(ask, assert.fail);
  const verdicts = (low) => ({ clear: 5, impinged: 0, undecided: 0, vertices_without_bound: 0, vertices_measured_on_the_faces: 1, largest_mm: 1, median_mm: 1, smallest_gap_between_mm: [low, low] });
  const pose = (flexion) => ({ pose: { flexion }, translation: [0, 0, 0] });
  const proven = () => ['smallest-proven', 'bound-half', 'undecided', 'bound'].map((id) => shown[id].textContent);
  proof.forget();
  proof.begin(pose(10));
  asked[0].answer(verdicts(3));
  await soon();
  assert.deepEqual(proven(), ['3.000 mm', '± 1.00 mm', '0', '± 1.00 mm']);
  proof.posed(pose(10)); // other colours: the same pose
  assert.equal(shown['smallest-proven'].textContent, '3.000 mm');
  asked[1].answer(verdicts(3));
  await soon();
  proof.posed(pose(20));
  assert.deepEqual(proven(), ['–', '–', '–', 'proving … 0 s']);
  proof.posed(pose(30));
  asked[2].answer(verdicts(2)); // of 20 degrees
  await soon();
  assert.deepEqual(proven(), ['–', '–', '–', 'proving … 0 s']);
  asked[3].answer(verdicts(1));
  await soon();
  assert.equal(shown['smallest-proven'].textContent, '1.000 mm');
});

test('a sweep goes with its own motion, and nothing is left of it when another is asked for', async () => {
  const shown = fakePage();
  const { asked, ask } = heldQuestions();
  const app = { state: words.firstState() };
  const poses = [];
  const panel = new words.SweepPanel(app, ask, (pose) => poses.push(pose));
  const start = { flexion: 0, abduction: 0, internal_rotation: 0 };
  panel.setCatalogue({ motions: [{ name: 'flexion', growing: 'flexion', meaning: '', start }, { name: 'abduction', growing: 'abduction', meaning: '', start }] });
  const found = (low) => ({ angles: [0, 50, 100], smallest: [3, NaN, 1], limits: [{ ...LIMIT, low_deg: low }] });
  panel.again(0);
  await soon(5);
  asked[0].answer(found(90));
  await soon();
  assert.equal(shown['sweep-go'].disabled, false);
  assert.match(shown['sweep-say'].textContent, /first touch between 90/);
  app.state.sweep = 'abduction';
  shown['sweep-go'].listeners.click(); // before another is asked for: along the motion that was swept
  assert.deepEqual(poses, [{ ...start, flexion: 90 }]);
  panel.again(5);
  assert.deepEqual([shown['sweep-go'].disabled, shown['sweep-say'].textContent], [true, 'Working …']);
  shown['sweep-go'].listeners.click();
  shown['sweep-plot'].listeners.click({ clientX: 160 });
  panel.posed();
  assert.equal(poses.length, 1);
  await soon(10);
  panel.again(1000); // what is under way is of what was before
  asked[1].answer(found(40));
  await soon();
  assert.equal(shown['sweep-say'].textContent, 'Working …');
  assert.ok(shown['sweep-plot'].classes.has('old'));
  clearTimeout(panel.timer);
  panel.run();
  asked[2].refuse(new words.Told('no such motion'));
  await soon();
  assert.equal(shown['sweep-say'].textContent, 'no such motion');
  shown['sweep-plot'].listeners.click({ clientX: 160 });
  assert.equal(poses.length, 1);
});

test('tables are asked for once, and again where they went with a joint that was cancelled', async () => {
  const shown = fakePage();
  const { asked, ask } = heldQuestions();
  const live = { ask: (kind, request) => ask([kind, request]), restart: () => asked.forEach(({ refuse }) => refuse(new words.Stale())) };
  const told = [];
  const make = words.maker(live, { onTables: (_, request) => told.push(request), onJoint: (_, { joint }) => told.push(joint), onRefused: (error, { joint }) => told.push([error.constructor, joint]) });
  const kinds = () => asked.map(({ request: [kind, request] }) => [kind, request.precision_deg ?? request]);
  const of = (precision) => ({ ...words.firstState().tables, precision_deg: precision });
  make.tables(of(0.35)); // as the library has them at first
  assert.equal(asked.length, 0);
  make.joint({ request: 'cam', own: null, joint: 'a' });
  asked[0].answer({});
  make.tables(of(1));
  await soon();
  asked[1].answer({});
  await soon();
  make.tables(of(1));
  make.joint({ request: 'own', own: {}, joint: 'b' });
  make.tables(of(0.35)); // of a session with the tables that a page has at first
  shown['stage-cancel'].listeners.click();
  await soon();
  asked.slice(4).forEach(({ answer }) => answer({}));
  await soon();
  assert.deepEqual(kinds(), [['joint', 'cam'], ['tables', 1], ['joint', 'own'], ['tables', 0.35], ['joint', 'cam'], ['tables', 1], ['tables', 0.35]]);
  assert.deepEqual(told, ['a', of(1), [words.Stale, 'b'], of(0.35)]);
  make.tables(of(2));
  asked.at(-1).refuse(new words.Told('too fine'));
  await soon();
  assert.equal(shown['message-text'].textContent, 'too fine');
  make.tables(of(2)); // refused before
  assert.deepEqual(kinds().slice(-2), [['tables', 2], ['tables', 2]]);
});

test('a pose that went with a joint that was cancelled is asked for again', async () => {
  const { asked, ask } = heldQuestions();
  const app = { ready: true, state: words.firstState() };
  const view = { parts: { fromJointFrame: () => ({ toArray: () => [0, 0, 0] }) } };
  const poses = new words.Poses(app, view, { ask, onPose: assert.fail, fault: assert.fail });
  poses.again();
  app.state.motion.flexion = 30;
  asked[0].refuse(new words.Stale());
  await soon();
  assert.deepEqual(asked.map(({ request }) => request.pose.flexion), [0, 30]);
});

test('all of the area is in the histogram, and zones of the clock that are left out are seen', () => {
  const bars = words.barsBetween(-1, 1, { first_mm: -2, bin_mm: 0.5 }, { area_mm2: [1, 2, 3, 4, 5, 6, 7, 8], below_mm2: 10, beyond_mm2: 20 });
  assert.deepEqual(bars.map(({ from, to, area }) => [from, to, area]), [[-2, -1, 13], [-1, -0.5, 3], [-0.5, 0, 4], [0, 0.5, 5], [0.5, 1, 6], [1, 2, 35]]);
  const zone = (from) => ({ clock_from: `${from}:00`, clock_to: `${from + 1}:00` });
  assert.equal(words.zones([1, 3, 5].map(zone)), '1:00 to 2:00, 3:00 to 4:00, 5:00 to 6:00');
  assert.equal(words.zones([1, 3, 5, 7].map(zone)), '1:00 to 2:00, 3:00 to 4:00, 5:00 to 6:00, …');
  assert.equal(words.zones([]), '–');
});

test('the curve of a motion is broken where surfaces do not face each other', () => {
  fakePage();
  const svg = document.createElementNS('', 'svg');
  const draw = (at) => {
    words.drawSweep(svg, { angles: [0, 10, 20, 30, 40], smallest: [3, 2, NaN, NaN, 1], limits: [{ state: 'free' }] }, { title: 'flexion', cartilage: 0, at });
    const [curve, now] = ['curve', 'now'].map((name) => svg.children.find(({ attributes }) => attributes.class === name));
    return [curve.attributes.d.replace(/[\d. ]+/g, ''), Boolean(now)];
  };
  assert.deepEqual([draw(10), draw(22), draw(null)], [['MLM', true], ['MLM', false], ['MLM', false]]);
});

test('what makes limits too large is said as the program says it', () => {
  const { missingWords } = words;
  assert.equal(missingWords([]), '');
  assert.equal(missingWords([{ ball_cut_mm: null, rim_in_head_mm: null }]), '');
  assert.match(missingWords([{ ball_cut_mm: 45.04, rim_in_head_mm: null }]), /^The ball’s bone is cut off 45\.0 mm from the centre, through its neck: .* limits may be too large; give the whole bone\.$/);
  assert.equal(missingWords([{ ball_cut_mm: null, rim_in_head_mm: 1.21 }]), 'The rim lies in the head as scanned, up to 1.3 mm deep: there it meets the neck late, or not at all.');
});

test('a required motion is reached where it is known to be', () => {
  const of = (state, low) => words.reached({ state, low_deg: low }, 30);
  assert.deepEqual([of('free', 30), of('limited', 45.67), of('limited', 12.34), of('unknown', 30), of('unknown', 12.34), of('blocked', 0)],
    ['yes', 'yes, to 45.6°', '12.3°', 'yes', 'not before 12.3°', 'no']);
});

test('a range of rotation is that of the middle of a square of the map', () => {
  const map = { range_deg: [10, -1, -2, 44.9], step: 5, flexion: [85, 95], abduction: [-5, 5] };
  const at = (flexion, abduction) => words.squareWords(words.squareAt(map, { flexion, abduction }));
  assert.equal(at(95, 3), 'In the middle of this pose’s square, at flexion 92.5° and abduction 2.5°, 44° of rotation are without contact, internal and external together.');
  assert.match(at(90, -5), /at flexion 92\.5° and abduction −2\.5°, it is undecided/);
  assert.match(at(86, 1), /at flexion 87\.5° and abduction 2\.5°, the hip is blocked/);
  assert.equal(at(96, 0), 'This pose is outside of the map.');
});

test('a fault is told in words of the page, not of JavaScript', async () => {
  const { Told, inWords, readMesh } = words;
  const { inWords: workerInWords } = require('../../analysis/joint3d/src/worker.js');
  const seen = [];
  const { error: log } = console;
  console.error = (error) => seen.push(error);
  try {
    assert.equal(inWords(new Told('cup.stl: is empty; give a mesh')), 'cup.stl: is empty; give a mesh');
    for (const error of [new RangeError('Array buffer allocation failed'), new Error('Out of memory')]) {
      assert.match(inWords(error), /^there is not enough memory; choose/);
      assert.match(workerInWords(error), /^there is not enough memory; choose/);
    }
    for (const error of [new TypeError("Cannot read properties of undefined (reading 'x')"), new Error('unreachable')]) {
      for (const told of [inWords(error), workerInWords(error)]) {
        assert.match(told, /load (it|the page) again/);
        assert.ok(!told.includes(error.message), told);
      }
    }
  } finally {
    console.error = log;
  }
  assert.equal(seen.length, 2, 'what the page does not know goes to the console, where tests see it');
  const file = (name, bytes) => ({ name, size: 9, arrayBuffer: () => (bytes instanceof Error ? Promise.reject(bytes) : Promise.resolve(bytes)) });
  await assert.rejects(readMesh(file('a.ply', new RangeError('Array buffer allocation failed'))), /^BadFile|a\.ply: there is not enough memory/);
  const short = new TextEncoder().encode('solid').buffer; // a RangeError of a DataView, which is no lack of memory
  await assert.rejects(readMesh(file('short.stl', short)), ({ message }) => /^short\.stl: it cannot be read as a mesh; /.test(message));
  await assert.rejects(readMesh(file('a.ply', new ArrayBuffer(9))), ({ message }) => /^a\.ply: .*; /.test(message) && !/undefined|Cannot read/.test(message));
});

test('an STL in capitals is read, and a file of VTK refused', async () => {
  const text = 'SOLID A\nFACET NORMAL 0 0 1\nOUTER LOOP\nVERTEX 0 0 0\nVERTEX 1.5E1 0 0\nVERTEX 0 1 0\nENDLOOP\nENDFACET\nENDSOLID A\n';
  const file = (name) => ({ name, size: text.length, arrayBuffer: () => Promise.resolve(new TextEncoder().encode(text).buffer) });
  assert.deepEqual([...(await words.readMesh(file('A.STL'))).positions], [0, 0, 0, 15, 0, 0, 0, 1, 0]);
  await assert.rejects(words.readMesh(file('a.vtp')), ({ message }) => message === 'a.vtp: this kind of file is not read here; save it as PLY, STL or OBJ, or use the program impinge');
});

test('a PLY is read whole or refused', async () => {
  const read = (faces, { properties = 'property list uchar int vertex_indices', count = faces.length, points = 6, end = '\n', format = 'ascii' } = {}) => {
    const head = `ply\nformat ${format} 1.0\ncomment SPACE=LPS\nelement vertex ${points}\nproperty float x\nproperty float y\nproperty float z\nelement face ${count}\n${properties}\nend_header\n`;
    const corners = Array.from({ length: points }, (_, k) => [k, k * k, 1 + k]);
    if (format === 'ascii') return words.readMesh(new File([head + [...corners, ...faces].map((row) => row.join(' ')).join('\n') + end], 'a.ply'));
    const body = Buffer.concat([...corners.flat().map((x) => { const of = Buffer.alloc(4); of.writeFloatBE(x); return of; }),
      ...faces.flatMap(([n, ...of]) => [Buffer.from([n]), ...of.map((v) => { const as = Buffer.alloc(4); as.writeInt32BE(v); return as; })])]);
    return words.readMesh(new File([head, body], 'a.ply'));
  };
  const mixed = [[3, 0, 1, 2], [4, 0, 1, 2, 3]];
  for (const format of ['ascii', 'binary_big_endian']) {
    assert.deepEqual([...(await read(mixed, { format })).faces], [0, 1, 2, 0, 1, 2, 0, 2, 3]);
    await assert.rejects(read([...mixed, [5, 0, 1, 2, 3, 4]], { format }), ({ message }) => message === 'a.ply: it has faces of five corners or more, or its end is missing; triangulate the mesh and save it again');
    await assert.rejects(read([], { format }), ({ message }) => message === 'a.ply: there are no faces in it; give a surface mesh');
    await assert.rejects(read([[2, 0, 1]], { format }), /there are no faces in it/);
  }
  await assert.rejects(read(mixed, { count: 3 }), /its end is missing/); // one line too few
  await assert.rejects(read([[3, 0, 1, 2], [3, 0, 1]]), /its end is missing/);
  await assert.rejects(read([[3, 0, 1, 2]], { points: 9, count: 9 }), /its end is missing/);
  const coloured = { properties: ['list uchar int vertex_index', 'uchar red', 'uchar green', 'uchar blue'].map((each) => `property ${each}`).join('\n') };
  assert.equal((await read([[3, 0, 1, 2, 9, 9, 9], [4, 0, 1, 2, 3, 9, 9, 9]], coloured)).positions.length, 27); // the loader takes its faces apart
  await assert.rejects(read([[3, 0, 1, 2, 9, 9, 9], [5, 0, 1, 2, 3, 4, 9, 9, 9]], coloured), /five corners/);
});

test('a unit is offered where a human head would have it', () => {
  assert.deepEqual(words.likelyUnits(24, 'mm'), []);
  assert.deepEqual(words.likelyUnits(0.024, 'mm'), ['m']);
  assert.deepEqual(words.likelyUnits(2.4, 'mm'), ['cm']);
  assert.deepEqual(words.likelyUnits(24000, 'm'), ['mm']);
});

test('names of files say joint and pose, and none is empty', () => {
  const state = { motion: { flexion: 90, abduction: -10.25, internal_rotation: 0 }, offset: [0, 0, 1] };
  assert.equal(words.fileStem('Patient A (stand-in)', 'right', state), 'patient_a_stand_in_right_flexion_90_adduction_10.25_shifted');
  assert.equal(words.fileStem('Fémur 1.ply and acetabulum.stl', null, { motion: {}, offset: [0, 0, 0] }), 'femur_1_and_acetabulum');
  assert.equal(words.poseWords(state), 'Flexion 90°, adduction 10.25°; ball shifted by 0.0, 0.0, 1.0 mm to the right, forward, up');
  assert.equal(words.poseWords({ motion: { flexion: 0, abduction: 0, internal_rotation: 0 }, offset: [0, 0, 0] }), 'All angles 0');
});

test('motions and hips have the names that a reader knows', () => {
  const { motionLabel, presetLabel } = words;
  const labels = [['flexion', 'flexion', 'thigh forward'], ['internal_rotation_at_45', 'internal_rotation', 'at 45 degrees of flexion'], ['fadir', 'internal_rotation', 'at 90 of flexion']]
    .map(([name, growing, meaning]) => motionLabel({ name, growing, meaning }));
  assert.deepEqual(labels, ['Flexion (thigh forward)', 'Internal rotation at 45 degrees of flexion', 'FADIR (at 90 of flexion)']);
  assert.deepEqual(['cam', 'patient_a'].map(presetLabel), ['Cam', 'Patient A (stand-in)']);
});

test('measures that are refused are named, once a reason', () => {
  const of = (measure, refused) => ({ measure, state: refused ? `refused: ${refused}` : 'measured', value: refused ? null : 1 });
  assert.equal(words.refusedWords([of('version', null), of('head_radius', null)]), '');
  const some = [of('version', 'no rim'), of('alpha_at_1_30', 'no neck'), of('head_neck_offset', 'no neck'), of('alpha_at_12', 'no neck'), of('coverage', null)];
  assert.equal(words.refusedWords(some), 'Left out: Version of the socket (no rim); Head-neck offset, Alpha at 1:30, 12 o’clock (no neck).');
});

test('a file of limits has a cell for every column, and quotes a name', () => {
  const limits = [LIMIT, { ...LIMIT, centre: 'socket', state: 'free', clock: null, what: '' }, { ...LIMIT, threshold_mm: 4, half_mm_gap_deg: null, what: 'rim and head; sensitive to 0.5 mm of play' }];
  const [head, ...lines] = words.limitsCsv('cam, right', [{ limits }]).trim().split('\n');
  assert.equal(head.split(',').length, 15);
  assert.equal(lines[0], '"cam, right",fadir,0,ball,limited,53.56789,53.56791,40.06,60.04,50.06,1:20,rim and neck,39.06,,no');
  assert.equal(lines[1], '"cam, right",fadir,0,socket,free,53.56789,53.56791,40.06,60.04,50.06,,,39.06,,no');
  const shifted = words.limitsCsv('cam', [{ limits: [limits[2]] }], 'ball shifted by 0.0, 1.0, 0.0 mm').split('\n');
  assert.match(shifted[1], /^cam,.*,"ball shifted by 0.0, 1.0, 0.0 mm; rim and head; sensitive to 0.5 mm of play",39\.06,,no$/);
  assert.equal(lines[2], '"cam, right",fadir,4,ball,limited,53.56789,53.56791,40.06,60.04,,1:20,rim and head; sensitive to 0.5 mm of play,39.06,,no');
});

test('a state comes back from its fragment, with the camera, and nonsense is left out', async () => {
  const { firstState, fromFragment, toFragment } = words;
  const state = firstState();
  state.look.camera = [1, -2.5, 3, 0, 0.5, 0];
  Object.assign(state, { offset: [1, 0, -0.5], held: true, rim: true, required: 'flexion=90, abduction=-10; extension=5', clearance: 0.7, tilt: -4 });
  state.joint = { name: 'own', side: 'left', parameters: {} };
  assert.deepEqual(fromFragment(`#${toFragment(state)}`), state);
  for (const camera of ['1,2,3', '1,2,3,4,5,x', '1,2,3,4,5,1e9', '']) assert.equal(fromFragment(`#camera=${camera}`).look.camera, null);
  assert.deepEqual(fromFragment('#motion'), firstState());
});

test('a session comes back from its file, with the files as they were given', async () => {
  const { firstState, ownRequest, readMesh, readSession, sessionBytes, toFragment } = words;
  const text = (x) => `v 0 0 0\nv ${x} 0 0\nv 0 1 0\nf 1 2 3\n`;
  const mesh = (name, x) => readMesh(new File([text(x)], name));
  const points = new File(['label,x,y,z\n'], 'points.csv');
  const own = { ball: { ...await mesh('bone.obj', 1), parts: [await mesh('bone.obj', 2)] }, socket: { ...await mesh('session.json.obj', 3), parts: [] },
    landmarks: { name: 'points.csv', text: await points.text(), file: points }, side: 'left', axes: '', unit: 'mm', centre: [1, -2, 0.5] };
  const state = firstState();
  state.motion.flexion = 42;
  state.joint = { name: 'own', side: 'left', parameters: {} };
  const packed = new File([await sessionBytes(state, own, { program: 'impinge 1.0.0', commit: 'abc' })], 'session.zip');
  const { fragment, files, fields } = await readSession(packed);
  assert.equal(fragment, toFragment(state));
  assert.deepEqual(fields, { side: 'left', axes: '', unit: 'mm', centre: [1, -2, 0.5] });
  assert.deepEqual(Object.fromEntries(Object.entries(files).map(([key, list]) => [key, list.map(({ name }) => name)])),
    { ball: ['bone.obj'], socket: ['session.json.obj'], ball_parts: ['2_bone.obj'], socket_parts: [], landmarks: ['points.csv'] });
  assert.deepEqual(await Promise.all([files.ball[0], files.ball_parts[0], files.socket[0]].map((file) => file.text())), [1, 2, 3].map(text));
  const { ball, landmarks, axes } = ownRequest(own);
  assert.deepEqual([[...ball.parts[0].positions].slice(3, 6), ball.parts[0].file, landmarks, axes], [[2, 0, 0], undefined, { name: 'points.csv', text: 'label,x,y,z\n' }, null]);
  const preset = await readSession(new File([await sessionBytes(firstState(), null, {})], 'a.zip'));
  assert.deepEqual([preset.fragment, preset.files], [toFragment(firstState()), null]);
  for (const wrong of ['', 'PK', text(1)]) await assert.rejects(readSession(new File([wrong], 'a.zip')), ({ message }) => message === 'a.zip: it is no session; choose a session that Joint3D has saved');
});

test('whole bones and landmarks are told', () => {
  const taken = words.takenWords({ ball: { faces: 4321, of: 60000, within_mm: 31.04 }, socket: null });
  assert.deepEqual(taken, ['Of the femur 4,321 of 60,000 faces, within 31.0 mm of the centre, are the ball; the rest counts as bone beside it.']);
  assert.deepEqual(words.framesWords(null), []);
  assert.match(words.framesWords({ pelvic_tilt_deg: -4.06, scanned_flexion_deg: 1, scanned_abduction_deg: -2, scanned_internal_rotation_deg: 3 })[0], /tilted by −4\.1° in the scan; angles are counted from neutral, .* flexion 1\.0°, abduction −2\.0°, internal rotation 3\.0°\.$/);
});

test('what is asked while tables follow a joint is asked of that joint', async () => {
  const sent = [];
  const client = { ask: async (kind, request) => { sent.push([kind, request]); return { bound_mm: null }; } };
  const slow = new words.SlowWorker(client, { rest: 5, onBound() {}, fault: assert.fail });
  slow.follow({ joint: 'cam' });
  const first = slow.ask('measure');
  slow.follow({ tables: 'fine' }); // before the joint was sent
  await first;
  await slow.ask('sweep', 'flexion');
  assert.deepEqual(sent, [['joint', 'cam'], ['tables', 'fine'], ['measure', undefined], ['sweep', 'flexion']]);
  await new Promise((done) => setTimeout(done, 150));
  assert.deepEqual(sent.slice(4), [['bound', undefined]]);
});

test('a worker that refuses a joint does not answer for the one before', async () => {
  const sent = [];
  const faults = [];
  const client = { restart: () => sent.push('restart'), ask: async (kind, request) => {
    sent.push([kind, request]);
    if (request === 'huge') throw new words.Told('there is not enough memory');
    return { bound_mm: null };
  } };
  const slow = new words.SlowWorker(client, { rest: 1, onBound() {}, fault: ({ message }) => faults.push(message) });
  slow.follow({ joint: 'cam' });
  slow.follow({ tables: 'fine' });
  await slow.rested();
  slow.follow({ joint: 'huge' });
  await slow.rested();
  assert.deepEqual(sent, [['joint', 'cam'], ['tables', 'fine'], ['joint', 'huge'], 'restart']);
  assert.deepEqual(faults, ['there is not enough memory']);
  slow.follow({ joint: 'pincer' }); // with the tables that the live one has
  await slow.rested();
  assert.deepEqual(sent.slice(4), [['joint', 'pincer'], ['tables', 'fine']]);
});

test('a file of gaps is of one pose, though a motion goes on', async () => {
  const { strFromU8, unzipSync } = await import('../../analysis/node_modules/three/examples/jsm/libs/fflate.module.js');
  const shown = fakePage();
  const saved = [];
  document.querySelector = () => ({ content: '1' });
  document.createElement = () => { const link = { append() {}, click: () => saved.push(link) }; return link; };
  const { createObjectURL } = URL;
  const { setTimeout: wait } = globalThis;
  const { asked, ask } = heldQuestions();
  let stopped = 0;
  const app = { state: words.firstState(), player: { stop: () => { stopped += 1; } } };
  const request = () => ({ pose: { ...app.state.motion } });
  const joint = { side: 'right' };
  new words.ExportPanel(app, {}, { ask: (kind, of) => ask([kind, of]), request, shown: () => ({ joint, pose: null, tables: {}, name: 'cam' }), write() {}, fault: assert.fail });
  let blob;
  URL.createObjectURL = (content) => { blob = content; return ''; };
  globalThis.setTimeout = () => {};
  try {
    app.state.motion.flexion = 30;
    shown['save-csv'].listeners.click();
    app.state.motion.flexion = 60;
    assert.deepEqual(asked.map(({ request: [kind, { pose }] }) => [kind, pose.flexion ?? pose.pose.flexion]), [['pose', 30], ['export', 30]]);
    asked[0].answer({ matrix: [1], smallest_gap: { gap_mm: 3 } });
    asked[1].answer({ bytes: new Uint8Array(1) });
    await new Promise(setImmediate);
  } finally {
    Object.assign(URL, { createObjectURL });
    globalThis.setTimeout = wait;
  }
  assert.equal(stopped, 1);
  assert.equal(saved[0].download, 'gaps_cam_right_flexion_30.zip');
  const { pose_deg: pose, smallest_gap: gap, columns } = JSON.parse(strFromU8(unzipSync(new Uint8Array(await blob.arrayBuffer()))['gaps.json']));
  assert.deepEqual([pose.flexion, gap.gap_mm], [30, 3]);
  assert.equal(columns.vertex, 'index in the mesh after welding, unless it is a whole bone');
});
