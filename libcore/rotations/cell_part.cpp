// SPDX-License-Identifier: GPL-3.0-or-later
#include "rotations/cell_part.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

namespace impinge {
namespace {

constexpr double kFormRounding = 1e-14;   // share of the entries of a form
constexpr double kFloatRounding = 2e-6;   // share of a plane's slope
constexpr double kPolytopeSlack = 1e-12;  // share of a cell's volume that rounding may add to a polytope

// Does the half-space hold all of the cell's eighth k?
bool holds_eighth(const CellPlane& plane, std::uint64_t k) {
  Vec3 middle;
  double reach = 0.0;
  for (std::size_t side = 0; side < 3; ++side) {
    middle[static_cast<Eigen::Index>(side)] = ((k >> side) & 1U) != 0 ? 0.5 : -0.5;
    reach += 0.5 * std::abs(static_cast<double>(plane.slope[side]));
  }
  return plane.at(middle) >= reach * (1.0 + kFloatRounding);
}

}  // namespace

CellPlane FormOverCell::plane() const {
  // The slope is scaled to length 1 and rounded to floats; the offset allows for that.
  const double scale = 1.0 / std::max(slope.norm(), 1e-300);
  CellPlane plane;
  for (std::size_t k = 0; k < 3; ++k)
    plane.slope[k] = static_cast<float>(scale * slope[static_cast<Eigen::Index>(k)]);
  const double offset = std::clamp(scale * (middle + least), -1e6, 1e6);
  plane.offset = static_cast<float>(offset - kFloatRounding * (1.0 + std::abs(offset)));
  return plane;
}

Quaternion4 CellPlane::normal(const CellFrame& frame) const {
  const Vec3 middle = frame.sides(frame.middle());
  Quaternion4 n = static_cast<double>(offset) * frame.across();
  for (std::size_t k = 0; k < 3; ++k)
    n += static_cast<double>(slope[k]) / frame.half() *
         (frame.side(k) - middle[static_cast<Eigen::Index>(k)] * frame.across());
  return n;
}

CellFrame::CellFrame(const RotationCell& cell)
    : middle_(centre(cell)),
      half_(std::ldexp(1.0, -static_cast<int>(cell.level))),
      cube_(static_cast<Eigen::Index>(cell.number >> (3 * cell.level))) {
  std::size_t at = 0;
  for (Eigen::Index k = 0; k < 4; ++k)
    if (k != cube_) side_[at++] = k;
  most_ = middle_.squaredNorm() + 2.0 * half_ * middle_.norm() * 2.0 + 3.0 * half_ * half_;
  // Of a pure quaternion v and q: (-v . q_v, w v + v x q_v).
  Eigen::Matrix<double, 4, 3> product;
  product << -middle_[1], -middle_[2], -middle_[3],  //
      middle_[0], middle_[3], -middle_[2],           //
      -middle_[3], middle_[0], middle_[1],           //
      middle_[2], -middle_[1], middle_[0];
  Eigen::Matrix3d along;
  for (Eigen::Index k = 0; k < 3; ++k) along.row(k) = product.row(side_[static_cast<std::size_t>(k)]);
  turned_ = along * rotation_of(middle_);
}

FormOverCell CellFrame::form_in_ball(const Vec3& n, const Vec3& x, double product, double k, double sign,
                                     double slack) const {
  const double inner = n.dot(x) - k;
  FormOverCell over;
  over.middle = sign * inner * middle_.squaredNorm();
  over.slope = 2.0 * half_ * sign * (inner * sides(middle_) - turned_ * n.cross(x));
  over.least = 3.0 * half_ * half_ * std::min(-sign * k - product, 0.0) -
               most_ * (slack + kFormRounding * 16.0 * (product + std::abs(k)));
  return over;
}

FormOverCell CellFrame::form(const Vec3& n, const Vec3& x, double k, double sign, double slack) const {
  const double inner = n.dot(x);
  const Vec3 cross = x.cross(n);
  Eigen::Matrix4d a;
  a(0, 0) = inner - k;
  for (Eigen::Index i = 0; i < 3; ++i) {
    a(0, i + 1) = cross[i];
    a(i + 1, 0) = cross[i];
    for (Eigen::Index j = 0; j < 3; ++j)
      a(i + 1, j + 1) = n[i] * x[j] + n[j] * x[i] - (i == j ? inner + k : 0.0);
  }
  a *= sign;
  const Quaternion4 image = a * middle_;
  FormOverCell over;
  over.slope = 2.0 * half_ * sides(image);
  double rest = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    rest += std::min(a(side_[i], side_[i]), 0.0);
    for (std::size_t j = 0; j < i; ++j) rest -= 2.0 * std::abs(a(side_[i], side_[j]));
  }
  // As |n . R x| <= |n| |x|, no eigenvalue of a is below this: of use where n goes along R x.
  rest = std::max(rest, 3.0 * std::min(-sign * k - n.norm() * x.norm(), 0.0));
  over.middle = middle_.dot(image);
  over.least =
      half_ * half_ * rest - most_ * (slack + kFormRounding * 16.0 * (n.norm() * x.norm() + std::abs(k)));
  return over;
}

