// SPDX-License-Identifier: GPL-3.0-or-later
// The pose at hand: asked of the library whenever it changes, and shown when the answer comes.
import { byId } from "./elements.js";
import { Stale, newestOnly } from "./engine_client.js";
import { showLegend } from "./look_bar.js";
import { drawHistogram } from "./plots.js";
import { showReadouts } from "./readouts.js";

export class Poses {
  /** ask(request): the library's reply to `pose`; onPose(request) after a pose has been shown; fault(error). */
  constructor(app, view, { ask, onPose, fault }) {
    Object.assign(this, { app, view, onPose, vertices: 0, shown: null, at: null });
    this.asking = newestOnly(({ request }) => ask(request), (pose, took, asked) => this.show(pose, took, asked), (error) => (error instanceof Stale ? this.again() : fault(error)));
  }

  /** Another joint, of so many vertices of the ball. */
  begin(vertices) {
    this.vertices = vertices;
  }

  /** What of a pose is the same along a motion. */
  shape() {
    const { offset, cartilage } = this.app.state;
    return { translation: this.view.parts.fromJointFrame(offset).toArray(), cartilage_mm: cartilage };
  }

  request() {
    return { pose: { ...this.app.state.motion }, ...this.shape() };
  }

  again() {
    const { motion, offset } = structuredClone(this.app.state);
    if (this.app.ready) this.asking({ request: this.request(), at: { motion, offset } });
  }

  /** at: the motion and the shift that it was asked of. */
  show(pose, took, { request, at }) {
    if (!this.app.ready || pose.ball_gap.length !== this.vertices) return; // of a joint that is no more
    Object.assign(this, { shown: pose, at });
    const scale = this.app.state.look.colours;
    this.view.setPose(pose, scale);
    this.legend();
    drawHistogram(byId("histogram"), pose, scale);
    showReadouts(pose, took);
    this.onPose(request);
    document.body.dataset.poses = String(Number(document.body.dataset.poses ?? 0) + 1);
  }

  legend() {
    if (this.shown) showLegend(this.view.parts, this.app.state.look.colours, this.shown.colours);
  }
}
