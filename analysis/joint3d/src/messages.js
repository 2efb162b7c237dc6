// SPDX-License-Identifier: GPL-3.0-or-later
// What the page says about itself: messages over the picture, and that something is being made.
import { byId } from "./elements.js";

/** kind: "fault" or "warning"; no text takes the message away. */
export function say(text, kind = "fault") {
  byId("message").hidden = !text;
  byId("message").className = kind;
  byId("message-text").textContent = text;
}

export const fault = (error) => say(typeof error === "string" ? error : error.message);

const making = new Set();

/** While a joint or tables are made, the picture says so. kind: which of them. */
export function busy(kind, more) {
  making[more ? "add" : "delete"](kind);
  byId("stage").setAttribute("aria-busy", String(making.size > 0));
}
