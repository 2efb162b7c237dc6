// SPDX-License-Identifier: GPL-3.0-or-later
#include "phantoms/implant.hpp"

#include <cmath>
#include <vector>

#include <Eigen/Geometry>

#include "mesh/loft.hpp"
#include "phantoms/phantom_meshes.hpp"

namespace impinge {
namespace {

// Mm.
constexpr double kHeadRadius = 16.0;
constexpr double kNeckRadius = 6.0;   // radius
constexpr double kNeckLength = 40.0;  // from the centre
constexpr double kBendRadius = 30.0;  // radius of the way from the neck to the shaft
constexpr double kShaftRadius = 8.0;  // radius where it begins
constexpr double kTipRadius = 4.0;    // radius where it ends
constexpr double kShaftLength = 130.0;
constexpr double kClearance = 0.1;
constexpr double kShell = 6.0;  // thickness of the cup

// From the middle of the body outwards, `down` from the transverse plane and `forward` from the frontal one.
Vec3 outwards(double down, double forward) {
  return {std::cos(forward) * std::cos(down), std::sin(forward) * std::cos(down), -std::sin(down)};
}

// A place on the middle line of the stem, with the ring about it.
struct Station {
  Vec3 centre, along;  // mm, unit vector
  double radius;       // mm
};

// The stem from the pole of the head on: rings at equal steps of each of its pieces.
class Stem {
 public:
  Station on_head(double share) const {
    const double polar = share * (kPi - std::asin(kNeckRadius / kHeadRadius));
    return {-kHeadRadius * std::cos(polar) * neck_, neck_, kHeadRadius * std::sin(polar)};
  }
  Station on_neck(double share) const {
    const double begin = std::sqrt(kHeadRadius * kHeadRadius - kNeckRadius * kNeckRadius);
    return {std::lerp(begin, kNeckLength, share) * neck_, neck_, kNeckRadius};
  }
  Station on_bend(double share) const {
    const double turn = share * std::acos(-neck_.z());
    const Vec3 inwards = side().cross(neck_);
    const Vec3 way = std::sin(turn) * neck_ + (1.0 - std::cos(turn)) * inwards;
    return {kNeckLength * neck_ + kBendRadius * way, std::cos(turn) * neck_ + std::sin(turn) * inwards,
            std::lerp(kNeckRadius, kShaftRadius, share)};
  }
  Station on_shaft(double share) const {
    const Station begin = on_bend(1.0);
    return {begin.centre + share * kShaftLength * begin.along, begin.along,
            std::lerp(kShaftRadius, kTipRadius, share)};
  }

  // Across the plane of neck and shaft.
  Vec3 side() const { return neck_.cross(-Vec3::UnitZ()).normalized(); }

 private:
  Vec3 neck_ = outwards(45.0 * kDegree, 10.0 * kDegree);
};

std::vector<Vec3> ring_of(const Station& at, const Vec3& side, std::size_t sides) {
  const Vec3 across = side.cross(at.along);
  std::vector<Vec3> ring;
  for (std::size_t k = 0; k < sides; ++k) {
    const double angle = 2.0 * kPi * static_cast<double>(k) / static_cast<double>(sides);
    ring.push_back(at.centre + at.radius * (std::cos(angle) * side + std::sin(angle) * across));
  }
  return ring;
}

TriangleMesh make_stem(std::size_t sides) {
  const Stem stem;
  std::vector<std::vector<Vec3>> rings{{stem.on_head(0.0).centre}};
  const auto add = [&](Station (Stem::*piece)(double) const, double share_of_rings) {
    const double steps = std::round(share_of_rings * static_cast<double>(sides));
    for (double k = 1.0; k <= steps; ++k)
      rings.push_back(ring_of((stem.*piece)(k / steps), stem.side(), sides));
  };
  add(&Stem::on_head, 0.35);
  add(&Stem::on_neck, 0.2);
  add(&Stem::on_bend, 0.15);
  add(&Stem::on_shaft, 0.3);
  rings.push_back({stem.on_shaft(1.0).centre});
  return loft(rings);
}

TriangleMesh make_cup(std::size_t sides) {
  const double half = 0.5 * static_cast<double>(sides);
  const double step = 0.5 * kPi / half;
  const double inner = kHeadRadius + kClearance;
  std::vector<LatheRing> rings = sphere_rings(inner + kShell, 0.5 * kPi, step);
  std::vector<LatheRing> inside = sphere_rings(inner, 0.5 * kPi, step);
  rings.insert(rings.end(), inside.rbegin(), inside.rend());
  return revolve({rings, -outwards(45.0 * kDegree, 20.0 * kDegree), Vec3::Zero(), sides});
}

}  // namespace

BallSocketPair make_implant(std::size_t faces) {
  const auto sides = static_cast<std::size_t>(std::lround(std::sqrt(0.25 * static_cast<double>(faces))));
  return {make_stem(sides), make_cup(sides)};
}

}  // namespace impinge
