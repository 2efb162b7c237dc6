// SPDX-License-Identifier: GPL-3.0-or-later
// Contact of bones (limits/body_pairs.hpp) in words and as JSON.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "hip/joint.hpp"
#include "limits/body_pairs.hpp"

namespace impinge {

/// The line for a terminal, such as "contact             yes: the surfaces of ball and socket meet".
std::string describe_contact(const Joint& joint, const BodyPairs::Verdict& found);

/// state ("no", "yes", "unknown"), by ("surfaces", "inside", "radii"; null where there is none), and the
/// names of parts (add_part_names()).
nlohmann::json contact_json(const Joint& joint, const BodyPairs::Verdict& found);

}  // namespace impinge
