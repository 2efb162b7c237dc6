// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/meeting_faces.hpp"

#include <algorithm>

#include "sphere/orientation.hpp"
#include "sphere/plane_side.hpp"

namespace impinge {
namespace {

bool of_one_sign(int a, int b, int c) {
  const auto [least, most] = std::minmax({a, b, c});
  return least >= 0 || most <= 0;
}

// The projection along one axis to a plane, in which the sign of a triangle's area is exact.
class Flat {
 public:
  explicit Flat(int axis) : u_((axis + 1) % 3), v_((axis + 2) % 3) {}

  int side(const Vec3& a, const Vec3& b, const Vec3& c) const {
    return orientation(lifted(a), lifted(b), lifted(c));
  }
  bool meet(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b) const {
    const int of_a = side(p, q, a);
    const int of_b = side(p, q, b);
    if (of_a == 0 && of_b == 0) return overlap(p, q, a, b, u_) && overlap(p, q, a, b, v_);
    return of_a * of_b <= 0 && side(a, b, p) * side(a, b, q) <= 0;
  }

 private:
  Vec3 lifted(const Vec3& x) const { return {x[u_], x[v_], 1.0}; }
  static bool overlap(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b, int axis) {
    return std::max(p[axis], q[axis]) >= std::min(a[axis], b[axis]) &&
           std::max(a[axis], b[axis]) >= std::min(p[axis], q[axis]);
  }

  int u_;
  int v_;
};

bool meets_in_plane(const Triangle& face, const Vec3& p, const Vec3& q) {
  const auto& [a, b, c] = face;
  for (int axis = 0; axis < 3; ++axis) {
    const Flat flat(axis);
    if (flat.side(a, b, c) == 0) continue;  // the axis sees the triangle edge-on
    return of_one_sign(flat.side(a, b, p), flat.side(b, c, p), flat.side(c, a, p)) || flat.meet(p, q, a, b) ||
           flat.meet(p, q, b, c) || flat.meet(p, q, c, a);
  }
  return false;
}

}  // namespace

bool meets_segment(const Triangle& face, const Vec3& p, const Vec3& q) {
  const auto& [a, b, c] = face;
  const int of_p = plane_side(a, b, c, p);
  const int of_q = plane_side(a, b, c, q);
  if (of_p * of_q > 0) return false;
  if (of_p == 0 && of_q == 0) return meets_in_plane(face, p, q);
  return of_one_sign(plane_side(p, q, a, b), plane_side(p, q, b, c), plane_side(p, q, c, a));
}

bool faces_meet(const Triangle& a, const Triangle& b) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (meets_segment(b, a[k], a[(k + 1) % 3]) || meets_segment(a, b[k], b[(k + 1) % 3])) return true;
  }
  return false;
}

}  // namespace impinge
