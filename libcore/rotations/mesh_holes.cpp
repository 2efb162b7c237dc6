// SPDX-License-Identifier: GPL-3.0-or-later
#include "rotations/mesh_holes.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "sphere/cube_faces.hpp"

namespace impinge {
namespace {

constexpr std::size_t kFine = 8;     // halvings, of a cell that has a direction without a face
constexpr std::size_t kFinest = 10;  // and of others
constexpr double kBeyond = 1e-6;     // radians, from a border to a direction in the hole

// A cell of a face of the cube: its middle, and half of its side.
struct HoleCell {
  std::size_t face;
  double a, b, half;
};

DirectionCap cap_of(const HoleCell& cell) {
  // A little beside the middle: symmetric meshes have sides of faces there, along which no face is found.
  DirectionCap cap{
      cube_point(cell.face, cell.a + 0.0137 * cell.half, cell.b + 0.0071 * cell.half).normalized(), 0.0};
  for (const double da : {-cell.half, cell.half}) {
    for (const double db : {-cell.half, cell.half})
      cap.radius =
          std::max(cap.radius, angle_between(cap.axis, cube_point(cell.face, cell.a + da, cell.b + db)));
  }
  cap.radius += kCapSlack;
  return cap;
}

class HoleFinder {
 public:
  explicit HoleFinder(const SeenSurface& surface) : surface_(surface) {}

  void look_at(const HoleCell& cell, std::size_t level) {
    const DirectionCap cap = cap_of(cell);
    const bool covered = surface_.any_along(cap.axis, [&](std::uint32_t from) {
      return surface_.covers(cap, from, memory_, [](const DirectionFace&) { return true; });
    });
    if (covered) return;
    const bool empty = !surface_.any_near(cap);
    if (empty) clear.push_back(cap);
    if (empty || (level >= kFine && add_point(cap)) || level == kFinest) {
      holes.push_back({cap, {0.0, 1.0}});
      return;
    }
    const double half = 0.5 * cell.half;
    for (const double da : {-half, half}) {
      for (const double db : {-half, half}) look_at({cell.face, cell.a + da, cell.b + db, half}, level + 1);
    }
  }

  // A direction without a face, if the axis or one just beyond a border is one.
  bool add_point(const DirectionCap& cap) {
    const auto add = [&](const Vec3& u) {
      const DirectionCap point{u, kCapSlack};
      const bool is = !surface_.any_near(point);
      if (is) clear.push_back(point);
      return is;
    };
    if (add(cap.axis)) return true;
    for (const SeenBorder& border : borders_) {
      const double off = border.inward.dot(cap.axis);
      if (std::abs(off) > cap.radius) continue;
      if (add((cap.axis - (off + kBeyond) * border.inward).normalized())) return true;
    }
    return false;
  }

  std::vector<CapItem> holes;
  std::vector<DirectionCap> clear;  // without a face: some of `holes`, and points of others

 private:
  const SeenSurface& surface_;
  std::vector<SeenBorder> borders_ = surface_.borders();
  PatchMemory memory_;
};

}  // namespace

MeshHoles mesh_holes(const SeenSurface& surface) {
  HoleFinder finder(surface);
  for (std::size_t face = 0; face < 6; ++face) finder.look_at({face, 0.0, 0.0, 1.0}, 0);
  MeshHoles holes{CapTree(finder.holes), {}, std::move(finder.clear)};
  for (const std::uint32_t k : holes.tree.order()) holes.caps.push_back(finder.holes[k].cap);
  return holes;
}

}  // namespace impinge
