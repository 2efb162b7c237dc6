# SPDX-License-Identifier: GPL-3.0-or-later
"""What deterministic experiments write with `--profile quick`, in sums. `kept_numbers.py RESULTS >kept_numbers.csv` keeps those
of a run without real joints, after its experiment was changed on purpose.

sum is that of a column's numbers, the n-th of N times 1 + n / N, so that their order counts; size that of their absolute
values; words is a checksum of the cells that are no numbers. Times are left out.
"""

from __future__ import annotations

import csv
import json
import math
import sys
import zlib
from pathlib import Path

KEPT = Path(__file__).with_suffix(".csv")
EXPERIMENTS = (
    "band_limit baselines claims conchoid_angles conchoid_curve conchoid_origins conchoid_shape conchoid_spacing "
    "conchoid_surface diagram_bodies diagram_chart diagram_corners diagram_coverage diagram_excerpt diagram_lookups "
    "diagram_rays diagram_scans diagram_sections error_budget fill_memory helix_curve helix_lookup_error helix_neighbours helix_placement "
    "motion_frames motion_zones sampling_error sampling_error_bounds sampling_error_proven sampling_error_sphere "
    "slice_band_limit slices slices_to_surface spectrum strain_hip strain_incidence strain_layer"
).split()
TIMES = {"ns", "us", "ms", "s"}
TIMED = {"inconclusive", "repeats", "rounds"}  # what is said of how times were taken
COLUMNS = ("name", "column", "rows", "sum", "size", "words")


def is_time(unit: str) -> bool:
    return unit.split(" ")[0].split("/")[0] in TIMES


def number(cell: str) -> float | None:
    try:
        value = float(cell)
    except ValueError:
        return None
    return value if math.isfinite(value) else None


def sums(results: Path, name: str, most: int | None = None) -> dict[str, dict]:
    """By column, of the first rows: those of real joints come last."""
    table = results / "data" / f"{name}.csv"
    units = {column["name"]: column["unit"] for column in json.loads(table.with_suffix(".json").read_text())["columns"]}
    with table.open(newline="", encoding="utf-8") as file:
        lines = [line for line in csv.DictReader(file) if not is_time(line.get("unit", ""))][:most]
    found = {}
    for column, unit in units.items():
        if is_time(unit) or column in TIMED:
            continue
        cells = [line[column] for line in lines]
        values = [(1 + n / len(cells), value) for n, cell in enumerate(cells) if (value := number(cell)) is not None]
        found[column] = {"name": name, "column": column, "rows": len(cells), "sum": math.fsum(share * value for share, value in values),
                         "size": math.fsum(abs(value) for _, value in values),
                         "words": zlib.crc32(",".join(cell for cell in cells if number(cell) is None).encode())}
    return found


def differences(results: Path) -> list[str]:
    """Columns that are not there, have fewer rows or other words, or sums that differ by more than 1e-9 of their size; what is
    less than 1e-12 is rounding.
    """
    with KEPT.open(newline="", encoding="utf-8") as file:
        kept = list(csv.DictReader(file))
    rows = {line["name"]: int(line["rows"]) for line in kept}
    found = {name: sums(results, name, most) for name, most in rows.items()}
    wrong = []
    for line in kept:
        now = found[line["name"]].get(line["column"], dict.fromkeys(COLUMNS, math.nan))
        same = [str(now[key]) == line[key] for key in ("rows", "words")]
        same += [abs(now[key] - float(line[key])) <= 1e-9 * float(line["size"]) + 1e-12 for key in ("sum", "size")]
        if not all(same):
            wrong.append(f"{line['name']}.csv {line['column']}: {now}, kept {line}")
    return wrong


if __name__ == "__main__":
    writer = csv.DictWriter(sys.stdout, COLUMNS, lineterminator="\n")
    writer.writeheader()
    for experiment in EXPERIMENTS:
        writer.writerows(sums(Path(sys.argv[1]), experiment).values())
