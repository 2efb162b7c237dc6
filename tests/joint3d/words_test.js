// SPDX-License-Identifier: GPL-3.0-or-later
// What the page says of what is proven: ends no higher or no lower than they are, and what a limit does not cover.
'use strict';

const assert = require('node:assert/strict');
const fs = require('node:fs');
const os = require('node:os');
const path = require('node:path');
const { after, before, test } = require('node:test');
const { pathToFileURL } = require('node:url');

// The page's modules, which a browser takes for modules without being told.
const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'joint3d-words-'));
const load = (name) => import(pathToFileURL(path.join(folder, name)));

let words;

before(async () => {
  fs.cpSync(path.join(__dirname, '../../analysis/joint3d/src'), folder, { recursive: true });
  fs.writeFileSync(path.join(folder, 'package.json'), '{ "type": "module" }');
  words = { ...await load('elements.js'), ...await load('sweep_panel.js'), ...await load('proof.js') };
});

after(() => fs.rmSync(folder, { recursive: true }));

const LIMIT = {
  about: 'ball', threshold_mm: 0, state: 'limited', low_deg: 53.56789, high_deg: 53.56791, clock: '1:20', within_mm: 0.5,
  centre_low_deg: 40.06, centre_high_deg: 60.04, play_low_deg: 39.06, play_high_deg: null,
  half_mm_gap_deg: 50.06, hangs_on_less: false, leaves_ball_mesh_deg: null,
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
  assert.match(told, /^Bones first touch between 53\.5678° and 53\.5680°, at 1:20 o’clock: a certified limit/);
  assert.match(told, /any centre within 0\.5 mm: at 40\.0° to 60\.1°; with that much play of the ball: not before 39\.0°\./);
  assert.match(told, /falls to 0\.5 mm at 50\.0°\.$/);
  assert.match(words.limitWords({ ...LIMIT, centre_low_deg: 0, centre_high_deg: null }), /within 0\.5 mm: not known;/);
  assert.match(words.limitWords({ ...LIMIT, state: 'free', low_deg: 119.7 }), /up to 119°/);
  assert.match(words.limitWords({ ...LIMIT, state: 'unknown' }), /up to 53\.5° \(certified\), where surfaces graze/);
});

test('a limit beyond the ball’s mesh says so', () => {
  const told = words.limitWords({ ...LIMIT, leaves_ball_mesh_deg: 30.06 });
  assert.match(told, /The ball’s mesh ends under the socket from 30\.0° on: what is missing may come first\.$/);
  const unknown = words.limitWords({ ...LIMIT, state: 'unknown', leaves_ball_mesh_deg: 53.56789 });
  assert.match(unknown, /up to 53\.5° \(certified\), where the motion leaves the ball’s mesh; nothing is known beyond/);
  assert.doesNotMatch(unknown, /come first/);
});

test('proven gaps and bounds are rounded outward', () => {
  const shown = {};
  globalThis.document = { getElementById: (id) => (shown[id] ??= { textContent: '' }) };
  const proof = new words.Proof(() => {}, assert.fail);
  proof.show({ clear: 5, impinged: 0, undecided: 0, unbounded: 0, measured: 1, largest_mm: 1.2301, median_mm: 0.0123401, low_mm: -0.0704, high_mm: 0.0512 });
  assert.equal(shown['smallest-proven'].textContent, '−0.071 to 0.052 mm');
  assert.deepEqual(['bound', 'bound-half'].map((id) => shown[id].textContent), ['± 1.24 mm', '± 12.4 µm']);
});
