# SPDX-License-Identifier: GPL-3.0-or-later
# @name      paper-facts
# @question  Every number that the text of the papers names.
# @data      sampling_time detection_time strain_layer
# @depends   verdicts.csv tables/figure-50-difference.csv tables/findings.csv
# @outputs   paper/facts.tex
"""Every number that the text of the papers names, as \\setfact{key}{text}. From verdicts.csv and the sidecars of
the timed data.

Keys: count:VERDICT and :all, count:ARTEFACT:VERDICT or :all that were not given, each number of the thesis once;
count:KIND:VERDICT and :all for computed, measured and given; thesis, measured, low and rounded:ARTEFACT:ROW:COLUMN;
exponent:DATA:METHOD (of what was measured) and exponent-thesis:...; ratio:DATA:KEY:METHOD/METHOD of our
times of the generated pair, as ratio:sampling_time:0.05:usid/rsid; rounds, control and inconclusive:DATA; finding:VERDICT, :all of the thesis, :others;
one for each number of further CSVs (see MODULES), as scheme:usid:covering_constant;
difference:JOINT:SURFACE:largest (mm), :changed and :vertices of the gaps by the thesis' two tables; and the
machine: cpu, cores, compiler, flags, commit and profile.
"""

from pathlib import Path

import pandas as pd

import common
from common import strain, tally, timing
from findings import finding
from paper import baselines, cells, error_against_time, limits, needs, studies, theorems, volume, whole
from verdicts import verdict

MODULES = (cells, studies, error_against_time, strain, baselines, limits, needs, volume, whole, theorems)
MACHINE = ["cpu", "cores", "compiler", "flags", "profile", "commit"]


def verdict_facts(verdicts: pd.DataFrame) -> dict[str, str]:
    """How often each verdict was given, each number once, and the values of each row."""
    counted = verdict.counted(verdicts)
    facts = {f"count:{name}": str((counted.verdict == name).sum()) for name in verdict.VERDICTS}
    facts["count:all"] = str(len(counted))
    for kind, found in tally.counts(verdicts.to_dict("records")).items():
        facts |= {f"count:{kind}:{name}": str(found[name]) for name in verdict.VERDICTS} | {f"count:{kind}:all": str(found.total())}
    for artefact, rows in counted.groupby("artefact"):
        facts |= {f"count:{artefact}:{name}": str((rows.verdict == name).sum()) for name in verdict.VERDICTS}
        facts[f"count:{artefact}:all"] = str((rows.verdict != "input").sum())
    for row in verdicts.itertuples():
        name = f"{row.artefact}:{row.row}:{row.column}"
        facts |= {
            f"thesis:{name}": grouped(row.thesis),
            f"measured:{name}": grouped(row.measured),
            f"low:{name}": rounded(row.low),
            f"rounded:{name}": rounded(row.measured),
        }
    return facts


def grouped(text: str) -> str:
    """Thousands kept apart, for a number; anything else as it is."""
    try:
        number = float(text)
    except ValueError:
        return text
    return f"{number:,.10g}" if number >= 1000 else text


def rounded(text: str) -> str:
    """Three significant digits, for a number; anything else as it is."""
    try:
        return common.digits(float(text))
    except ValueError:
        return text


def timing_facts(results: Path, table: timing.TimingTable) -> dict[str, str]:
    """Growth of each method, ratios, rounds, control and inconclusive cases of a timed table."""
    lines = timing.compare(results, table)
    lines = lines[lines.joint == timing.GENERATED]
    size = lines["size"]
    facts = {}
    for method in lines.method.unique():
        mine = (lines.method == method) & ~lines.extrapolated
        facts[f"exponent:{table.data}:{method}"] = f"{timing.slope(size[mine], lines.measured_ms[mine]):.2f}"
        every = lines.method == method
        if lines.thesis_ms[every].notna().any():
            facts[
                f"exponent-thesis:{table.data}:{method}"
            ] = f"{timing.slope(size[every], lines.thesis_ms[every]):.2f}"
    facts |= ratio_facts(lines, table)
    data = common.load(results, table.data)
    rounds = data[~data.extrapolated].rounds
    protocol = data.attrs.get("timing") or {}
    facts[f"rounds:{table.data}"] = (
        f"{rounds.min()}" if rounds.min() == rounds.max() else f"{rounds.min()} to {rounds.max()}"
    )
    facts[f"control:{table.data}"] = f"{protocol.get('control', {}).get('ratio', float('nan')):.3f}"
    facts[f"inconclusive:{table.data}"] = str(len(protocol.get("inconclusive", [])))
    facts |= {f"parameter:{table.data}:{key}": str(value) for key, value in data.attrs["parameters"].items()}
    return facts


def ratio_facts(lines: pd.DataFrame, table: timing.TimingTable) -> dict[str, str]:
    """Every time of ours over every other one of the same row."""
    return {
        f"ratio:{table.data}:{key:g}:{one.method}/{other.method}": common.digits(one.measured_ms / other.measured_ms)
        for key, group in lines.groupby(table.key)
        for one in group.itertuples()
        for other in group.itertuples()
        if one.method != other.method
    }


def difference_facts(results: Path) -> dict[str, str]:
    """How far the gaps by RSID and by USID are apart, and how many vertices change sides of a threshold."""
    table = pd.read_csv(results / "tables" / "figure-50-difference.csv")
    facts = {}
    for (joint, surface), rows in table.groupby(["joint", "surface"]):
        name = f"difference:{joint}:{surface}"
        facts[f"{name}:largest"] = common.digits(rows.largest_difference_mm.iloc[0], 2)
        facts[f"{name}:changed"] = f"{rows.changed.sum():,}"
        facts[f"{name}:vertices"] = f"{rows.met_by_both.iloc[0]:,}"
    return facts


def finding_facts(results: Path) -> dict[str, str]:
    """How many statements of the thesis hold, and how many do not."""
    table = pd.read_csv(results / "tables" / "findings.csv")
    own = table[table.said_by == finding.THESIS]
    facts = {f"finding:{name}": str((own.verdict == name).sum()) for name in finding.VERDICTS}
    return facts | {"finding:all": str(len(own)), "finding:others": str(len(table) - len(own))}


def main(options) -> None:
    """Writes paper/facts.tex."""
    verdicts = common.as_text(options.results / "verdicts.csv")
    record = common.sidecar(options.results / "data" / f"{timing.TABLE_4.data}.csv")
    facts = {key: str(record.get(key, "unknown")) for key in MACHINE}
    facts["commit"] = facts["commit"][:12]
    facts["flags"] = " ".join(
        flag for flag in facts["flags"].split() if not flag.startswith("-W")
    )  # warnings change nothing
    facts |= verdict_facts(verdicts)
    facts |= difference_facts(options.results)
    facts |= finding_facts(options.results)
    for module in MODULES:
        facts |= module.facts(options.results)
    for table in (timing.TABLE_8, timing.TABLE_9):  # they hold Tables 3 and 4
        facts |= timing_facts(options.results, table)
    lines = [f"\\setfact{{{key}}}{{{common.tex(value)}}}" for key, value in facts.items()]
    common.write(options.out / "paper" / "facts.tex", "\n".join(lines) + "\n")


common.run(main)
