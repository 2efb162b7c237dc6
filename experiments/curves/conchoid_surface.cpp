// SPDX-License-Identifier: GPL-3.0-or-later
#include "curves/conchoid_surface.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>
#include <stdexcept>
#include <tuple>

#include "curves/gsl.hpp"

namespace impinge {
namespace {

Vec3 surface_point(const ConchoidShape& shape, double phi, double theta) {
  return conchoid_radius(shape, phi) * to_direction({phi, theta});
}

// Points in one place share the area that was given to the first of them.
void share(std::span<const Vec3> points, std::vector<double>& areas) {
  std::map<std::tuple<double, double, double>, std::vector<std::size_t>> places;
  for (std::size_t i = 0; i < points.size(); ++i) {
    places[{points[i].x(), points[i].y(), points[i].z()}].push_back(i);
  }
  for (const auto& [place, group] : places) {
    double sum = 0.0;
    for (const std::size_t i : group) sum += areas[i];
    for (const std::size_t i : group) areas[i] = sum / static_cast<double>(group.size());
  }
}

constexpr double kMostCubes = 16777216.0;

}  // namespace

std::vector<Vec3> conchoid_rings(const ConchoidShape& shape, std::span<const double> angles,
                                 std::size_t per_ring) {
  std::vector<Vec3> points;
  points.reserve(angles.size() * per_ring);
  for (const double phi : angles) {
    for (std::size_t i = 0; i < per_ring; ++i) {
      const double theta = 2.0 * kPi * static_cast<double>(i) / static_cast<double>(per_ring);
      points.push_back(surface_point(shape, phi, theta));
    }
  }
  return points;
}

std::vector<Vec3> conchoid_spiral(const ConchoidShape& shape, std::size_t count) {
  if (count == 0) throw std::invalid_argument("a spiral on a conchoid has at least one point");
  const double each = cap_area(shape, kConchoidRim) / static_cast<double>(count);
  std::vector<Vec3> points;
  points.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double phi = polar_angle_at_cap_area(shape, (static_cast<double>(i) + 0.5) * each);
    points.push_back(surface_point(shape, phi, 2.0 * kPi * meridian_length(shape, phi) / std::sqrt(each)));
  }
  return points;
}

// The pieces are rings at equal distances along the meridian, cut about as long as they are wide.
std::vector<double> nearest_areas(const ConchoidShape& shape, std::span<const Vec3> points,
                                  std::size_t pieces_per_point) {
  if (points.empty() || pieces_per_point == 0) {
    throw std::invalid_argument("areas need at least one point on the conchoid and one piece a point");
  }
  const double mean = cap_area(shape, kConchoidRim) / static_cast<double>(points.size());
  const NearestPoint nearest(points, std::sqrt(mean));
  const double length = meridian_length(shape, kConchoidRim);
  const double rows = std::ceil(length / std::sqrt(mean / static_cast<double>(pieces_per_point)));
  std::vector<double> areas(points.size(), 0.0);
  double above = 0.0;
  for (double row = 1.0; row <= rows; row += 1.0) {
    const double below =
        cap_area(shape, std::min(polar_angle_at_meridian_length(shape, length * row / rows), kConchoidRim));
    const double phi = polar_angle_at_cap_area(shape, 0.5 * (above + below));
    const double around = 2.0 * kPi * conchoid_radius(shape, phi) * std::sin(phi);
    const double pieces = std::max(std::round(around * rows / length), 1.0);
    for (double piece = 0.5; piece < pieces; piece += 1.0) {
      areas[nearest(surface_point(shape, phi, 2.0 * kPi * piece / pieces))] += (below - above) / pieces;
    }
    above = below;
  }
  share(points, areas);
  return areas;
}

std::vector<AreaBand> area_bands(const ConchoidShape& shape, std::span<const Vec3> points,
                                 const AreaBandOptions& options) {
  if (options.bands == 0) throw std::invalid_argument("areas are listed in at least one band");
  const std::vector<double> areas = nearest_areas(shape, points, options.pieces_per_point);
  const double margin = std::sqrt(cap_area(shape, kConchoidRim) / static_cast<double>(points.size()));
  const double inside = meridian_length(shape, kConchoidRim) - margin;
  const double width = kConchoidRim / static_cast<double>(options.bands);
  std::vector<AreaBand> bands(options.bands);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double phi = to_angles(points[i]).phi;
    if (phi > kConchoidRim || meridian_length(shape, phi) > inside) continue;
    const double place =
        std::floor(phi / width * (1.0 + kCurveRounding));  // a ring on a border is in the band it starts
    AreaBand& band = bands[std::min(static_cast<std::size_t>(place), options.bands - 1)];
    band.smallest = band.points == 0 ? areas[i] : std::min(band.smallest, areas[i]);
    band.largest = std::max(band.largest, areas[i]);
    band.mean += areas[i];
    ++band.points;
  }
  for (std::size_t k = 0; k < bands.size(); ++k) {
    bands[k].from_deg = 90.0 * static_cast<double>(k) / static_cast<double>(options.bands);
    bands[k].to_deg = 90.0 * static_cast<double>(k + 1) / static_cast<double>(options.bands);
    bands[k].mean /= static_cast<double>(std::max<std::size_t>(bands[k].points, 1));
  }
  std::erase_if(bands, [](const AreaBand& band) { return band.points == 0; });
  return bands;
}

