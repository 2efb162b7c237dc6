// SPDX-License-Identifier: GPL-3.0-or-later
// Icosahedral grids: each of the twenty faces is divided into n^2 triangles, with an entry at each corner.
//
// Node (i, j) of a diamond (see sphere/icosahedron.hpp) lies in the direction of w(n - i - j) A + w(i) P +
// w(j) Q if i + j <= n, else w(i + j - n) F + w(n - i) Q + w(n - j) P, with the weights w of the warp. A
// diamond owns i = 1..n, j = 0..n-1; with the poles these are all nodes, each once: 10 n^2 + 2 entries.
// A look-up finds the face, then the triangle, and weights the three corners by barycentric coordinates:
// by the fractions for stencil(), by the place on the flat face for plane_stencil().
//
// Precision is 72 / n degrees: 5 n entries stand round the equator.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <vector>

#include <Eigen/Geometry>

#include "sphere/arc_borders.hpp"
#include "sphere/cone_polygon.hpp"
#include "sphere/equator_division.hpp"
#include "sphere/icosahedron.hpp"
#include "sphere/largest_gap.hpp"
#include "sphere/scheme.hpp"

namespace impinge {

/// Lower and upper ends of three barycentric coordinates.
struct TriangleRange {
  Vec3 low;  // corner by corner
  Vec3 high;
};

/// A warp says what makes one icosahedral grid differ from another:
///   name, label, citation   of the scheme (sphere/scheme.hpp)
///   weight(k, n)       weight of a corner in the node that is k / n of the way to it; 0 for k = 0
///   fractions(lambda)  from barycentric coordinates on the flat face (>= 0, sum 1) to k / n of each corner
///   widen(range)       from ranges of the former, within [0, 1], to ranges of the latter that hold them
///   kFlatCells         whether the fractions are lambda itself; if not, also
///   kMostBend          the largest second derivative of a fraction along a unit step of lambda
///   kLongestWay        the longest way between two points of a cell along straight lines of the fractions,
///                      times n; radians
/// Its widest cell must be at most kWidest steps from the middle of the face.
template <class Warp>
class IcosahedralGrid {
 public:
  static constexpr std::string_view name = Warp::name;
  static constexpr std::string_view label = Warp::label;
  static constexpr std::string_view citation = Warp::citation;

  static constexpr bool kFlatCells = Warp::kFlatCells;

  class Walker;

  IcosahedralGrid() : IcosahedralGrid(72) {}
  static IcosahedralGrid with_precision(double degrees) {
    return IcosahedralGrid(equator_division(degrees, 72.0, label));
  }

  std::size_t divisions() const { return n_; }  // n
  std::size_t size() const { return 10 * n_ * n_ + 2; }
  std::size_t cells() const { return 20 * n_ * n_; }
  std::size_t equator_points() const { return 5 * n_; }
  double precision_deg() const { return 72.0 / static_cast<double>(n_); }
  double covering_radius() const { return covering_radius_; }
  double stencil_radius() const { return Warp::kLongestWay / static_cast<double>(n_); }

  Vec3 direction(std::size_t entry) const {
    if (entry >= north()) return {0.0, 0.0, entry == north() ? 1.0 : -1.0};
    const std::size_t row = entry / n_;
    return node(row / n_, entry % n_ + 1, row % n_, [this](std::size_t k) { return Warp::weight(k, n_); });
  }

  Stencil stencil(const Vec3& x) const {
    const std::size_t face = Icosahedron::instance().face_of(x);
    return to_stencil(face, triangle_at(flat_place(face, x)));
  }

