// SPDX-License-Identifier: GPL-3.0-or-later
// A replaced hip: a head of 32 mm on a stem, in a cup.
#pragma once

#include <cstddef>

#include "mesh/ball_socket_pair.hpp"

namespace impinge {

/// Mm, the joint frame of a right hip, the centre of the head as origin. The stem: the head with a neck of
/// 12 mm, 45 degrees to the shaft and 10 of anteversion, and a shaft that narrows to its end, 180 mm below.
/// The cup: a shell round a hemisphere 0.1 mm beyond the head, open at 45 degrees of inclination and 20 of
/// anteversion. Both are closed, with outward normals, and have about half of the faces. The clearance asks
/// for 10,000 faces or more.
BallSocketPair make_implant(std::size_t faces);

}  // namespace impinge
