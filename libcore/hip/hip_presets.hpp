// SPDX-License-Identifier: GPL-3.0-or-later
// Named hips.
#pragma once

#include <span>
#include <string_view>

#include "hip/hip_parameters.hpp"

namespace impinge {

/// The names, in this order:
///   normal      the defaults: published means where there are any
///   cam         a bump on the head-neck junction, anterosuperior
///   pincer      a deep socket with a prominent anterosuperior rim
///   mixed       cam and pincer together
///   dysplastic  a shallow, steep socket that covers too little
///   patient_a, patient_b
///               stand-ins for the two patients of the thesis (Section 5.2), whose scans are not public. The
///               side is theirs; the shapes are ours, chosen so that the zones of small gaps at the ends
///               of the motions of Table 11 lie where Tables 12 and 13 report them. Say so wherever they
///               appear.
std::span<const std::string_view> hip_preset_names();

/// The parameters of a preset. Throws std::invalid_argument, one line with all names, for any other name.
HipParameters hip_preset(std::string_view name);

}  // namespace impinge
