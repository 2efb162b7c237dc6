// SPDX-License-Identifier: GPL-3.0-or-later
// Methods that are wrong on purpose, by a sign or a tolerance: what the judge of a family must notice.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "stress/methods.hpp"

namespace impinge::lab {

// What is wrong: with rays that are make_cone_rays() (methods.hpp) else, and the last with look-ups.
enum class Flaw {
  farthest,        // the sign of the comparison of two radii
  one_sided,       // the sign of a face's orientation counts
  behind,          // the sign of the radius does not
  strict_edges,    // > in place of >= at an edge
  loose_edges,     // a tolerance of 1e-9 at an edge
  steep_left_out,  // a tolerance of 1e-6 on the cosine between ray and normal
  thin_left_out,   // a tolerance of 1e-6 mm^2 on the area of a face
  arccosine,       // the polar angle by an arccosine
  float_azimuth,   // the azimuth in float
  mirrored         // a look-up takes x with the other sign
};

std::string describe(Flaw flaw);  // in words, for the results

// A method with that flaw, made from one of those of a scene; none where these have no table to spoil.
std::optional<StabilityMethod> wrong_on_purpose(const TriangleMesh& mesh, Flaw flaw,
                                                std::span<const StabilityMethod> methods);

}  // namespace impinge::lab
