# SPDX-License-Identifier: GPL-3.0-or-later
# @data      error_against_time error_against_time_spread
# @options   --name NAME
# @name      error-against-time
# @question  The error of every method against the time of a query, of filling, and memory.
# @name      error-against-time-scenes
# @question  The error of every method against the time of a query, on every scene.
"""Error against cost of every method, on one scene or on the query of every scene: lower left is better."""

import itertools

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd

import common
from common import cost_marks, pareto

REFERENCES = ["embree_ray8, robust", "rsid_thesis", "usid_thesis"]  # coloured wherever they are there
# Below this error, um, where only exact methods are, a decade has this share of the width of one above.
EXACT = 1e-3
SHARE = 0.18
LEAST = 1e-10  # um


def main(options) -> common.Figure:
    """error-against-time is the main scene with its three costs,
    error-against-time-scenes the query of every scene.
    """
    table = pareto.load(options.results)
    points = pareto.fronts(table)
    table = table.merge(
        points.pivot(index=pareto.KEYS, columns="cost", values="on_front").reset_index(),
        on=pareto.KEYS,
        how="left",
        suffixes=("", "_front"),
    )
    draw = costs_of_main_scene if options.name == "error-against-time" else queries_of_scenes
    return draw(table)


def costs_of_main_scene(table: pd.DataFrame) -> plt.Figure:
    """Three panels, one a cost."""
    names = list(table.scene.unique())
    scene = pareto.main_scene(names)
    own = table[table.scene == scene]
    looks = looks_of(own, list(pareto.COSTS))
    figure, grid = plt.subplots(2, 2, figsize=(common.WIDTH, 5.4))
    for axes, cost in zip(grid.flat, pareto.COSTS):
        panel(axes, own, cost, looks, labelled=True)
        axes.set(title=pareto.COSTS[cost].split(",")[0].capitalize(), ylabel=pareto.COSTS[cost])
    figure.suptitle(
        f"Error against cost, {scene.replace('_', ' ')}: lower left is better", x=0.01, ha="left", fontsize=11
    )
    figure.tight_layout()
    grid[1, 1].set_axis_off()
    cost_marks.legend(grid[1, 1], looks, loc="upper left", bbox_to_anchor=(-0.12, 1.05))
    return figure


def queries_of_scenes(table: pd.DataFrame) -> plt.Figure:
    """One panel a scene."""
    scenes = list(table.scene.unique())
    columns = min(3, len(scenes))
    lines = -(-len(scenes) // columns)
    looks = looks_of(table, ["query_ns"])
    figure, grid = plt.subplots(
        lines, columns, figsize=(5.2 * columns, 4.4 * lines), sharex=True, sharey=True, squeeze=False
    )
    for axes in grid.flat[len(scenes) :]:
        axes.set_axis_off()
    for axes, scene in zip(grid.flat, scenes):
        panel(axes, table[table.scene == scene], "query_ns", looks, labelled=False)
        axes.set(title=scene.replace("_", " "))
        axes.xaxis.set_tick_params(labelbottom=True)
    for axes in grid[:, 0]:
        axes.set_ylabel(pareto.COSTS["query_ns"])
    figure.suptitle("Error against the time of a query: lower left is better", x=0.125, y=0.96, ha="left")
    figure.subplots_adjust(hspace=0.32, wspace=0.08)
    cost_marks.legend(
        figure, looks, loc="upper left", bbox_to_anchor=(0.12, 0.02 if lines > 1 else -0.06), ncol=4
    )
    return figure


def looks_of(table: pd.DataFrame, costs: list[str]) -> dict[str, dict]:
    """A look for the lines that are coloured: those most often on the front of each cost, and the references."""
    ranked = []
    for cost in costs:
        often = table[f"{cost}_front"].eq(True).groupby(table.line).sum()  # NaN: not in the benchmark
        often = often[often > 0].sort_values(ascending=False, kind="stable")
        ranked.append(list(often.index))
    turns = [line for turn in itertools.zip_longest(*ranked) for line in turn if line is not None]
    chosen = list(dict.fromkeys(turns))[: len(common.COLOURS) - 1]
    chosen += [line for line in REFERENCES if line in set(table.line) and line not in chosen]
    looks = common.look(chosen)
    for line in chosen[len(common.COLOURS) :]:
        looks[line]["color"] = "#555555"
    return looks


def panel(axes: plt.Axes, own: pd.DataFrame, cost: str, looks: dict, labelled: bool) -> None:
    """Every line of one scene against one cost; those without a look are faded."""
    axes.set_xscale("function", functions=(squeezed, spread_out))
    axes.set(yscale="log", xlabel="largest error measured, µm", xlim=(LEAST, 0.3 * cost_marks.MOST))
    ticks = [1e-8, *(10.0**k for k in range(-2, 5))]
    axes.set_xticks(ticks, [f"$10^{{{round(np.log10(tick))}}}$" for tick in ticks])
    axes.axvspan(LEAST, EXACT, color="#f3f3f3", zorder=0)
    own = own[np.isfinite(own.error_um) & np.isfinite(own[cost]) & (own[cost] > 0)]
    axes.set_ylim(0.6 * own[cost].min(), 1.6 * own[cost].max())
    shown = own.assign(x=own.error_um.clip(LEAST, cost_marks.MOST))
    for line, group in shown.groupby("line", sort=False):
        group = group.sort_values(["precision_deg", "x"], ascending=[False, True])
        look = looks.get(line)
        colour = look["color"] if look else cost_marks.FADED
        axes.plot(
            group.x,
            group[cost],
            color=colour,
            linestyle=look["linestyle"] if look else "-",
            linewidth=1.3 if look else 0.7,
            marker=look["marker"] if look else ".",
            markersize=5.5 if look else 4,
            markerfacecolor=colour if group.measure.iloc[0] == "radial" else "white",
            zorder=3 if look else 1,
        )
        cost_marks.failures(axes, group, cost)
        if look:
            cost_marks.whiskers(axes, group, cost, colour)
            cost_marks.bounds(axes, group, cost, look)
            if labelled:
                cost_marks.steps(axes, group, cost, colour)
    cost_marks.staircase(axes, shown, cost)
    cost_marks.floors(axes)


def squeezed(error: np.ndarray) -> np.ndarray:
    """Logarithm, with the decades below EXACT pushed together."""
    x = np.log10(np.clip(error, LEAST, None) / EXACT)
    return np.where(x < 0, SHARE * x, x)


def spread_out(place: np.ndarray) -> np.ndarray:
    """The inverse of squeezed()."""
    x = np.asarray(place, dtype=float)
    return EXACT * 10 ** np.where(x < 0, x / SHARE, x)


common.run(main, "--name")
