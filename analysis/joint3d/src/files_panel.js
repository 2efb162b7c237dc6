// SPDX-License-Identifier: GPL-3.0-or-later
// A reader's own joint: two meshes by dialog or drop, its side, axes and unit, and its centre, fitted or typed.
import { byId, make } from "./elements.js";
import { BadFile, readMesh, sortFiles } from "./mesh_files.js";

const PARTS = ["ball", "socket"];
const NAMES = { ball: "femur", socket: "pelvis" };
const FIELDS = { side: "file-side", axes: "axes", unit: "unit" };
export const UNITS = { mm: 1, cm: 10, m: 1000, µm: 0.001, in: 25.4 }; // mm in each
const HUMAN = [5, 50]; // mm: radii of heads, as hip/length_unit.hpp has them

export class FilesPanel {
  /** onJoint(own) when a reader wants own meshes: { ball, socket, side, axes, unit, centre } in the unit of the files; onFault(error). */
  constructor(onJoint, onFault) {
    Object.assign(this, { onJoint, onFault, files: {}, meshes: {} });
    byId("unit").replaceChildren(...Object.keys(UNITS).map((unit) => make("option", { value: unit, textContent: unit })));
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
      if (byId("files").closest("[inert]")) {
        this.onFault("The page is still starting; drop the files again when its panels answer");
        return;
      }
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
    byId("files-say").textContent = missing ? `Now choose the ${NAMES[missing]}.` : "";
  }

  /** own: meshes that were kept over a reload, as onJoint() got them. */
  restore(own) {
    const { ball, socket } = own;
    this.take({ ball, socket }, true);
    this.meshes = { ball, socket };
    Object.entries(FIELDS).forEach(([key, id]) => { byId(id).value = own[key]; });
    byId("centre-typed").checked = Boolean(own.centre);
    byId("centre").disabled = !own.centre;
    byId("centre").value = own.centre?.join(", ") ?? "";
  }

  centre() {
    if (!byId("centre-typed").checked) return null;
    const numbers = byId("centre").value.trim().split(/[\s,;]+/).map(Number);
    if (numbers.length !== 3 || !numbers.every(Number.isFinite)) throw new BadFile("The centre is three numbers, x, y and z; type them as 12.5, -3, 40");
    return numbers;
  }

  /** change: other fields than are shown, such as { unit: "m" }. */
  async use(change = {}) {
    Object.entries(change).forEach(([key, value]) => { byId(FIELDS[key]).value = value; });
    const fields = Object.fromEntries(Object.entries(FIELDS).map(([key, id]) => [key, byId(id).value.trim()]));
    try {
      const centre = this.centre();
      for (const part of PARTS) this.meshes[part] ??= await readMesh(this.files[part]);
      this.onJoint({ ...this.meshes, ...fields, centre });
    } catch (error) {
      this.onFault(error);
    }
  }
}

/** The question to the library about own meshes. Without axes their files say them, or they are RAS. */
export function ownRequest({ ball, socket, side, axes, unit, centre }) {
  const scaled = (numbers) => (unit === "mm" ? numbers : numbers?.map((x) => x * UNITS[unit]));
  const mesh = ({ name, positions, faces, head }) => ({ name, positions: scaled(positions), faces, head });
  return { source: "files", ball: mesh(ball), socket: mesh(socket), side, axes: axes.toUpperCase() || null, centre: scaled(centre) };
}

/** Units in which a ball of that radius, read in `unit`, would be a human one; none where it is one. */
export function likelyUnits(radius, unit) {
  const human = (each) => { const mm = (radius / UNITS[unit]) * UNITS[each]; return mm >= HUMAN[0] && mm <= HUMAN[1]; };
  return human(unit) ? [] : Object.keys(UNITS).filter((each) => each !== "in" && human(each));
}
