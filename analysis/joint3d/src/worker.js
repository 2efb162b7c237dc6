// SPDX-License-Identifier: GPL-3.0-or-later
// Stands between the page and the library: questions come in as messages {id, kind, ...} and are answered one by one as
// {id, ok: true, ...} or {id, ok: false, error}. Of the poses that wait only the newest is looked at; the others are answered
// {id, ok: false, stale: true}. The script of the engine, which defines joint3dEngine, stands before this one.
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

// serve(engine, post): a function that takes messages. `engine` is a promise of the engine; post(reply, transfer) sends.
// `later` runs a function when the messages that have arrived have been taken in.
// joint3dReached(open) of a question that says how far it is posts {id, open}.
function serve(engine, post, later) {
  const waiting = [];
  let busy = false;
  let answering = null;
  globalThis.joint3dReached = (open) => post({ id: answering, open }, []);

  function isStale(message) {
    return message.kind === 'pose' && waiting.some((other) => other.kind === 'pose');
  }

  function reply(id, answer) {
    const whole = { id, ...answer };
    post(whole, buffersOf(answer));
  }

  async function answerNext() {
    const message = waiting.shift();
    if (message === undefined) {
      busy = false;
      return;
    }
    const { id, kind, ...request } = message;
    answering = id;
    try {
      if (isStale(message)) {
        reply(id, { ok: false, stale: true });
      } else {
        reply(id, (await engine).ask(kind, request));
      }
    } catch (error) {
      reply(id, { ok: false, error: inWords(error) });
    }
    later(answerNext);
  }

  return (message) => {
    waiting.push(message);
    if (busy) return;
    busy = true;
    later(answerNext);
  };
}

// As soon as the messages before it are through; a timer would wait for some milliseconds.
function soon() {
  const channel = new MessageChannel();
  const tasks = [];
  channel.port1.onmessage = () => tasks.shift()();
  return (task) => {
    tasks.push(task);
    channel.port2.postMessage(null);
  };
}

if (typeof importScripts === 'function') {
  self.fetch = undefined; // the engine holds its module: it must not try to ask for it, which the page forbids
  const receive = serve(joint3dEngine(), (reply, transfer) => self.postMessage(reply, transfer), soon());
  self.onmessage = (event) => receive(event.data);
} else if (typeof module === 'object') {
  module.exports = { inWords, serve, soon };
}
