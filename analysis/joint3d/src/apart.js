// SPDX-License-Identifier: GPL-3.0-or-later
// One question at a time to the library in a worker of its own, which is gone when it has answered, and when its answer no
// longer matters.

export class Apart {
  /** open(): a client of the library in a worker of its own. */
  constructor(open) {
    Object.assign(this, { open, client: null, run: 0 });
  }

  stop() {
    this.run += 1;
    this.client?.worker.terminate();
    this.client = null;
  }

  /** The library's answer about a joint, the request that makes it; null where another question, or stop(), came first. */
  async ask(joint, kind, request) {
    this.stop();
    const mine = this.run;
    this.client = this.open();
    try {
      await this.client.ask("joint", joint);
      const answer = await this.client.ask(kind, request);
      return mine === this.run ? answer : null;
    } catch (error) {
      if (mine !== this.run) return null;
      throw error;
    } finally {
      if (mine === this.run) this.stop();
    }
  }
}
