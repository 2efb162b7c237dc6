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
  ply: (file, bytes) => fromGeometry(file, new PLYLoader().parse(bytes)),
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
