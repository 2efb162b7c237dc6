# SPDX-License-Identifier: GPL-3.0-or-later
# @data      all_gaps
# @name      error-against-time
# @question  What does each method err by on a hip, and what does it cost: a query, a pose, a thousand poses, a million?
# @options   --scene hip --name NAME
# @name      error-against-time-generated
# @question  What does each method err by on a generated ball and socket, and what does it cost: a query, a pose, a thousand poses, a million?
# @options   --scene generated --name NAME
# @name      error-against-time-real
# @question  What does each method err by on a real joint, and what does it cost: a query, a pose, a thousand poses, a million?
# @options   --scene real --name NAME
# @when      JOINTS
"""Work and precision: time against the worse error of both scans, a line a method through its precisions."""

import common
from common import error_panel, work_precision

PANELS = {
    "single": ("One gap by itself", "time of a gap, ns", 1.0),
    "one": ("All gaps of one pose, building included", "time, ms", 1.0),
    "thousand": ("All gaps of 1,000 poses, building included", "time, s", 1e-3),
    "million": ("All gaps of 1,000,000 poses, building included", "time, s", 1e-3),
}
NAMES = {
    "thesis, RSID": "grid of the thesis (RSID)",
    "thesis, USID": "helix of the thesis (USID)",
    "conchoid": "spiral on a conchoid",
    "icosahedral": "icosahedral grid",
    "RSID, vectors": "RSID, vector instructions",
    "USID, vectors": "USID, vector instructions",
    "cube, 16 bits": "cube map, 16 bits",
    "exact cells": "exact cells, on the faces",
    "Embree": "Embree, rays",
    "CGAL": "CGAL, exact rays",
}
FOOT = (
    "Lower left is better. Error: the worst gap of both scans in 12 poses. At points of tables: their precision, {steps}.\n"
    "Times of 1,000 and more poses: building, and so many times the time of a pose. One thread."
)


def main(options) -> common.Figure:
    rows = work_precision.load(options.results)
    scenes = work_precision.scenes(rows)
    if options.scene not in scenes:
        raise common.Refused(f"data/all_gaps.csv has no {options.scene} scene with all methods")
    scene = scenes[options.scene]
    own = rows[rows.scene == scene].rename(columns={"error_um": "error", "bound_um": "bound"})
    looks = common.look(list(dict.fromkeys(work_precision.LINES.values())))
    foot = FOOT.format(steps=", ".join(f"{degrees:g}°" for degrees in sorted(work_precision.degrees(own), reverse=True)))
    figure, grid = error_panel.grid_of(f"Error and time of finding gaps: {work_precision.scene_title(scene)}", foot, 3.2, 1.45, 0.0)
    for axes, (column, (title, unit, scale)) in zip(grid.flat, PANELS.items()):
        points = work_precision.fastest(own, column)
        points = points.assign(cost=scale * points[column], step=points.step.where(points.step.str.endswith("°"), ""))
        error_panel.draw(axes, points, error_panel.MICROMETRES, looks)
        error_panel.write_steps(axes, points, error_panel.MICROMETRES, looks)
        axes.set(title=title, ylabel=unit)
    keys = [common.key(NAMES[line], **looks[line], markersize=5) for line in looks if line in set(own.line)]
    keys.append(common.key("proven bound of the same, in any direction", color="black", marker="|", linestyle=":", linewidth=0.8))
    figure.legend(handles=keys, loc="lower center", bbox_to_anchor=(0.5, 0.42 / figure.get_figheight()), ncols=3)
    return figure


common.run(main, "--scene", "--name")
