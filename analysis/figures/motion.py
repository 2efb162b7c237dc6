# SPDX-License-Identifier: GPL-3.0-or-later
# @data      motion_frames
# @depends   data/motion_frames/JOINT-{ball,socket}.ply
# @depends   scenes/JOINT-{MOTIONS}/{ball.ply,socket.ply,summary.json}
# @options   --joint JOINT --name NAME
# @outputs   gif
# @seconds   9 9
# @name      motion-patient_a
# @for       JOINT in patient_a
# @question  The recorded motions of a stand-in for patient A, animated.
# @name      motion-patient_b
# @for       JOINT in patient_b
# @question  The recorded motions of a stand-in for patient B, animated.
"""The recorded motions of a hip as an animation: the joint from the front with its socket as glass, and the socket
unrolled.
"""

import matplotlib.pyplot as plt
import numpy as np
from PIL import Image

import common
from common import gap_colours, hip, render, replay, socket_map

SIDE = 300  # pixels of a picture
SHOWN_MS, HELD_MS = 120, 900  # a frame, and one at the end of a motion
COLOURS = 64  # of the palette


def main(options) -> None:
    """Writes figures/NAME.gif."""
    motions = replay.load(options.results, options.joint)
    like = hip.load(options.results, f"{options.joint}-flexion")
    frames = [row for row in motions.frames.itertuples() if row.motion != "forward"]
    unrolled = socket_map.unroll(like, SIDE)
    with render.screen():
        images = [picture(replay.posed(motions, row, like), unrolled) for row in frames]
    sheet = Sheet(like)
    shown = {row.picture: sheet.with_images(*pair, caption(row)) for row, pair in zip(frames, images)}
    path = options.out / "figures" / f"{options.name}.gif"
    path.parent.mkdir(parents=True, exist_ok=True)
    colours = [gap_colours.colours_of(like.summary, part).rgb for part in ("ball", "socket")]
    write(path, shown, frames, np.vstack(colours))


def picture(joint: hip.Hip, unrolled: socket_map.SocketMap) -> tuple[np.ndarray, np.ndarray]:
    """The joint, and the map of its socket."""
    actors = [gap_colours.of_part(joint, "ball"), gap_colours.of_part(joint, "socket", opacity=0.4)]
    front, up = hip.towards("anterior", joint)
    view = render.View(np.array([0.15 * hip.NEAR * joint.outwards, 0, 0]), front, up, hip.NEAR, SIDE)
    shades = gap_colours.shades(gap_colours.colours_of(joint.summary, "socket"))
    return render.picture(actors, view), unrolled.image(joint.socket.properties["gap"], shades)


def caption(row) -> str:
    """Motion, angle and smallest gap of a frame."""
    motion = replay.MOTIONS.get(row.motion, "As modelled")
    angle = f" {row.angle_deg:.1f}°" if row.motion in replay.MOTIONS else ""
    where = f" at {replay.clock(row.clock_hours)}"
    return f"{motion}{angle}: smallest gap {row.smallest_gap_mm:.2f} mm{where}"


class Sheet:
    """A figure whose pictures and caption change from frame to frame."""

    def __init__(self, joint: hip.Hip) -> None:
        self.figure = plt.figure(figsize=(6.6, 4.4), dpi=100)
        self.figure.suptitle(f"{hip.title(joint.name)} ({joint.side} hip)", fontsize=10, y=0.995)
        left = self.figure.add_axes([0.01, 0.20, 0.48, 0.66])
        self.front = left.imshow(np.zeros((SIDE, SIDE, 3)))
        left.set_title("joint, anterior view, socket as glass", loc="center", fontsize=8.5)
        left.axis("off")
        right = self.figure.add_axes([0.51, 0.20, 0.48, 0.66])
        socket_map.draw(right, np.zeros((SIDE, SIDE, 3)), joint, "socket unrolled, as seen from medial")
        right.title.set_fontsize(8.5)
        self.map = right.images[0]
        self.text = self.figure.text(0.5, 0.925, "", ha="center", va="center", fontsize=9.5)
        handles = gap_colours.legend(joint.summary)
        self.figure.legend(
            handles=handles, loc="lower center", ncol=4, title="gap, mm", title_fontsize=8, fontsize=7.5
        )

    def with_images(self, front: np.ndarray, unrolled: np.ndarray, text: str) -> Image.Image:
        """One frame."""
        self.front.set_data(front)
        self.map.set_data(unrolled)
        self.text.set_text(text)
        self.figure.canvas.draw()
        return Image.fromarray(np.asarray(self.figure.canvas.buffer_rgba())[..., :3])


def write(path, shown: dict[float, Image.Image], frames: list, colours: np.ndarray) -> None:
    """There and back through every motion, in one palette that has the colours of the legend, so that frames differ in
    few pixels.
    """
    order, times = [frames[0].picture], [HELD_MS]
    for motion in replay.MOTIONS:
        there = [row.picture for row in frames if row.motion == motion]
        order += [*there, *reversed(there[:-1]), frames[0].picture]
        times += [*[SHOWN_MS] * (len(there) - 1), HELD_MS, *[SHOWN_MS] * len(there)]
    some = [np.asarray(image) for image in list(shown.values())[::6]]
    wide = some[0].shape[1]
    legend = np.repeat(np.round(255 * colours).astype(np.uint8)[:, None], wide, axis=1).repeat(60, axis=0)
    sample = Image.fromarray(np.vstack([*some, legend])).quantize(COLOURS, dither=Image.Dither.NONE)
    shades = np.array(sample.getpalette()).reshape(-1, 3)[:COLOURS]
    shades = shades[shades.min(axis=1) < 240]  # paler ones would stand for the white of the ground
    palette = Image.new("P", (1, 1))
    palette.putpalette(np.vstack([shades, np.round(255 * colours), [[255, 255, 255]]]).astype(int).ravel().tolist())
    sheets = [shown[k].quantize(palette=palette, dither=Image.Dither.NONE) for k in order]
    sheets[0].save(path, save_all=True, append_images=sheets[1:], duration=times, loop=0, optimize=False)


common.run(main, "--joint", "--name")
