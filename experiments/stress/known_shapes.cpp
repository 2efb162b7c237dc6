// SPDX-License-Identifier: GPL-3.0-or-later
// The bones of turns with a known first contact. They are made about +z and turned to x or y without
// rounding, by exchanging coordinates.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <Eigen/Geometry>

#include "mesh/bodies.hpp"
#include "stress/known_turn.hpp"
#include "stress/precise.hpp"
#include "stress/shapes.hpp"

namespace impinge::lab {
namespace {

Vec3 exchanged(const Vec3& x, std::size_t k) {
  if (k % 3 == 0) return x;
  return k % 3 == 1 ? Vec3(x.z(), x.x(), x.y()) : Vec3(x.y(), x.z(), x.x());
}

// A convex body; each face is wound as seen from outside.
TriangleMesh convex(std::vector<Vec3> corners, std::vector<Face> faces) {
  Vec3 middle = Vec3::Zero();
  for (const Vec3& x : corners) middle += x / static_cast<double>(corners.size());
  TriangleMesh mesh{std::move(corners), std::move(faces)};
  for (Face& face : mesh.faces) {
    if (area_vector(mesh, face).dot(corner(mesh, face, 0) - middle) < 0.0) std::swap(face[1], face[2]);
  }
  return mesh;
}

TriangleMesh tetrahedron(const Vec3& tip, const Vec3& a, const Vec3& b, const Vec3& c) {
  return convex({tip, a, b, c}, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 2, 3}});
}

// The prism between two triangles; the first corners of both are the ends of the ridge.
TriangleMesh prism(const std::array<Vec3, 3>& low, const std::array<Vec3, 3>& high) {
  return convex({low[0], low[1], low[2], high[0], high[1], high[2]},
                {{0, 1, 2}, {3, 4, 5}, {0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}, {2, 0, 3}, {2, 3, 5}});
}

TriangleMesh slab(const Vec3& low, const Vec3& high) {
  std::vector<Vec3> corners;
  for (const double x : {low.x(), high.x()})
    for (const double y : {low.y(), high.y()})
      for (const double z : {low.z(), high.z()}) corners.emplace_back(x, y, z);
  return convex(std::move(corners), {{0, 1, 3},
                                     {0, 3, 2},
                                     {4, 5, 7},
                                     {4, 7, 6},
                                     {0, 1, 5},
                                     {0, 5, 4},
                                     {2, 3, 7},
                                     {2, 7, 6},
                                     {0, 2, 6},
                                     {0, 6, 4},
                                     {1, 3, 7},
                                     {1, 7, 5}});
}

// The ball starts `start` before the place where it is made, and turns forward.
KnownTurn about(std::size_t k, BallSocketPair bones, double start) {
  KnownTurn known;
  for (TriangleMesh* mesh : {&bones.ball, &bones.socket})
    for (Vec3& x : mesh->vertices) x = exchanged(x, k);
  known.bones = std::move(bones);
  known.turn.axis = exchanged(Vec3::UnitZ(), k);
  known.turn.inner = Eigen::AngleAxisd(-start, known.turn.axis).toRotationMatrix();
  return known;
}

double number(std::size_t k) { return static_cast<double>(k); }
double radius(std::size_t k) { return 30.0 + 0.37 * number(k); }  // mm
// radians; spread over 23 degrees, and within steps of a tenth of a degree
double spread(std::size_t k) { return std::fmod(1.137 * number(k), 23.0) * kDegree; }
double begin(std::size_t k) { return 25.31 * kDegree + spread(k); }

}  // namespace

KnownTurn passing_behind(std::size_t k, double distance_mm) {
  const double c = radius(k);
  const double x = c + distance_mm;
  KnownTurn known =
      about(k,
            {slab({x, -6.0, -5.0}, {x + 4.0, 6.0, 5.0}),
             tetrahedron({c, 0.0, 0.0}, {c - 5.0, 2.0, -2.0}, {c - 5.0, -2.0, -2.0}, {c - 5.0, 0.0, 3.0})},
            begin(k));
  known.deepest = begin(k);
  known.depth_mm = c - x;  // with all digits of the slab
  return known;
}

