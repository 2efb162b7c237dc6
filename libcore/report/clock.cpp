// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/clock.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/LU>

#include "sphere/direction.hpp"

namespace impinge {
namespace {

// Axes in the joint frame; `axis` points from the centre into the socket.
struct SocketAxes {
  Vec3 twelve;
  Vec3 three;
  Vec3 axis;

  double angle_deg(const Vec3& x) const { return std::acos(x.normalized().dot(axis)) / kDegree; }
  Vec3 direction(double hours, double angle_deg) const {
    const double turn = hours * 30.0 * kDegree;
    const double angle = angle_deg * kDegree;
    return std::cos(angle) * axis + std::sin(angle) * (std::cos(turn) * twelve + std::sin(turn) * three);
  }
};

// The main surface of the socket in the joint frame, and the gaps of its vertices.
struct UnrolledSocket {
  std::vector<Vec3> places;
  std::vector<Face> faces;
  SocketAxes axes;
};

UnrolledSocket unrolled(const SessionJoint& joint) {
  UnrolledSocket socket{mapped(joint.axes, joint.joint.socket.mesh.vertices), {}, {}};
  Vec3 middle = Vec3::Zero();
  for (const Face& face : joint.joint.socket.mesh.faces) {
    const bool main =
        std::all_of(face.begin(), face.end(), [&](std::uint32_t k) { return joint.socket.used[k]; });
    if (!main) continue;
    socket.faces.push_back(face);
    for (const std::uint32_t k : face) middle += socket.places[k].normalized();
  }
  socket.axes = {joint.dial->twelve, joint.dial->three, joint.dial->twelve.cross(joint.dial->three)};
  if (socket.axes.axis.dot(middle) < 0.0) socket.axes.axis = -socket.axes.axis;
  return socket;
}

// The rows and columns that a face may cover; all columns if the axis runs through it.
struct Stretch {
  std::size_t first_row = 0;
  std::size_t last_row = 0;
  std::size_t first_column = 0;
  std::size_t columns = ClockMap::kColumns;  // from the first on, past the last on to column 0
};

Stretch stretch_of(const std::array<Vec3, 3>& corners, const SocketAxes& axes, const ClockFace& dial,
                   bool about_axis) {
  double low = 180.0;
  double high = 0.0;
  double before = 0.0;  // hours from those of the first corner
  double after = 0.0;
  const double first = dial.hours(corners[0]);
  for (const Vec3& corner : corners) {
    low = std::min(low, axes.angle_deg(corner));
    high = std::max(high, axes.angle_deg(corner));
    const double apart = std::remainder(dial.hours(corner) - first, 12.0);
    before = std::min(before, apart);
    after = std::max(after, apart);
  }
  // Between its ends an edge may come a little nearer to the axis, or go farther from it.
  const auto row = [](double angle) {
    return static_cast<std::size_t>(std::max(angle, 0.0) / ClockMap::kRowDeg);
  };
  Stretch cells{.first_row = about_axis ? 0 : row(low - ClockMap::kRowDeg),
                .last_row = row(high + ClockMap::kRowDeg)};
  if (about_axis) return cells;
  constexpr double kAnHour = ClockMap::kColumns / 12.0;
  cells.first_column = static_cast<std::size_t>((first + before + 12.0) * kAnHour);
  cells.columns = static_cast<std::size_t>((after - before) * kAnHour) + 2;
  return cells;
}

// The gap where a ray meets a face with these weights of its corners. Corners without a gap take the gap of
// the others, as in the viewer; NaN where they have more than half of the weight.
double between(const Vec3& weights, const std::array<double, 3>& gaps) {
  double gap = 0.0;
  double met = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double weight = weights[static_cast<Eigen::Index>(k)];
    if (!std::isfinite(gaps[k])) continue;
    gap += weight * gaps[k];
    met += weight;
  }
  return met < 0.5 ? std::nan("") : gap / met;
}

void keep_smaller(double& cell, double gap) {
  if (cell == ClockMap::kAbsent || std::isnan(cell) || gap < cell) cell = gap;
}

// Adds a face to the cells of the map that it covers.
void add_face(const Face& face, const UnrolledSocket& socket, const ClockFace& dial,
              const SurfaceAnswer& gaps, ClockMap& map) {
  const std::array<Vec3, 3> corners{socket.places[face[0]], socket.places[face[1]], socket.places[face[2]]};
  Eigen::Matrix3d columns;
  columns << corners[0], corners[1], corners[2];
  const Eigen::Matrix3d inverse = columns.inverse();
  if (!inverse.allFinite()) return;  // edge-on
  const auto inside = [](const Vec3& weights) { return weights.minCoeff() >= -1e-9 * weights.maxCoeff(); };
  const Stretch cells = stretch_of(corners, socket.axes, dial, inside(inverse * socket.axes.axis));
  for (std::size_t row = cells.first_row; row <= cells.last_row && row < map.rows; ++row) {
    for (std::size_t k = 0; k < cells.columns; ++k) {
      const std::size_t column = (cells.first_column + k) % ClockMap::kColumns;
      Vec3 weights = inverse * socket.axes.direction(ClockMap::hours(column), ClockMap::angle_deg(row));
      if (!inside(weights)) continue;
      weights /= weights.sum();
      const std::size_t cell = row * ClockMap::kColumns + column;
      const auto of = [&](const std::vector<double>& values) {
        return between(weights, {values[face[0]], values[face[1]], values[face[2]]});
      };
      keep_smaller(map.gap_mm[cell], of(gaps.gap));
      keep_smaller(map.against_cartilage[cell], of(gaps.against_cartilage));
    }
  }
}

}  // namespace

std::optional<ClockMap> clock_map(const SessionJoint& joint, const GapsAnswer& found) {
  if (!joint.dial) return std::nullopt;
  const UnrolledSocket socket = unrolled(joint);
  double widest = 0.0;
  for (const Face& face : socket.faces)
    for (const std::uint32_t k : face) widest = std::max(widest, socket.axes.angle_deg(socket.places[k]));
  ClockMap map;
  map.rows = static_cast<std::size_t>(std::ceil(widest / ClockMap::kRowDeg));
  map.gap_mm.assign(map.rows * ClockMap::kColumns, ClockMap::kAbsent);
  map.against_cartilage = map.gap_mm;
  map.touching = found.touching;
  for (const Face& face : socket.faces) add_face(face, socket, *joint.dial, found.socket, map);
  return map;
}

Table clock_table(const ClockMap& map) {
  Table table{{{"clock_hours", "1", "on the rim's clock; 12 is superior, 3 anterior"},
               {"angle_deg", "deg", "from the axis of the socket, at the centre of rotation"},
               {"gap_mm", "mm", "along the ray from the centre"}}};
  for (std::size_t row = 0; row < map.rows; ++row) {
    for (std::size_t column = 0; column < ClockMap::kColumns; ++column) {
      const double gap = map.gap_mm[row * ClockMap::kColumns + column];
      if (std::isfinite(gap)) table.add_row({ClockMap::hours(column), ClockMap::angle_deg(row), gap});
    }
  }
  return table;
}

}  // namespace impinge
