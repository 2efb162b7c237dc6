// SPDX-License-Identifier: GPL-3.0-or-later
// What the page says about itself: messages over the picture, and that something is being made.
import { byId, make } from "./elements.js";

/** A fault in words that are for the reader. */
export class Told extends Error {}

export const NO_MEMORY = "there is not enough memory; choose smaller meshes or a coarser precision, or use the program impinge";
export const isMemory = (error) => /memory|alloc/i.test(error.message);

/** kind: "fault" or "warning"; no text takes the message away. actions: { text, act } for buttons. */
export function say(text, kind = "fault", actions = []) {
  byId("message").hidden = !text;
  byId("message").className = kind;
  byId("message-text").textContent = text;
  byId("message-actions").replaceChildren(...actions.map(({ text: label, act }) =>
    make("button", { type: "button", textContent: label, onclick: () => { say(""); act(); } })));
}

/** A fault of a kind that the page knows, in its words; of another one nobody but a programmer can read more. */
export function inWords(error) {
  if (typeof error === "string") return error;
  if (error instanceof Told) return error.message;
  if (isMemory(error)) return NO_MEMORY;
  console.error(error);
  return "This page has failed: load it again. What it shows is kept in its address.";
}

export const fault = (error) => say(inWords(error));

const making = new Set();

/** While a joint or tables are made, the picture says so. kind: which of them. */
export function busy(kind, more) {
  making[more ? "add" : "delete"](kind);
  byId("stage").setAttribute("aria-busy", String(making.size > 0));
}
