// SPDX-License-Identifier: GPL-3.0-or-later
#include "culling/face_item.hpp"

#include "sampling/face_index.hpp"

namespace impinge {
namespace {

constexpr double kSteepSlope = 1e4;  // see near_faces.cpp

}  // namespace

std::optional<CapItem> face_item(const TriangleMesh& mesh, const Face& face) {
  const TriangleCone cone = cone_of(mesh, face);
  FaceIndex::SeenFace seen = see_face(cone.corners());
  if (seen.side == 0 && cone.edge_on()) return std::nullopt;
  if (!(cone.largest_slope() <= kSteepSlope)) seen.range.low = 0.0;
  if (!(seen.cap.radius < 0.5 * kPi)) seen.cap.radius = kPi;
  return CapItem{seen.cap, seen.range};
}

}  // namespace impinge
