# SPDX-License-Identifier: GPL-3.0-or-later
# @name      contact-against-time
# @question  Do the surfaces overlap, how small is the gap, when is first contact, and how long does filling take: what does each method miss, and what does it cost?
# @data      all_gaps contact contact_agreement limit_time
"""A panel a question, of the normal hip: what is missed or wrong across, time up; lower left is better."""

import numpy as np
import pandas as pd

import common
from common import error_panel, fast, limit_time, work_precision

FOOT = (
    "Lower left is better; time: one thread. Overlap: poses near contact, against exact arithmetic; tests of vertices: overlaps between them"
    " that they miss, on the\ngenerated pair. Smallest gap: the slowest of three poses. First contact: ours is proven, others ask"
    " pose after pose in steps, small\nones are slower, then halve to 0.01°. Tables: spacings from 2° down, finer ones take longer; dotted with |: proven"
    " bound of the error."
)

BESIDE = 7  # lines whose names have room beside their points


def main(options) -> common.Figure:
    poses = hip_rows(fast.contacts(options.results, scenes=fast.HIPS))
    turns = limit_time.load(options.results)
    panels = [touch(poses, common.load(options.results, "contact_agreement").iloc[0]), smallest(poses), first_contact(turns[turns.joint == turns.joint.iloc[0]]), filling(work_precision.load(options.results))]
    looks = common.look([line for rows, *_ in panels for line in rows.line])
    title = f"What methods miss or err by, and how long they take: {work_precision.scene_title(poses.scene.iloc[0])}"
    figure, grid = error_panel.grid_of(title, FOOT, 3.0, 0.6, 0.3)
    for axes, (rows, errors, words, unit) in zip(grid.flat, panels):
        error_panel.draw(axes, rows, errors, looks)
        error_panel.name_lines(axes, rows, errors, looks, apart=rows.line.nunique() > BESIDE)
        axes.set(title=words, ylabel=unit)
    return figure


def hip_rows(table: pd.DataFrame) -> pd.DataFrame:
    """Those of the normal hip, or of the first there is."""
    scene = f"{fast.HIPS}normal_{fast.TRIANGLES}"
    return table[table.scene == (scene if scene in set(table.scene) else table.scene.iloc[0])]


VERTICES = ("culled", "all_vertices")  # methods that test vertices alone


def touch(poses: pd.DataFrame, agreed: pd.Series) -> tuple:
    """Of the poses that touch or nearly, those that a method is wrong about; of vertices the overlaps that they miss."""
    rows = poses[(poses.gap_case == "touching") & (poses.question != "smallest gap")]
    missed = 100 * agreed.missed / (agreed.impinged + agreed.missed)
    error = (100 * rows.wrong / rows.poses).where(~rows.method.isin(VERTICES), missed)
    rows = rows.assign(line=rows.line.str.removesuffix(", touch"), error=error, cost=rows.us_pose, bound=np.nan)
    return named(rows), error_panel.PERCENT, "Do the surfaces overlap?", "time of a pose, µs"


def smallest(poses: pd.DataFrame) -> tuple:
    """The smallest gap, or all of them, of the slowest of three gaps."""
    rows = poses[poses.question != "touch"].groupby("line", sort=False)[["error_um", "us_pose"]].max().reset_index()
    rows = rows.assign(error=rows.error_um, cost=rows.us_pose, bound=np.nan)
    return named(rows), error_panel.MICROMETRES, "Smallest gap", "time of a pose, µs"


def first_contact(turns: pd.DataFrame) -> tuple:
    """The limits of a hip, a line a method over its steps, which its name tells, with the contacts that are missed."""
    rows = turns.assign(cost=turns.cpu_ms / turns.motions, error=turns.largest_error_deg, bound=np.nan)
    missed = [f" (misses {count} of {asked})" if count else "" for count, asked in zip(rows.missed, rows.asked)]
    step = rows.step_deg.map("{:g}°".format).where(rows.step_deg.notna()) + pd.Series(missed, rows.index)
    steps = step.fillna("").groupby(rows.line).transform(", ".join)
    return named(rows, ", steps " + steps.where(steps != "", np.nan)), error_panel.DEGREES, "First contact of a motion", "time of a motion, ms"


def filling(rows: pd.DataFrame) -> tuple:
    """Building of both surfaces."""
    own = rows[rows.scene == work_precision.scenes(rows)["hip"]]
    own = work_precision.fastest(own, "build_ms")
    own = own.rename(columns={"build_ms": "cost", "error_um": "error", "bound_um": "bound"})
    return named(own), error_panel.MICROMETRES, "Filling tables or building trees, both surfaces", "time, ms"


def named(rows: pd.DataFrame, more: pd.Series | str = "") -> pd.DataFrame:
    """With the name of each line."""
    lines = rows.line.str.removesuffix(", culled")  # their trees are what makes them fast
    return rows.assign(name=lines + pd.Series(more, rows.index).fillna(""))


common.run(main)
