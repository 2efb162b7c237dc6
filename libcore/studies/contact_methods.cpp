// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/contact_methods.hpp"

#include <benchmark/benchmark.h>

namespace impinge {
namespace {

constexpr std::size_t kSlowStride = 16;  // FCL measures distances in one pose of so many

}  // namespace

std::vector<AskedContact> contact_methods(ContactStage& stage, const std::vector<Pose>& poses) {
  std::vector<Pose> few;
  for (std::size_t k = 0; k < poses.size(); k += kSlowStride) few.push_back(poses[k]);
  const auto fcl = [&stage](const Pose& pose) { return stage.fcl->touches(pose); };
  const auto distance = [&stage](const Pose& pose) { return stage.distance.distance(pose) <= 0.0; };
  const auto vtk = [&stage](const Pose& pose) { return stage.vtk->touches(pose); };
  const auto all = [&stage](const Pose& pose) {
    stage.scan_all(pose);
    benchmark::ClobberMemory();
    return false;
  };
  const auto all_touch = [&stage](const Pose& pose) {
    stage.scan_all(pose);
    return stage.any_at_most_zero();
  };
  const auto culled = [&stage](const Pose& pose) { return stage.culled.impinged(pose).has_value(); };
  const auto coherent = [&stage](const Pose& pose) { return stage.coherent.impinged(pose).has_value(); };
  const auto least = [&stage](const Pose& pose) {
    const auto gap = stage.culled.least_gap(pose);
    return gap && gap->gap_mm <= 0.0;
  };
  return {{"fcl_collide", poses, fcl, fcl},         {"fcl_distance", few, distance, distance},
          {"vtk_collide", few, vtk, vtk},           {"all_vertices", poses, all, all_touch},
          {"culled", poses, culled, culled},        {"coherent", poses, coherent, coherent},
          {"culled_least_gap", poses, least, least}};
}

Column contact_method_column() {
  return {"method", "",
          "fcl_collide, vtk_collide: trees of oriented boxes; fcl_distance: smallest distance; "
          "all_vertices: both scans by the kernels, all gaps; culled: touch; coherent: touch, from one pose "
          "to the next; culled_least_gap: smallest gap"};
}

}  // namespace impinge
