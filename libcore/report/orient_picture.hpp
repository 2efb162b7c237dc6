// SPDX-License-Identifier: GPL-3.0-or-later
// The map of the socket's orientations as a picture.
#pragma once

#include <string>

#include "joint/orient.hpp"

namespace impinge {

/// An SVG over inclination and anteversion, in the colours of volume_picture(): blue where every required
/// motion is free, grey where one is blocked, yellow where the ball's mesh ends on the way, white where it is
/// undecided. A ring is the socket as scanned, a dot the nearest free orientation.
std::string orient_picture(const OrientAnswer& found);

}  // namespace impinge
