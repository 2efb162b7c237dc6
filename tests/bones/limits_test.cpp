// SPDX-License-Identifier: GPL-3.0-or-later
// The twelve named motions of real joints, whole, cropped and in parts, against FCL in steps of a quarter of
// a degree, bisected. Steps may jump over a contact: where a limit comes earlier, CGAL must see the surfaces
// meet there and not before.
#include <iostream>
#include <optional>

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/narrowphase/collision.h>
#include <gtest/gtest.h>

#include "bones/real_bones.hpp"
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

}  // namespace
}  // namespace impinge
