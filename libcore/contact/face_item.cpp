// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/face_item.hpp"

#include "table/face_index.hpp"

namespace impinge {
namespace {

constexpr double kSteepSlope = 1e4;  // see near_faces.cpp

}  // namespace

std::optional<CapItem> face_item(const TriangleMesh& mesh, const Face& face) {
  const TriangleCone cone = cone_of(mesh, face);
  if (cone.edge_on()) return std::nullopt;
  FaceIndex::SeenFace seen = see_face(cone.corners());
  if (!(cone.largest_slope() <= kSteepSlope)) seen.range.low = 0.0;
  if (!(seen.cap.radius < 0.5 * kPi)) seen.cap.radius = kPi;
  return CapItem{seen.cap, seen.range};
}

}  // namespace impinge
