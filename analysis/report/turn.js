// SPDX-License-Identifier: GPL-3.0-or-later
// Shows Joint3D, the file beside this one, in a frame when it is asked for; another joint or pose is another fragment of its address.
"use strict";
{
  const place = document.getElementById("turn-place");
  const joint = document.getElementById("turn-joint");
  const panels = document.getElementById("turn-panels");

  function show() {
    const frame = place.querySelector("iframe");
    if (!frame) return;
    place.classList.toggle("whole", panels.checked);
    frame.src = `joint3d.html#${panels.checked ? "" : "embedded&"}${joint.value}`;
  }

  document.getElementById("turn-start").addEventListener("click", () => {
    const frame = document.createElement("iframe");
    frame.title = "Joint3D: a joint that turns, coloured by its gaps";
    place.append(frame);
    place.classList.add("awake");
    show();
    frame.focus();
  });
  [joint, panels].forEach((control) => control.addEventListener("change", show));
}
