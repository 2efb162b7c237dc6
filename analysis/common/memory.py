# SPDX-License-Identifier: GPL-3.0-or-later
"""Entries and memory of a table of the thesis, compared with ours (Tables 2 and 7)."""

from pathlib import Path

import pandas as pd

import common

SCHEMES = {"table-2": "rsid", "table-6": "usid", "table-7": "usid"}  # what each table of the thesis is about
MIB = 2**20  # bytes: the "MB" of the thesis


def ours(results: Path, artefact: str) -> pd.DataFrame:
    """The rows of lut_memory.csv for the scheme of that table, by precision."""
    table = common.load(results, "lut_memory")
    return table[table.scheme == SCHEMES[artefact]].set_index("precision_deg")


def compare(results: Path, artefact: str) -> pd.DataFrame:
    """One row for each precision of the table; the thesis' digits are text."""
    filling = common.load(results, "fill_memory").set_index(["method", "precision_deg"])
    thesis = common.thesis(artefact).pivot(index="row", columns="column", values="value")
    return pd.DataFrame(
        [
            {
                "precision_deg": precision,
                "thesis_entries": int(thesis.lut_entries[f"{precision:g}deg"]),
                "measured_entries": row.entries,
                "bytes_per_entry": row.bytes_per_entry,
                "thesis_mib": thesis.memory[f"{precision:g}deg"],
                "measured_mib": row.bytes / MIB,
                "filled_mib": row.filled_bytes / MIB,
                "peak_mib": filling.peak_bytes[f"{SCHEMES[artefact]}_thesis", precision] / MIB,
            }
            for precision, row in ours(results, artefact).iterrows()
            if f"{precision:g}deg" in thesis.index
        ]
    )


def cells(line) -> list[str]:
    """Entries and MiB of a row of compare(), for thesis and here; our MiB with a rim mask beside the radii; and the peak while
    the table is filled as in the thesis.
    """
    return [
        f"{line.thesis_entries:,}",
        f"{line.measured_entries:,.0f}",
        line.thesis_mib,
        f"{line.measured_mib:,.3f}",
        f"{line.filled_mib:,.3f}",
        f"{line.peak_mib:,.3f}",
    ]
