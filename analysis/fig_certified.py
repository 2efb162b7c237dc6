# SPDX-License-Identifier: GPL-3.0-or-later
"""What certified ranges decide, by precision, and how much later scans of vertices see a contact than the
surfaces make it. From data/certified.csv, certified_poses.csv and schemes.csv.
"""

import matplotlib.pyplot as plt
import pandas as pd

import common

SMALLEST_UM = 0.01  # where a contact is drawn that vertices see at once


def main() -> None:
    """Writes figures/certified.svg, .png and .pdf."""
    options = common.arguments(__doc__)
    verdicts = common.load(options.results, "certified")
    poses = common.load(options.results, "certified_poses")
    common.style()
    figure, (left, right) = plt.subplots(1, 2, figsize=(10.4, 4.8))
    draw_undecided(left, verdicts, common.scheme_labels(options.results))
    draw_late(right, poses)
    figure.tight_layout()
    common.save_figure(figure, options.out, "certified")


def draw_undecided(axes: plt.Axes, table: pd.DataFrame, labels: dict[str, str]) -> None:
    """Share of vertices that the ranges leave to the exact test, over all joints; a line a scheme."""
    sums = table.groupby(["scheme", "precision_deg"], sort=False)[["undecided", "vertices"]].sum().reset_index()
    sums["share"] = 100 * sums.undecided / sums.vertices
    for i, (scheme, look) in enumerate(common.look(list(sums.scheme)).items()):
        if i >= len(common.COLOURS):
            look |= {"markerfacecolor": "white", "linestyle": common.DASHES[(i + 1) % len(common.DASHES)]}
        lines = sums[sums.scheme == scheme].sort_values("precision_deg")
        axes.plot(lines.precision_deg, lines.share, label=labels[scheme], linewidth=1.1, markersize=5, **look_of(look))
    precisions = sorted(sums.precision_deg.unique())
    axes.set(
        xscale="log",
        yscale="log",
        xlabel="precision, finer to the right",
        ylabel="vertices left undecided, %",
        title="Ranges decide all but a few vertices",
    )
    axes.set_xticks(precisions, [f"{p:g}°" for p in precisions])
    axes.set_xlim(1.1 * precisions[-1], precisions[0] / 1.1)
    axes.minorticks_off()
    axes.yaxis.set_major_formatter(lambda value, _: f"{value:g}")
    axes.legend(loc="upper left", bbox_to_anchor=(0, -0.17), ncols=3, fontsize=8)


def look_of(look: dict) -> dict:
    """A look of a line that says its width and size itself."""
    return {key: value for key, value in look.items() if key not in ("linewidth", "markersize")}


def draw_late(axes: plt.Axes, table: pd.DataFrame) -> None:
    """How far a motion goes on between the contact of the surfaces and the first one of a vertex."""
    faces = table.ball_faces + table.socket_faces
    colour, other = common.COLOURS[0], common.COLOURS[1]
    generated = table.joint.str.startswith("generated")
    for of_pair, marker in ((True, "o"), (False, "s")):
        rows = table[generated == of_pair]
        if rows.empty:
            continue
        whose = "generated pair" if of_pair else "real joints"
        x = faces[rows.index]
        late = rows.largest_later_um.clip(lower=SMALLEST_UM)
        axes.plot(x, late, linestyle="none", marker=marker, color=colour, label=f"latest vertex, {whose}")
        axes.plot(
            x,
            rows.largest_missed_um.clip(lower=SMALLEST_UM),
            linestyle="none",
            marker=marker,
            color=other,
            markerfacecolor="white",
            label=f"deepest unseen contact, {whose}",
        )
        for at, row in zip(x, rows.itertuples()):
            share = 100 * row.crossings_matter / row.poses
            axes.annotate(
                f"{share:.2g} %",
                (at, max(row.largest_later_um, SMALLEST_UM)),
                xytext=(0, 6),
                textcoords="offset points",
                ha="center",
                fontsize=8,
            )
    axes.set(
        xscale="log",
        yscale="log",
        xlabel="faces of ball and socket together",
        ylabel="µm",
        title="What scans of vertices miss where edges cross",
    )
    axes.set_ylim(top=axes.get_ylim()[1] * 2)
    axes.yaxis.set_major_formatter(lambda value, _: f"{value:,g}")
    axes.xaxis.set_major_formatter(lambda value, _: f"{value:,g}")
    axes.legend(loc="upper left", bbox_to_anchor=(0, -0.17), fontsize=8)
    axes.text(
        0.98,
        0.98,
        "% of poses in which only edges touch",
        transform=axes.transAxes,
        ha="right",
        va="top",
        fontsize=8,
    )


common.run(main)
