# SPDX-License-Identifier: GPL-3.0-or-later
# @name      error-against-time
# @question  The error of every method against its time: a vertex, all gaps, touch, smallest gap, first contact.
# @data      error_against_time error_against_time_spread all_gaps contact first_contact
"""Error against time, lower left is better: a panel a question."""

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd

import common
from common import error_panel, fast, pareto

REFERENCES = {  # labelled wherever they are: what a reader knows, or compares with
    "cgal_first_hit": "CGAL, first hit",
    "rsid_thesis": "thesis, RSID",
    "usid_thesis": "thesis, USID",
}


def main(options) -> common.Figure:
    """A panel a question; but for the vertex, of a hip."""
    results = options.results
    table = pareto.load(results)
    figure, grid = error_panel.grid_of(3, 3.3)
    scene = pareto.main_scene(list(table.scene.unique()))
    error_panel.draw(grid[0, 0], queries(table[table.scene == scene]))
    grid[0, 0].set(title="Gap of a vertex, asked alone", ylabel="time of a query, ns")
    gaps = scans(fast.load(results, scenes=fast.HIPS))
    error_panel.draw(grid[0, 1], gaps)
    grid[0, 1].set(title=f"All gaps of a pose, {words(gaps)}", ylabel="time of a vertex, ns")
    poses = hip_rows(fast.contacts(results, scenes=fast.HIPS))
    bars(grid[1, 0], poses[poses.question == "touch"])
    grid[1, 0].set(title=f"Touch, {words(poses)}")
    bars(grid[1, 1], poses[poses.question != "touch"])
    grid[1, 1].set(title=f"Smallest gap, {words(poses)}")
    turns = motions(hip_rows(common.load(results, "first_contact")))
    error_panel.draw(grid[2, 0], turns, error_panel.DEGREES)
    grid[2, 0].set(title=f"First contact of a motion, {words(turns)}", ylabel="time of a motion, ms")
    grid[2, 1].set_axis_off()
    return figure


def queries(own: pd.DataFrame) -> pd.DataFrame:
    """What asks for the radius along a direction; of Embree's ways the fastest."""
    rows = own[pareto.competes(own) & (own.query_ns > 0)].copy()
    embree = rows.method.str.startswith("embree")
    names = rows.method.map(REFERENCES).fillna(rows.method.map(common.label))
    rows["name"] = np.where(embree, "Embree", names)
    rows["always"] = embree | rows.method.isin(list(REFERENCES))
    own = rows[rows.kind == "ours"]
    if not own.empty:
        rows.loc[own.query_ns.idxmin(), "always"] = True
    rows["group"] = np.where(embree, "embree", rows.line)
    return rows.rename(columns={"query_ns": "cost", "error_um": "error", "bound_um": "bound"})


def hip_rows(table: pd.DataFrame) -> pd.DataFrame:
    """Those of the normal hip, or of the first there is."""
    scene = f"{fast.HIPS}normal_{fast.TRIANGLES}"
    return table[table.scene == (scene if scene in set(table.scene) else table.scene.iloc[0])]


def scans(table: pd.DataFrame) -> pd.DataFrame:
    """Kernels and others' libraries on a hip, ball to socket, one thread."""
    rows = fast.one_thread(hip_rows(table))
    rows = rows[(rows.direction == "ball->socket") & (rows.measure == "radial") & (rows.method != "floor")].copy()
    embree = rows.method.str.startswith("embree")
    scalar = rows.method.str.endswith("_scalar")
    rows["name"] = np.where(embree, "Embree", rows.line)
    rows["always"] = embree | scalar | rows.method.isin(["cgal_first_hit", "cube_cells_exact"])
    rows["group"] = np.where(embree, "embree", rows.line)
    return rows.rename(columns={"ns_vertex": "cost", "error_um": "error"}).assign(bound=np.nan)  # no kernel proves one


def words(rows: pd.DataFrame) -> str:
    """The hip of the rows and its thousands of triangles, as a reader reads them."""
    preset, triangles = rows.scene.iloc[0].removeprefix(fast.HIPS).rsplit("_", 1)
    return f"{preset.replace('_', ' ')} hip, {int(triangles) // 1000}k"


def motions(table: pd.DataFrame) -> pd.DataFrame:
    """A line a method over its steps."""
    rows = table.copy()
    rows["name"] = rows.method.map(table.attrs["labels"]).fillna(rows.method)
    rows["always"] = True
    rows["group"] = rows.method
    return rows.rename(columns={"ms_motion": "cost", "error_deg": "error", "bound_deg": "bound"})


def bars(axes: plt.Axes, rows: pd.DataFrame) -> None:
    """One bar a method, from the fastest to the slowest of the three gaps; with its largest error, where it has one."""
    spans = rows.groupby("line").us_pose.agg(["min", "median", "max"]).sort_values("median", ascending=False)
    errors = rows.groupby("line").error_um.max()
    for place, (line, span) in enumerate(spans.iterrows()):
        axes.plot([span["min"], span["max"]], [place, place], color=common.COLOURS[0], linewidth=5, alpha=0.35)
        axes.plot(span["median"], place, "o", color=common.COLOURS[0], markersize=5)
        left = span["median"] > np.sqrt(spans["median"].min() * spans["median"].max())
        exact = not errors[line] >= error_panel.MICROMETRES.least
        common.note(
            axes,
            line if exact else f"{line} ({common.digits(errors[line], 2)} µm)",
            (span["min"] if left else span["max"], place),
            (-7 if left else 7, 0),
            ha="right" if left else "left",
            va="center",
        )
    axes.set(xscale="log", yticks=[], ylim=(-0.6, len(spans) - 0.4), xlabel="time of a pose, µs")
    axes.set_xlim(spans["min"].min() / 2, spans["max"].max() * 2)


common.run(main)
