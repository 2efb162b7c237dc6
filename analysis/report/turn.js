// SPDX-License-Identifier: GPL-3.0-or-later
// Wakes Joint3D in a frame when it is asked for; another joint or pose is another fragment of its address.
"use strict";
{
  const place = document.getElementById("turn-place");
  const joint = document.getElementById("turn-joint");
  const panels = document.getElementById("turn-panels");
  let address = ""; // of the page, once it is awake

  function show() {
    if (!address) return;
    place.classList.toggle("whole", panels.checked);
    place.querySelector("iframe").src = `${address}#${panels.checked ? "" : "embedded&"}${joint.value}`;
  }

  document.getElementById("turn-start").addEventListener("click", () => {
    const page = JSON.parse(document.getElementById("turn-page").textContent);
    address = URL.createObjectURL(new Blob([page], { type: "text/html;charset=utf-8" }));
    const frame = document.createElement("iframe");
    frame.title = "Joint3D: a joint that turns, coloured by its gaps";
    place.append(frame);
    place.classList.add("awake");
    show();
    frame.focus();
  });
  [joint, panels].forEach((control) => control.addEventListener("change", show));
}
