// SPDX-License-Identifier: GPL-3.0-or-later
// How far off the gaps of a method are, against all triangles in double.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "methods/gaps.hpp"

namespace impinge::lab {

// Points as far from the centre as the joint space is, with the exact gaps there.
struct FastProbes {
  AskedPoints asked;              // the points
  std::vector<double> truth;      // gaps, mm, NaN where there is no surface
  std::vector<double> distances;  // Euclidean ones, mm, of the first few
};

// Half of them in uniform directions, half through vertices and edges, where a table is worst.
FastProbes fast_probes(const AskedSurface& surface, std::size_t count, std::uint64_t seed);

struct FastErrors {
  double largest_mm = 0.0;     // where both have an answer
  std::size_t misses = 0;      // no answer where there is a surface
  std::size_t false_hits = 0;  // an answer where there is none
  std::size_t undecided = 0;   // answered by a slower way
  std::size_t probes = 0;      // points that were asked
};

// std::runtime_error, which names the method, for an error or a share of false hits that no right method has.
FastErrors fast_errors(const GapQuery& query, const FastProbes& probes, const GapCase& method);

}  // namespace impinge::lab
