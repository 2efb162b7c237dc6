// SPDX-License-Identifier: GPL-3.0-or-later
// How far a joint turns until its surfaces first touch: proven brackets (limits/turn_limit.hpp) beside what
// is done with a test of touch: steps until one touches, then halvings.
#pragma once

#include <span>
#include <vector>

#include "10_error_against_time/contact.hpp"

namespace impinge::lab {

QuestionTable make_first_contact_table();  // first_contact.csv

// scene, method, setting, triangles.
std::vector<Column> first_contact_keys();

// Turns about random axes from the pose as it is, those that end in a common point of the surfaces.
// std::runtime_error where the exact overlay contradicts a bracket. The methods are those of the scene's
// joint. Adds the rows; none where the joint impinges already.
void run_first_contact(const BenchmarkScene& scene, std::span<const MadeContact> methods, bool quick,
                       const BenchmarkOptions& options, QuestionTable& found, Progress& progress);

}  // namespace impinge::lab
