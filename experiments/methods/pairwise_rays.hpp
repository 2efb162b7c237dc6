// SPDX-License-Identifier: GPL-3.0-or-later
// Method pairwise of the distances: the ray of every point against every triangle (see
// table/pairwise.hpp).
#pragma once

#include <memory>

#include "methods/radius_method.hpp"

namespace impinge::lab {

// mesh in the centre frame; its triangles are copied.
std::unique_ptr<RadiusMethod> make_pairwise_rays(const TriangleMesh& mesh, Layer layer);

}  // namespace impinge::lab