KnownTurn grazing_ridges(std::size_t k, double depth_mm) {
  const double c = radius(k);
  const double x = c - depth_mm;
  KnownTurn known = about(k,
                          {prism({Vec3(c, 0.0, -4.0), Vec3(c - 5.0, 2.0, -4.0), Vec3(c - 5.0, -2.0, -4.0)},
                                 {Vec3(c, 0.0, 4.0), Vec3(c - 5.0, 2.0, 4.0), Vec3(c - 5.0, -2.0, 4.0)}),
                           prism({Vec3(x, -6.0, 0.0), Vec3(x + 5.0, -6.0, 2.0), Vec3(x + 5.0, -6.0, -2.0)},
                                 {Vec3(x, 6.0, 0.0), Vec3(x + 5.0, 6.0, 2.0), Vec3(x + 5.0, 6.0, -2.0)})},
                          begin(k));
  // The ridge at c cos(angle) reaches x.
  const double before = acos(Precise(x) / Precise(c)).convert_to<double>();
  known.contact = begin(k) - before;
  known.rate = c * std::sin(before);
  known.deepest = begin(k);
  known.depth_mm = c - x;
  return known;
}

KnownTurn meeting_ridges(std::size_t k, double between) {
  const double c = radius(k);
  const double along = 6.0 * std::cos(between);
  const double out = 6.0 * std::sin(between);
  KnownTurn known =
      about(k,
            {prism({Vec3(c - out, 0.0, -along), Vec3(c - 2.0, -4.0, -6.0), Vec3(c + 2.0, -4.0, -6.0)},
                   {Vec3(c + out, 0.0, along), Vec3(c - 2.0, -4.0, 6.0), Vec3(c + 2.0, -4.0, 6.0)}),
             prism({Vec3(c, 0.0, -6.0), Vec3(c - 2.0, 4.0, -6.0), Vec3(c + 2.0, 4.0, -6.0)},
                   {Vec3(c, 0.0, 6.0), Vec3(c - 2.0, 4.0, 6.0), Vec3(c + 2.0, 4.0, 6.0)})},
            begin(k));
  // Until then the ball is on one side of the plane y = 0, and the socket on the other.
  known.contact = begin(k);
  known.rate = c;
  known.deepest = begin(k) + 0.01;
  known.depth_mm = 0.01 * c;
  return known;
}

KnownTurn tip_beside_opening(std::size_t k, double beside_mm) {
  const double scale = 1.0 + 0.1 * number(k);
  const double r = 25.0 * scale;
  const double y = 15.0 * scale;
  const bool ahead = k % 2 == 0;  // does the tip move on into the opening, or on across the sheet?
  const double first = ahead ? 20.0 * scale - beside_mm : 8.0 * scale;
  const double last = ahead ? 28.0 * scale : 20.0 * scale + beside_mm;
  const TriangleMesh sheet{{{first, y, -8.0}, {last, y, -8.0}, {last, y, 8.0}, {first, y, 8.0}},
                           {{0, 1, 2}, {0, 2, 3}}};
  const double start = spread(k);
  KnownTurn known = about(
      k,
      {tetrahedron({r, 0.0, 0.0}, {r - 6.0, 1.0, -1.0}, {r - 6.0, -1.0, -1.0}, {r - 6.0, 0.0, 1.0}), sheet},
      start);
  const double meets = asin(Precise(y) / Precise(r)).convert_to<double>();
  known.contact = start + meets;
  known.rate = r * std::cos(meets);
  // The tip has moved 20 mm per radian through the sheet; its flanks are twice as far behind.
  const double further = ahead ? std::min(beside_mm / (70.0 * scale), 0.02) : 0.02;
  known.deepest = *known.contact + further;
  known.depth_mm = known.rate * further;
  return known;
}

Slide known_slide(std::size_t k, double angle, double octahedron_radius) {
  const Slide slide = slide_touching_at(-angle, octahedron_radius);
  return {exchanged(slide.axis, k), exchanged(slide.along, k), exchanged(slide.aside, k)};
}

KnownTurn sliding_tip(std::size_t k, double angle, double octahedron_radius) {
  const Slide slide = known_slide(k, angle, octahedron_radius);
  const double start = -(30.0 + 0.137 * number(k)) * kDegree;
  const Vec3 tip = slide.vertex(start);
  const AimedFrame frame(tip);
  const Vec3 foot = 0.8 * tip;
  KnownTurn known;
  known.bones = {tetrahedron(tip, foot + 0.5 * frame.first, foot - 0.5 * frame.first + 0.5 * frame.second,
                             foot - 0.5 * frame.second),
                 octahedron(octahedron_radius)};
  known.turn.axis = slide.axis;
  const PreciseSlide precise(slide, octahedron_radius);
  const Precise contact = precise.contact();
  known.contact = Precise(contact - start).convert_to<double>();
  known.rate = Precise((precise.gap(contact) - precise.gap(contact + 1e-20)) / 1e-20).convert_to<double>();
  known.deepest = -start;
  known.depth_mm = -precise.gap(0).convert_to<double>();
  return known;
}

}  // namespace impinge::lab
