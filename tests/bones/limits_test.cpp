// SPDX-License-Identifier: GPL-3.0-or-later
// The twelve named motions of real joints, whole, cropped and in parts, against FCL in steps of a quarter of
// a degree, bisected. Steps may jump over a contact: where a limit comes earlier, CGAL must see the surfaces
// meet there and not before. Likewise of the rim alone, of generated hips too.
#include <iostream>
#include <optional>

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/narrowphase/collision.h>
#include <gtest/gtest.h>

#include "bones/real_bones.hpp"
#include "hip/hip.hpp"
#include "hip/hip_presets.hpp"
#include "hip/named_motion.hpp"

namespace impinge {
namespace {

constexpr double kPeerStep = 0.25;    // degrees
constexpr double kPeerWidth = 0.002;  // degrees, of its bisection
constexpr double kAgreement = 0.01;   // degrees

class Peer {
 public:
  Peer(const TriangleMesh& ball, const TriangleMesh& socket) {
    fill(ball_, ball);
    fill(socket_, socket);
  }
  bool meet(const Pose& pose) const {
    fcl::Transform3<double> at = fcl::Transform3<double>::Identity();
    at.linear() = pose.rotation;
    at.translation() = pose.translation;
    fcl::CollisionResult<double> found;
    fcl::collide(&ball_, at, &socket_, fcl::Transform3<double>::Identity(),
                 fcl::CollisionRequest<double>(1, /*enable_contact_=*/false), found);
    return found.isCollision();
  }
  // Degrees; none where nothing meets.
  std::optional<double> first(const JointTurn& turn, double largest) const {
    for (double high = 0.0; high <= largest; high += kPeerStep) {
      if (!meet(test::pose_at(turn, high))) continue;
      double low = std::max(0.0, high - kPeerStep);
      while (high - low > kPeerWidth) {
        const double middle = 0.5 * (low + high);
        (meet(test::pose_at(turn, middle)) ? high : low) = middle;
      }
      return high;
    }
    return std::nullopt;
  }

