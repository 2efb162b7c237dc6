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

const COLUMNS = { surface: "ball or socket", vertex: "index in the mesh after welding, unless it is a whole bone", "x, y, z": "mm, in the pose, frame of the meshes", gap_mm: "mm, radial; empty where the other surface is not met" };
export const about = (name) => document.querySelector(`meta[name="${name}"]`).content;

const titled = (name, { side }) => `${name}, ${side ?? "side unknown"}`;

/** What gaps.csv was made from. state: as it was asked; joint and pose: the library's replies. */
function metadata(app, { motion, offset, cartilage }, { joint, tables }, pose) {
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
  /**
   * ask(kind, request): the library's reply; request(): that for the pose of the state; shown(): { joint, pose, at, tables, limits, name } as the page has them, `at` of the
   * pose; write(): the address; fault(error).
   */
  constructor(app, view, { ask, request, shown, write, fault }) {
    Object.assign(this, { app, view, ask, request, shown, write });
    const actions = {
      "save-picture": () => this.picture(), "save-csv": () => this.gaps(), "save-limits": () => this.limits(),
      "save-ball": () => this.surface("ball"), "save-socket": () => this.surface("socket"), "copy-link": () => this.link(), "save-session": () => this.session(),
    };
    Object.entries(actions).forEach(([id, act]) => byId(id).addEventListener("click", () => act().catch(fault)));
  }

  /** The name of a file of the joint at hand in a pose. */
  named(what, kind, pose = this.app.state) {
    const { name, joint } = this.shown();
    return `${what}_${fileStem(name, joint.side, pose)}.${kind}`;
  }

  async picture() {
    const { name, joint, pose, at } = this.shown();
    const file = this.named("joint3d", "png", at);
    const lines = [poseWords(at), gapWords(pose.smallest_gap), `Gaps are radial. Joint3D of impinge ${about("version")}, ${about("commit").slice(0, 12)}: research software, no medical device.`];
    const { parts } = this.view;
    if (parts.isCut) lines.splice(2, 0, `The femur after a cut for ${this.app.state.required}; the gap is that before it.`);
    save(await labelledPicture(this.view, titled(name, joint), lines, shownRows(parts, this.app.state.look.colours, pose.colours)), file);
  }

  async gaps() {
    this.app.player.stop();
    const [state, request] = [structuredClone(this.app.state), this.request()]; // a reader may go on meanwhile
    const [pose, { bytes }] = await Promise.all([this.ask("pose", request), this.ask("export", { format: "csv", surface: "both", pose: request })]);
    const json = strToU8(`${JSON.stringify(metadata(this.app, state, this.shown(), pose), null, 2)}\n`);
    save(zipSync({ "gaps.csv": bytes, "gaps.json": json }), this.named("gaps", "zip", state));
  }

  async surface(surface) {
    this.app.player.stop();
    const [state, request] = [structuredClone(this.app.state), this.request()];
    const { bytes } = await this.ask("export", { format: "ply", surface, pose: request });
    save(bytes, this.named(surface, "ply", state));
  }

  async limits() {
    const { name, joint, limits } = this.shown();
    const { offset } = this.app.state;
    save(limitsCsv(titled(name, joint), limits, shiftWords(offset).replaceAll("−", "-")), `limits_${this.app.state.rim ? "rim_" : ""}${fileStem(name, joint.side, { motion: {}, offset })}.csv`);
  }

  async session() {
    const file = this.named("session", "zip");
    const bytes = await sessionBytes(this.app.state, this.app.own, { program: `impinge ${about("version")}`, commit: about("commit") });
    save(bytes, file);
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
