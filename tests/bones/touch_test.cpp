// SPDX-License-Identifier: GPL-3.0-or-later
// Whether real bones touch, by CGAL's exact meeting of all faces: next to contact on both sides of it, with
// and without a shift, and anywhere. Whole bones in a tenth of the random cases a joint, the others in a
// hundredth.
#include <array>
#include <chrono>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "bones/real_bones.hpp"
#include "support/dice.hpp"
#include "support/random_cases.hpp"

namespace impinge {
namespace {

using test::Dice;

// Asks both of a pose, and counts.
class TouchCheck {
 public:
  explicit TouchCheck(const test::BoneVariant& of)
      : of_(of),
        joint_(assemble_joint(of.input), of.input.side, of.input.axes),
        exact_(of.ball, of.socket),
        closed_(test::closed(of.ball) && test::closed(of.socket)) {}

  const Joint& joint() const { return joint_.joint; }
  std::size_t poses() const { return meet_ + apart_; }

  // Is there contact? `told` is what a limit says of surfaces.
  bool ask(const Pose& pose, std::optional<bool> told = {}) {
    const auto begin = std::chrono::steady_clock::now();
    const BodyPairs::Verdict said = joint_.bodies().verdict(pose);
    const auto asked = std::chrono::steady_clock::now();
    const bool meet = exact_.of_doubles(pose);
    ours_ += asked - begin;
    cgal_ += std::chrono::steady_clock::now() - asked;
    const bool yes = said.contact == Contact::yes;
    ++(meet ? meet_ : apart_);
    EXPECT_TRUE(!meet || yes) << "pose " << poses();
    EXPECT_TRUE(meet || !yes || said.rule != ContactRule::surfaces) << "pose " << poses();
    EXPECT_EQ(meet, told.value_or(meet)) << "pose " << poses();
    if (!meet) check_inside(pose, said);
    if (poses() % 8 == 0 && exact_.of_reals(pose) != meet) ++rounded_;
    return yes;
  }

  void print(const std::string& joint) const {
    std::cout << joint << ", " << of_.name << ": " << meet_ << " poses meet, " << apart_ << " do not, "
              << inside_ << " inside, " << radii_ << " by radii, " << unknown_ << " unknown, " << rounded_
              << " of " << poses() / 8
              << " otherwise without rounding; us a pose: " << 1e6 * ours_.count() / double(poses())
              << ", CGAL " << 1e6 * cgal_.count() / double(poses()) << std::endl;
  }

 private:
  void check_inside(const Pose& pose, const BodyPairs::Verdict& said) {
    inside_ += said.contact == Contact::yes && said.rule == ContactRule::inside ? 1U : 0U;
    radii_ += said.contact == Contact::yes && said.rule == ContactRule::radii ? 1U : 0U;
    unknown_ += said.contact == Contact::unknown ? 1U : 0U;
    if (!closed_) return;
    std::vector<Vec3> ball;
    for (const Vec3& x : of_.ball.vertices) ball.push_back(to_socket(pose, x));
    std::vector<Vec3> socket;
    for (const Vec3& x : of_.socket.vertices) socket.push_back(to_ball(pose, x));
    const bool inside = test::holds(of_.socket, ball) || test::holds(of_.ball, socket);
    EXPECT_EQ(said.contact, inside ? Contact::yes : Contact::no) << "pose " << poses();
  }

