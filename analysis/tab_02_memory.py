# SPDX-License-Identifier: GPL-3.0-or-later
"""Table 2, entries and memory of the RSID table: thesis beside ours. From data/lut_memory.csv."""

import pandas as pd

import common

SCHEME = "rsid"  # Table 2 of the thesis is about this one


def main() -> None:
    """Writes tables/table-2.csv and .tex."""
    options = common.arguments(__doc__)
    ours = common.load(options.results, "lut_memory")
    ours = ours[ours.scheme == SCHEME].set_index("precision_deg")
    thesis = common.thesis("table-2").pivot(index="row", columns="column", values="value")
    lines = pd.DataFrame(
        [
            {
                "precision_deg": precision,
                "thesis_entries": int(thesis.lut_entries[f"{precision:g}deg"]),
                "measured_entries": row.entries,
                "bytes_per_entry": row.bytes_per_entry,
                "thesis_mib": thesis.memory[f"{precision:g}deg"],
                "measured_mib": row.bytes / 2**20,
            }
            for precision, row in ours.iterrows()
            if f"{precision:g}deg" in thesis.index
        ]
    )
    common.write_table(options.out, "table-2", lines, latex(lines))


def latex(lines: pd.DataFrame) -> str:
    """Entries and MiB, thesis and here."""
    rows = [
        f"{line.precision_deg:g}\\textdegree & {line.thesis_entries:,} & {line.measured_entries:,.0f} & "
        f"{line.thesis_mib} & {line.measured_mib:,.3f} \\\\"
        for line in lines.itertuples()
    ]
    return "\n".join(
        [
            "\\begin{tabular}{@{}lrrrr@{}}",
            "\\toprule",
            " & \\multicolumn{2}{c}{entries} & \\multicolumn{2}{c}{memory, MiB} \\\\",
            "\\cmidrule(lr){2-3}\\cmidrule(lr){4-5}",
            "Precision & thesis & here & thesis & here \\\\",
            "\\midrule",
            *rows,
            "\\bottomrule",
            "\\end{tabular}",
            "",
        ]
    )


common.run(main)
