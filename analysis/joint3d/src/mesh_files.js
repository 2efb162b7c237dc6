// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes from a reader's files: PLY, STL, OBJ. Only corners and faces are taken; what they are worth, the library judges.
import { OBJLoader } from "three/addons/loaders/OBJLoader.js";
import { PLYLoader } from "three/addons/loaders/PLYLoader.js";
import { STLLoader } from "three/addons/loaders/STLLoader.js";
import { NO_MEMORY, Told, isMemory } from "./messages.js";

const HEAD = 65536; // bytes in which the library looks for a header that says the axes
const LARGEST = 200e6; // bytes: above it a page runs out of memory

export class BadFile extends Told {}

const fail = (file, why, cure) => { throw new BadFile(`${file.name}: ${why}; ${cure}`); };

function fromGeometry(file, geometry) {
  const positions = geometry?.getAttribute?.("position");
  if (!positions || positions.count < 3) fail(file, "there are no triangles in it", "give a surface mesh");
  const faces = geometry.index ? Uint32Array.from(geometry.index.array) : null;
  return { name: file.name, positions: Float64Array.from(positions.array), faces };
}

const SIZES = { char: 1, int8: 1, uchar: 1, uint8: 1, short: 2, int16: 2, ushort: 2, uint16: 2, int: 4, int32: 4, uint: 4, uint32: 4, float: 4, float32: 4, double: 8, float64: 8 };

/** Of how many triangles the faces of a PLY are, by its own words. Where it ends too early, NaN or a RangeError. */
function trianglesOf(bytes) {
  const [header] = new TextDecoder("latin1").decode(bytes.slice(0, HEAD)).match(/^ply[^]*?end_header(\r\n|\r|\n)/);
  const ascii = /^format\s+ascii/m.test(header);
  const little = /^format\s+binary_little/m.test(header);
  const words = ascii ? new TextDecoder("latin1").decode(bytes.slice(header.length)).trim().split(/\s+/) : null;
  const view = new DataView(bytes, header.length);
  const sizeOf = (type) => (ascii ? 1 : SIZES[type]);
  const read = (type, at) => (ascii ? Number(words[at]) : sizeOf(type) === 1 ? view.getUint8(at) : sizeOf(type) === 2 ? view.getUint16(at, little) : view.getUint32(at, little));
  const elements = [];
  for (const line of header.split(/\r\n|\r|\n/)) {
    const [what, ...rest] = line.trim().split(/\s+/);
    if (what === "element") elements.push({ name: rest[0], count: Number(rest[1]), properties: [] });
    if (what === "property") elements.at(-1).properties.push(rest);
  }
  let [at, triangles] = [0, 0];
  elements.forEach(({ name, count, properties }) => {
    for (let k = 0; k < count; k += 1) {
      for (const [type, countType, itemType, list] of properties) {
        const corners = type === "list" ? read(countType, at) : 0;
        at += type === "list" ? sizeOf(countType) + corners * sizeOf(itemType) : sizeOf(type);
        if (name === "face" && /^vertex_ind/.test(list)) triangles += Math.max(corners - 2, 0);
      }
    }
  });
  return at <= (ascii ? words.length : view.byteLength) ? triangles : NaN;
}

/** The loader leaves out faces of five corners or more, and what of an ascii file is missing, without a word. */
function fromPly(file, bytes) {
  const geometry = new PLYLoader().parse(bytes);
  const triangles = trianglesOf(bytes);
  const mesh = fromGeometry(file, geometry);
  if (triangles === 0) fail(file, "there are no faces in it", "give a surface mesh");
  if ((mesh.faces ?? mesh.positions).length / (mesh.faces ? 3 : 9) !== triangles) fail(file, "it has faces of five corners or more, or its end is missing", "triangulate the mesh and save it again");
  return mesh;
}

/** All objects of the file as one. */
function fromObj(file, bytes) {
  const parts = [];
  new OBJLoader().parse(new TextDecoder().decode(bytes)).traverse((node) => { if (node.isMesh) parts.push(node.geometry); });
  if (!parts.length) fail(file, "there are no faces in it", "give a surface mesh");
  const meshes = parts.map((geometry) => fromGeometry(file, geometry.toNonIndexed?.() ?? geometry));
  return { name: file.name, positions: Float64Array.from(meshes.flatMap((mesh) => [...mesh.positions])), faces: null };
}

/** The loader knows ascii STL in small letters alone. */
function plainStl(bytes) {
  const start = new TextDecoder().decode(bytes.slice(0, 5));
  if (start === "solid" || start.toLowerCase() !== "solid") return bytes;
  const text = new TextDecoder().decode(bytes);
  return text.includes("\0") ? bytes : text.toLowerCase();
}

const READERS = {
  ply: fromPly,
  stl: (file, bytes) => fromGeometry(file, new STLLoader().parse(plainStl(bytes))),
  obj: fromObj,
};

/** { name, positions, faces, head, file } of a File. A BadFile names the file, the reason and the cure. */
export async function readMesh(file) {
  const reader = READERS[file.name.split(".").pop().toLowerCase()];
  if (!reader) fail(file, "this kind of file is not read here", "save it as PLY, STL or OBJ, or use the program impinge");
  if (file.size > LARGEST) fail(file, "it has more than 200 MB", "give a mesh of fewer faces, or use the program impinge");
  try {
    const bytes = await file.arrayBuffer();
    const mesh = { ...reader(file, bytes), file, head: new Uint8Array(bytes.slice(0, HEAD)) };
    if (!mesh.positions.every(Number.isFinite)) fail(file, "it has corners that are no numbers", "save it again");
    return mesh;
  } catch (error) {
    if (error instanceof BadFile) throw error;
    if (isMemory(error)) throw new BadFile(`${file.name}: ${NO_MEMORY}`);
    if (error instanceof DOMException) fail(file, "the browser cannot read it", "choose it again: it may have been moved or changed");
    return fail(file, "it cannot be read as a mesh", `save it again as ${file.name.split(".").pop().toUpperCase()}, or as another kind`);
  }
}

export const isLandmarks = ({ name }) => /\.(json|fcsv|csv|tsv|txt)$/i.test(name);

/** { name, text, file } of a File of landmarks, which the library reads. */
export async function readLandmarks(file) {
  if (!isLandmarks(file)) fail(file, "landmarks are not read from this kind of file", "give markups of 3D Slicer (.mrk.json, .fcsv) or a CSV label,x,y,z");
  return { name: file.name, text: await file.text(), file };
}

/** The files of a reader's joint, as FilesPanel has it: a list for each that they are given for. */
export function filesOf({ ball, socket, landmarks }) {
  const files = (meshes) => meshes.map(({ file }) => file);
  return { ball: files([ball]), socket: files([socket]), ball_parts: files(ball.parts), socket_parts: files(socket.parts), landmarks: landmarks ? [landmarks.file] : [] };
}

const BALLS = /femur|femor|head|ball|humer|caput/i;
const SOCKETS = /acetab|socket|pelvi|glenoid|scapul|hip_?bone|cup/i;

/** Which of one or two files is the ball and which the socket, by their names: { ball, socket }, or what is left out. */
export function sortFiles(files) {
  const sorted = {};
  const rest = [];
  files.forEach((file) => {
    const part = SOCKETS.test(file.name) ? "socket" : BALLS.test(file.name) ? "ball" : null;
    if (part && !sorted[part]) sorted[part] = file;
    else rest.push(file);
  });
  rest.forEach((file) => { sorted[sorted.ball ? "socket" : "ball"] ??= file; });
  return sorted;
}