  /// On a face of the icosahedron an arc is a straight line, along which the fractions bend by at most
  /// kMostBend times its length squared. Cells lie between lines of whole n times a fraction.
  bool meets_cells_once(const Vec3& a, const Vec3& b) const {
    if constexpr (kFlatCells) {
      return true;
    } else {
      const std::size_t face = Icosahedron::instance().face_of(a);
      if (face != Icosahedron::instance().face_of(b)) return false;
      const auto n = static_cast<double>(n_);
      const Vec3 from = flat_place(face, a);
      const Vec3 to = flat_place(face, b);
      const Vec3 first = n * Warp::fractions(from);
      const Vec3 last = n * Warp::fractions(to);
      const double bend = n * Warp::kMostBend * (to - from).squaredNorm();
      return passes_lines_once(first[0], last[0], bend) && passes_lines_once(first[1], last[1], bend) &&
             passes_lines_once(first[2], last[2], bend);
    }
  }

  double depth(const Vec3& x) const {
    const Icosahedron& icosahedron = Icosahedron::instance();
    return icosahedron.face[icosahedron.face_of(x)].axis.dot(x);
  }
  Stencil plane_stencil(const Vec3& x) const {
    if constexpr (kFlatCells) return stencil(x);
    const std::size_t face = Icosahedron::instance().face_of(x);
    const Vec3 flat = flat_place(face, x);
    return to_stencil(face, flat_triangle_at(flat));
  }

  Walker walker() const { return Walker(*this); }

  friend bool operator==(const IcosahedralGrid&, const IcosahedralGrid&) = default;

 private:
  explicit IcosahedralGrid(std::size_t n) : n_(n), covering_radius_(widest_near_middle()) {}

  /// Largest circumradius of the triangles round the middle of a face.
  double widest_near_middle() const {
    const auto weight = [this](std::size_t k) { return Warp::weight(k, n_); };
    const auto at = [&](std::size_t i, std::size_t j) { return node(0, i, j, weight); };
    const std::size_t middle = n_ / 3;
    const std::size_t low = middle - std::min(middle, kWidest);
    double widest = 0.0;
    for (std::size_t i = low; i <= middle + kWidest; ++i) {
      for (std::size_t j = low; j <= middle + kWidest; ++j) {
        if (i + j + 1 <= n_) widest = std::max(widest, circumradius(at(i, j), at(i + 1, j), at(i, j + 1)));
        if (i + j + 2 <= n_) {
          widest = std::max(widest, circumradius(at(i + 1, j + 1), at(i + 1, j), at(i, j + 1)));
        }
      }
    }
    return widest;
  }

  std::size_t north() const { return 10 * n_ * n_; }

  /// Direction of node (i, j) of a diamond; weight(k) is the weight of a corner.
  template <class Weight>
  Vec3 node(std::size_t diamond, std::size_t i, std::size_t j, Weight&& weight) const {
    const auto& faces = Icosahedron::instance().face;
    if (i + j <= n_) return blend(faces[2 * diamond].corner, weight(n_ - i - j), weight(i), weight(j));
    return blend(faces[2 * diamond + 1].corner, weight(i + j - n_), weight(n_ - i), weight(n_ - j));
  }

  static Vec3 blend(const std::array<Vec3, 3>& corner, double a, double b, double c) {
    const Vec3 sum = a * corner[0] + b * corner[1] + c * corner[2];
    return sum / std::sqrt(sum.x() * sum.x() + sum.y() * sum.y() + sum.z() * sum.z());
  }

  std::size_t owned(std::size_t diamond, std::size_t i, std::size_t j) const {
    return (diamond * n_ + j) * n_ + i - 1;
  }

  /// Entry at node (i, j) of a diamond, i and j from 0 to n. On two edges it belongs to the next diamond.
  std::size_t entry_at(std::size_t diamond, std::size_t i, std::size_t j) const {
    if (i != 0 && j != n_) return owned(diamond, i, j);
    const std::size_t next = diamond % 5 == 4 ? diamond - 4 : diamond + 1;
    if (diamond < 5) {
      if (i == 0) return j == 0 ? north() : owned(next, j, 0);
      return owned(diamond + 5, i, 0);
    }
    if (j == n_) return i == n_ ? north() + 1 : owned(next, n_, i);
    return owned(next - 5, n_, j);
  }

