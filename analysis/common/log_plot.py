# SPDX-License-Identifier: GPL-3.0-or-later
"""How time grows with size."""

import math

import numpy as np
import pandas as pd


def slope(x: pd.Series, y: pd.Series) -> float:
    """Exponent b of the power law y = a x^b that fits best in logarithms; NaN for fewer than two points."""
    known = np.isfinite(y) & (y > 0)
    return float(np.polyfit(np.log(x[known]), np.log(y[known]), 1)[0]) if known.sum() > 1 else math.nan
