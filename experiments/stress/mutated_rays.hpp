// SPDX-License-Identifier: GPL-3.0-or-later
// Methods that are wrong on purpose, by a sign or a tolerance: what the judge of a family must notice.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "stress/methods.hpp"

namespace impinge::lab {

// What is wrong: all but the last in rays that are else make_cone_rays() (methods.hpp), the last in look-ups.
enum class Flaw {
  farthest,        // wrong sign in the comparison of two radii
  one_sided,       // counts only faces of one orientation
  behind,          // ignores the sign of the radius
  strict_edges,    // > in place of >= at an edge
  loose_edges,     // a tolerance of 1e-9 at an edge
  steep_left_out,  // a tolerance of 1e-6 on the cosine between ray and normal
  thin_left_out,   // a tolerance of 1e-6 mm^2 on the area of a face
  arccosine,       // the polar angle by an arccosine
  float_azimuth,   // the azimuth in float
  mirrored         // a look-up uses x with the wrong sign
};

std::string describe(Flaw flaw);  // in words, for the results

// A method with this flaw, made from the methods of a scene; none if these have no table to spoil.
std::optional<StabilityMethod> wrong_on_purpose(const TriangleMesh& mesh, Flaw flaw,
                                                std::span<const StabilityMethod> methods);

}  // namespace impinge::lab
