# SPDX-License-Identifier: GPL-3.0-or-later
"""What the figures of stability share: who is drawn how, places of the magnitudes, lines of errors, the legend."""

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
from matplotlib.patches import Patch

import common
from common import stability

FLOOR = 1e-3  # smaller errors, and none at all, are drawn here
BAND = "#dceefb"  # errors of order one
MOST_TICKS = 8  # of a panel
LIMIT = (0, (5, 3))  # the dashes of a threshold
FAILURES = "hits missed or false, wrong values"


def looks(cases: pd.DataFrame) -> dict[str, dict]:
    """Ours are full, others hollow."""
    found = common.look(list(cases.who.cat.categories))
    for name, look in found.items():
        look |= {"linewidth": 1.2, "markersize": 5}
        if name not in stability.OURS.values():
            look |= {"markerfacecolor": "white", "linewidth": 0.9}
    return found


def lines_of(cases: pd.DataFrame, column: str) -> pd.DataFrame:
    """The worst of the methods behind each line: a row a magnitude, a column a line."""
    worst = cases.pivot_table(index="magnitude", columns="who", values=column, aggfunc="max", observed=True)
    return worst.reindex(stability.magnitudes(cases))


def ticks(axes: plt.Axes, cases: pd.DataFrame) -> None:
    """One place a magnitude."""
    texts = [stability.power(value) for value in stability.magnitudes(cases)]
    axes.set_xticks(range(len(texts)), texts)
    axes.set_xlim(-0.4, len(texts) - 0.6)


def fewer_ticks(axes: plt.Axes) -> None:
    """Text at every second or third place, where a panel is narrow."""
    texts = [label.get_text() for label in axes.get_xticklabels()]
    step = -(-len(texts) // MOST_TICKS)
    axes.set_xticklabels([text if k % step == 0 else "" for k, text in enumerate(texts)])


def draw_errors(axes: plt.Axes, cases: pd.DataFrame, column: str, of_all: dict[str, dict]) -> None:
    """A line a method, between the floor and the ceiling of the axes; what is beyond stands at its edge."""
    worst = lines_of(cases, column)
    low, high = axes.get_ylim()
    for name in worst.columns:
        values = worst[name].clip(lower=low, upper=high)
        axes.plot(np.arange(len(values)), values, **of_all[name], clip_on=False)


def band(axes: plt.Axes, threshold: float, high: float) -> None:
    """Errors of order one, and the threshold."""
    axes.set_yscale("log")
    axes.set_ylim(FLOOR, high)
    axes.axhspan(FLOOR, 1, color=BAND, zorder=0)
    axes.axhline(threshold, color="black", linewidth=0.8, linestyle=LIMIT)
    axes.minorticks_off()


def legend_of(of_all: dict[str, dict]) -> list:
    """The lines, and what else is drawn."""
    lines = [common.key(name, **look) for name, look in of_all.items()]
    return lines + [
        Patch(color=BAND, label="as good as the input, rounded once"),
        common.key("allowed of ours (analysis)", color="black", linewidth=0.8, linestyle=LIMIT),
        common.key(FAILURES, color="black", marker="x", linestyle="none"),
    ]


def ceiling(cases: pd.DataFrame) -> float:
    """A power of ten above all that is finite."""
    values = cases.error_over_condition_u.replace(np.inf, np.nan)
    return 10.0 ** np.ceil(np.log10(max(values.max(), 1e3)) + 0.3)


def unit_text(family: pd.Series) -> str:
    """The unit in brackets, where there is one."""
    return "" if family.unit in ("1", "") else f" ({family.unit})"