Vec3 CellFrame::place(const Quaternion4& q) const { return (sides(q) / q[cube_] - sides(middle_)) / half_; }

CellPolytope::CellPolytope() {
  for (std::uint32_t k = 0; k < 8; ++k)
    point_[points_++] = {(k & 1U) != 0 ? 1.0 : -1.0, (k & 2U) != 0 ? 1.0 : -1.0, (k & 4U) != 0 ? 1.0 : -1.0};
  for (std::uint32_t side = 0; side < 6; ++side) {
    const std::size_t axis = side / 2;
    const double at = side % 2 == 1 ? 1.0 : -1.0;
    Polygon& polygon = face_[faces_++];
    polygon.number = side;
    polygon.corners = 4;
    constexpr std::array<std::array<double, 2>, 4> kRound{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
    for (std::size_t k = 0; k < 4; ++k) {
      const auto& [a, b] = kRound[at > 0.0 ? k : 3 - k];  // counter-clockwise from outside
      Vec3& corner = polygon.corner[k];
      corner[static_cast<Eigen::Index>(axis)] = at;
      corner[static_cast<Eigen::Index>((axis + 1) % 3)] = a;
      corner[static_cast<Eigen::Index>((axis + 2) % 3)] = b;
    }
  }
}

double CellPolytope::depth_below(const FormOverCell& form, double most) const {
  const double offset = form.middle + form.least;
  if (offset >= form.corner()) return 0.0;
  const double length = std::max(form.slope.norm(), 1e-300);
  const double inside = form.slope.dot(middle_) + offset;
  if (inside >= length * radius_) return 0.0;
  if (-inside >= most * length) return most > 0.0 ? most : HUGE_VAL;
  double least = 0.0;
  for (std::size_t k = 0; k < points_; ++k) least = std::min(least, form.slope.dot(point_[k]) + offset);
  return least == 0.0 ? 0.0 : -least / length;
}

// A ball round all corners, about a point of the polytope.
void CellPolytope::find_middle() {
  middle_.setZero();
  for (std::size_t k = 0; k < points_; ++k) middle_ += point_[k] / static_cast<double>(points_);
  radius_ = 0.0;
  for (std::size_t k = 0; k < points_; ++k) radius_ = std::max(radius_, (point_[k] - middle_).norm());
  radius_ *= 1.0 + kFormRounding;
}

double CellPolytope::farthest(const CellPlane& plane) const {
  double most = -HUGE_VAL;
  for (std::size_t f = 0; f < faces_; ++f)
    for (std::size_t k = 0; k < face_[f].corners; ++k) most = std::max(most, plane.at(face_[f].corner[k]));
  return most;
}

bool CellPolytope::clip(const CellPlane& plane, std::uint32_t number) {
  std::size_t kept = 0;
  std::size_t cut = 0;
  Polygon clipped;
  for (std::size_t f = 0; f < faces_; ++f) {
    Polygon& face = face_[f];
    clipped.corners = 0;
    clipped.number = face.number;
    for (std::size_t k = 0; k < face.corners; ++k) {
      const Vec3& a = face.corner[k];
      const Vec3& b = face.corner[(k + 1) % face.corners];
      const double at_a = plane.at(a);
      const double at_b = plane.at(b);
      if (at_a >= 0.0) clipped.corner[clipped.corners++] = a;
      if ((at_a >= 0.0) == (at_b >= 0.0)) continue;
      // Interpolated from the inside outwards, so that both faces at this edge get the same corner.
      const Vec3 x = at_a >= 0.0 ? Vec3(a + (at_a / (at_a - at_b)) * (b - a))
                                 : Vec3(b + (at_b / (at_b - at_a)) * (a - b));
      clipped.corner[clipped.corners++] = x;
      cut_[cut++] = x;
      if (clipped.corners + 2 > kMostCorners || cut == cut_.size()) {
        faces_ = 0;
        return false;
      }
    }
    if (clipped.corners < 3) continue;
    face_[kept].corners = clipped.corners;
    face_[kept].number = clipped.number;
    std::copy_n(clipped.corner.begin(), clipped.corners, face_[kept].corner.begin());
    ++kept;
  }
  faces_ = kept;
  if (kept == 0) return true;
  if (kept == kMostFaces) {
    faces_ = 0;
    return false;
  }
  if (cut < 3) return true;
  std::size_t still = 0;
  for (std::size_t k = 0; k < points_; ++k)
    if (plane.at(point_[k]) >= 0.0) point_[still++] = point_[k];
  points_ = still;
  return close(plane, number, cut);
}

// Adds the new face in the plane, its corners in order round their mean.
bool CellPolytope::close(const CellPlane& plane, std::uint32_t number, std::size_t cut) {
  const Vec3 outwards = -Vec3(plane.slope[0], plane.slope[1], plane.slope[2]);
  const Vec3 across = outwards.unitOrthogonal();
  const Vec3 up = outwards.normalized().cross(across);
  Vec3 mean = Vec3::Zero();
  for (std::size_t k = 0; k < cut; ++k) mean += cut_[k] / static_cast<double>(cut);
  std::array<std::pair<double, std::size_t>, 2 * kMostFaces> order;
  for (std::size_t k = 0; k < cut; ++k)
    order[k] = {std::atan2(up.dot(cut_[k] - mean), across.dot(cut_[k] - mean)), k};
  std::sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(cut));
  Polygon& face = face_[faces_];
  face.number = number;
  face.corners = 0;
  for (std::size_t k = 0; k < cut; ++k) {  // each corner is there twice, once from either face
    const Vec3& x = cut_[order[k].second];
    if (face.corners > 0 && face.corner[face.corners - 1] == x) continue;
    if (face.corners == kMostCorners || points_ == kMostPoints) {
      faces_ = 0;
      return false;
    }
    face.corner[face.corners++] = x;
    point_[points_++] = x;
  }
  if (face.corners > 1 && face.corner[0] == face.corner[face.corners - 1]) --face.corners;
  if (face.corners >= 3) ++faces_;
  find_middle();
  return true;
}

