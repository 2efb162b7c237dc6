// SPDX-License-Identifier: GPL-3.0-or-later
// Times the engine of the page in Node, on one thread: the normal hip of 12,000 faces a surface. Medians of rounds in which the
// cases take turns. Usage: node engine_speed.js ENGINE CSV
'use strict';

const fs = require('node:fs');

const kRounds = 15;
const kPoses = 40; // of a round, each another one
const [engineFile, csvFile] = process.argv.slice(2);

const kTables = [
  ['cube_gnomonic', 0.35, 'uint16'],
  ['cube_gnomonic', 0.35, 'float'],
  ['cube_gnomonic', 0.35, 'double'],
  ['rsid', 0.5, 'uint16'],
  ['rsid', 0.5, 'double'],
  ['icosahedral_gnomonic', 0.5, 'uint16'],
  ['usid', 0.5, 'double'],
];

function quantile(numbers, share) {
  const sorted = [...numbers].sort((a, b) => a - b);
  return sorted[Math.min(Math.floor(share * sorted.length), sorted.length - 1)];
}

function question(engine, kind, request) {
  const start = performance.now();
  const reply = engine.ask(kind, request);
  if (!reply.ok) throw new Error(`${kind}: ${reply.error}`);
  return { reply, ms: performance.now() - start };
}

// Times of one round: {what: ms}.
function round(engine, [scheme, precision_deg, storage], turn) {
  const tables = question(engine, 'tables', { scheme, precision_deg, storage });
  const scans = [];
  const questions = [];
  for (let k = 0; k < kPoses; ++k) {
    const pose = [(7 * k + turn) % 110, (k % 5) * 4, (3 * k) % 30];
    const asked = question(engine, 'pose', { pose, cartilage_mm: 4 });
    scans.push(asked.reply.ms);
    questions.push(asked.ms);
  }
  const times = { fill: tables.reply.fill_ms, scans: quantile(scans, 0.5), pose: quantile(questions, 0.5) };
  return { times, entries: tables.reply.entries, bytes: tables.reply.bytes };
}

async function main() {
  const engine = await require(engineFile)();
  question(engine, 'joint', { source: 'preset', name: 'normal', parameters: {} });
  const cases = kTables.map((settings) => ({ settings, fill: [], scans: [], pose: [] }));
  for (let turn = -1; turn < kRounds; ++turn) { // the first compiles
    for (const one of cases) {
      const found = round(engine, one.settings, turn);
      Object.assign(one, { entries: found.entries, bytes: found.bytes });
      if (turn >= 0) for (const [what, ms] of Object.entries(found.times)) one[what].push(ms);
    }
  }
  const lines = ['scheme,precision_deg,storage,entries,bytes,what,median_ms,iqr_ms,rounds'];
  const meaning = { fill: 'fill both tables', scans: 'both scans of a pose', pose: 'whole answer to a pose' };
  for (const one of cases) {
    for (const [what, text] of Object.entries(meaning)) {
      const iqr = quantile(one[what], 0.75) - quantile(one[what], 0.25);
      const median = quantile(one[what], 0.5);
      const [scheme, precision, storage] = one.settings;
      lines.push([scheme, precision, storage, one.entries, one.bytes, text, median.toFixed(4), iqr.toFixed(4), kRounds].join());
    }
  }
  fs.writeFileSync(csvFile, `${lines.join('\n')}\n`);
}

main().catch((error) => {
  console.error(`engine_speed: error: ${error.message}`);
  process.exit(1);
});