NearestPoint::NearestPoint(std::span<const Vec3> points, double side) : points_(points), side_(side) {
  if (points.empty()) throw std::invalid_argument("there is no nearest point among none");
  lowest_ = points.front();
  Vec3 highest = points.front();
  for (const Vec3& p : points) {
    lowest_ = lowest_.cwiseMin(p);
    highest = highest.cwiseMax(p);
  }
  const Vec3 cubes = ((highest - lowest_) / side).array().floor() + 1.0;
  if (!(side > 0.0 && cubes.prod() <= kMostCubes)) {
    throw std::invalid_argument(
        "the cubes of a nearest-point grid have a side above 0 that is not too small");
  }
  last_ = {static_cast<int>(cubes.x()) - 1, static_cast<int>(cubes.y()) - 1, static_cast<int>(cubes.z()) - 1};
  start_.assign(static_cast<std::size_t>(cubes.prod()) + 1, 0);
  const auto number_of = [this](const Vec3& p) {
    const Cube cube = cube_of(p);
    return number(cube.x, cube.y, cube.z);
  };
  for (const Vec3& p : points) ++start_[number_of(p) + 1];
  for (std::size_t c = 1; c < start_.size(); ++c) start_[c] += start_[c - 1];
  order_.resize(points.size());
  std::vector<std::size_t> next(start_.begin(), start_.end() - 1);
  for (std::size_t i = 0; i < points.size(); ++i) order_[next[number_of(points[i])]++] = i;
}

// Every point beyond all cubes within `reach` of x's own is at least reach * side away.
std::size_t NearestPoint::operator()(const Vec3& x) const {
  const Cube own = cube_of(x);
  const int farthest = std::max({last_.x, last_.y, last_.z});
  Best best{0, std::numeric_limits<double>::infinity()};
  for (int reach = 0; reach <= farthest; ++reach) {
    search_shell(own, reach, x, best);
    if (best.square <= (reach * side_) * (reach * side_)) break;
  }
  return best.point;
}

// Searches cubes that are `reach` from x's own in some direction: whole rows on four sides, else two ends.
void NearestPoint::search_shell(const Cube& own, int reach, const Vec3& x, Best& best) const {
  for (int k = std::max(own.z - reach, 0); k <= std::min(own.z + reach, last_.z); ++k) {
    for (int j = std::max(own.y - reach, 0); j <= std::min(own.y + reach, last_.y); ++j) {
      const bool side = std::max(std::abs(k - own.z), std::abs(j - own.y)) == reach;
      for (int i = own.x - reach; i <= own.x + reach; i += side ? 1 : 2 * reach) {
        if (i >= 0 && i <= last_.x) search(number(i, j, k), x, best);
      }
    }
  }
}

void NearestPoint::search(std::size_t cube, const Vec3& x, Best& best) const {
  for (std::size_t n = start_[cube]; n < start_[cube + 1]; ++n) {
    const std::size_t point = order_[n];
    const double* p = points_[point].data();
    const double square =
        (p[0] - x[0]) * (p[0] - x[0]) + (p[1] - x[1]) * (p[1] - x[1]) + (p[2] - x[2]) * (p[2] - x[2]);
    if (square < best.square || (square == best.square && point < best.point)) best = {point, square};
  }
}

NearestPoint::Cube NearestPoint::cube_of(const Vec3& x) const {
  const auto along = [this](double offset, int last) {
    return static_cast<int>(std::clamp(std::floor(offset / side_), 0.0, static_cast<double>(last)));
  };
  return {along(x.x() - lowest_.x(), last_.x), along(x.y() - lowest_.y(), last_.y),
          along(x.z() - lowest_.z(), last_.z)};
}

std::size_t NearestPoint::number(int x, int y, int z) const {
  const auto wide = static_cast<std::size_t>(last_.x) + 1;
  const auto deep = static_cast<std::size_t>(last_.y) + 1;
  return (static_cast<std::size_t>(z) * deep + static_cast<std::size_t>(y)) * wide +
         static_cast<std::size_t>(x);
}

}  // namespace impinge
