# SPDX-License-Identifier: GPL-3.0-or-later
# @name      scheme-comparison
# @question  Every sampling scheme: covering, evenness, time of a look-up, memory saved.
# @data      schemes scheme_covering scheme_errors scheme_savings lookup_time
"""Every sampling scheme in one table: covering, evenness, time of a look-up, memory saved."""

import re

import pandas as pd

import common

PRECISION = 1.0  # degrees, of the table that savings are counted from
SAVINGS = ["covering_radius", "interpolation_p9999", "interpolation_rms"]


def main(options) -> common.Table:
    schemes, covering, lookup, savings = (
        common.load(options.results, name)
        for name in ("schemes", "scheme_covering", "lookup_time", "scheme_savings")
    )
    saved = savings[savings.precision_deg == PRECISION]
    saved = saved.pivot(index="scheme", columns="meaning", values="saved_percent")
    lines = (
        schemes.drop(columns=["covering_radius_deg", "equator_points"])
        .merge(covering[["scheme", "constant_away"]], on="scheme")
        .merge(lookup[["scheme", "median_ns"]], on="scheme")
        .merge(saved[SAVINGS].add_prefix("saved_percent_"), left_on="scheme", right_index=True, how="left")
        .sort_values("covering_constant", kind="stable", ignore_index=True)
    )
    return lines, latex(lines)


def short(citation: str) -> str:
    """Names and year of the first source, such as "Gorski et al. 2005"; without a year, the words before a comma."""
    first = citation.split(";")[0]
    name = r"[A-Z][\w'-]+"
    found = re.search(rf"({name}(?:(?:, | and | & ){name})*)( et al\.)? \(?(\d{{4}})", first)
    if not found:
        return first.split(",")[0]
    names = re.split(r", | and | & ", found[1])
    return f"{names[0]} et al. {found[3]}" if found[2] or len(names) > 2 else f"{found[1]} {found[3]}"


def latex(lines: pd.DataFrame) -> str:
    """One row per scheme, the best covering first."""
    body = [
        [
            common.tex(line.label),
            common.tex(short(line.citation)),
            f"{line.entries:,}",
            common.digits(line.covering_constant),
            common.digits(line.constant_away),
            common.digits(line.max_area_ratio),
            common.digits(line.median_ns),
            *(percent(getattr(line, f"saved_percent_{meaning}")) for meaning in SAVINGS),
        ]
        for line in lines.itertuples()
    ]
    return common.tabular(
        r"@{}llrrrrrrrr@{}",
        [
            r" & & & \multicolumn{2}{c}{$N\rho^2$} & area & look-up & "
            r"\multicolumn{3}{c}{saved at equal, \%} \\",
            r"\cmidrule(lr){4-5}\cmidrule(l){8-10}",
            r"Scheme & Source & entries & all & off poles & ratio & ns & $\rho$ & $e_{99.99}$ & rms \\",
        ],
        body,
    )


def percent(value: float) -> str:
    """A whole percentage with a true minus sign; a dash where nothing was found."""
    return "---" if pd.isna(value) else f"{value:,.0f}".replace("-", "$-$")


common.run(main)
