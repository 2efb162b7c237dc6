// SPDX-License-Identifier: GPL-3.0-or-later
// A hip with trochanters and an anterior inferior iliac spine.
#pragma once

#include "hip/hip_parameters.hpp"

namespace impinge::test {

inline HipParameters hip_with_parts(HipParameters hip = {}) {
  hip.greater_trochanter_width = 30.0;
  hip.lesser_trochanter_height = 8.0;
  hip.aiis_height = 10.0;
  return hip;
}

}  // namespace impinge::test
