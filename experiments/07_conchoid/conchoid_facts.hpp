// SPDX-License-Identifier: GPL-3.0-or-later
// What the experiment on the conchoid says of the shape itself (Figures 51-56, Section 5.1).
#pragma once

#include "curves/conchoid.hpp"
#include "harness/provenance.hpp"

namespace impinge::lab {

// conchoid_curve.csv: the meridian from apex to phi = 180 degrees, half a degree a row.
Result conchoid_curve(const ConchoidShape& shape);

// conchoid_shape.csv: one row of lengths, areas and angles of the cap from the apex to the rim at 90 degrees.
Result conchoid_cap(const ConchoidShape& shape);

}  // namespace impinge::lab
