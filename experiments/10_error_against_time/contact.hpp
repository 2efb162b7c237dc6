// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a joint touches, and its smallest gap: culled, by scans of all vertices, and by libraries.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "10_error_against_time/report.hpp"
#include "methods/contact.hpp"

namespace impinge::lab {

// A method of a joint, made once, with what that took.
struct MadeContact {
  ContactCase method;
  std::shared_ptr<const ContactQuery> query;
  double build_s = 0.0;
  double bytes = 0.0;  // of the heap; NaN where it is not counted
};
// Those of all methods, of a joint that outlives them.
std::vector<MadeContact> made_contacts(const BallSocketPair& pair);

QuestionTable make_contact_table();  // contact.csv

// scene, method, gap_case, triangles.
std::vector<Column> contact_keys();

// Every culled answer that is timed is compared with the exact test of all vertices first, or one of several
// where there are many; other methods with the exact overlay of the faces in every pose. std::runtime_error
// where one differs by more than float explains. The methods are those of the scene's joint. Adds the rows of
// the scene; a gap case that it has no motions of is left out, and the progress says so.
void run_contact(const BenchmarkScene& scene, std::span<const MadeContact> methods,
                 const BenchmarkOptions& options, QuestionTable& found, Progress& progress);

}  // namespace impinge::lab
