// SPDX-License-Identifier: GPL-3.0-or-later
// The measures of hip/hip_measures.hpp, as the page reads them.
#pragma once

#include "joint/session.hpp"
#include "js_values.hpp"

namespace impinge {

/// Of ball and socket: `measures`, each with `measure`, `value`, `uncertainty`, `unit`, `refused`, why it has
/// no value or null, and `published`, null or the members of hip/published_measures.hpp. Nothing is measured
/// where the side is not known.
val measures_reply(const SessionJoint& joint);

}  // namespace impinge
