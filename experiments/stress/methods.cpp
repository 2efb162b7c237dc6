// SPDX-License-Identifier: GPL-3.0-or-later
#include "stress/methods.hpp"

#include <memory>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "mesh/bodies.hpp"
#include "mesh/lengths.hpp"
#include "sphere/radial_table.hpp"
#include "sphere/scheme_list.hpp"

namespace impinge::lab {
namespace {

// Larger surfaces get the first-order bound, since proving the tight one takes too long here.
constexpr std::size_t kMostEntries = 20000;
constexpr std::size_t kMostFaces = 700;

BenchmarkScene benchmark_scene(const StabilityScene& scene) { return {"stability", {{}, scene.mesh}, {}}; }

StabilityMethod ours(std::string_view name) {
  StabilityMethod method;
  method.maker.name = name;
  method.maker.kind = "ours";
  return method;
}

// Methods with a name for stiff cases; they keep the benchmark's scene.
std::vector<StabilityMethod> named_methods(const StabilityScene& scene, const BoundOptions& search) {
  const auto bench = std::make_shared<const BenchmarkScene>(benchmark_scene(scene));
  const PointSizes sizes{{{scene.precision_deg}, kMostEntries, kMostFaces, search}, {}};
  std::vector<StabilityMethod> methods;
  for (PointCase& one : cases_of(points_methods(), &Method::points, *bench, sizes)) {
    if (one.stability.empty()) continue;
    StabilityMethod method;
    method.scalar = one.in_float ? Scalar::float32 : Scalar::float64;
    method.maker = std::move(one);
    method.maker.name = method.maker.stability;
    method.maker.make = [bench, make = std::move(method.maker.make)] { return make(); };
    methods.push_back(std::move(method));
  }
  return methods;
}

void add_refusals(std::vector<StabilityMethod>& methods, const StabilityScene& scene) {
  for_each_scheme([&]<class S>() {
    try {
      static_cast<void>(S::with_precision(scene.precision_deg));
    } catch (const std::invalid_argument& refusal) {
      StabilityMethod method = ours(S::name);
      method.refused = refusal.what();
      method.maker.precision_deg = scene.precision_deg;
      methods.push_back(std::move(method));
    }
  });
}

}  // namespace

bool is_met(const TriangleCone& cone, const Vec3& x, const Vec3& u) {
  // Normalising changes an edge plane's test by less than one doubt.
  if (cone.least_edge_distance(u.x(), u.y(), u.z()) < -2.0 * cone.doubt()) return false;
  return place_in_cone(cone.corners(), cone.side(), x) >= 0;
}

PointQuery make_cone_rays(const TriangleMesh& mesh) {
  require_lengths(mesh);
  std::vector<TriangleCone> cones;
  for (const Face& face : mesh.faces) {
    const TriangleCone cone = cone_of(mesh, face);
    if (!cone.edge_on()) cones.push_back(cone);
  }
  const auto bytes = static_cast<double>(cones.size() * sizeof(TriangleCone));
  return one_by_one(
      [cones = std::move(cones)](const Vec3& x) {
        const Vec3 u = x.stableNormalized();
        double radius = kNoSurface;
        for (const TriangleCone& cone : cones) {
          if (is_met(cone, x, u)) keep(radius, cone.radius(u), BenchmarkScene::kLayer);
        }
        return radius;
      },
      bytes);
}

std::vector<StabilityMethod> stability_methods(const StabilityScene& scene, const BoundOptions& search) {
  std::vector<StabilityMethod> methods{ours("cone_rays")};
  methods.front().maker.make = [&mesh = scene.mesh] { return make_cone_rays(mesh); };
  std::vector<StabilityMethod> named = named_methods(scene, search);
  const auto add = [&](const char* kind) {
    for (StabilityMethod& method : named)
      if (method.maker.kind == kind) methods.push_back(std::move(method));
  };
  add("ours");
  add_refusals(methods, scene);
  add("brute");
  add("library");
  return methods;
}

std::vector<SchemeEntries> scheme_entries(double precision_deg) {
  const StabilityScene scene{octahedron(1.0), {}, {}, precision_deg};
  std::vector<SchemeEntries> entries;
  for (const StabilityMethod& method : named_methods(scene, {})) {
    const PointCase& maker = method.maker;
    if (maker.interpolant == "smooth" && maker.storage == "double")
      entries.push_back({maker.scheme, maker.make().stored().directions});
  }
  return entries;
}

}  // namespace impinge::lab
