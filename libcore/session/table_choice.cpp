// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/table_choice.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "sphere/stored_table.hpp"

namespace impinge {
namespace {

constexpr std::array kPrecisions{2.0, 1.0, 0.5, 0.25, 0.1, 0.05};  // degrees
constexpr double kShareOfStorage = 0.25;                           // of the accuracy
constexpr double kReading = 0.1;                                   // of a ray, reading the table once
constexpr std::size_t kFewestLookUps = 100'000;  // fewer rays take less time than choosing a table

struct StorageChoice {
  Storage storage;
  double bound;  // mm
};

StorageChoice smallest_storage(const RadiusRange& range, double accuracy) {
  const double sums = kSumRounding * range.high;
  // A step of 16 bits, of which an entry is off by half; 2^-24 of a radius in float.
  const double sixteen = (range.high - range.low) / (Uint16Values::kNone - 1) + sums;
  if (sixteen <= kShareOfStorage * accuracy) return {Storage::sixteen_bits, sixteen};
  const double single = range.high * 0x1p-24 + sums;
  if (single <= kShareOfStorage * accuracy) return {Storage::single_precision, single};
  return {Storage::double_precision, 0.0};
}

// Largest stencil radius that keeps a first-order error at a look-up.
std::vector<double> widest_stencils(std::span<const LookUpNeed> look_ups, double error) {
  std::vector<double> widest(look_ups.size());
  std::ranges::transform(look_ups, widest.begin(), [error](const LookUpNeed& need) {
    return need.slope > 0.0 ? std::log1p(error / need.radius) / need.slope
                            : std::numeric_limits<double>::infinity();
  });
  std::ranges::sort(widest);
  return widest;
}

// How a scheme spends its entries, at any precision p in degrees: about stencil_radius * p radians and
// entries / p^2. Some schemes take tens of milliseconds to make, so each is made once in a run of the
// program.
struct SchemeShape {
  std::string name;
  double stencil_radius;
  double entries;
  double taps;
  bool flat_cells;
};

const std::vector<SchemeShape>& scheme_shapes() {
  static const std::vector<SchemeShape> shapes = [] {
    std::vector<SchemeShape> all;
    for (const std::string& name : all_scheme_names()) {
      const AnyScheme scheme(name, 1.0);
      all.push_back({name, scheme.stencil_radius(), static_cast<double>(scheme.size()),
                     static_cast<double>(scheme.stencil(Vec3(0.3, 0.5, 0.8)).taps), scheme.flat_cells()});
    }
    return all;
  }();
  return shapes;
}

}  // namespace

double first_order_error(const LookUpNeed& need, double stencil_radius) {
  return need.radius * std::expm1(need.slope * stencil_radius);
}

TableChoice choose_table(std::span<const LookUpNeed> look_ups, std::size_t each, const RadiusRange& range,
                         double accuracy_mm, const AnyScheme& given) {
  const auto [storage, storage_bound] = smallest_storage(range, accuracy_mm);
  TableChoice rays_only{given, storage, accuracy_mm, /*rays_only=*/true};
  if (each * look_ups.size() < kFewestLookUps) return rays_only;
  const std::vector<double> widest = widest_stencils(look_ups, accuracy_mm - storage_bound);
  const auto share = static_cast<double>(each);
  const double rays = share * static_cast<double>(look_ups.size());
  const SchemeShape* cheapest = nullptr;
  double at_precision = 0.0;
  double least = rays;
  for (const double precision : kPrecisions) {
    for (const SchemeShape& shape : scheme_shapes()) {
      if (!shape.flat_cells && shape.name != given.name()) continue;
      const double good =
          share * static_cast<double>(widest.end() -
                                      std::ranges::lower_bound(widest, shape.stencil_radius * precision));
      const double filled = std::min(shape.taps * good, shape.entries / (precision * precision));
      const double cost = filled + (rays - good) + kReading * good;
      if (cost >= least) continue;
      least = cost;
      cheapest = &shape;
      at_precision = precision;
    }
  }
  if (cheapest == nullptr) return rays_only;
  return {AnyScheme(cheapest->name, at_precision), storage, accuracy_mm, /*rays_only=*/false};
}

}  // namespace impinge
