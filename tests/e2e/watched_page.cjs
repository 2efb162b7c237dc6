// SPDX-License-Identifier: GPL-3.0-or-later
// What every test in a real browser needs: one that asks nobody for anything, and pages that are watched for faults.
"use strict";
const path = require("node:path");
const { pathToFileURL } = require("node:url");
const { chromium } = require("../../analysis/node_modules/playwright-core");

const QUIET = ["--disable-background-networking", "--disable-component-update", "--disable-sync", "--disable-quic",
  "--no-first-run", "--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"];
const PATIENCE = 1000 * Number(process.env.PATIENCE_S ?? 90); // ms: of a machine that does other things, too

const launch = () => chromium.launch({ executablePath: "/usr/bin/chromium", args: QUIET });

/** Gathers what the page and its workers complain of, what the policy of the page forbids them, and every address outside of it that it asks for. */
async function faultsOf(page) {
  page.setDefaultTimeout(PATIENCE);
  const faults = [];
  const log = await page.context().newCDPSession(page); // the console does not tell of a worker that breaks the policy
  log.on("Log.entryAdded", ({ entry }) => { if (entry.level === "error") faults.push(`${entry.source}: ${entry.text.replace(/(data:.{40})[^']*/, "$1…")}`); });
  await log.send("Log.enable");
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
