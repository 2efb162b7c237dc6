// SPDX-License-Identifier: GPL-3.0-or-later
// A reader's own joint: two meshes by dialog or drop, its side, its axes, and its centre, fitted or typed.
import { byId } from "./elements.js";
import { BadFile, readMesh, sortFiles } from "./mesh_files.js";

const PARTS = ["ball", "socket"];

export class FilesPanel {
  /** onJoint(request) with the question to the library; onFault(message). */
  constructor(onJoint, onFault) {
    Object.assign(this, { onJoint, onFault, files: {}, meshes: {} });
    PARTS.forEach((part) => byId(`file-${part}`).addEventListener("change", (event) => this.take({ [part]: event.target.files[0] }, false)));
    byId("use-files").addEventListener("click", () => this.use());
    byId("centre-typed").addEventListener("change", () => { byId("centre").disabled = !byId("centre-typed").checked; });
    this.listenForDrops(document.body);
  }

  listenForDrops(place) {
    const over = (on) => document.body.classList.toggle("dropping", on);
    place.addEventListener("dragover", (event) => { event.preventDefault(); over(true); });
    place.addEventListener("dragleave", (event) => { if (!event.relatedTarget) over(false); });
    place.addEventListener("drop", async (event) => {
      event.preventDefault();
      over(false);
      const files = [...event.dataTransfer.files];
      if (!files.length) return;
      if (files.length > 2) {
        this.onFault(`${files.length} files were dropped; drop two meshes, the ball and the socket`);
        return;
      }
      this.take(sortFiles(files), true);
      if (this.files.ball && this.files.socket) this.use();
    });
  }

  /** Keeps files for the parts they are given for. */
  take(chosen, dropped) {
    PARTS.filter((part) => chosen[part]).forEach((part) => {
      this.files[part] = chosen[part];
      delete this.meshes[part];
      byId(`name-${part}`).textContent = dropped ? chosen[part].name : ""; // a dialog shows it by itself
      if (dropped) byId(`file-${part}`).value = "";
    });
    byId("use-files").disabled = !(this.files.ball && this.files.socket);
    const missing = PARTS.find((part) => !this.files[part]);
    byId("files-say").textContent = missing ? `Now the ${missing}.` : "";
  }

  centre() {
    if (!byId("centre-typed").checked) return null;
    const numbers = byId("centre").value.trim().split(/[\s,;]+/).map(Number);
    if (numbers.length !== 3 || !numbers.every(Number.isFinite)) throw new BadFile("The centre is three numbers, x, y and z in mm; type them as 12.5, -3, 40");
    return numbers;
  }

  async use() {
    const [side, axes] = [byId("file-side").value, byId("axes").value];
    try {
      const centre = this.centre();
      for (const part of PARTS) this.meshes[part] ??= await readMesh(this.files[part]);
      this.onJoint({ source: "files", ball: this.meshes.ball, socket: this.meshes.socket, side, axes, centre });
    } catch (error) {
      this.onFault(error.message);
    }
  }
}
