// SPDX-License-Identifier: GPL-3.0-or-later
// Files out of the page: a picture, gaps as CSV with their metadata, limits, PLY from the library's own writers, and the state
// as a link. Their names say joint and pose.
import { strToU8, zipSync } from "three/addons/libs/fflate.module.js";
import { byId, make } from "./elements.js";
import { limitsCsv } from "./limits_panel.js";
import { shownRows } from "./look_bar.js";
import { labelledPicture } from "./picture.js";
import { fileStem, poseWords, shiftWords } from "./pose_words.js";
import { gapWords } from "./readouts.js";
import { sessionBytes } from "./session_file.js";
import { OWN } from "./state.js";

export function save(content, name) {
  const blob = content instanceof Blob ? content : new Blob([content], { type: "application/octet-stream" });
  const link = make("a", { href: URL.createObjectURL(blob), download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

const COLUMNS = { surface: "ball or socket", vertex: "index in the mesh after welding", "x, y, z": "mm, in the pose, frame of the meshes", gap_mm: "mm, radial; empty where the other surface is not met" };
export const about = (name) => document.querySelector(`meta[name="${name}"]`).content;

const titled = (name, { side }) => `${name}, ${side ?? "side unknown"}`;

/** What gaps.csv was made from. joint and pose: the library's replies. */
function metadata(app, joint, pose, tables) {
  const { motion, offset, cartilage } = app.state;
  const { label, ball, socket, landmarks, ...given } = app.own ?? {};
  const gap = pose.smallest_gap;
  const own = app.state.joint.name === OWN;
  const names = (bone) => [bone, ...bone.parts].map(({ name }) => name);
  return {
    program: `impinge ${about("version")}`, commit: about("commit"), made: new Date().toISOString(), columns: COLUMNS,
    joint: own ? { ball: names(ball), socket: names(socket), landmarks: landmarks?.name ?? null, ...given } : { preset: app.state.joint.name, parameters: joint.parameters },
    side: joint.side, axes: joint.axes, centre_mm: joint.centre, fit: joint.fit, warnings: joint.warnings,
    pose_deg: motion, shift_mm_right_forward_up: offset, matrix_column_by_column: [...pose.matrix], cartilage_mm: cartilage,
    tables, smallest_gap: gap && { gap_mm: gap.gap_mm, surface: gap.surface, vertex: gap.vertex, position: gap.position, place: pose.place, clock: gap.clock },
  };
}

export class ExportPanel {
  /** ask(request): the library's reply to `export`; shown(): { joint, pose, tables, limits, name } as the page has them; write(): the address; fault(error). */
  constructor(app, view, { ask, shown, write, fault }) {
    Object.assign(this, { app, view, ask, shown, write });
    const actions = {
      "save-picture": () => this.picture(), "save-csv": () => this.gaps(), "save-limits": () => this.limits(),
      "save-ball": () => this.surface("ball"), "save-socket": () => this.surface("socket"), "copy-link": () => this.link(), "save-session": () => this.session(),
    };
    Object.entries(actions).forEach(([id, act]) => byId(id).addEventListener("click", () => act().catch(fault)));
  }

  /** The name of a file of the joint and pose at hand. */
  named(what, kind) {
    const { name, joint } = this.shown();
    return `${what}_${fileStem(name, joint.side, this.app.state)}.${kind}`;
  }

  async picture() {
    const { name, joint, pose } = this.shown();
    const lines = [poseWords(this.app.state), gapWords(pose.smallest_gap), `Gaps are radial. Joint3D of impinge ${about("version")}, ${about("commit").slice(0, 12)}: research software, no medical device.`];
    const { parts } = this.view;
    if (parts.isCut) lines.splice(2, 0, `The femur after a cut for ${this.app.state.required}; the gap is that before it.`);
    save(await labelledPicture(this.view, titled(name, joint), lines, shownRows(parts, this.app.state.look.colours, pose.colours)), this.named("joint3d", "png"));
  }

  async gaps() {
    const { joint, pose, tables } = this.shown();
    const { bytes } = await this.ask({ format: "csv", surface: "both" });
    const json = strToU8(`${JSON.stringify(metadata(this.app, joint, pose, tables), null, 2)}\n`);
    save(zipSync({ "gaps.csv": bytes, "gaps.json": json }), this.named("gaps", "zip"));
  }

  async surface(surface) {
    save((await this.ask({ format: "ply", surface })).bytes, this.named(surface, "ply"));
  }

  async limits() {
    const { name, joint, limits } = this.shown();
    const { offset } = this.app.state;
    save(limitsCsv(titled(name, joint), limits, shiftWords(offset).replaceAll("−", "-")), `limits_${this.app.state.rim ? "rim_" : ""}${fileStem(name, joint.side, { motion: {}, offset })}.csv`);
  }

  async session() {
    const bytes = await sessionBytes(this.app.state, this.app.own, { program: `impinge ${about("version")}`, commit: about("commit") });
    save(bytes, this.named("session", "zip"));
  }

  async link() {
    this.write();
    byId("link").value = location.href;
    byId("link-row").hidden = false;
    byId("link").select();
    const note = this.app.state.joint.name === OWN ? " Your meshes are not in it: save the session to have them beside it." : "";
    const copied = await navigator.clipboard?.writeText(location.href).then(() => true, () => false);
    byId("link-say").textContent = `${copied ? "Copied." : "Copy it from here."}${note}`;
  }
}