  const test::BoneVariant& of_;
  SessionJoint joint_;
  test::ExactMeeting exact_;
  bool closed_;
  std::size_t meet_ = 0, apart_ = 0, inside_ = 0, radii_ = 0, unknown_ = 0, rounded_ = 0;
  std::chrono::duration<double> ours_{}, cgal_{};
};

// About any axis from near the scan's pose, to within a billionth of a degree to one of what we say is the
// first contact.
void ask_near_a_limit(TouchCheck& check, const TurnLimits& limits, Dice& dice) {
  const Eigen::Matrix3d inner =
      Eigen::AngleAxisd(dice.between(0.0, 0.3), dice.direction()).toRotationMatrix();
  const JointTurn turn{.axis = dice.direction(), .inner = inner};
  const TurnLimit limit = limits.first_contact(turn, 360.0);
  if (limit.state != LimitState::limited) {
    check.ask(test::pose_at(turn, 0.0));
    return;
  }
  check.ask(test::pose_at(turn, limit.low_deg), false);
  check.ask(test::pose_at(turn, limit.high_deg), true);
  for (int k = 0; k < 4; ++k) {
    check.ask(test::pose_at(turn, std::max(0.0, limit.low_deg - dice.power(-9.0, 0.0))), false);
    check.ask(test::pose_at(turn, limit.high_deg + dice.power(-9.0, 0.0)));
  }
}

// Halfway between a pose in contact and one that is not, again and again.
void ask_between(TouchCheck& check, Dice& dice) {
  std::array<std::optional<Pose>, 2> ends;
  for (int k = 0; k < 100 && !(ends[0] && ends[1]); ++k) {
    const Pose pose{Eigen::AngleAxisd(dice.between(0.0, kPi), dice.direction()).toRotationMatrix(),
                    dice.power(-3.0, 1.0) * dice.direction()};
    ends[check.ask(pose) ? 1 : 0] = pose;
  }
  for (int k = 0; k < 30 && ends[0] && ends[1]; ++k) {
    const Eigen::Quaterniond middle =
        Eigen::Quaterniond(ends[0]->rotation).slerp(0.5, Eigen::Quaterniond(ends[1]->rotation));
    const Pose pose{middle.normalized().toRotationMatrix(),
                    0.5 * (ends[0]->translation + ends[1]->translation)};
    ends[check.ask(pose) ? 1 : 0] = pose;
  }
}

class TheoremContactOfRealBones : public testing::TestWithParam<std::size_t> {};
INSTANTIATE_TEST_SUITE_P(Joint, TheoremContactOfRealBones, testing::Range(std::size_t{0}, test::kShares));

TEST_P(TheoremContactOfRealBones, WhereCgalSays) {
  for (const JointFolder& joint : test::joints_of(GetParam())) {
    for (const test::BoneVariant& of : test::variants(joint)) {
      SCOPED_TRACE(joint.subject + ", " + of.name);
      TouchCheck check(of);
      const CentredLimits centred = test::limits_of(check.joint());
      Dice dice(49);
      while (check.poses() < random_cases() / (of.name == "whole" ? 10 : 100)) {
        for (int k = 0; k < 4; ++k) ask_near_a_limit(check, centred.limits, dice);
        ask_between(check, dice);
      }
      check.print(joint.subject);
    }
  }
}

// A femur of a fiftieth of its size about each place of the pelvis: in its bone, through its surface, and
// off.
TEST_P(TheoremContactOfRealBones, InsideWhereSolidAnglesSay) {
  for (const JointFolder& joint : test::joints_of(GetParam())) {
    test::BoneVariant of = test::variants(joint).front();
    if (!test::closed(of.ball) || !test::closed(of.socket)) continue;
    for (Vec3& x : of.ball.vertices) x *= 0.02;
    const BodyPairs pairs({of.ball, of.socket}, {});
    const test::ExactMeeting exact(of.ball, of.socket);
    Dice dice(50);
    std::array<std::size_t, 3> found{};
    for (std::size_t k = 0; k < random_cases() / 100; ++k) {
      const int place = dice.whole(0, static_cast<int>(of.socket.vertices.size()) - 1);
      const Pose pose{dice.rotation(), of.socket.vertices[static_cast<std::size_t>(place)] +
                                           dice.power(-3.0, 1.3) * dice.direction()};
      const bool meet = exact.of_doubles(pose);
      const bool inside = !meet && test::within(of.socket, to_socket(pose, of.ball.vertices[0]));
      const BodyPairs::Verdict said = pairs.verdict(pose);
      EXPECT_EQ(said.contact, meet || inside ? Contact::yes : Contact::no) << joint.subject << " " << k;
      EXPECT_TRUE(said.contact == Contact::no || (said.rule == ContactRule::inside) == inside) << k;
      ++found[meet ? 0 : inside ? 1 : 2];
    }
    std::cout << joint.subject << ", small: " << found[0] << " meet, " << found[1] << " inside, " << found[2]
              << " neither" << std::endl;
  }
}

}  // namespace
}  // namespace impinge
