// SPDX-License-Identifier: GPL-3.0-or-later
#include "13_fill/fill_methods.hpp"

#include <cmath>
#include <concepts>
#include <optional>

#include "kernels/cube_fill.hpp"
#include "kernels/thread_team.hpp"
#include "table/exact_raster.hpp"

namespace impinge::lab {
namespace {

constexpr double kReach = 64.0;       // mm, beyond every corner of the pair
constexpr double kMostMissed = 0.01;  // of the rays
constexpr double kRayError = 1e-3;    // mm, of a ray in float
constexpr double kFloatShare = 1e-5;  // of a radius, far above what float takes

// Drawn and stored at once.
template <class Value>
class AtOnce final : public TableFilling {
 public:
  AtOnce(const FilledSurface& surface, int threads)
      : mesh_(surface.mesh), fill_{surface.scheme, surface.layer, threads, {}} {}

  void fill() override { fill_cube(mesh_, fill_, table_); }
  void forget() override { table_ = {}; }
  double radius(std::size_t entry) const override {
    const double q = table_.smallest + table_.step * static_cast<double>(table_.values[entry]);
    return 1.0 / (q * fill_.scheme.depth(fill_.scheme.direction(entry)));
  }
  // dr = r^2 depth dq, depth <= 1
  double tolerance() const override {
    return kFloatShare * kReach + (std::same_as<Value, std::uint16_t> ? kReach * kReach * table_.step : 0.0);
  }

 private:
  const TriangleMesh& mesh_;
  CubeFill fill_;
  PackedTable<CubeGnomonic, Value> table_;
};

// The rasteriser of all schemes, in double.
class InDouble final : public TableFilling {
 public:
  InDouble(const FilledSurface& surface, int /*threads*/) : surface_(surface) {}

  void fill() override { table_.emplace(fill_exact(surface_.mesh, surface_.scheme, surface_.layer)); }
  void forget() override { table_.reset(); }
  double radius(std::size_t entry) const override { return table_->radius_of(entry); }
  double tolerance() const override { return 0.0; }

 private:
  FilledSurface surface_;
  std::optional<RadialTable<CubeGnomonic>> table_;
};

// A tree, and a ray an entry.
class ByRays final : public TableFilling {
 public:
  ByRays(const FilledSurface& surface, int threads)
      : mesh_(surface.mesh), directions_(surface.directions), threads_(static_cast<std::size_t>(threads)) {}

  void fill() override {
    const EmbreeScene scene(mesh_, EmbreeQuality::fast);
    radii_.resize(directions_->size());
    on_threads(threads_, [&](std::size_t thread) {
      const Share share = share_of(directions_->size(), thread, threads_);
      cast_coherent(scene, *directions_, {share.first, share.end}, radii_);
    });
  }
  void forget() override { radii_ = {}; }
  double radius(std::size_t entry) const override { return static_cast<double>(radii_[entry]); }
  double tolerance() const override { return kRayError; }

 private:
  const TriangleMesh& mesh_;
  std::shared_ptr<const RayDirections> directions_;
  std::size_t threads_;
  TableMemory<float> radii_;
};

template <class Filling>
std::unique_ptr<TableFilling> make_filling(const FilledSurface& surface, int threads) {
  return std::make_unique<Filling>(surface, threads);
}

}  // namespace

std::vector<FillingMaker> filling_methods() {
  return {{"cube_at_once", "uint16", 1, 0.0, make_filling<AtOnce<std::uint16_t>>},
          {"cube_at_once", "uint16", 2, 0.0, make_filling<AtOnce<std::uint16_t>>},
          {"cube_at_once", "float", 1, 0.0, make_filling<AtOnce<float>>},
          {"cube_in_double", "double", 1, 0.0, make_filling<InDouble>},
          {"embree_fill", "float", 1, kMostMissed, make_filling<ByRays>}};
}

}  // namespace impinge::lab
