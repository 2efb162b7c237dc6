# SPDX-License-Identifier: GPL-3.0-or-later
# @name      certified-verdicts
# @question  How many vertices do certified ranges decide, and which contacts do vertex tests miss?
# @data      certified certified_poses schemes
"""What certified ranges decide, by precision, and how much later scans of vertices see a contact than the surfaces make
it.
"""

import matplotlib.pyplot as plt
import pandas as pd

import common

SMALLEST_UM = 0.01  # what is less, or nothing, is drawn here
SHARES = [0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50]  # %
FACES = [100, 300, 1000, 3000, 10000, 30000]


def main(options) -> common.Figure:
    verdicts = common.load(options.results, "certified")
    poses = common.load(options.results, "certified_poses")
    figure, (left, right) = plt.subplots(1, 2, figsize=(common.WIDTH, 3.6))
    draw_undecided(left, verdicts, common.scheme_labels(options.results))
    draw_missed(right, poses)
    figure.tight_layout()
    for axes, at, columns in ((left, 0.02, 2), (right, 0.58, 1)):
        figure.legend(*axes.get_legend_handles_labels(), loc="upper left", bbox_to_anchor=(at, 0.0), ncols=columns)
    return figure


def draw_undecided(axes: plt.Axes, table: pd.DataFrame, labels: dict[str, str]) -> None:
    """Share of vertices that the ranges leave to the exact test, over the joints that were examined at every
    precision; a line a scheme.
    """
    precisions = sorted(table.precision_deg.unique())
    all_of_them = table.groupby("joint").precision_deg.transform("nunique") == len(precisions)
    groups = table[all_of_them].groupby(["scheme", "precision_deg"], sort=False)
    sums = groups[["undecided", "vertices"]].sum()
    sums["share"] = (100 * sums.undecided / sums.vertices).clip(lower=SHARES[0])
    sums = sums.reset_index()
    for scheme, look in common.scheme_looks(list(sums.scheme)).items():
        lines = sums[sums.scheme == scheme].sort_values("precision_deg")
        axes.plot(lines.precision_deg, lines.share, label=labels[scheme], **look)
    axes.set(
        xscale="log",
        yscale="log",
        xlabel="precision of the ranges, finer to the right",
        ylabel="vertices that they leave undecided, %",
        title="Ranges decide all but a few vertices",
    )
    axes.set_xticks(precisions, [f"{p:g}°" for p in precisions])
    axes.set_xlim(1.15 * precisions[-1], precisions[0] / 1.15)
    shown = [tick for tick in SHARES if sums.share.min() / 2.5 <= tick <= sums.share.max() * 2.5]
    axes.set_yticks(shown, [f"{tick:g}" for tick in shown])
    axes.minorticks_off()


def draw_missed(axes: plt.Axes, table: pd.DataFrame) -> None:
    """How deep surfaces are in each other while all vertices are clear, and how much farther a motion goes
    before one is not.
    """
    faces = table.ball_faces + table.socket_faces
    generated = table.joint.str.startswith("generated")
    columns = {
        "largest_later_um": ("way on to the first vertex", common.COLOURS[0]),
        "largest_missed_um": ("depth with all vertices clear", common.COLOURS[1]),
    }
    for of_pair, marker, whose in ((True, "o", "generated"), (False, "s", "real joints")):
        rows = table[generated == of_pair]
        if rows.empty:
            continue
        for column, (text, colour) in columns.items():
            common.marks(
                axes,
                faces[rows.index],
                rows[column].clip(lower=SMALLEST_UM),
                marker=marker,
                color=colour,
                markerfacecolor=colour if column == "largest_later_um" else "white",
                label=f"{text}, {whose}",
            )
    for at, row in zip(faces, table.itertuples()):
        top = max(row.largest_later_um, row.largest_missed_um, SMALLEST_UM)
        if row.crossings_matter:
            common.note(axes, f"{100 * row.crossings_matter / row.poses:.2g} %", (at, top), (0, 6), ha="center")
    axes.set(
        xscale="log",
        yscale="log",
        xlabel="faces of both models",
        ylabel="largest, µm",
        title="Edge contacts that vertex tests miss (labels: % of poses)",
    )
    shown = [tick for tick in FACES if faces.min() / 3 <= tick <= faces.max() * 3]
    axes.set_xticks(shown, [f"{tick:,}" for tick in shown])
    axes.minorticks_off()
    axes.set_ylim(top=axes.get_ylim()[1] * 3)
    axes.yaxis.set_major_formatter(lambda value, _: f"{value:,g}")


common.run(main)
