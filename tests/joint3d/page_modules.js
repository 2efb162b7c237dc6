// SPDX-License-Identifier: GPL-3.0-or-later
// The page's modules in Node, which takes them for modules where it is told so: here in a copy of their folder.
'use strict';

const fs = require('node:fs');
const os = require('node:os');
const path = require('node:path');
const { pathToFileURL } = require('node:url');

const kAnalysis = path.join(__dirname, '../../analysis');

/** All that the modules of these names have. */
async function pageModules(...names) {
  const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'joint3d-modules-'));
  try {
    fs.cpSync(path.join(kAnalysis, 'joint3d/src'), folder, { recursive: true });
    fs.writeFileSync(path.join(folder, 'package.json'), '{ "type": "module" }');
    fs.symlinkSync(path.join(kAnalysis, 'node_modules'), path.join(folder, 'node_modules'));
    return Object.assign({}, ...await Promise.all(names.map((name) => import(pathToFileURL(path.join(folder, `${name}.js`))))));
  } finally {
    fs.rmSync(folder, { recursive: true });
  }
}

module.exports = { pageModules };