  /// A triangle of a face that has its corners at (0, 0), (n, 0), (0, n). The upright one has the nodes (i,
  /// j), (i + 1, j), (i, j + 1); the one beside it, upside down, has (i + 1, j + 1) in place of (i, j). The
  /// weights are in the order of the nodes.
  struct Triangle {
    std::size_t i;
    std::size_t j;
    bool upright;
    std::array<double, 3> weight;

    using Node = std::array<std::size_t, 2>;
    std::array<Node, 3> nodes() const {
      return {upright ? Node{i, j} : Node{i + 1, j + 1}, Node{i + 1, j}, Node{i, j + 1}};
    }
  };

  /// Barycentric coordinates on the flat face.
  static Vec3 flat_place(std::size_t f, const Vec3& x) {
    const Icosahedron::Face& face = Icosahedron::instance().face[f];
    const Vec3 flat = Vec3(face.dual[0].dot(x), face.dual[1].dot(x), face.dual[2].dot(x)).cwiseMax(0.0);
    return flat / flat.sum();
  }

  /// The triangle that holds a place, with weights by the fractions.
  Triangle triangle_at(const Vec3& flat) const {
    const Vec3 place = Warp::fractions(flat) * static_cast<double>(n_);
    const std::size_t i = std::min(static_cast<std::size_t>(place[1]), n_ - 1);
    const std::size_t j = std::min(static_cast<std::size_t>(place[2]), n_ - 1 - i);
    const double a = std::min(place[1] - static_cast<double>(i), 1.0);
    double b = std::min(place[2] - static_cast<double>(j), 1.0);
    const bool last = i + j + 1 == n_;  // there is no upside-down triangle beyond the edge
    if (last) b = std::min(b, 1.0 - a);
    if (last || a + b <= 1.0) return {i, j, true, {std::max((1.0 - a) - b, 0.0), a, b}};
    return {i, j, false, {a - (1.0 - b), 1.0 - b, 1.0 - a}};
  }

  /// The triangle that holds a place on the flat face, with the weights there. It is triangle_at() or a
  /// neighbour of it, as the borders of the fractions are curved on the flat face.
  Triangle flat_triangle_at(const Vec3& flat) const {
    Triangle triangle = triangle_at(flat);
    for (std::size_t step = 0;; ++step) {
      triangle.weight = flat_weights(triangle, flat);
      const auto least =
          static_cast<std::size_t>(std::ranges::min_element(triangle.weight) - triangle.weight.begin());
      if (triangle.weight[least] >= 0.0 || step == kMostSteps || !cross_edge(least, triangle)) break;
    }
    double sum = 0.0;
    for (double& w : triangle.weight) sum += w = std::max(w, 0.0);  // negative by rounding alone
    for (double& w : triangle.weight) w /= sum;
    return triangle;
  }

  /// Goes to the triangle across the edge opposite to a node; false if that one is on another face.
  bool cross_edge(std::size_t opposite, Triangle& triangle) const {
    Triangle next = triangle;
    next.upright = !triangle.upright;
    if (opposite == 1) triangle.upright ? --next.i : ++next.j;
    if (opposite == 2) triangle.upright ? --next.j : ++next.i;
    if (std::max(next.i, next.j) >= n_ || next.i + next.j + (next.upright ? 1 : 2) > n_) return false;
    triangle = next;
    return true;
  }

