# SPDX-License-Identifier: GPL-3.0-or-later
# @name      baseline-comparison
# @question  The methods that the thesis compares itself with, measured (Section 3.6 of the thesis).
# @data      baselines
"""The methods that the thesis compares itself with in Section 3.6, measured."""

import pandas as pd

import common


def main(options) -> common.Table:
    table = common.load(options.results, "baselines")
    rows = pd.DataFrame({"joint": table.joint, "method": table.method, "setting": table.setting})
    rows["kB"] = (table.bytes / 1e3).map(common.digits)
    rows["build_ms"] = table.build_ms.map(common.digits) + table.build_extrapolated.map({True: "†", False: ""})
    rows["pose_us"] = table.pose_us.map(common.digits)
    rows["triangles_missed"] = share(table.faces_missed, table.faces)
    rows["vertices_missed"] = share(table.points_missed, table.points)
    rows["rms_error_um"] = (1e3 * table.rms_error_mm).map(error)
    rows["false_touches"] = share(table.false_touches, table.poses)
    rows["missed_touches"] = share(table.missed_touches, table.poses)
    rows["wrong_within_mm"] = table.wrong_within_mm.map(lambda value: f"{value:g}")
    rows["gives_distance"] = table.gives_distance
    return rows, latex(rows[rows.joint == table.joint.iloc[0]])


def error(value: float) -> str:
    """Micrometres; what is below a nanometre is the rounding of an exact answer."""
    return "" if pd.isna(value) else "0" if value < 1e-3 else common.digits(value, 2)


def share(part: pd.Series, whole: pd.Series) -> pd.Series:
    """Per cent with one place, empty where nothing was counted."""
    return (100 * part / whole).map(lambda value: "" if pd.isna(value) else f"{value:.1f}")


def latex(rows: pd.DataFrame) -> str:
    """The rows of one joint."""
    head = [
        r" & & & fill & pose & \multicolumn{2}{c}{missed (\%)} & error & \multicolumn{2}{c}{wrong (\%)} & within \\",
        r"method & resolution & kB & (ms) & (µs) & triangles & vertices & (µm) & false & missed & (mm) \\",
    ]
    lines = []
    for row in rows.itertuples():
        cells = [common.label(row.method), row.setting.replace("x", r"$\times$"), row.kB]
        cells += [row.build_ms.replace("†", r"\textdagger"), row.pose_us, row.triangles_missed, row.vertices_missed, row.rms_error_um]
        cells += [row.false_touches, row.missed_touches, row.wrong_within_mm]
        lines.append(cells)
    return common.tabular("@{}llrrrrrrrrr@{}", head, common.ruled(lines))


common.run(main)
