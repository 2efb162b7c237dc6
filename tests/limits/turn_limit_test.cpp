// SPDX-License-Identifier: GPL-3.0-or-later
// low: no pose from the start has a contact; high: this one has; high - low below a tenth of a degree.
#include "limits/turn_limit.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "contact/turn_surface.hpp"
#include "hip/clock.hpp"
#include "hip/hip.hpp"
#include "hip/hip_presets.hpp"
#include "hip/named_motion.hpp"
#include "mesh/bodies.hpp"
#include "mesh/edges.hpp"
#include "mesh/generated_pair.hpp"
#include "mesh/triangle_distance.hpp"
#include "support/dice.hpp"
#include "support/joined.hpp"
#include "support/turned.hpp"

namespace impinge {
namespace {

constexpr double kWidest = 0.1;  // degrees

bool in_contact(const TurnLimits& limits, const JointTurn& turn, double angle_deg) {
  return limits.verdict(turn, angle_deg).contact == Contact::yes;
}
const JointTurn kAbduct = joint_turn({}, motion_name("abduction"), Side::right);

// The pair with its bump as high as the space: the smooth ball reaches the smooth socket once the part of the
// bump above 4 mm, 8.86 degrees about its top at 130, is under the rim at 87: a turn of 34.14 degrees. The
// meshes are a tenth of a millimetre within, which is a degree.
TEST(TurnLimit, OfTheCamIsThatOfItsFormula) {
  const TurnLimits limits(make_ball_socket_pair(1600, impinging_cam()));
  const TurnLimit limit = limits.first_contact(kAbduct, 120.0);
  EXPECT_EQ(limit.state, LimitState::limited);
  const double level = 60.0 / kPi * std::acos(std::sqrt(0.8));  // degrees from the top
  EXPECT_NEAR(limit.low_deg, 130.0 - 87.0 - level, 1.5);
  EXPECT_LE(limit.high_deg - limit.low_deg, kWidest);
  EXPECT_FALSE(in_contact(limits, kAbduct, limit.low_deg));
  EXPECT_TRUE(in_contact(limits, kAbduct, limit.high_deg));
  EXPECT_GT(limits.smallest_gap(kAbduct, limit.low_deg)->gap_mm, -1e-9);
}

TEST(TurnLimit, SaysWhenThereIsNone) {
  const TurnLimits limits(make_ball_socket_pair(400));
  const TurnLimit limit = limits.first_contact(kAbduct, 150.0);
  EXPECT_EQ(limit.state, LimitState::free);
  EXPECT_EQ(limit.low_deg, 150.0);
  EXPECT_EQ(limit.high_deg, 150.0);
  EXPECT_FALSE(limit.contact);
  EXPECT_THROW(limits.first_contact(kAbduct, 0.0), std::invalid_argument);
  EXPECT_THROW(limits.first_contact(kAbduct, 361.0), std::invalid_argument);
}

TEST(TurnLimit, SaysWhenTheStartIsBlocked) {
  const TurnLimits limits({octahedron(30.0), octahedron(29.0)});
  EXPECT_EQ(limits.first_contact(kAbduct, 90.0).state, LimitState::blocked);
  const TurnLimits hollow({octahedron(20.0), octahedron(29.0)});
  EXPECT_EQ(hollow.first_contact(kAbduct, 30.0).state, LimitState::free) << "bone is outside of this socket";
  TriangleMesh open = test::inside_out(octahedron(29.0));
  std::erase_if(open.faces, [&](const Face& face) { return std::ranges::find(face, 5U) != face.end(); });
  const TurnLimits wide({octahedron(20.0), open});
  EXPECT_EQ(wide.first_contact(kAbduct, 10.0).state, LimitState::free);
  EXPECT_EQ(wide.gap_of(kAbduct, 9.5, 10.0).state, LimitState::blocked);
  EXPECT_EQ(wide.gap_of(kAbduct, 8.5, 10.0).state, LimitState::limited);
}

// A gap falls to a threshold before the surfaces touch, and to a smaller one later.
TEST(TurnLimit, OfAThresholdComesBeforeContact) {
  const TurnLimits limits(make_ball_socket_pair(1000, impinging_cam()));
  double later = limits.first_contact(kAbduct, 120.0).low_deg;
  for (const double gap : {0.5, 1.0, 2.0}) {
    const TurnLimit limit = limits.gap_of(kAbduct, gap, 120.0);
    ASSERT_EQ(limit.state, LimitState::limited);
    EXPECT_LT(limit.high_deg, later);
    EXPECT_LE(limit.high_deg - limit.low_deg, kWidest);
    EXPECT_GT(limits.smallest_gap(kAbduct, limit.low_deg - 1e-6)->gap_mm, gap);
    EXPECT_LE(limits.smallest_gap(kAbduct, limit.high_deg)->gap_mm, gap);
    later = limit.high_deg;
  }
}

// What the limit moves by when the socket moves across the contact: as `deg_per_mm` says, to first order.
TEST(TurnLimit, SensitivityIsThatOfAShiftedCentre) {
  const BallSocketPair joint = make_ball_socket_pair(1000, impinging_cam());
  const TurnLimit limit = TurnLimits(joint).first_contact(kAbduct, 120.0);
  constexpr double kShift = 1e-4;  // mm
  for (const double way : {-kShift, kShift}) {
    BallSocketPair moved = joint;
    for (Vec3& x : moved.socket.vertices) x += way * limit.contact->normal;
    const TurnLimit other = TurnLimits(moved).first_contact(kAbduct, 120.0);
    EXPECT_NEAR(std::abs(other.low_deg - limit.low_deg), limit.deg_per_mm * kShift,
                0.01 * limit.deg_per_mm * kShift);
  }
}

// A pose goes through outer, axis and inner turns alike: the same limit from wherever the motion begins.
TEST(TurnLimit, CountsFromWhereTheMotionBegins) {
  const TurnLimits limits(make_ball_socket_pair(600, impinging_cam()));
  const double whole = limits.first_contact(kAbduct, 120.0).low_deg;
  const JointTurn later = joint_turn(parse_motion("abduction=10"), motion_name("abduction"), Side::right);
  EXPECT_NEAR(limits.first_contact(later, 120.0).low_deg, whole - 10.0, 1e-6);
  const JointTurn bent =
      joint_turn(parse_motion("flexion=30,internal_rotation=20"), motion_name("abduction"), Side::right);
  const TurnLimit limit = limits.first_contact(bent, 120.0);
  ASSERT_EQ(limit.state, LimitState::limited);
  EXPECT_FALSE(in_contact(limits, bent, limit.low_deg));
  EXPECT_TRUE(in_contact(limits, bent, limit.high_deg));
}

// A ball that is a cap of 60 degrees about +z under a socket that covers directions up to 20 degrees from +z:
// its rim passes the socket's after 40 degrees, and nothing touches. A thin shell of that shape has no end.
TEST(TurnLimit, EndsWhereTheMeshOfTheBallDoes) {
  const TriangleMesh cap = cup(20.0, 60.0, 4000);
  TriangleMesh shell = cap;
  const auto inner = static_cast<VertexIndex>(cap.vertices.size());
  for (const Vec3& x : cap.vertices) shell.vertices.push_back(0.9 * x);
  for (const Face& face : cap.faces)
    shell.faces.push_back({face[0] + inner, face[2] + inner, face[1] + inner});
  for (const auto& [a, b] : boundary_edges(cap)) {
    shell.faces.push_back({b, a, a + inner});
    shell.faces.push_back({b, a + inner, b + inner});
  }
  const JointTurn turn{.axis = Vec3::UnitX()};
  const TriangleMesh socket = cup(26.0, 20.0, 4000);
  const TurnLimit of_sheet = TurnLimits({cap, socket}).first_contact(turn, 90.0);
  EXPECT_EQ(of_sheet.state, LimitState::unknown);
  ASSERT_TRUE(of_sheet.leaves_mesh_deg);
  EXPECT_NEAR(*of_sheet.leaves_mesh_deg, 40.0, 0.2);
  EXPECT_EQ(of_sheet.low_deg, *of_sheet.leaves_mesh_deg);
  EXPECT_EQ(of_sheet.high_deg, 90.0);
  const TurnLimit of_shell = TurnLimits({shell, socket}).first_contact(turn, 90.0);
  EXPECT_EQ(of_shell.state, LimitState::free);
  EXPECT_FALSE(of_shell.leaves_mesh_deg);
  // With a hole in the inner layer it is not known whether its outer one ends the bone.
  shell.faces.erase(shell.faces.begin() + static_cast<std::ptrdiff_t>(cap.faces.size()));
  EXPECT_NEAR(TurnLimits({shell, socket}).first_contact(turn, 90.0).leaves_mesh_deg.value_or(0.0), 40.0, 0.2);
}

// The mesh of the ball ends about every centre within half a millimetre, and with play, no earlier than
// ranges say.
TEST(TurnLimit, RangesCountTheEndOfTheMeshAboutOtherCentres) {
  const BallSocketPair joint{cup(20.0, 60.0, 1000), cup(26.0, 20.0, 400)};
  const JointTurn turn{.axis = Vec3::UnitX()};
  const TurnLimits limits(joint);
  const TurnLimit limit = limits.first_contact(turn, 90.0);
  for (const double largest : {90.0, 35.0}) {  // unknown, and free
    const TurnLimit found = limits.first_contact(turn, largest);
    for (const CentreDoubt doubt : {CentreDoubt::common, CentreDoubt::play}) {
      const CentreInterval interval = limits.centre_interval(turn, found, largest, {doubt, 2.0, 0.0});
      double least = largest;
      for (int k = 0; k < 24; ++k) {
        const Vec3 centre = 1.9 * (Eigen::AngleAxisd(k * kPi / 12.0, Vec3::UnitX()) * Vec3::UnitY());
        const BallSocketPair moved =
            doubt == CentreDoubt::common
                ? BallSocketPair{relative_to(joint.ball, centre), relative_to(joint.socket, centre)}
                : BallSocketPair{joint.ball, relative_to(joint.socket, centre)};
        least =
            std::min(least, TurnLimits(moved).first_contact(turn, largest).leaves_mesh_deg.value_or(largest));
      }
      EXPECT_LE(interval.low_deg, least) << largest;
      EXPECT_GT(interval.low_deg, least - 7.0) << largest;
      EXPECT_LT(least, limit.low_deg - 1.0);
    }
  }
}

// A speck turns into a cropped wall, between its two layers, and meets neither.
TEST(TurnLimit, IsNotFreeWhereABoneEndsInACroppedOne) {
  const TriangleMesh wall = test::joined(cup(26.0, 60.0, 400), test::inside_out(cup(40.0, 60.0, 400)));
  const TurnLimits limits({sphere(20.0, 400), wall},
                          {{test::moved(sphere(0.5, 20), Vec3(0.0, 33.0, 0.0))}, {}});
  const JointTurn turn{.axis = Vec3::UnitX()};
  EXPECT_NE(limits.verdict(turn, 50.0).contact, Contact::no);
  const TurnLimit ends_inside = limits.first_contact(turn, 50.0);
  EXPECT_EQ(ends_inside.state, LimitState::unknown);
  EXPECT_EQ(ends_inside.low_deg, 0.0);
  EXPECT_EQ(limits.first_contact(turn, 10.0).state, LimitState::free);
}

// Near edges are seen under up to 180 degrees.
TEST(WallsBeyond, HoldAllThatIsBeyondAnEdge) {
  test::Dice dice(31);
  double widest = 0.0;
  for (int round = 0; round < 300; ++round) {
    const Vec3 middle = dice.power(-2.0, 1.0) * dice.direction();
    const Vec3 along = dice.power(-1.0, 1.0) * dice.direction();
    const TriangleMesh edge{{middle - along, middle + dice.between(0.1, 1.0) * along}, {}};
    const double reach = dice.power(-1.0, 2.0);
    const std::vector<TurnFace> walls = walls_beyond(edge, {{0, 1}}, reach);
    widest = std::max(widest, angle_between(edge.vertices[0], edge.vertices[1]));
    for (int k = 0; k < 40; ++k) {
      const Vec3 y = edge.vertices[0] + dice.between(0.0, 1.0) * (edge.vertices[1] - edge.vertices[0]);
      const Vec3 x = std::max(1.0, dice.between(0.0, 1.0) * reach / y.norm()) * y;
      double least = HUGE_VAL;
      for (const TurnFace& wall : walls) {
        const auto& [a, b, c] = wall.corner;
        least = std::min(least, std::sqrt(squared_distance_to_triangle(x, a, b, c)));
      }
      ASSERT_LE(least, 1e-9 * (x.norm() + reach)) << round;
    }
  }
  EXPECT_GT(widest, 3.0);
}

// What the limit moves by when the common centre of both is off by t: to first order, t . (I - R)^T n.
TEST(TurnLimit, SensitivityIsThatOfAnUnknownCentre) {
  const BallSocketPair joint = make_ball_socket_pair(1000, impinging_cam());
  const TurnLimit limit = TurnLimits(joint).first_contact(kAbduct, 120.0);
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(limit.low_deg * kDegree, kAbduct.outer * kAbduct.axis).toRotationMatrix() *
      kAbduct.outer * kAbduct.inner;
  const Vec3 n = limit.contact->normal;
  const Vec3 worst = n - turn.transpose() * n;
  EXPECT_NEAR(limit.centre_deg_per_mm, worst.norm() * limit.deg_per_mm, 1e-9 * limit.deg_per_mm);
  constexpr double kOff = 1e-4;  // mm
  const Vec3 t = kOff * worst.normalized();
  const TurnLimit other =
      TurnLimits({relative_to(joint.ball, t), relative_to(joint.socket, t)}).first_contact(kAbduct, 120.0);
  EXPECT_NEAR(std::abs(other.low_deg - limit.low_deg), limit.centre_deg_per_mm * kOff,
              0.01 * limit.centre_deg_per_mm * kOff);
}

// The top of a small face turns on its point under a face that is 5e-12 mm above it: doubles cannot tell that
// from a touch, and nothing follows.
TEST(TurnLimit, IsUnknownWhereAGrazeLasts) {
  const double z = 20.0 + 5e-12;
  const TriangleMesh ball{{{0, 0, 20}, {3, 0, 15}, {0, 3, 15}}, {{0, 1, 2}}};
  const TriangleMesh socket{{{-6, -5, z}, {6, -5, z}, {0, 7, z}}, {{0, 1, 2}}};
  const TurnLimit limit =
      TurnLimits({ball, socket})
          .first_contact({Eigen::Matrix3d::Identity(), Vec3::UnitZ(), Eigen::Matrix3d::Identity()}, 120.0);
  EXPECT_EQ(limit.state, LimitState::unknown);
  EXPECT_EQ(name(limit.state), "unknown");
  EXPECT_EQ(limit.low_deg, 0.0);
  EXPECT_EQ(limit.high_deg, 120.0);
  EXPECT_FALSE(limit.contact);
}

// Of surfaces that were cut out of bones: the mesh of the ball ends where the bone's own does, and nowhere if
// that has no end.
TEST(TurnLimit, OfCutSurfacesEndsWhereTheirBoneDoes) {
  const TriangleMesh cap = cup(20.0, 60.0, 1000);
  const BallSocketPair cut{cup(20.0, 50.0, 400), cup(26.0, 20.0, 400)};
  const JointTurn turn{.axis = Vec3::UnitX()};
  const TurnLimit open = TurnLimits::of_surfaces({cut, cut, cap}).first_contact(turn, 90.0);
  EXPECT_EQ(open.state, LimitState::unknown);
  EXPECT_NEAR(open.leaves_mesh_deg.value(), 40.0, 0.5);
  EXPECT_EQ(open.low_deg, *open.leaves_mesh_deg);
  for (const TriangleMesh& uncut : {TriangleMesh{}, octahedron(20.0)}) {
    const TurnLimit closed = TurnLimits::of_surfaces({cut, cut, uncut}).first_contact(turn, 90.0);
    EXPECT_EQ(closed.state, LimitState::free);
    EXPECT_FALSE(closed.leaves_mesh_deg);
  }
}

// A cropped ball ends, whether the socket is cropped too or the whole bone is given; a whole ball does not.
TEST(TurnLimit, OfACroppedBallEndsBesideAWholeSocketToo) {
  const TriangleMesh inner = cup(26.0, 20.0, 400);
  const BallSocketPair joint{cup(20.0, 60.0, 1000), inner};
  const TriangleMesh pelvis = test::with_back(inner, cup(30.0, 20.0, 400));
  const JointTurn turn{.axis = Vec3::UnitX()};
  for (const std::optional<TriangleMesh>& whole : {std::optional<TriangleMesh>{}, std::optional(pelvis)}) {
    const TurnLimit open = TurnLimits(joint, {{}, {}, {}, whole}).first_contact(turn, 90.0);
    EXPECT_EQ(open.state, LimitState::unknown);
    EXPECT_NEAR(open.leaves_mesh_deg.value_or(0.0), 40.0, 0.5);
    const TurnLimit closed = TurnLimits(joint, {{}, {}, octahedron(20.0), whole}).first_contact(turn, 90.0);
    EXPECT_EQ(closed.state, LimitState::free);
  }
}

// A face of the ball that the centre sees edge-on has no gap, whoever decides about contact.
TEST(TurnLimit, AGapIsNoneOfAFaceThatIsEdgeOn) {
  const TriangleMesh ball = octahedron(20.0);
  TriangleMesh finned = ball;
  test::add_face(finned, {0, 0, 20}, {0, 0, 24}, {0, 12, 12});
  const TriangleMesh socket = cup(28.0, 60.0, 100);
  const double expected = TurnLimits({ball, socket}).smallest_gap(kAbduct, 5.0).value().gap_mm;
  EXPECT_EQ(TurnLimits({finned, socket}).smallest_gap(kAbduct, 5.0).value().gap_mm, expected);
  EXPECT_LT(TurnLimits({octahedron(24.0), socket}).smallest_gap(kAbduct, 5.0).value().gap_mm, expected - 3.0);
}

// A start in the hollow of a sheet whose bone may be on either side.
TEST(TurnLimit, IsUnknownWhereTheStartIs) {
  const Vec3 far(60.0, 7.0, -3.0);
  const TriangleMesh sheet = test::inside_out(test::moved(cup(10.0, 60.0, 400), far));
  const TriangleMesh inside = test::moved(octahedron(1e-3), far + Vec3(0.3, 0.2, 9.0));
  const TurnLimits limits({octahedron(5.0), cup(8.0, 60.0, 100)}, {{inside}, {sheet}});
  ASSERT_EQ(limits.verdict(kAbduct, 0.0).contact, Contact::unknown);
  const TurnLimit limit = limits.first_contact(kAbduct, 30.0);
  EXPECT_EQ(limit.state, LimitState::unknown);
  EXPECT_EQ(limit.low_deg, 0.0);
  EXPECT_EQ(limit.high_deg, 30.0);
}

// A tip turns below triangles, 5e-12 mm above it, that doubles cannot tell from a touch, one after the other,
// and then into a wall: more grazes than are looked for, and the wall is found nevertheless.
TEST(TurnLimit, BehindManyGrazesIsFound) {
  TriangleMesh ball;
  test::add_face(ball, {20, 0, 0}, {15, -1, -5}, {15, 1, -5});
  const auto at = [](double angle, double radius, double z) {
    return Vec3(radius * std::cos(angle), radius * std::sin(angle), z);
  };
  TriangleMesh socket;
  for (const double angle : {0.5, 0.8, 1.1, 1.4, 1.7})
    test::add_face(socket, at(angle, 18.0, 5e-12), at(angle, 23.0, 5e-12), at(angle + 0.15, 20.0, 5e-12));
  test::add_face(socket, at(2.5, 19.0, 1.0), at(2.5, 22.0, 1.0), at(2.5, 20.0, -3.0));
  const TurnLimit limit = TurnLimits::of_surfaces({{ball, socket}, {ball, socket}, {}})
                              .first_contact({.axis = Vec3::UnitZ()}, 170.0);
  ASSERT_EQ(limit.state, LimitState::limited);
  EXPECT_NEAR(limit.low_deg * kDegree, 0.5, 1e-6);
  EXPECT_NEAR(limit.high_deg * kDegree, 2.5, 0.06);
}

// Limits of the generated hips: a normal hip reaches what a clinician finds, a cam impinges anterosuperiorly.
// (A left hip is the mirror image of a right one: tests/python/test_making.py.)

constexpr std::size_t kHipFacesHere = 800;

struct HipLimits {
  explicit HipLimits(const HipParameters& parameters)
      : HipLimits(parameters, make_hip(parameters, kHipFacesHere)) {}
  HipLimits(const HipParameters& parameters, const Hip& hip)
      : side(parameters.side), dial(*clock_face(hip.socket)), limits({hip.ball, hip.socket}) {}

