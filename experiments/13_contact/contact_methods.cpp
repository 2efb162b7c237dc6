// SPDX-License-Identifier: GPL-3.0-or-later
#include "13_contact/contact_methods.hpp"

#include <utility>

#include <benchmark/benchmark.h>

namespace impinge::lab {
namespace {

constexpr std::size_t kSlowStride = 16;  // FCL measures distances in one pose of so many

// One pose after the other.
std::function<void(std::span<const Pose>)> each(std::function<bool(const Pose&)> touches) {
  return [touches = std::move(touches)](std::span<const Pose> poses) {
    for (const Pose& pose : poses) benchmark::DoNotOptimize(touches(pose));
  };
}

AskedContact asked_scan(ContactScans& scans, const ContactScan& way, const std::vector<Pose>& poses) {
  return {way.method, poses, [&](std::span<const Pose> all) { scan_poses(scans, way, all); },
          [&](const Pose& pose) {
            way.scan(pose, scans.gaps.front());
            return any_at_most_zero(scans.gaps.front());
          }};
}

}  // namespace

std::vector<AskedContact> contact_methods(ContactStage& stage, const std::vector<Pose>& poses) {
  std::vector<Pose> few;
  for (std::size_t k = 0; k < poses.size(); k += kSlowStride) few.push_back(poses[k]);
  const auto fcl = [&stage](const Pose& pose) { return stage.fcl->touches(pose); };
  const auto distance = [&stage](const Pose& pose) { return stage.distance.distance(pose) <= 0.0; };
  const auto vtk = [&stage](const Pose& pose) { return stage.vtk->touches(pose); };
  const auto culled = [&stage](const Pose& pose) { return stage.culled.impinged(pose).has_value(); };
  const auto coherent = [&stage](const Pose& pose) { return stage.coherent.impinged(pose).has_value(); };
  const auto least = [&stage](const Pose& pose) {
    const auto gap = stage.culled.least_gap(pose);
    return gap && gap->gap_mm <= 0.0;
  };
  std::vector<AskedContact> methods{
      {"fcl_collide", poses, each(fcl), fcl},        {"fcl_distance", few, each(distance), distance},
      {"vtk_collide", few, each(vtk), vtk},          {"culled", poses, each(culled), culled},
      {"coherent", poses, each(coherent), coherent}, {"culled_least_gap", poses, each(least), least}};
  for (const ContactScan& way : stage.scans.ways) methods.push_back(asked_scan(stage.scans, way, poses));
  return methods;
}

Column contact_method_column() {
  return {
      "method", "",
      "fcl_collide, vtk_collide: trees of oriented boxes; fcl_distance: smallest distance; "
      "all_vertices: both scans by the kernels, all gaps, of tables in 16 bits; all_corners: of tables with "
      "the corners of a cell together and centred errors, as accurate; all_corners_2_threads: the same, two "
      "threads sharing the poses; all_corners_sampled: corners of finer tables, not centred, as accurate; "
      "culled: touch; coherent: touch, from one pose to the next; culled_least_gap: smallest gap"};
}

}  // namespace impinge::lab
