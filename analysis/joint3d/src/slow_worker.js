// SPDX-License-Identifier: GPL-3.0-or-later
// The worker for what takes longer than a pose: sweeps, sample points, bounds and what they prove. It gets the joint and the
// tables that the live one has, when both have rested; the bound comes last.

export class SlowWorker {
  /** client: an EngineClient; rest: ms without a change; onBound(bound) in mm, null where none is proven; fault(error). */
  constructor(client, { rest, onBound, fault }) {
    Object.assign(this, { client, rest, onBound, fault, newest: 0, unsent: {}, sent: {}, settled: Promise.resolve(), asking: Promise.resolve() });
  }

  /** news: { joint } or { tables }, the requests that the live worker has answered. */
  follow(news) {
    const mine = (this.newest += 1);
    Object.assign(this.unsent, news);
    const rested = new Promise((done) => setTimeout(done, this.rest));
    this.settled = this.settled.then(() => rested).then(() => (mine === this.newest ? this.send() : undefined)).catch(this.fault);
    this.settled.then(() => this.bound(mine));
  }

  async send() {
    const { joint, tables } = this.unsent;
    Object.assign(this.sent, this.unsent);
    this.unsent = {};
    try {
      if (joint) await this.client.ask("joint", joint);
      if (tables) await this.client.ask("tables", tables);
    } catch (error) {
      this.client.restart(); // it must not answer for the joint or tables before as if for these
      this.unsent = { ...this.sent, ...this.unsent };
      throw error;
    }
  }

  /** Until the worker has the newest joint and tables, those included that come while one waits. */
  async rested() {
    let seen;
    do await (seen = this.settled); while (seen !== this.settled);
  }

  /** The library's answer about the newest joint and tables. */
  ask(kind, request) {
    const answer = this.rested().then(() => this.client.ask(kind, request));
    this.asking = answer.catch(() => {});
    return answer;
  }

  async bound(mine) {
    await new Promise((done) => setTimeout(done, 100)); // a sweep that is due begins
    await this.asking;
    if (mine !== this.newest) return;
    const { bound_mm: bound } = await this.client.ask("bound").catch(() => ({ bound_mm: null }));
    if (mine === this.newest) this.onBound(bound);
  }
}
