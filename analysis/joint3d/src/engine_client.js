// SPDX-License-Identifier: GPL-3.0-or-later
// Questions to the library, which runs in a worker. Every question has one answer; a refusal is Told in the library's words.
import { Told } from "./messages.js";

/** The worker that was asked is gone, as a reader wanted. */
export class Stale extends Told {
  constructor() {
    super("This went with the joint that was cancelled; ask for it again");
  }
}

export class EngineClient {
  /** source: the text of the engine and its worker. onLost: called with a message when the worker itself fails. */
  constructor(source, onLost) {
    Object.assign(this, { answers: new Map(), last: 0, onLost });
    this.address = URL.createObjectURL(new Blob([source], { type: "text/javascript" }));
    this.open();
  }

  open() {
    this.worker = new Worker(this.address);
    this.worker.onmessage = ({ data }) => this.answer(data);
    this.worker.onerror = (event) => {
      event.preventDefault();
      this.answers.forEach(({ reject }) => reject(new Told("the engine has stopped")));
      this.answers.clear();
      this.onLost(event.message || "the engine has stopped");
    };
  }

  /** Nothing that was asked matters any more: a new worker, which has no joint yet. */
  restart() {
    this.worker.terminate();
    this.answers.forEach(({ reject }) => reject(new Stale()));
    this.answers.clear();
    this.open();
  }

  answer({ id, ok, error, ...reply }) {
    const waiting = this.answers.get(id);
    if (!waiting) return;
    if (ok === undefined) { // not an answer yet, but how far it is
      waiting.onReached(reply.open);
      return;
    }
    this.answers.delete(id);
    if (ok) waiting.resolve(reply);
    else waiting.reject(new Told(error));
  }

  /** onReached(open): the share of the work that is still to be done, of questions that say so. */
  ask(kind, request = {}, onReached = () => {}) {
    const id = (this.last += 1);
    return new Promise((resolve, reject) => {
      this.answers.set(id, { resolve, reject, onReached });
      this.worker.postMessage({ ...request, id, kind });
    });
  }
}

/**
 * Of questions that come faster than answers: one under way, and the newest that waits. use(answer, ms, request),
 * fail(error, request), also where it is Stale, idle() when nothing waits.
 */
export function newestOnly(ask, use, fail, idle = () => {}) {
  let running = false;
  let next = null;
  const run = async (request) => {
    running = true;
    const asked = performance.now();
    try {
      const answer = await ask(request);
      use(answer, performance.now() - asked, request);
    } catch (error) {
      fail(error, request);
    }
    running = false;
    if (next) {
      const newest = next;
      next = null;
      run(newest);
    } else {
      idle();
    }
  };
  return (request) => {
    if (running) next = request;
    else run(request);
  };
}
