// SPDX-License-Identifier: GPL-3.0-or-later
// Method pairwise of the distances: the ray of every point against every triangle (see
// sampling/pairwise.hpp).
#pragma once

#include <memory>

#include "contenders/radius_method.hpp"

namespace impinge {

// mesh in the centre frame; its triangles are copied.
std::unique_ptr<RadiusMethod> make_pairwise_rays(const TriangleMesh& mesh, Layer layer);

}  // namespace impinge
