// SPDX-License-Identifier: GPL-3.0-or-later
// The ways to say whether a joint touches, as they are timed.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "13_contact/contact_stage.hpp"
#include "files/csv.hpp"

namespace impinge::lab {

// Answers of one method in poses of one gap.
struct AskedContact {
  std::string method;                              // as results name it
  std::vector<Pose> poses;                         // fewer for slow ones
  std::function<void(std::span<const Pose>)> run;  // what is timed
  std::function<bool(const Pose&)> touches;        // what it says
};

// Of all ways in the poses; the stage must outlive them.
std::vector<AskedContact> contact_methods(ContactStage& stage, const std::vector<Pose>& poses);

// What the names of the ways mean.
Column contact_method_column();

}  // namespace impinge::lab