  TurnLimit of(std::string_view name) const {
    for (const NamedMotion& motion : named_motions()) {
      if (motion.name != name) continue;
      const MotionName& growing = motion_name(motion.growing);
      return limits.first_contact(joint_turn(motion.start, growing, side),
                                  largest_growth(motion.start, growing));
    }
    ADD_FAILURE() << "no motion " << name;
    return {};
  }

  Side side;
  ClockFace dial;
  TurnLimits limits;
};

// Bone alone: soft tissue stops a patient before. Degrees: from what normal hips reach to 10 degrees or so
// above what these shapes came to, so that a contact that is missed shows.
TEST(HipLimits, ANormalHipReachesTheClinicalRanges) {
  const HipLimits normal(hip_preset("normal"));
  const auto expect_within = [&](std::string_view motion, double least, double most) {
    const TurnLimit limit = normal.of(motion);
    EXPECT_EQ(limit.state, LimitState::limited) << motion;
    EXPECT_GT(limit.low_deg, least) << motion;
    EXPECT_LT(limit.high_deg, most) << motion << ": it is no ball on a thread";
  };
  expect_within("flexion", 110.0, 158.0);
  expect_within("extension", 10.0, 77.0);
  expect_within("abduction", 30.0, 69.0);
  expect_within("adduction", 20.0, 64.0);
  expect_within("external_rotation", 40.0, 57.0);
  expect_within("internal_rotation_at_90", 30.0, 51.0);
}

// Between 12 and 3 o'clock, with some tolerance at 12, and earlier than a normal hip.
TEST(HipLimits, CamsImpingeAnterosuperiorlyInFadir) {
  const double normal = HipLimits(hip_preset("normal")).of("fadir").low_deg;
  for (const char* name : {"cam", "mixed"}) {
    const HipLimits hip(hip_preset(name));
    const TurnLimit limit = hip.of("fadir");
    ASSERT_EQ(limit.state, LimitState::limited) << name;
    const double hours = hip.dial.hours(limit.contact->place);
    EXPECT_TRUE(hours < 3.0 || hours > 11.75) << name << " " << clock_text(hours);
    EXPECT_LT(limit.high_deg, normal - 5.0) << name;
  }
}

// A cropped hip that comes to a contact up to 46 degrees later about some centres within 0.5 mm. Its socket
// is a sheet: the vertices near the first contact pass it by less than the shift; the deepest one settles it.
TEST(HipLimits, TheLatestLimitOfOtherCentresIsNearTheUpperEnd) {
  const HipParameters parameters = hip_preset("patient_a");
  const BallSocketPair hip = main_surfaces(make_hip(parameters, 3000));
  const MotionName& inwards = motion_name("internal_rotation");
  const JointTurn turn = joint_turn({}, inwards, parameters.side);
  const double largest = largest_growth({}, inwards);
  const TurnLimits limits(hip);
  const CentreInterval all = limits.centre_interval(turn, limits.first_contact(turn, largest), largest,
                                                    {CentreDoubt::common, 0.5, 0.0});
  double latest = 0.0;
  for (int k = 0; k < 6; ++k) {
    const Vec3 t = (k % 2 == 0 ? 0.499 : -0.499) * Vec3::Unit(k / 2);
    latest = std::max(latest, TurnLimits({relative_to(hip.ball, t), relative_to(hip.socket, t)})
                                  .first_contact(turn, largest)
                                  .high_deg);
  }
  EXPECT_TRUE(all.limited);
  EXPECT_GT(all.high_deg, latest);
  EXPECT_LT(all.high_deg, latest + 5.0);
}

TEST(NamedMotion, EachCanBeDone) {
  for (const NamedMotion& motion : named_motions()) {
    const MotionName& growing = motion_name(motion.growing);
    EXPECT_GT(largest_growth(motion.start, growing), 90.0) << motion.name;
    EXPECT_NO_THROW(joint_turn(motion.start, growing, Side::left)) << motion.name;
    EXPECT_FALSE(motion.meaning.empty());
  }
}

}  // namespace
}  // namespace impinge
