// SPDX-License-Identifier: GPL-3.0-or-later
// What the volume of free rotations says of real bones, of cells as a whole and of their parts: beside the
// verdict of the pose, and CGAL's exact meeting of all faces.
#include "joint/volume.hpp"

#include <array>
#include <iostream>
#include <vector>

#include <gtest/gtest.h>

#include "bones/real_bones.hpp"
#include "support/dice.hpp"
#include "support/random_cases.hpp"

namespace impinge {
namespace {

class TheoremVolumeOfRealBones : public testing::TestWithParam<std::size_t> {};
INSTANTIATE_TEST_SUITE_P(Joint, TheoremVolumeOfRealBones, testing::Range(std::size_t{0}, test::kShares));

TEST_P(TheoremVolumeOfRealBones, IsNeverWrongOfARotation) {
  for (const JointFolder& joint : test::joints_of(GetParam())) {
    for (const test::BoneVariant& of : test::variants(joint)) {
      SCOPED_TRACE(joint.subject + ", " + of.name);
      SessionJoint assembled(assemble_joint(of.input), of.input.side, of.input.axes);
      const CellTest cells = cell_test(assembled, assembled.joint.socket.mesh);
      const MotionVolume volume(cells, {.width = 0.05, .most_cells = 20'000});
      std::vector<RotationCell> parted;
      volume.for_each([&](const VolumeCell& at) {
        if (at.part != nullptr) parted.push_back(at.cell);
      });
      if (parted.empty()) volume.for_each([&](const VolumeCell& at) { parted.push_back(at.cell); });
      const test::ExactMeeting exact(of.ball, of.socket);
      test::Dice dice(51);
      std::array<std::size_t, 2> said{};  // free, blocked
      for (std::size_t k = 0; k < random_cases(); ++k) {
        const RotationCell& cell = parted[static_cast<std::size_t>(dice.whole(0, int(parted.size()) - 1))];
        const Quaternion4 q =
            k % 4 == 0
                ? dice.quaternion()
                : point_of(cell, {dice.between(-1.0, 1.0), dice.between(-1.0, 1.0), dice.between(-1.0, 1.0)});
        const CellState state = volume.at(q).state;
        if (state != CellState::free && state != CellState::blocked) continue;
        const Pose pose{rotation_of(q), Vec3::Zero()};
        const bool is_free = state == CellState::free;
        EXPECT_NE(assembled.bodies().verdict(pose).contact, is_free ? Contact::yes : Contact::no) << k;
        EXPECT_FALSE(is_free && k % 8 < 2 && exact.of_doubles(pose)) << k;
        ++said[is_free ? 0 : 1];
      }
      std::cout << joint.subject << ", " << of.name << ": " << said[0] << " free rotations, " << said[1]
                << " blocked" << std::endl;
      EXPECT_GT(said[0] + said[1], random_cases() / 20);
    }
  }
}

}  // namespace
}  // namespace impinge
