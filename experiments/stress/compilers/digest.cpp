// SPDX-License-Identifier: GPL-3.0-or-later
// Prints a digest of tables, look-ups and scans, one line a scheme: NAME TABLE LOOK-UPS. CMakeLists.txt
// builds it with several sets of flags, all of which must print the same.
#include <bit>
#include <cinttypes>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Geometry>

#include "gap/gap_scan.hpp"
#include "sphere/schemes/cube_gnomonic.hpp"
#include "sphere/schemes/icosahedral_gnomonic.hpp"
#include "sphere/schemes/usid.hpp"
#include "sphere/stored_table.hpp"
#include "sphere/uniform_directions.hpp"
#include "table/own_scheme.hpp"

namespace impinge::lab {
namespace {

// FNV-1a over the bytes of the numbers; every NaN counts as one number, for its bits may differ.
std::uint64_t digest(std::span<const double> values) {
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const double value : values) {
    const auto bits = std::isnan(value) ? ~std::uint64_t{0} : std::bit_cast<std::uint64_t>(value);
    for (unsigned byte = 0; byte < 64; byte += 8) hash = (hash ^ ((bits >> byte) & 0xffU)) * 0x100000001b3U;
  }
  return hash;
}

// A dented body with an opening round the south pole.
TriangleMesh body() {
  constexpr VertexIndex kRings = 14;
  constexpr VertexIndex kAround = 24;
  TriangleMesh mesh;
  for (VertexIndex i = 0; i <= kRings; ++i) {
    for (VertexIndex j = 0; j < kAround; ++j) {
      const CosSin polar = half_turn_fraction(static_cast<long>(i), kRings + 3);
      const CosSin turn = half_turn_fraction(2 * static_cast<long>(j), kAround);
      const Vec3 u(polar.sin * turn.cos, polar.sin * turn.sin, polar.cos);
      mesh.vertices.emplace_back((24.0 + 2.0 * u.x() * u.y() - 3.0 * u.z() * u.z() * u.x()) * u);
    }
  }
  for (VertexIndex i = 0; i < kRings; ++i) {
    for (VertexIndex j = 0; j < kAround; ++j) {
      const VertexIndex a = i * kAround + j;
      const VertexIndex b = i * kAround + (j + 1) % kAround;
      if (i > 0) mesh.faces.push_back({a, a + kAround, b});
      mesh.faces.push_back({b, a + kAround, b + kAround});
    }
  }
  return mesh;
}

Pose turned() {
  Pose pose;
  pose.rotation = Eigen::AngleAxisd(0.7, Vec3(0.48, -0.6, 0.64)).toRotationMatrix();
  pose.translation = Vec3(0.3, -0.2, 0.1);
  return pose;
}

void print(std::string_view name, std::span<const double> kept, std::span<const double> asked) {
  std::printf("%s %016" PRIx64 " %016" PRIx64 "\n", std::string(name).c_str(), digest(kept), digest(asked));
}

template <SamplingScheme S>
void print_tables(const TriangleMesh& mesh, std::span<const Vec3> points) {
  const RadialTable<S> table = fill_exact(mesh, S::with_precision(4.0), Layer::nearest);
  std::vector<double> gaps(points.size());
  scan_gaps(table, points, turned(), Surface::ball, gaps);
  print(S::name, table.radii(), gaps);
  scan_gaps(table, points, turned(), Surface::socket, gaps);
  print(std::string(S::name) + "_of_a_ball", table.radii(), gaps);
  if constexpr (PlaneExactScheme<S>) {
    const InverseDepthTable<S> depths(table);
    for (std::size_t i = 0; i < points.size(); ++i) gaps[i] = depths.radius_at(points[i]);
    print(std::string(S::name) + "_mesh_exact", depths.values(), gaps);
  }
}

void print_all() {
  const TriangleMesh mesh = body();
  std::vector<Vec3> points = uniform_directions(1000, 3);
  for (Vec3& x : points) x *= 21.0;
  print_tables<CubeGnomonic>(mesh, points);
  print_tables<IcosahedralGnomonic>(mesh, points);
  print_tables<Usid>(mesh, points);
}

}  // namespace
}  // namespace impinge::lab

int main() {
  try {
    impinge::lab::print_all();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "digest: %s\n", error.what());
    return 1;
  }
  return 0;
}
