// SPDX-License-Identifier: GPL-3.0-or-later
#include "stress/methods.hpp"

#include <functional>
#include <span>
#include <stdexcept>
#include <utility>

#include "10_error_against_time/methods.hpp"
#include "mesh/bodies.hpp"
#include "mesh/lengths.hpp"
#include "methods/cgal_distances.hpp"
#include "methods/embree_rays.hpp"
#include "methods/pairwise_rays.hpp"
#include "methods/table_method.hpp"
#include "sphere/radial_table.hpp"
#include "sphere/scheme_list.hpp"

namespace impinge::lab {
namespace {

// Larger surfaces have the bound of first order: the proof of the tight one takes too long here.
constexpr std::size_t kMostEntries = 20000;
constexpr std::size_t kMostFaces = 700;

class ConeRays final : public RadiusMethod {
 public:
  explicit ConeRays(const TriangleMesh& mesh) {
    require_lengths(mesh);
    for (const Face& face : mesh.faces) {
      const TriangleCone cone = cone_of(mesh, face);
      if (!cone.edge_on()) cones_.push_back(cone);
    }
  }

  void answer(std::span<const Vec3> points, std::span<double> out) override {
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vec3 u = points[i].stableNormalized();
      out[i] = kNoSurface;
      for (const TriangleCone& cone : cones_) {
        if (is_met(cone, points[i], u)) keep(out[i], cone.radius(u), BenchmarkScene::kLayer);
      }
    }
  }
  double bytes() const override { return static_cast<double>(cones_.size() * sizeof(TriangleCone)); }

 private:
  std::vector<TriangleCone> cones_;
};

StabilityMethod method_of(std::string name, std::string kind, Scalar scalar,
                          std::function<std::unique_ptr<RadiusMethod>()> make) {
  StabilityMethod method;
  method.maker.name = std::move(name);
  method.maker.kind = std::move(kind);
  method.maker.make = std::move(make);
  method.scalar = scalar;
  return method;
}

BenchmarkScene benchmark_scene(const StabilityScene& scene) { return {"stability", {{}, scene.mesh}, {}}; }

// Tables of the scene in double and float. The benchmark's scene is kept by the methods.
void add_tables(std::vector<StabilityMethod>& methods, const StabilityScene& scene,
                const BoundOptions& search) {
  const auto bench = std::make_shared<const BenchmarkScene>(benchmark_scene(scene));
  for (MethodMaker& maker :
       table_methods(*bench, {{scene.precision_deg}, kMostEntries, kMostFaces, search})) {
    if (maker.storage == "uint16") continue;  // steps of one size: an error without relative bound
    StabilityMethod method;
    method.scalar = maker.storage == "float" ? Scalar::float32 : Scalar::float64;
    method.maker = std::move(maker);
    method.maker.make = [bench, make = std::move(method.maker.make)] { return make(); };
    methods.push_back(std::move(method));
  }
}

void add_refusals(std::vector<StabilityMethod>& methods, const StabilityScene& scene) {
  for_each_scheme([&]<class S>() {
    try {
      static_cast<void>(S::with_precision(scene.precision_deg));
    } catch (const std::invalid_argument& refusal) {
      StabilityMethod method = method_of(std::string(S::name), "ours", Scalar::float64, {});
      method.refused = refusal.what();
      methods.push_back(std::move(method));
    }
  });
}

}  // namespace

bool is_met(const TriangleCone& cone, const Vec3& x, const Vec3& u) {
  // Normalising moves an edge plane's test by less than one doubt.
  if (cone.least_edge_distance(u.x(), u.y(), u.z()) < -2.0 * cone.doubt()) return false;
  return place_in_cone(cone.corners(), cone.side(), x) >= 0;
}

std::unique_ptr<RadiusMethod> make_cone_rays(const TriangleMesh& mesh) {
  return std::make_unique<ConeRays>(mesh);
}

std::vector<StabilityMethod> stability_methods(const StabilityScene& scene, const BoundOptions& search) {
  const TriangleMesh& mesh = scene.mesh;
  std::vector<StabilityMethod> methods;
  methods.push_back(
      method_of("cone_rays", "ours", Scalar::float64, [&mesh] { return make_cone_rays(mesh); }));
  add_tables(methods, scene, search);
  add_refusals(methods, scene);
  methods.push_back(method_of("pairwise", "brute", Scalar::float64,
                              [&mesh] { return make_pairwise_rays(mesh, BenchmarkScene::kLayer); }));
  for (const auto& [quality, name] :
       {std::pair{EmbreeQuality::fast, "embree_fast"}, {EmbreeQuality::robust, "embree_robust"}}) {
    methods.push_back(method_of(name, "library", Scalar::float32, [&mesh, quality = quality] {
      return make_embree_rays(mesh, {1, quality});
    }));
  }
  methods.push_back(
      method_of("cgal_first_hit", "library", Scalar::float64, [&mesh] { return make_cgal_first_hit(mesh); }));
  return methods;
}

std::vector<SchemeEntries> scheme_entries(double precision_deg) {
  const StabilityScene scene{octahedron(1.0), {}, {}, precision_deg};
  std::vector<StabilityMethod> methods;
  add_tables(methods, scene, {});
  std::vector<SchemeEntries> entries;
  for (const StabilityMethod& method : methods) {
    const MethodMaker& maker = method.maker;
    if (maker.interpolant == "smooth" && maker.storage == "double")
      entries.push_back({maker.scheme, dynamic_cast<const KeepsRadii&>(*maker.make()).stored().directions});
  }
  return entries;
}

}  // namespace impinge::lab