bool CellPolytope::bounds(std::uint32_t number) const {
  return std::any_of(face_.begin(), face_.begin() + static_cast<std::ptrdiff_t>(faces_),
                     [&](const Polygon& face) { return face.number == number; });
}

double CellPolytope::share(const CellFrame& frame) const {
  double volume = 0.0;
  Vec3 first = Vec3::Zero();
  double second = 0.0;
  for (std::size_t f = 0; f < faces_; ++f) {
    const Polygon& face = face_[f];
    for (std::size_t k = 2; k < face.corners; ++k) {
      const Vec3& a = face.corner[0];
      const Vec3& b = face.corner[k - 1];
      const Vec3& c = face.corner[k];
      const double part = a.dot(b.cross(c)) / 6.0;
      const Vec3 sum = a + b + c;
      volume += part;
      first += 0.25 * part * sum;
      second += 0.05 * part * (a.squaredNorm() + b.squaredNorm() + c.squaredNorm() + sum.squaredNorm());
    }
  }
  const double h = frame.half();
  const Vec3 middle = frame.sides(frame.middle());
  const double s = 1.0 + middle.squaredNorm();
  const double least = 1.0 + (middle.cwiseAbs().array() - h).max(0.0).square().sum();
  const double found = volume / (s * s) - 4.0 * h / (s * s * s) * middle.dot(first) -
                       2.0 * h * h * second / (least * least * least) - 8.0 * kPolytopeSlack;
  constexpr double kAll = std::numbers::pi * std::numbers::pi;
  return std::max(0.0, found * h * h * h / kAll);
}

bool CellPart::is_free(const Vec3& t) const {
  return !free.empty() &&
         std::all_of(free.begin(), free.end(), [&](const CellPlane& plane) { return plane.at(t) >= 0.0; });
}

bool CellPart::is_blocked(const Vec3& t) const {
  return std::any_of(blocked.begin(), blocked.end(),
                     [&](const CellPlane& plane) { return plane.at(t) >= 0.0; });
}

bool CellPart::frees(std::uint64_t k) const {
  return !free.empty() && std::all_of(free.begin(), free.end(),
                                      [&](const CellPlane& plane) { return holds_eighth(plane, k); });
}

bool CellPart::blocks(std::uint64_t k) const {
  return std::any_of(blocked.begin(), blocked.end(),
                     [&](const CellPlane& plane) { return holds_eighth(plane, k); });
}

}  // namespace impinge
