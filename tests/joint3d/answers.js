// SPDX-License-Identifier: GPL-3.0-or-later
// What the page says of a joint of two files: read by its own readers, asked of its library as its panels ask, limits in its
// own CSV. tests/python/test_same_answers.py holds it against the program and the module of Python.
//
//   answers.js QUESTIONS     writes its answers, arrays of numbers as lists; both are JSON
'use strict';

const fs = require('node:fs');
const path = require('node:path');

const { pageModules } = require('./page_modules.js');

/** A File of a browser. */
function fileOf(name) {
  const bytes = fs.readFileSync(name);
  const content = bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length);
  return { name: path.basename(name), size: bytes.length, arrayBuffer: async () => content };
}

async function main({ ball, socket, side, pose, tables = [], limits, questions = [] }) {
  const { limitsCsv, ownRequest, readMesh } = await pageModules('files_panel', 'limits_panel', 'mesh_files');
  const engine = await require(process.env.JOINT3D_ENGINE)();
  const ask = (kind, request = {}) => {
    const reply = engine.ask(kind, request);
    if (!reply.ok) throw new Error(`${kind}: ${reply.error}`);
    return reply;
  };
  const [head, cup] = [await readMesh(fileOf(ball)), await readMesh(fileOf(socket))];
  ask('joint', ownRequest({ ball: head, socket: cup, side, axes: '', unit: 'mm', centre: null }));
  const answers = { questions: questions.map(([kind, request]) => ask(kind, request)) };
  answers.tables = tables.map((settings) => {
    ask('tables', settings);
    const csv = Buffer.from(ask('export', { format: 'csv', surface: 'both', pose }).bytes).toString();
    return { csv, pose: ask('pose', pose), verdicts: ask('verdicts', pose), bound: ask('bound') };
  });
  if (limits) answers.limits = limitsCsv('', ask('presets').motions.map(({ name }) => ask('limits', { ...limits, motions: [name] })));
  const plain = (_, value) => (ArrayBuffer.isView(value) ? Array.from(value) : value);
  process.stdout.write(JSON.stringify(answers, plain));
}

main(JSON.parse(process.argv[2]));
