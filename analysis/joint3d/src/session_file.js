// SPDX-License-Identifier: GPL-3.0-or-later
// A session as one file: a ZIP of the state, as its link has it, and of a reader's own files as they were given. Unpacked,
// session.json describes the joint to the program, too (impinge ... --config session.json).
import { strFromU8, strToU8, unzipSync, zipSync } from "three/addons/libs/fflate.module.js";
import { BadFile, filesOf } from "./mesh_files.js";
import { OWN, toFragment } from "./state.js";

const NAME = "session.json";
const KEYS = { ball: "ball", socket: "socket", ball_parts: "ball_part", socket_parts: "socket_part", landmarks: "landmarks" }; // as the program has them
const only = (values) => Object.fromEntries(Object.entries(values).filter(([, value]) => value));

/** Names of which none is twice, and none is that of the description. */
function differing(files) {
  const taken = new Set([NAME]);
  return new Map(files.map((file) => {
    let { name } = file;
    for (let k = 2; taken.has(name); k += 1) name = `${k}_${file.name}`;
    taken.add(name);
    return [file, name];
  }));
}

/** The bytes of the ZIP. own: a reader's joint as FilesPanel has it; about: { program, commit }. */
export async function sessionBytes(state, own, about) {
  const said = { ...about, page: toFragment(state) };
  const packed = {};
  if (state.joint.name === OWN) {
    const { side, axes, unit, centre } = own;
    const lists = filesOf(own);
    const names = differing(Object.values(lists).flat());
    for (const [file, name] of names) packed[name] = [new Uint8Array(await file.arrayBuffer()), { level: 6 }];
    Object.entries(lists).forEach(([key, list]) => {
      const named = list.map((file) => names.get(file));
      if (named.length) said[KEYS[key]] = key.endsWith("_parts") ? named : named[0];
    });
    Object.assign(said, only({ side, axes: axes.toUpperCase(), unit, centre }));
  }
  return zipSync({ [NAME]: strToU8(`${JSON.stringify(said, null, 2)}\n`), ...packed });
}

/** { fragment, files, fields } of a session's File: the link's words, and of a reader's own joint its files and fields, else null. */
export async function readSession(file) {
  const fail = (why) => { throw new BadFile(`${file.name}: ${why}; choose a session that Joint3D has saved`); };
  let packed;
  let said;
  try {
    packed = unzipSync(new Uint8Array(await file.arrayBuffer()));
    said = JSON.parse(strFromU8(packed[NAME]));
  } catch {
    fail("it is no session");
  }
  if (typeof said?.page !== "string") fail("it is no session");
  if (!said.ball) return { fragment: said.page, files: null, fields: null };
  const taken = ([key, word]) => [key, [said[word] ?? []].flat().map((name) => (packed[name] ? new File([packed[name]], name) : fail(`${name} is missing in it`)))];
  return { fragment: said.page, files: Object.fromEntries(Object.entries(KEYS).map(taken)),
    fields: { side: said.side, axes: said.axes ?? "", unit: said.unit ?? "mm", centre: said.centre ?? null } };
}
