# SPDX-License-Identifier: GPL-3.0-or-later
# @options   --name NAME
# @name      table-3
# @question  Time to fill the tables of a joint of 3,000 triangles a model (Table 3 of the thesis).
# @data      sampling_time
# @name      table-4
# @question  Time to test one pose at four numbers of triangles (Table 4 of the thesis).
# @data      detection_time
# @name      table-8
# @question  Time to fill the tables of a joint by RSID and USID (Table 8 of the thesis).
# @data      sampling_time
# @name      table-9
# @question  Time to test one pose by RSID and USID (Table 9 of the thesis).
# @data      detection_time
"""A timing table of the thesis (Table 3, 4, 8 or 9) compared with ours: times and ratios."""

import common
from common import timing


def main(options) -> common.Table:
    table = next(table for table in timing.TABLES if table.artefact == options.name)
    lines = timing.compare(options.results, table)
    lines = lines[lines.method.isin(common.methods_of(table.artefact))]
    return lines.drop(columns="size"), timing.latex(lines, table)


common.run(main, "--name")