  /// Weights of the nodes on the flat face, from the second and third coordinate of the place. Some are
  /// negative for a place outside.
  std::array<double, 3> flat_weights(const Triangle& triangle, const Vec3& flat) const {
    const auto on_face = [this](const typename Triangle::Node& node) -> Eigen::Vector2d {
      const double first = Warp::weight(n_ - node[0] - node[1], n_);
      const Eigen::Vector2d rest(Warp::weight(node[0], n_), Warp::weight(node[1], n_));
      return rest / (first + rest.sum());
    };
    const auto [p, q, r] = triangle.nodes();
    const Eigen::Vector2d from = on_face(p);
    const Eigen::Vector2d u = on_face(q) - from;
    const Eigen::Vector2d v = on_face(r) - from;
    const Eigen::Vector2d x = flat.tail<2>() - from;
    const double area = u.x() * v.y() - u.y() * v.x();
    const double b = (x.x() * v.y() - x.y() * v.x()) / area;
    const double c = (u.x() * x.y() - u.y() * x.x()) / area;
    return {(1.0 - b) - c, b, c};
  }

  Stencil to_stencil(std::size_t face, const Triangle& triangle) const {
    const bool even = face % 2 == 0;
    const auto& weight = triangle.weight;
    Stencil stencil{{}, {weight[0], weight[1], weight[2], 0.0}, 3, 0};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [i, j] = triangle.nodes()[k];
      stencil.entry[k] = even ? entry_at(face / 2, i, j) : entry_at(face / 2, n_ - i, n_ - j);
    }
    const std::size_t column = even ? triangle.i : n_ - 1 - triangle.i;
    const std::size_t row = even ? triangle.j : n_ - 1 - triangle.j;
    stencil.cell = 2 * ((face / 2 * n_ + row) * n_ + column) + (triangle.upright == even ? 0U : 1U);
    return stencil;
  }

  static constexpr std::size_t kWidest = 3;
  static constexpr std::size_t kMostSteps = 4;  // to a neighbour: one is enough but for rounding

  std::size_t n_;
  double covering_radius_;  // radians
};

/// Computes each weight of the warp once, for all triangles.
template <class Warp>
class IcosahedralGrid<Warp>::Walker {
 public:
  /// Computes the weights of all nodes along an edge.
  explicit Walker(const IcosahedralGrid& scheme) : scheme_(scheme), weight_(scheme.n_ + 1) {
    for (std::size_t k = 0; k < weight_.size(); ++k) weight_[k] = Warp::weight(k, scheme.n_);
  }

  template <class Visit>
  void visit_near(const TriangleCone& cone, double margin, Visit&& visit) const {
    const ConePolygon triangle(cone);
    Vec3 middle = Vec3::Zero();
    for (const Vec3& x : triangle.corners()) middle += x / 3.0;
    double least = 1.0;
    for (const Vec3& x : triangle.corners()) least = std::min(least, middle.dot(x) / middle.norm());
    // A cap of less than 90 degrees about the middle holds the triangle if it holds the corners.
    const double reach = std::acos(std::max(least, -1.0)) + margin + Icosahedron::kCornerAngle + kRounding;
    const bool anywhere = !(least > 0.01) || reach >= kPi;
    const double limit = anywhere ? 0.0 : std::cos(reach) * middle.norm();
    for (std::size_t f = 0; f < 20; ++f) {
      const Vec3& axis = Icosahedron::instance().face[f].axis;
      if (anywhere || axis.dot(middle) >= limit * axis.norm()) visit_face(f, triangle, margin, visit);
    }
  }

 private:
  static constexpr double kRounding = 1e-10;     // rad, far above the rounding of clipping
  static constexpr double kSlack = 1e-6;         // of a spacing
  static constexpr double kLargestMargin = 0.5;  // rad; beyond it every entry is near
  static constexpr double kLeastDepth = 1e-3;    // of a clipped corner, for its coordinates to be accurate

  /// First and last multiple of 1 / n in a range.
  struct Lines {
    std::size_t first;
    std::size_t last;
  };

  Lines lines(double low, double high) const {
    const auto n = static_cast<double>(scheme_.n_);
    const double first = std::clamp(std::ceil(low * n - kSlack), 0.0, n);
    const double last = std::clamp(std::floor(high * n + kSlack), 0.0, n);
    return {static_cast<std::size_t>(first), static_cast<std::size_t>(last)};
  }

