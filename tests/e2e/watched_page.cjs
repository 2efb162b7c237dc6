// SPDX-License-Identifier: GPL-3.0-or-later
// What every test in a real browser needs: one that asks nobody for anything, and pages that are watched for faults.
"use strict";
const path = require("node:path");
const { pathToFileURL } = require("node:url");
const { chromium } = require("../../analysis/node_modules/playwright-core");

const QUIET = ["--disable-background-networking", "--disable-component-update", "--disable-sync", "--disable-quic",
  "--no-first-run", "--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"];
const PATIENCE = 40000; // ms: of a machine that does other things, too

const launch = () => chromium.launch({ executablePath: "/usr/bin/chromium", args: QUIET });

/** Gathers what the page complains of, and every address outside of it that it asks for. */
function faultsOf(page) {
  page.setDefaultTimeout(PATIENCE);
  const faults = [];
  page.on("console", (message) => { if (message.type() === "error") faults.push(message.text()); });
  page.on("pageerror", (error) => faults.push(error.message));
  page.on("request", (request) => {
    if (!/^(file|data|blob):/.test(request.url())) faults.push(`asks for ${request.url()}`);
  });
  return faults;
}

/** The address of the page that is tested, the first argument of the program. */
const address = () => pathToFileURL(path.resolve(process.argv[2])).href;

module.exports = { PATIENCE, address, faultsOf, launch };
