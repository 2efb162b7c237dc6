// SPDX-License-Identifier: GPL-3.0-or-later
// The library in WebAssembly against the same sources compiled for this machine (scenes.cpp), on the same meshes.
//
// What must be equal. Both compute in IEEE 754 without fused sums. They differ where they ask their libm (sines and cosines of the
// pose and of the directions of some schemes, angles of look-ups), and in the order in which Eigen adds three products: in
// vectors of two here, one by one there.
//   cube_gnomonic, 16 bits and float    No libm. The entries agree to a few 2^-53 of themselves, which is lost where they are
//                    rounded to 2^-24 or to 1 / 65534 of their range, and the kernel adds in one order everywhere. So gaps are
//                    equal bit for bit, where the pose has the same rotation in float, as it is in `matrix`.
//   in double, and other schemes    Each libm is right to one unit in the last place, so that directions and places differ by at
//                    most some 8 * 2^-53 radians. With tan psi up to 1e3 and radii up to 150 mm a gap changes by at most
//                    8 * 2^-53 * 1e3 * 150 mm = 1.4e-10 mm, and by another order of sums by 16 * 2^-53 * 150 mm, a thousandth
//                    of it. kAngle allows ten times that, and half a unit of the float that the page is given.
//                    Of entries stored in float one in some 10^8 may round to its other neighbour instead; none here does.
//   other schemes in 16 bits    A number may round to the next step instead: kStep, for radii that differ by up to 100 mm.
'use strict';

const assert = require('node:assert/strict');
const { execFileSync } = require('node:child_process');
const fs = require('node:fs');
const os = require('node:os');
const path = require('node:path');
const { after, before, test } = require('node:test');

const kAngle = 1.4e-9; // mm
const kStep = 100 / 65534; // mm

const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'joint3d-'));
let engine;
let hips;

function numbers(name, Type) {
  const bytes = fs.readFileSync(path.join(folder, name));
  return new Type(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length));
}

function surface(hip, part) {
  const stem = `${hip.name}-${part}`;
  return { name: part, positions: numbers(`${stem}.positions`, Float64Array), faces: numbers(`${stem}.faces`, Uint32Array) };
}

function ask(kind, request) {
  const reply = engine.ask(kind, request);
  assert.equal(reply.error, undefined);
  return reply;
}

function useHip(hip) {
  const request = { source: 'files', side: hip.side, centre: [0, 0, 0] };
  return ask('joint', { ...request, ball: surface(hip, 'ball'), socket: surface(hip, 'socket') });
}

// Distance of a gap from that of this machine beyond half a unit in the last place of the page's float.
function excess(gap, native) {
  if (Number.isNaN(gap) || Number.isNaN(native)) return Number.isNaN(gap) === Number.isNaN(native) ? 0 : Infinity;
  if (gap === Math.fround(native)) return 0;
  return Math.abs(gap - native) - Math.abs(native) * 2 ** -24;
}

function largestExcess(gaps, file) {
  const native = numbers(file, Float64Array);
  assert.equal(gaps.length, native.length);
  return gaps.reduce((most, gap, i) => Math.max(most, excess(gap, native[i])), 0);
}

function allowance(scene, reply) {
  const { scheme, storage } = scene.tables;
  const sameRotation = scene.matrix.every((x, i) => x === reply.matrix[4 * Math.floor(i / 3) + (i % 3)]);
  if (scheme === 'cube_gnomonic' && storage !== 'double') {
    assert.ok(sameRotation, 'another rotation in float: the poses must be such as both libms agree on');
    return 0;
  }
  return storage === 'uint16' ? kStep : kAngle;
}

before(async () => {
  execFileSync(process.env.JOINT3D_SCENES, [folder]);
  hips = JSON.parse(fs.readFileSync(path.join(folder, 'scenes.json')));
  engine = await require(process.env.JOINT3D_ENGINE)();
});
after(() => fs.rmSync(folder, { recursive: true }));

test('gaps are those of this machine, and so is what follows from them', () => {
  const seen = {};
  let negative = 0;
  for (const hip of hips) {
    useHip(hip);
    for (const scene of hip.scenes) {
      const tables = ask('tables', scene.tables);
      assert.ok(tables.error_mm > 0);
      const reply = ask('pose', scene.pose);
      const allowed = allowance(scene, reply);
      const name = `${hip.name} ${JSON.stringify(scene.tables)} ${JSON.stringify(scene.pose)}`;
      for (const part of ['ball', 'socket']) {
        const over = largestExcess(reply[`${part}_gap`], path.join(hip.name, `${scene.file}.${part}`));
        assert.ok(over <= allowed, `${name}: gaps of the ${part} differ by ${over} mm, more than ${allowed}`);
        seen[scene.tables.scheme] = Math.max(seen[scene.tables.scheme] ?? 0, over);
      }
      assert.ok(Math.abs(reply.smallest.gap_mm - scene.smallest.gap_mm) <= allowed, name);
      if (allowed < kStep) {
        assert.equal(reply.smallest.vertex, scene.smallest.vertex, name);
        assert.equal(reply.smallest.surface, scene.smallest.surface, name);
        assert.equal(reply.smallest.clock, scene.smallest.clock, name);
        assert.ok(Math.abs(reply.impinged_area_mm2 - scene.bone_mm2) <= 1e-9 * scene.bone_mm2, name);
        assert.ok(Math.abs(reply.socket.cartilage.area_mm2 - scene.cartilage_mm2) <= 1e-9 * scene.cartilage_mm2, name);
      }
      if (reply.smallest.gap_mm < 0) negative += 1;
    }
  }
  assert.ok(negative > 10, 'too few scenes are impinged');
  console.log('largest difference beyond the rounding to float, mm:', seen);
});

