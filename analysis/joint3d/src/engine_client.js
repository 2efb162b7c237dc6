// SPDX-License-Identifier: GPL-3.0-or-later
// Questions to the library, which runs in a worker. Every question has one answer; a refusal is Told in the library's words.
import { Told } from "./messages.js";

/** The answer came too late: a newer question of the same kind had been asked. */
class Stale extends Error {}

export class EngineClient {
  /** source: the text of the engine and its worker. onLost: called with a message when the worker itself fails. */
  constructor(source, onLost) {
    this.answers = new Map();
    this.last = 0;
    const address = URL.createObjectURL(new Blob([source], { type: "text/javascript" }));
    this.worker = new Worker(address);
    this.worker.onmessage = ({ data }) => this.answer(data);
    this.worker.onerror = (event) => {
      event.preventDefault();
      this.answers.forEach(({ reject }) => reject(new Told("the engine has stopped")));
      this.answers.clear();
      onLost(event.message || "the engine has stopped");
    };
  }

  answer({ id, ok, stale, error, ...reply }) {
    const waiting = this.answers.get(id);
    if (!waiting) return;
    this.answers.delete(id);
    if (ok) waiting.resolve(reply);
    else waiting.reject(stale ? new Stale() : new Told(error));
  }

  ask(kind, request = {}) {
    const id = (this.last += 1);
    return new Promise((resolve, reject) => {
      this.answers.set(id, { resolve, reject });
      this.worker.postMessage({ ...request, id, kind });
    });
  }
}

/**
 * Of questions that come faster than answers: one under way, and the newest that waits. use(answer, ms, request), fail(error),
 * idle() when nothing waits.
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
      if (!(error instanceof Stale)) fail(error);
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
