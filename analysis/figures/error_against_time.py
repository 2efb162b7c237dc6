# SPDX-License-Identifier: GPL-3.0-or-later
# @data      all_gaps
# @name      error-against-time
# @question  What does each method err by, and what does it cost: a query, a pose, a thousand, a million? On a hip.
# @options   --scene hip --name NAME
# @name      error-against-time-generated
# @question  The same of the generated pair.
# @options   --scene generated --name NAME
# @name      error-against-time-real
# @question  The same of a real hip.
# @options   --scene real --name NAME
# @when      JOINTS
"""Work and precision: time against the worse error of both scans, a line a method through its precisions."""

import common
from common import error_panel, work_precision

PANELS = {
    "single": ("A single query", "time of a vertex, ns", 1.0),
    "one": ("All gaps of one pose, with building", "time, ms", 1.0),
    "thousand": ("All gaps of 1,000 poses, with building", "time, s (building + 1,000 × a pose)", 1e-3),
    "million": ("All gaps of 1,000,000 poses, with building", "time, s (building + 1,000,000 × a pose)", 1e-3),
}
FOOT = (
    "Lower left is better. Error: of the worst gap of both scans in 12 poses. At the points: spacing of the entries. | at the end of a"
    " thin line: proven bound,\nin any direction. Times of 1,000 and 1,000,000 poses are derived: building and so many times a pose, both measured. One thread."
)


def main(options) -> common.Figure:
    rows = work_precision.load(options.results)
    scenes = work_precision.scenes(rows)
    if options.scene not in scenes:
        raise common.Refused(f"data/all_gaps.csv has no {options.scene} scene with all methods")
    scene = scenes[options.scene]
    own = rows[rows.scene == scene].rename(columns={"error_um": "error", "bound_um": "bound"})
    looks = common.look(list(dict.fromkeys(work_precision.LINES.values())))
    figure, grid = error_panel.grid_of(2, 4.1, FOOT)
    for axes, (column, (title, unit, scale)) in zip(grid.flat, PANELS.items()):
        points = work_precision.fastest(own, column)
        error_panel.draw(axes, points.assign(cost=scale * points[column]), error_panel.MICROMETRES, looks)
        axes.set(title=title, ylabel=unit)
    figure.suptitle(f"Scene: {scene.replace('_', ' ')}", x=0.01, y=1.01, ha="left", fontsize=11)
    return figure


common.run(main, "--scene", "--name")
