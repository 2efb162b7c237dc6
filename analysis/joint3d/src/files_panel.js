// SPDX-License-Identifier: GPL-3.0-or-later
// A reader's own joint: two bones by dialog or drop, parts beside them and landmarks, its side, axes and unit, and its centre,
// fitted or typed.
import { byId, make } from "./elements.js";
import { BadFile, filesOf, isLandmarks, readLandmarks, readMesh, sortFiles } from "./mesh_files.js";

const BONES = { ball: "femur", socket: "pelvis" };
const MORE = ["ball_parts", "socket_parts", "landmarks"]; // beside them, or none
const FIELDS = { side: "file-side", axes: "axes", unit: "unit" };
export const UNITS = { mm: 1, cm: 10, m: 1000, µm: 0.001, in: 25.4 }; // mm in each
const HUMAN = [5, 50]; // mm: radii of heads, as hip/length_unit.hpp has them

export class FilesPanel {
  /**
   * onJoint(own) when a reader wants own meshes: { ball, socket, landmarks, side, axes, unit, centre }, meshes as of readMesh()
   * with their `parts`, in the unit of the files; onSession(file) when one is dropped; onFault(error).
   */
  constructor(onJoint, onSession, onFault) {
    Object.assign(this, { onJoint, onSession, onFault, files: {}, read: new Map() }); // files: a list for each of BONES and MORE
    byId("unit").replaceChildren(...Object.keys(UNITS).map((unit) => make("option", { value: unit, textContent: unit })));
    [...Object.keys(BONES), ...MORE].forEach((key) => byId(`file-${key}`).addEventListener("change", (event) => this.take({ [key]: [...event.target.files] }, false)));
    byId("no-more").addEventListener("click", () => this.take(Object.fromEntries(MORE.map((key) => [key, []])), true));
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
      this.dropped(files);
    });
  }

  dropped(files) {
    if (files.length === 1 && /\.zip$/i.test(files[0].name)) {
      this.onSession(files[0]);
      return;
    }
    const [landmarks, meshes] = [files.filter(isLandmarks), files.filter((file) => !isLandmarks(file))];
    if (meshes.length > 2 || landmarks.length > 1) {
      this.onFault(`${files.length} files were dropped; drop two meshes, the ball and the socket, and choose parts beside them under “Parts and landmarks”`);
      return;
    }
    const sorted = Object.fromEntries(Object.entries(sortFiles(meshes)).map(([part, file]) => [part, [file]]));
    this.take(landmarks.length ? { ...sorted, landmarks } : sorted, true);
    if (this.whole()) this.use();
  }

  whole() {
    return Object.keys(BONES).every((part) => this.files[part]?.length);
  }

  /** Keeps files for what they are given for: lists. shown: their names are shown here, where no dialog does it. */
  take(chosen, shown) {
    Object.entries(chosen).forEach(([key, files]) => {
      if (key in BONES && !files.length) return; // a dialog that was left
      this.files[key] = files;
      byId(`name-${key}`).textContent = shown ? files.map(({ name }) => name).join(", ") : "";
      if (shown) byId(`file-${key}`).value = "";
    });
    byId("use-files").disabled = !this.whole();
    const more = MORE.some((key) => this.files[key]?.length);
    byId("no-more").hidden = !more;
    byId("more").open ||= more;
    const missing = Object.keys(BONES).find((part) => !this.files[part]?.length);
    byId("files-say").textContent = missing ? `Now choose the ${BONES[missing]}.` : "";
  }

  /** own: a joint that was kept, as onJoint() got it. */
  restore(own) {
    [own.ball, own.socket].forEach((bone) => [bone, ...bone.parts].forEach((mesh) => this.read.set(mesh.file, mesh)));
    this.take(filesOf(own), true);
    this.fill(own);
  }

  /** Fields of a joint: side, axes, unit and centre. */
  fill(fields) {
    Object.entries(FIELDS).forEach(([key, id]) => { byId(id).value = fields[key]; });
    byId("centre-typed").checked = Boolean(fields.centre);
    byId("centre").disabled = !fields.centre;
    byId("centre").value = fields.centre?.join(", ") ?? "";
    byId("frame").open ||= Boolean(fields.axes || fields.centre);
  }

  centre() {
    if (!byId("centre-typed").checked) return null;
    const numbers = byId("centre").value.trim().split(/[\s,;]+/).map(Number);
    if (numbers.length !== 3 || !numbers.every(Number.isFinite)) throw new BadFile("The centre is three numbers, x, y and z; type them as 12.5, -3, 40");
    return numbers;
  }

  async mesh(file) {
    if (!this.read.has(file)) this.read.set(file, await readMesh(file));
    return this.read.get(file);
  }

  async bone(part) {
    const parts = [];
    for (const file of this.files[`${part}_parts`] ?? []) parts.push(await this.mesh(file));
    return { ...await this.mesh(this.files[part][0]), parts };
  }

  /** The joint of the files and fields at hand. */
  async own() {
    const fields = Object.fromEntries(Object.entries(FIELDS).map(([key, id]) => [key, byId(id).value.trim()]));
    const [marked] = this.files.landmarks ?? [];
    if (marked && fields.unit !== "mm") throw new BadFile(`${marked.name}: landmarks are read in mm; give meshes in mm beside them`);
    const own = { ball: await this.bone("ball"), socket: await this.bone("socket"), landmarks: marked ? await readLandmarks(marked) : null, ...fields, centre: this.centre() };
    const used = new Set(Object.values(filesOf(own)).flat());
    [...this.read.keys()].filter((file) => !used.has(file)).forEach((file) => this.read.delete(file));
    return { ...own, label: `${own.ball.name} and ${own.socket.name}` };
  }

  /** change: other fields than are shown, such as { unit: "m" }. */
  async use(change = {}) {
    Object.entries(change).forEach(([key, value]) => { byId(FIELDS[key]).value = value; });
    byId("frame").open ||= "axes" in change;
    try {
      this.onJoint(await this.own());
    } catch (error) {
      this.onFault(error);
    }
  }
}

/** The question to the library about own meshes. Without axes their files say them, or they are RAS. */
export function ownRequest({ ball, socket, landmarks = null, side, axes, unit, centre }) {
  const scaled = (numbers) => (unit === "mm" ? numbers : numbers?.map((x) => x * UNITS[unit]));
  const mesh = ({ name, positions, faces, head }) => ({ name, positions: scaled(positions), faces, head });
  const bone = ({ parts = [], ...main }) => ({ ...mesh(main), parts: parts.map(mesh) });
  const marked = landmarks && { name: landmarks.name, text: landmarks.text };
  return { source: "files", ball: bone(ball), socket: bone(socket), landmarks: marked, side, axes: axes.toUpperCase() || null, centre: scaled(centre) };
}

/** Units in which a ball of that radius, read in `unit`, would be a human one; none where it is one. */
export function likelyUnits(radius, unit) {
  const human = (each) => { const mm = (radius / UNITS[unit]) * UNITS[each]; return mm >= HUMAN[0] && mm <= HUMAN[1]; };
  return human(unit) ? [] : Object.keys(UNITS).filter((each) => each !== "in" && human(each));
}
