// SPDX-License-Identifier: GPL-3.0-or-later
// Stands between the page and the library: questions come in as messages {id, kind, ...} and are answered one by one as
// {id, ok: true, ...} or {id, ok: false, error}; before that {id, open} says how far it is, where the library tells it by
// joint3dReached(open). The script of the engine, which defines joint3dEngine, stands before this one.
'use strict';

// Every array of numbers in a reply, to be handed over instead of copied.
function buffersOf(value, found = []) {
  if (ArrayBuffer.isView(value)) {
    found.push(value.buffer);
  } else if (value !== null && typeof value === 'object') {
    for (const member of Object.values(value)) buffersOf(member, found);
  }
  return found;
}

// What is thrown here is JavaScript's: the library answers its own faults.
function inWords(error) {
  if (/memory|alloc|OOM/i.test(error.message ?? error))
    return 'there is not enough memory; choose a coarser precision or smaller meshes, and load the page again';
  return 'the library has stopped; load the page again, what it shows is kept in its address';
}

// A function that takes messages. engine: a promise of the engine; post(reply, transfer) sends.
function serve(engine, post) {
  return async ({ id, kind, ...request }) => {
    let answer;
    try {
      const library = await engine;
      globalThis.joint3dReached = (open) => post({ id, open }, []);
      answer = library.ask(kind, request);
    } catch (error) {
      answer = { ok: false, error: inWords(error) };
    }
    post({ id, ...answer }, buffersOf(answer));
  };
}

if (typeof importScripts === 'function') {
  self.fetch = undefined; // the engine holds its module: it must not try to ask for it, which the page forbids
  const receive = serve(joint3dEngine(), (reply, transfer) => self.postMessage(reply, transfer));
  self.onmessage = (event) => receive(event.data);
} else if (typeof module === 'object') {
  module.exports = { inWords, serve };
}
