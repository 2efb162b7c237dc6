# SPDX-License-Identifier: GPL-3.0-or-later
# @name      findings
# @question  Which statements of the thesis hold, which do not, and what shows it?
# @outputs   tables/findings.csv tables/findings.json tables/findings.tex
# @depends   results/reference/tables/findings.csv
"""Statements of the thesis, of the note that suspected it, and of other papers, that a computation confirms or refutes.

Each module of MODULES has a function for each statement, which returns a Finding; every number in them comes from data/NAME.csv.
"""

import re
from pathlib import Path

import pandas as pd

import common
from common import ranges
from findings import baselines, claims, conchoid, finding, grid, helix, motion, note, slips

KEPT = Path(__file__).resolve().parents[2] / "results" / "reference" / "tables" / "findings.csv"
MODULES = (grid, baselines, helix, conchoid, slips, claims, note, motion)  # the thesis from front to back, the note, others

HEAD = r"""\begin{longtable}{@{}r>{\raggedright\arraybackslash}p{19mm}>{\raggedright\arraybackslash}p{47mm}
  >{\raggedright\arraybackslash}p{82mm}l@{}}
  \caption{Statements, and what was computed about them.}\label{tab:findings}\\
  \toprule
  & where & statement & computed & verdict \\
  \midrule
  \endfirsthead
  \toprule
  & where & statement & computed & verdict \\
  \midrule
  \endhead
  \bottomrule
  \endfoot"""


def main(options) -> common.Table:
    rows = pd.DataFrame(
        [row for module in MODULES for row in finding.rows(module, options.results)], columns=finding.COLUMNS
    )
    rows = ranges.steadied(rows, KEPT, ["where", "claim", "evidence"], "computed")
    rows.insert(0, "number", range(1, len(rows) + 1))
    return rows, latex(rows)


def mathematical(text: str) -> str:
    """LaTeX for a statement in plain text: powers, Greek letters, minus signs and signs of comparison."""
    text = common.tex(text)
    for plain, latex_text in {
        "\\textasciicircum{}2": "\\textsuperscript{2}",
        "N rho\\textsuperscript{2}": "$N\\rho^2$",
        "rho\\textsuperscript{2} / 2 r (1 + 2 tan\\textsuperscript{2} psi), rho": (
            "$\\tfrac12\\rho^2 r\\,(1+2\\tan^2\\psi)$, $\\rho$"
        ),
        "(1 - cos phi) / 2": "$(1-\\cos\\varphi)/2$",
        "d <= d\\_i": "$d\\le d_i$",
        "k = sqrt(w)": "$k=\\sqrt w$",
        "floor(T / dx)": "$\\lfloor T/\\Delta x\\rfloor$",
        "own dx": "own $\\Delta x$",
        "n - 1": "$n-1$",
    }.items():
        text = text.replace(plain, latex_text)
    text = re.sub(r"(?<=\d) x (?=\d)", r"\\,$\\times$\\,", text)
    text = re.sub(r"(?<![\w-])-(?=\d)", "$-$", text)
    return re.sub(r"(\d(?:\.\d+)?)e([+-])0?(\d+)", lambda m: f"${m[1]}\\cdot10^{{{m[2].strip('+')}{m[3]}}}$", text)


def latex(rows: pd.DataFrame) -> str:
    """The statements that do not hold, as a table over several pages whose head is repeated. The CSV has all."""
    body = []
    for row in rows[rows.verdict.isin(["wrong", "misprint"])].itertuples():
        source = f"~\\cite{{{row.source}}}" if row.source else ""
        body.append(
            f"{row.number} & {mathematical(row.where.replace('Section ', 'Sec. '))} & {mathematical(row.claim)} & "
            f"{mathematical(row.computed)}{source} & {row.verdict} \\\\"
        )
    return "\n".join([HEAD, "\\addlinespace[1pt]\n".join(line + "\n" for line in body), "\\end{longtable}", ""])


common.run(main)
