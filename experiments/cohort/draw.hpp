// SPDX-License-Identifier: GPL-3.0-or-later
// Hip j of a study follows from the study and j alone: draws are not taken one after another but looked up,
// by what they are for.
#pragma once

#include <cstdint>
#include <string>

#include "cohort/study.hpp"

namespace impinge::lab {

// A number in (0, 1), uniform, one of 2^52 equally spaced ones: 13 hexadecimal digits of the SHA-256 of seed,
// tag, hip and attempt, as text.
double uniform_draw(std::uint64_t seed, const std::string& tag, std::size_t hip, std::size_t attempt);

// A hip as it was drawn.
struct DrawnHip {
  HipParameters parameters;  // that make a hip
  std::size_t redrawn = 0;  // draws before that make none (hip/hip_checks.hpp), as a cam that touches at rest
};

// Hip j, from 0. std::runtime_error, one line, if a hundred draws make none.
DrawnHip draw_hip(const Study& study, std::size_t j);

}  // namespace impinge::lab