// What is proven about a pose: of all gaps, none is farther from 0 than the bound of its cell where it is undecided.
function verdictsAreThoseOf(native, bound) {
  const found = ask('verdicts', native.pose);
  for (const count of ['clear', 'impinged', 'undecided']) assert.equal(found[count], native[count], count);
  for (const length of ['largest_mm', 'median_mm', 'low_mm', 'high_mm'])
    assert.ok(Math.abs(found[length] - native[length]) <= kAngle + 2 ** -23 * Math.abs(native[length]), `${length} ${found[length]} ${native[length]}`);
  assert.equal(found.unbounded, 0);
  assert.ok(found.measured > 0 && found.high_mm - found.low_mm < 1e-9, 'the faces decide');
  assert.ok(found.median_mm > 0 && found.median_mm <= found.largest_mm && found.largest_mm <= bound);
  const pose = ask('pose', native.pose);
  const gaps = [...pose.ball_gap, ...pose.socket_gap].filter((gap) => !Number.isNaN(gap));
  assert.equal(found.clear + found.impinged + found.undecided, gaps.length);
  assert.ok(found.impinged <= gaps.filter((gap) => gap <= 0).length);
  assert.ok(found.undecided <= gaps.filter((gap) => Math.abs(gap) <= found.largest_mm).length);
  assert.ok(Math.abs(found.low_mm - pose.smallest.gap_mm) <= found.largest_mm);
  return found;
}

function limitIsThatOf(found, limit) {
  for (const key of ['about', 'threshold_mm', 'state', 'clock']) assert.equal(found[key], limit[key], key);
  assert.equal(found.half_mm_gap_deg === null, limit.half_mm_gap_deg === null);
  assert.ok(Math.abs(found.half_mm_gap_deg - limit.half_mm_gap_deg) < 1e-6);
  // Both brackets hold the limit, so that they meet; each is 1e-7 degrees wide.
  assert.ok(found.low_deg <= limit.high_deg + 1e-9 && limit.low_deg <= found.high_deg + 1e-9);
  if (found.state === 'limited') assert.ok(found.high_deg - found.low_deg < 1e-6);
}

test('bounds, limits and files are those of this machine', () => {
  let decided = 0;
  let undecided = 0;
  for (const hip of hips) {
    useHip(hip);
    ask('tables', { scheme: 'cube_gnomonic', precision_deg: 4, storage: 'uint16' });
    const bound = ask('bound', {}).bound_mm;
    assert.ok(Math.abs(bound - hip.bound_mm) <= 1e-9 * hip.bound_mm, `${bound} ${hip.bound_mm}`);
    const found = verdictsAreThoseOf(hip.verdicts, bound);
    decided += found.impinged;
    undecided += found.undecided;
    for (const { motion, limits } of hip.limits) {
      const found = ask('sweep', { motion, step_deg: 5 }).limits;
      assert.equal(found.length, limits.length);
      limits.forEach((limit, k) => limitIsThatOf(found[k], limit));
    }
    const csv = Buffer.from(ask('export', { format: 'csv', pose: {} }).bytes).toString();
    assert.equal(csv, hip.csv);
  }
  assert.ok(decided > 0 && undecided > 0, `${decided} vertices are proven to be impinged, ${undecided} are undecided`);
});

// Gaps, curve and limit are along rays from the ball's own centre: a shift that brings bones together at the start is a limit
// at the start, and before a limit no gap is below 0 by more than the error of the tables.
test('a limit is that of the shifted ball', () => {
  const states = new Set();
  for (const hip of hips) {
    useHip(hip);
    const { error_mm: error } = ask('tables', { scheme: 'cube_gnomonic', precision_deg: 0.5, storage: 'float' });
    const medial = hip.side === 'left' ? 1 : -1;
    const without = ask('sweep', { motion: 'flexion', largest_deg: 130, step_deg: 2 });
    assert.deepEqual(without.limits.map(({ about, threshold_mm: mm }) => [about, mm]), [['ball', 0], ['socket', 0], ['ball', 4]]);
    for (const translation of [[5 * medial, 0, 1], [0, 0, 6], [0.5, 1, 0.5], [-1 * medial, 0, 0], [0, 1.5, -2]]) {
      const sweep = ask('sweep', { motion: 'flexion', largest_deg: 130, step_deg: 2, translation });
      const [limit] = sweep.limits;
      const name = `${hip.name} ${translation} ${limit.state} ${limit.low_deg}`;
      states.add(limit.state);
      const { smallest } = ask('pose', { translation });
      assert.equal(Math.fround(smallest.gap_mm), sweep.smallest[0], name);
      if (Math.abs(smallest.gap_mm) > 2 * error) assert.equal(limit.state === 'blocked', smallest.gap_mm < 0, name);
      sweep.angles.forEach((angle, i) => {
        if (angle < limit.low_deg) assert.ok(sweep.smallest[i] > -2 * error, `${name}: ${sweep.smallest[i]} at ${angle}`);
      });
      assert.ok(sweep.limits.every(({ about }) => about === 'ball'), name);
      const proven = ask('verdicts', { translation, flexion: 40 });
      assert.ok(Math.abs(proven.low_mm - ask('pose', { translation, flexion: 40 }).smallest.gap_mm) < 2 * error, name);
    }
    assert.equal(ask('sweep', { motion: 'flexion', largest_deg: 130, step_deg: 2 }).limits[0].low_deg, without.limits[0].low_deg);
  }
  assert.ok(states.has('blocked') && states.has('limited'), [...states].join());
  assert.equal(ask('sweep', { motion: 'fadir', largest_deg: 60 }).angles.length, 61, 'a degree a step, where none is asked for');
});