 private:
  using Model = fcl::BVHModel<fcl::OBB<double>>;
  static void fill(Model& model, const TriangleMesh& mesh) {
    std::vector<fcl::Triangle> faces;
    for (const Face& face : mesh.faces) faces.emplace_back(face[0], face[1], face[2]);
    model.beginModel(static_cast<int>(faces.size()), static_cast<int>(mesh.vertices.size()));
    model.addSubModel(mesh.vertices, faces);
    model.endModel();
  }
  Model ball_;
  Model socket_;
};

struct Compared {
  const test::BoneVariant& of;
  const test::ExactMeeting& exact;
  const JointTurn& turn;
};

void check_limit(const Compared& with, const TurnLimits& limits, const TurnLimit& limit,
                 const std::optional<double>& peer) {
  const auto exactly = [&](double degrees) {
    return with.exact.of_doubles(test::pose_at(with.turn, degrees));
  };
  switch (limit.state) {
    case LimitState::blocked:
      switch (limits.verdict(with.turn, 0.0).rule) {
        case ContactRule::surfaces:
          EXPECT_TRUE(exactly(0.0));
          break;
        case ContactRule::inside:
          EXPECT_TRUE(test::holds(with.of.socket, with.of.ball.vertices) ||
                      test::holds(with.of.ball, with.of.socket.vertices));
          break;
        case ContactRule::radii:
          EXPECT_FALSE(exactly(0.0));
          break;
      }
      return;
    case LimitState::limited:
      EXPECT_TRUE(exactly(limit.high_deg));
      EXPECT_FALSE(exactly(limit.low_deg));
      EXPECT_LT(limit.high_deg, peer.value_or(HUGE_VAL) + kAgreement);
      return;
    case LimitState::free:
      EXPECT_FALSE(peer);
      return;
    case LimitState::unknown:
      EXPECT_LT(limit.low_deg, peer.value_or(HUGE_VAL) + kAgreement);
      return;
  }
}

class TheoremTurnOfRealBones : public testing::TestWithParam<std::size_t> {};
INSTANTIATE_TEST_SUITE_P(Joint, TheoremTurnOfRealBones, testing::Range(std::size_t{0}, test::kShares));

TEST_P(TheoremTurnOfRealBones, AreThoseOfAPeerOrEarlierAndExact) {
  for (const JointFolder& joint : test::joints_of(GetParam())) {
    for (const test::BoneVariant& of : test::variants(joint)) {
      const Joint made = assemble_joint(of.input);
      const CentredLimits centred = test::limits_of(made);
      const test::ExactMeeting exact(of.ball, of.socket);
      const Peer peer(of.ball, of.socket);
      for (const NamedMotion& motion : named_motions()) {
        SCOPED_TRACE(joint.subject + ", " + of.name + ", " + std::string(motion.name));
        const MotionName& growing = motion_name(motion.growing);
        const JointTurn turn = joint_turn(motion.start, growing, joint.side);
        const double largest = largest_growth(motion.start, growing);
        const TurnLimit limit = centred.limits.first_contact(turn, largest);
        const std::optional<double> other = peer.first(turn, largest);
        check_limit({of, exact, turn}, centred.limits, limit, other);
        std::cout << joint.subject << ", " << of.name << ", " << motion.name << ", " << name(limit.state)
                  << ", " << limit.low_deg << ", " << (other ? std::to_string(*other) : "free") << "\n";
      }
    }
  }
}

// The faces of the rim and of what is off the head, by their corners alone; `of` holds whole bones.
test::BoneVariant rim_of(test::BoneVariant of, const JointPlaces& places) {
  const auto leave = [](TriangleMesh& mesh, const auto& counts) {
    std::erase_if(mesh.faces, [&](const Face& face) {
      return std::ranges::none_of(face, [&](VertexIndex v) { return counts(mesh.vertices[v]); });
    });
  };
  const auto share = [&](const Vec3& x) { return (x - places.head->centre).norm() / places.head->radius; };
  const auto on_neck_side = [&](const Vec3& x) { return (x - places.head->centre).dot(places.neck) > 0.0; };
  double off = 0.005;
  for (const Vec3& x : of.ball.vertices)
    if (!on_neck_side(x) && share(x) <= 1.5) off = std::max(off, share(x) - 1.0);
  off = std::min(off, 0.04);
  leave(of.ball, [&](const Vec3& x) { return share(x) > 1.5 || (share(x) > 1.0 + off && on_neck_side(x)); });
  leave(of.socket, [&](const Vec3& y) {
    return std::ranges::any_of(places.rim->points, [&](const auto& point) {
      return point && (places.socket->centre + *point - y).norm() <= 0.1 * places.socket->radius;
    });
  });
  return of;
}

// With the ball where it is, and moved up into the socket.
void check_rim(const std::string& subject, test::BoneVariant of, Side side) {
  for (const double up : {0.0, 1.5}) {
    for (TriangleMesh* mesh : {&of.ball, &of.input.ball.mesh})
      for (Vec3& x : mesh->vertices) x.z() += up;
    const Joint joint = assemble_joint(of.input);
    const JointPlaces places = joint_places({main_surface(joint.ball.mesh, joint.ball.parts),
                                             main_surface(joint.socket.mesh, joint.socket.parts)});
    if (!places.rim || places.neck.isZero(0.0)) return;
    const CentredLimits centred(joint, {joint.ball.mesh, joint.socket.mesh}, Vec3::Zero(), Vec3::Zero(),
                                places);
    const test::BoneVariant rim = rim_of(of, places);
    const test::ExactMeeting exact(rim.ball, rim.socket);
    const Peer peer(rim.ball, rim.socket);
    for (const NamedMotion& motion : named_motions()) {
      SCOPED_TRACE(subject + ", " + of.name + ", " + std::string(motion.name));
      const MotionName& growing = motion_name(motion.growing);
      const JointTurn turn = joint_turn(motion.start, growing, side);
      const double largest = largest_growth(motion.start, growing);
      const TurnLimit limit = centred.limits.first_contact(turn, largest);
      const std::optional<double> other = peer.first(turn, largest);
      check_limit({rim, exact, turn}, centred.limits, limit, other);
      EXPECT_NE(centred.limits.verdict(turn, 0.0).contact, Contact::unknown);
      std::cout << subject << ", " << of.name << " up " << up << ", " << motion.name << ", rim, "
                << name(limit.state) << ", " << limit.low_deg << ", "
                << (other ? std::to_string(*other) : "free") << "\n";
    }
  }
}

TEST_P(TheoremTurnOfRealBones, OfTheRimAloneAreThoseOfAPeerOrEarlierAndExact) {
  for (const JointFolder& joint : test::joints_of(GetParam())) {
    for (const test::BoneVariant& of : test::variants(joint)) {
      if (of.name != "parts") check_rim(joint.subject, of, joint.side.value());
    }
  }
}

TEST(TheoremTurnOfTheRimAlone, OfHipsAreThoseOfAPeerOrEarlierAndExact) {
  for (const char* preset : {"normal", "cam", "pincer"}) {
    HipParameters parameters = hip_preset(preset);
    parameters.side = Side::right;
    const Hip hip = make_hip(parameters, 6000);
    test::BoneVariant of{"generated", {}, hip.ball, hip.socket};
    of.input.ball = {"ball", hip.ball};
    of.input.socket = {"socket", hip.socket};
    of.input.centre = Vec3::Zero();
    check_rim(preset, of, Side::right);
  }
}

}  // namespace
}  // namespace impinge