  /// The most by which a barycentric coordinate changes within `margin` of a point of the face. The plane of
  /// the face is cos(corner angle) from the centre; central projection to it stretches by at most that over
  /// the cosine squared of the angle from the middle. Over the height of the face the coordinate grows by
  /// one.
  static double spread(double margin) {
    const double height = Icosahedron::kEdge * 0.8660254037844386;
    const double farthest = std::cos(Icosahedron::kCornerAngle + margin);
    return margin * std::cos(Icosahedron::kCornerAngle) / (farthest * farthest * height);
  }

  /// Ranges of the barycentric coordinates of those points of a face that are within the margin of the
  /// triangle; false if there are none.
  static bool near_range(const Icosahedron::Face& face, ConePolygon polygon, double margin,
                         TriangleRange& range) {
    range = {Vec3::Zero(), Vec3::Ones()};
    if (margin > kLargestMargin) return true;
    const double wider = spread(margin + kRounding);
    for (const Vec3& dual : face.dual) {
      polygon.clip(dual + wider * face.axis);
      if (polygon.empty()) return false;
    }
    TriangleRange found{Vec3::Ones(), Vec3::Zero()};
    for (const Vec3& x : polygon.corners()) {
      const double depth = face.axis.dot(x);
      if (!(depth > kLeastDepth)) return true;  // an edge of the triangle passes close to the centre
      const Vec3 flat = Vec3(face.dual[0].dot(x), face.dual[1].dot(x), face.dual[2].dot(x)) / depth;
      found.low = found.low.cwiseMin(flat);
      found.high = found.high.cwiseMax(flat);
    }
    range.low = (found.low.array() - wider).max(0.0).min(1.0);
    range.high = (found.high.array() + wider).max(0.0).min(1.0);
    return true;
  }

  template <class Visit>
  void visit_face(std::size_t f, const ConePolygon& triangle, double margin, Visit&& visit) const {
    TriangleRange range;
    if (!near_range(Icosahedron::instance().face[f], triangle, margin, range)) return;
    Warp::widen(range);
    const Lines a = lines(range.low[0], range.high[0]);
    Lines p = lines(range.low[1], range.high[1]);
    Lines q = lines(range.low[2], range.high[2]);
    const std::size_t n = scheme_.n_;
    if ((f == 0 || f == 11) && a.last == n) {
      const std::size_t pole = scheme_.north() + (f == 0 ? 0 : 1);
      visit_in_runs(
          pole, 1, [&](std::size_t) { return scheme_.direction(pole); }, visit);
    }
    for (std::size_t j = q.first; j <= q.last; ++j) {
      const std::size_t first = std::max(p.first, n - j > a.last ? n - j - a.last : 0);
      const std::size_t end = std::min(p.last + 1, n - j >= a.first ? n - j - a.first + 1 : 0);
      if (first >= end) continue;
      if (f % 2 == 0) {
        if (j < n) visit_row(f / 2, j, std::max<std::size_t>(first, 1), end, visit);
      } else if (j > 0 && first + j < n) {
        visit_row(f / 2, n - j, n - std::min(end - 1, n - j - 1), n - first + 1, visit);
      }
    }
  }

  /// Visits nodes i = first..end - 1 of a row of a diamond.
  template <class Visit>
  void visit_row(std::size_t diamond, std::size_t j, std::size_t first, std::size_t end,
                 Visit&& visit) const {
    const auto direction_of = [&](std::size_t k) {
      return scheme_.node(diamond, first + k, j, [this](std::size_t l) { return weight_[l]; });
    };
    if (first < end) visit_in_runs(scheme_.owned(diamond, first, j), end - first, direction_of, visit);
  }

  IcosahedralGrid scheme_;
  std::vector<double> weight_;
};

}  // namespace impinge
