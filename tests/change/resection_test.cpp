// SPDX-License-Identifier: GPL-3.0-or-later
// The least radial cut and the least of all: their volumes beside closed forms, what they leave beside the
// exact overlay and beside bone along single rays, and what one hair less would leave.
#include "change/resection.hpp"

#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "hip/hip.hpp"
#include "hip/hip_presets.hpp"
#include "limits/bump_under_a_cup.hpp"
#include "limits/turn_limit.hpp"
#include "mesh/validation.hpp"
#include "support/dice.hpp"
#include "support/joined.hpp"
#include "support/random_cases.hpp"

namespace impinge {
namespace {

// Simpson's rule on 2000 steps.
template <class F>
double integral(double to, F&& f) {
  constexpr int kSteps = 2000;
  double sum = 0.0;
  for (int k = 0; k <= kSteps; ++k) {
    const double weight = k == 0 || k == kSteps ? 1.0 : (k % 2 == 1 ? 4.0 : 2.0);
    sum += weight * f(to * k / kSteps);
  }
  return sum * to / (3.0 * kSteps);
}

// With its normals inwards, and with each face twice, the second time the other way round.
BallSocketPair inside_out(BallSocketPair joint) {
  joint.ball = test::inside_out(joint.ball);
  return joint;
}
BallSocketPair twice(BallSocketPair joint) {
  const std::vector<Face> again = test::inside_out(joint.ball).faces;
  joint.ball.faces.insert(joint.ball.faces.end(), again.begin(), again.end());
  return joint;
}

void expect_closed_form_of_a_bump(const BallSocketPair& joint) {
  const std::vector<RequiredLeg> legs{turn_about_y(90.0)};
  const SweptRadius swept(joint.socket, legs);
  for (const double clearance : {0.25, 1.0}) {
    const Resection cut = least_radial_cut(joint.ball, swept, {.clearance_mm = clearance});
    const double kept = kCupRadius - clearance;
    const double level =
        2.0 * kBumpHalfWidth / kPi * std::acos(std::sqrt((kept - kHeadRadius) / kBumpHeight));
    const double volume = 2.0 * kPi / 3.0 * integral(level, [&](double v) {
                            return std::sin(v) * (std::pow(bump_radius(v), 3) - std::pow(kept, 3));
                          });
    const double area = 2.0 * kPi * integral(level, [&](double v) {
                          const double slope =
                              -kBumpHeight * 0.5 * kPi / kBumpHalfWidth * std::sin(kPi * v / kBumpHalfWidth);
                          return bump_radius(v) * std::sin(v) * std::hypot(bump_radius(v), slope);
                        });
    constexpr double kSagitta = 0.004;  // of the meshes, as a share
    EXPECT_LE(cut.volume_mm3.low, volume * (1.0 + kSagitta));
    EXPECT_GE(cut.volume_mm3.high, volume * (1.0 - kSagitta));
    EXPECT_LE(cut.volume_mm3.high - cut.volume_mm3.low, 0.02 * cut.volume_mm3.low + 0.5);
    EXPECT_GE(cut.cut_mm3, cut.volume_mm3.low);
    EXPECT_LE(cut.cut_mm3, 1.1 * volume);
    EXPECT_LE(cut.area_mm2.low, area * (1.0 + kSagitta));
    EXPECT_GE(cut.area_mm2.high, area * (1.0 - kSagitta));
    EXPECT_LE(cut.area_mm2.high - cut.area_mm2.low, 0.1 * area);
    const double depth = kHeadRadius + kBumpHeight - kept;
    EXPECT_LE(cut.depth_mm.low, depth + 0.005);
    EXPECT_GE(cut.depth_mm.high, depth - 0.005);
    EXPECT_LE(cut.depth_mm.high - cut.depth_mm.low, 0.1);
    EXPECT_EQ(TurnLimits({cut.before, joint.socket}).verdict(legs[0].turn, 60.0).contact, Contact::yes);
  }
}

TEST(Resection, OfABumpIsItsClosedForm) {
  expect_closed_form_of_a_bump(bump_under_a_cup());
  expect_closed_form_of_a_bump(inside_out(bump_under_a_cup()));
  expect_closed_form_of_a_bump(twice(bump_under_a_cup()));
}

// A sphere of 20 mm about the centre, and over it a slab from 26.6 to 28 mm, 10 degrees wide about +z,
// where a socket is of 26 mm: all of it has to go.
TriangleMesh slab() {
  std::vector<LatheRing> rings = sphere_rings(28.0, 10.0 * kDegree, kDegree);
  const std::vector<LatheRing> inside = sphere_rings(26.6, 10.0 * kDegree, kDegree);
  rings.insert(rings.end(), inside.rbegin(), inside.rend());
  return revolve({rings, Vec3::UnitZ(), Vec3::Zero(), 60});
}
TriangleMesh over_a_sphere(const TriangleMesh& mesh) {
  return test::joined(revolve({sphere_rings(20.0, kPi, 5.0 * kDegree), Vec3::UnitZ(), Vec3::Zero(), 40}),
                      mesh);
}
// Without the faces that have some corner where `gone` says so.
TriangleMesh without(TriangleMesh mesh, const std::function<bool(const Vec3&)>& gone) {
  std::erase_if(mesh.faces, [&](const Face& face) {
    return std::ranges::any_of(face, [&](VertexIndex v) { return gone(mesh.vertices[v]); });
  });
  return mesh;
}

TEST(Resection, OfABallThatIsNotStarShapedIsKnownWhereItIsClosedAlongTheCut) {
  const std::vector<RequiredLeg> legs{turn_about_y(30.0)};
  const SweptRadius swept(bump_under_a_cup().socket, legs);
  const SweptBone bone(cup_with_a_wall(), legs, 0.5);
  const CutQuestion question{.clearance_mm = 0.5, .closeness = 0.1, .most_new_faces = 2000};
  const auto volume_to = [](double radius) {
    return 2.0 * kPi / 3.0 * (1.0 - std::cos(10.0 * kDegree)) * (std::pow(radius, 3) - std::pow(26.6, 3));
  };
  const double whole = volume_to(28.0);
  const double least = volume_to(kWallRadius + 0.5);
  const TriangleMesh closed = over_a_sphere(slab());
  ASSERT_TRUE(validate(closed).volume);
  for (const TriangleMesh& ball :
       {closed, test::inside_out(closed), without(closed, [](const Vec3& x) { return x.z() < -15.0; })}) {
    const Resection cut = least_radial_cut(ball, swept, question);
    EXPECT_LE(cut.volume_mm3.low, whole * 1.005);
    EXPECT_GE(cut.volume_mm3.high, whole * 0.995);
    EXPECT_LE(cut.volume_mm3.high - cut.volume_mm3.low, 0.2 * whole);
    EXPECT_GE(cut.cut_mm3, cut.volume_mm3.low);
    const LeastCut less = least_cut(ball, bone, question);
    EXPECT_LE(less.volume_mm3.low, least * 1.01);
    EXPECT_GE(less.volume_mm3.high, least * 0.99);
    EXPECT_LE(less.volume_mm3.high - less.volume_mm3.low, 0.5 * least);
  }
  const auto at = [](double radius) {
    return [radius](const Vec3& x) { return std::abs(x.norm() - radius) < 0.1; };
  };
  const auto near_top = [](const Vec3& x) { return x.norm() < 21.0 && x.z() > 15.0; };
  for (const TriangleMesh& ball : {without(closed, at(28.0)), without(closed, at(26.6)),
                                   without(closed, near_top), over_a_sphere(test::inside_out(slab()))}) {
    const Resection cut = least_radial_cut(ball, swept, question);
    EXPECT_GT(cut.depth_mm.high, 0.9);
    EXPECT_EQ(cut.volume_mm3.low, 0.0);
    EXPECT_EQ(cut.volume_mm3.high, HUGE_VAL);
    EXPECT_TRUE(std::isnan(cut.cut_mm3));
    EXPECT_EQ(least_cut(ball, bone, question).volume_mm3.high, HUGE_VAL);
  }
}

// All bump above the inside of the wall goes out to its outside, and what is beyond stays.
TEST(LeastCut, OfABumpIsItsClosedForm) {
  const BallSocketPair joint = twice(inside_out(bump_under_a_cup()));
  const double clearance = 0.4;
  const CutQuestion question{.clearance_mm = clearance, .closeness = 0.2};
  const LeastCut cut =
      least_cut(joint.ball, SweptBone(cup_with_a_wall(), {turn_about_y(90.0)}, clearance), question);
  const auto level = [](double radius) {
    return 2.0 * kBumpHalfWidth / kPi * std::acos(std::sqrt((radius - kHeadRadius) / kBumpHeight));
  };
  const double from = kCupRadius - clearance;
  const double to = kWallRadius + clearance;
  const double volume =
      2.0 * kPi / 3.0 * integral(level(from), [&](double v) {
        return std::sin(v) * (std::pow(std::min(to, bump_radius(v)), 3) - std::pow(from, 3));
      });
  constexpr double kSagitta = 0.02;  // of the meshes, as a share
  EXPECT_LE(cut.volume_mm3.low, volume * (1.0 + kSagitta));
  EXPECT_GE(cut.volume_mm3.high, volume * (1.0 - kSagitta));
  EXPECT_LE(cut.volume_mm3.high - cut.volume_mm3.low, 0.2 * cut.volume_mm3.low + 0.5);
  EXPECT_LE(cut.depth_mm.low, to - from + 0.02);
  EXPECT_GE(cut.depth_mm.high, to - from - 0.02);
}

// A cam that is to reach more than it does.
struct CamThatTurnsFarther {
  Hip hip = make_hip(hip_preset("cam"), 4000);
  std::vector<RequiredLeg> legs = required_legs(parse_motion("flexion=90,internal_rotation=35"), Side::right);
  SweptRadius swept{hip.socket, legs};
  Resection cut = least_radial_cut(hip.ball, swept, {.clearance_mm = 0.5});
};

TEST(TheoremResection, LetsTheCutBallReachAllThatWasRequired) {
  const CamThatTurnsFarther cam;
  ASSERT_FALSE(cam.cut.empty());
  const TurnLimits before({cam.hip.ball, cam.hip.socket});
  const TurnLimits after({cam.cut.cut, cam.hip.socket});
  EXPECT_EQ(before.first_contact(cam.legs[1].turn, cam.legs[1].largest_deg).state, LimitState::limited);
  for (const RequiredLeg& leg : cam.legs) {
    EXPECT_EQ(after.first_contact(leg.turn, leg.largest_deg).state, LimitState::free) << describe(leg);
    EXPECT_EQ(after.gap_of(leg.turn, 0.5 * (1.0 - 1e-6), leg.largest_deg).state, LimitState::free);
  }
}

// Contact comes back where a vertex stands a hair beyond E, and not where it stands a hair within.
TEST(TheoremResection, LeavesNoMoreThanItMay) {
  const CamThatTurnsFarther cam;
  const Vec3 at = cam.cut.cut.vertices[cam.cut.deepest];
  const Ends least = cam.swept.over({at.normalized(), 1e-5}, 1e3);
  ASSERT_LT(least.high - least.low, 0.01);
  const auto state_at = [&](double radius) {
    TriangleMesh ball = cam.cut.cut;
    ball.vertices[cam.cut.deepest] = radius * at.normalized();
    const TurnLimits limits({ball, cam.hip.socket});
    bool free = true;
    for (const RequiredLeg& leg : cam.legs)
      free = free && limits.first_contact(leg.turn, leg.largest_deg).state == LimitState::free;
    return free;
  };
  EXPECT_FALSE(state_at(least.high + 0.01));
  EXPECT_TRUE(state_at(least.low - 0.01));
}

TEST(Resection, OfAJointThatReachesItIsNothing) {
  const Hip hip = make_hip(hip_preset("normal"), 2000);
  const auto legs = required_legs(parse_motion("flexion=60"), Side::right);
  const auto expect_nothing = [](const TriangleMesh& mesh, const SweptRadius& swept) {
    const Resection cut = least_radial_cut(mesh, swept, {.clearance_mm = 0.5});
    EXPECT_TRUE(cut.empty());
    EXPECT_EQ(cut.cut_mm3, 0.0);
    EXPECT_EQ(cut.volume_mm3.high, 0.0);
    EXPECT_EQ(cut.cut.vertices, mesh.vertices);
  };
  expect_nothing(hip.ball, SweptRadius(hip.socket, legs));
  expect_nothing(hip.socket, SweptRadius(hip.ball, legs, Surface::socket));
}

// Radii at which a ray meets faces, in order.
std::vector<double> crossings_along(const TriangleMesh& mesh, const Vec3& u) {
  std::vector<double> radii;
  for (const Face& face : mesh.faces) {
    const double radius = radius_along(mesh, face, u);
    if (radius < HUGE_VAL) radii.push_back(radius);
  }
  std::ranges::sort(radii);
  return radii;
}

// In random poses of the path no bone of the socket is within the clearance of bone of the ball that is in no
// cell; and the radial cut takes no less.
TEST(TheoremSweep, HoldsAllThatTheBoneSweepsThrough) {
  HipParameters parameters = hip_preset("cam");
  parameters.wall_thickness = 4.0;
  const Hip hip = make_hip(parameters, 600);
  const auto legs = required_legs(parse_motion("flexion=95,internal_rotation=30"), Side::right);
  const CutQuestion question{.clearance_mm = 0.5, .closeness = 0.1, .least_mm3 = 10.0};
  const LeastCut cut = least_cut(hip.ball, SweptBone(hip.socket, legs, 0.5), question);
  const Resection radial = least_radial_cut(hip.ball, SweptRadius(hip.socket, legs), question);
  EXPECT_GT(cut.volume_mm3.low, 0.0);
  EXPECT_LE(cut.volume_mm3.low, radial.volume_mm3.high);
  EXPECT_LE(cut.area_mm2.low, radial.area_mm2.high);
  std::mt19937_64 engine(7);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  std::size_t met = 0;
  const auto expect_held = [&](const std::array<Vec3, 3>& corners, const RaySpans& goes) {
    const double a = share(engine);
    const double b = (1.0 - a) * share(engine);
    const Vec3 x = a * corners[0] + b * corners[1] + (1.0 - a - b) * corners[2];
    const std::size_t leg = engine() % legs.size();
    const double angle = share(engine) * legs[leg].largest_deg;
    const Vec3 u = poses_of(legs[leg], {leg, angle, angle}).rotation * x.normalized();
    const std::vector<double> radii = crossings_along(hip.socket, u);
    for (std::size_t k = 0; k + 1 < radii.size(); k += 2) {
      const double to = std::min(radii[k + 1] + 0.5, x.norm());
      if (!(radii[k] - 0.5 < to)) continue;
      ++met;
      ASSERT_TRUE(goes.holds(radii[k] - 0.5 + 1e-6, to - 1e-6)) << radii[k] << " to " << radii[k + 1];
    }
  };
  for (std::size_t k = 0; k < random_cases(); ++k) {
    const LeastCut::Cell& cell = cut.cells[engine() % cut.cells.size()];
    expect_held(cell.corners, cell.goes);
  }
  EXPECT_GT(met, random_cases() / 100);
  // All other bone has no part in it: faces that no cell has a part of.
  for (const Face& face : hip.ball.faces) {
    const std::array<Vec3, 3> corners = corners_of(hip.ball, face);
    const Vec3 normal = area_vector(hip.ball, face);
    const bool cut_at = std::ranges::any_of(cut.cells, [&](const LeastCut::Cell& cell) {
      const Vec3 middle = (cell.corners[0] + cell.corners[1] + cell.corners[2]) / 3.0;
      return std::abs(normal.dot(middle - corners[0])) < 1e-6 * normal.norm() &&
             (middle - corners[0]).norm() < 20.0;
    });
    if (!cut_at) expect_held(corners, {});
  }
}

TEST(LeastCut, NeedsAWall) {
  const Hip hip = make_hip(hip_preset("cam"), 600);
  EXPECT_THROW(BoneOverCap{hip.socket}, std::runtime_error);
}

// What is in bone along single rays of a cap, and what is certain of all.
TEST(TheoremSweep, HoldsWhatEveryRayMeets) {
  HipParameters parameters = hip_preset("pincer");
  parameters.wall_thickness = 5.0;
  const TriangleMesh mesh = make_hip(parameters, 600).socket;
  const BoneOverCap bone(mesh);
  test::Dice dice(5);
  std::size_t certain = 0;
  for (std::size_t k = 0; k < random_cases(); ++k) {
    const DirectionCap cap{dice.direction(), dice.power(-4.0, -0.5)};
    const SpansOverCap found = bone.over(cap);
    const Vec3 across = Eigen::AngleAxisd(dice.between(0.0, 2.0 * kPi), cap.axis) * cap.axis.unitOrthogonal();
    const Vec3 u = Eigen::AngleAxisd(dice.between(0.0, cap.radius), across) * cap.axis;
    const std::vector<double> radii = crossings_along(mesh, u);
    ASSERT_EQ(radii.size() % 2, 0U);
    RaySpans bone_here;
    for (std::size_t i = 0; i + 1 < radii.size(); i += 2) bone_here.add(radii[i], radii[i + 1]);
    for (const RadiusRange& s : bone_here.spans())
      ASSERT_TRUE(found.possible.holds(s.low, s.high)) << s.low << " to " << s.high;
    for (const RadiusRange& s : found.certain.spans()) {
      ASSERT_TRUE(bone_here.holds(s.low, s.high)) << s.low << " to " << s.high;
      ++certain;
    }
  }
  EXPECT_GT(certain, random_cases() / 20);
}

// Ends over caps of what sweeps past, beside poses of the path and random directions of the cap: of the
// nearest radius of the socket, or of the farthest of the ball.
void expect_ends_of_what_sweeps(const TriangleMesh& moving, Surface cut) {
  const bool ball = cut == Surface::ball;
  const auto legs =
      required_legs(parse_motion("flexion=100,abduction=-15,internal_rotation=40"), Side::right);
  const SweptRadius swept(moving, legs, cut);
  test::Dice dice(5);
  std::size_t met = 0;
  std::size_t close = 0;
  for (std::size_t k = 0; k < std::min<std::size_t>(random_cases(), 20'000) / (ball ? 20 : 10); ++k) {
    const DirectionCap cap{dice.direction(), dice.power(-4.0, -0.5)};
    const Ends ends = swept.over(cap, ball ? 1e3 : 0.0);
    EXPECT_LE(ends.low, ends.high);
    const Vec3 u = Eigen::AngleAxisd(dice.between(0.0, cap.radius), cap.axis.unitOrthogonal()) * cap.axis;
    double least = HUGE_VAL;
    double farthest = -HUGE_VAL;
    for (std::size_t leg = 0; leg < legs.size(); ++leg) {
      for (int i = 0; i <= 64; ++i) {
        const double angle = legs[leg].largest_deg * i / 64.0;
        const Eigen::Matrix3d rotation = poses_of(legs[leg], {leg, angle, angle}).rotation;
        const auto radii =
            crossings_along(moving, ball ? Vec3(rotation * u) : Vec3(rotation.transpose() * u));
        if (radii.empty()) continue;
        least = std::min(least, radii.front());
        farthest = std::max(farthest, radii.back());
      }
    }
    EXPECT_TRUE(ball ? ends.low <= least : ends.high >= farthest) << k;
    met += (ball ? least < HUGE_VAL : farthest > 26.0) ? 1U : 0U;
    close += ends.low > -HUGE_VAL && ends.high < 1.05 * ends.low ? 1U : 0U;
  }
  EXPECT_GT(met, 5U);
  EXPECT_TRUE(ball || close > 20U) << close;
}

TEST(TheoremResection, HoldsWhatEveryPoseMeets) {
  expect_ends_of_what_sweeps(make_hip(hip_preset("pincer"), 600).socket, Surface::ball);
  expect_ends_of_what_sweeps(make_hip(hip_preset("cam"), 600).ball, Surface::socket);
}

TEST(RequiredMotion, GoesOneAngleAfterTheOther) {
  const auto legs = required_legs(parse_motion("internal_rotation=30,flexion=90,adduction=10"), Side::left);
  ASSERT_EQ(legs.size(), 3U);
  EXPECT_EQ(describe(legs[0]), "flexion from 0 to 90 degrees");
  EXPECT_EQ(describe(legs[1]), "adduction from 0 to 10 degrees at flexion 90");
  EXPECT_EQ(describe(legs[2]), "internal_rotation from 0 to 30 degrees at flexion 90 at adduction 10");
  const RotationBall end = poses_of(legs[2], {2, 30.0, 30.0});
  EXPECT_TRUE(end.rotation.isApprox(joint_rotation({90.0, -10.0, 30.0}, Side::left), 1e-12));
  for (std::size_t k = 0; k + 1 < legs.size(); ++k) {
    const double to = legs[k].largest_deg;
    EXPECT_TRUE(poses_of(legs[k], {k, to, to})
                    .rotation.isApprox(poses_of(legs[k + 1], {k + 1, 0, 0}).rotation, 1e-12));
  }
  EXPECT_TRUE(required_legs(Motion{}, std::nullopt).empty());
}

}  // namespace
}  // namespace impinge
