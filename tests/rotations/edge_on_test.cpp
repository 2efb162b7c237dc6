// SPDX-License-Identifier: GPL-3.0-or-later
// Cells of joints on a small grid, most of whose faces have a plane that holds the centre: no rotation of a
// free cell or part has a contact, by CGAL's exact intersection of all faces, or overlaps radially; every one
// of a blocked one has.
#include <algorithm>
#include <array>
#include <cstddef>

#include <gtest/gtest.h>

#include "gap/overlay.hpp"
#include "reference/meeting_surfaces.hpp"
#include "rotations/cell_test.hpp"
#include "rotations/rotation_cells.hpp"
#include "support/dice.hpp"
#include "support/grid_joint.hpp"
#include "support/joined.hpp"
#include "support/random_cases.hpp"
#include "support/turned.hpp"

namespace impinge {
namespace {

struct Counts {
  std::size_t free = 0;
  std::size_t blocked = 0;
  std::size_t unseen = 0;  // surfaces that meet where radii do not overlap
};

// by_radii: is what overlaps radially blocked?
void attack(const BallSocketPair& joint, const CellQuestion& question, test::Dice& dice, Counts& counts) {
  const CellTest test(joint, question);
  const bool by_radii = question.gap_mm > 0.0 || !test.bodies().has_inside();
  const SurfaceOverlay radii(joint.ball, joint.socket);
  CellSearch search(test);
  for (std::size_t n = 0; n < 100; ++n) {
    const Eigen::Matrix3d about = n % 2 == 0 ? test::grid_turn(dice) : dice.rotation();
    const Eigen::Quaterniond q(about);
    const RotationCell cell =
        cell_of({q.w(), q.x(), q.y(), q.z()}, static_cast<std::uint32_t>(dice.whole(3, 9)));
    const CellVerdict verdict = search.decide(cell);
    if (verdict.state == CellState::unknown) continue;
    const CellPart part = verdict.state == CellState::open ? search.part_of(cell, verdict.hint) : CellPart{};
    for (std::size_t k = 0; k < 5; ++k) {
      const Vec3 t(dice.between(-1.0, 1.0), dice.between(-1.0, 1.0), dice.between(-1.0, 1.0));
      const Eigen::Matrix3d rotation = rotation_of(point_of(cell, {t[0], t[1], t[2]}));
      const bool meet = surfaces_meet(test::turned(joint.ball, rotation), joint.socket);
      const bool overlap = radii.impinged({rotation, Vec3::Zero()});
      counts.unseen += meet && !overlap ? 1 : 0;
      if (verdict.state == CellState::free || part.state == CellState::free || part.is_free(t)) {
        ++counts.free;
        ASSERT_FALSE(meet) << cell.level << " " << cell.number;
        ASSERT_FALSE(overlap && by_radii) << cell.level << " " << cell.number;
      }
      if (verdict.state == CellState::blocked && question.gap_mm == 0.0 && by_radii) {
        ++counts.blocked;
        ASSERT_TRUE(meet || overlap) << cell.level << " " << cell.number;
      }
    }
  }
}

TEST(TheoremVolume, IsNeverWrongOfEdgeOnFacesAndASheet) {
  test::Dice dice(1);
  Counts counts;
  for (std::size_t k = 0; k < random_cases() / 25; ++k)
    attack(test::grid_joint(dice), {k % 3 == 0 ? 0.25 : 0.0, 0.0}, dice, counts);
  EXPECT_GT(counts.free, random_cases());
  EXPECT_GT(counts.blocked, random_cases() / 50);
  EXPECT_GT(counts.unseen, random_cases() / 50);
}

// A socket that is closed all round: then radii only tell that nothing is in contact.
TEST(TheoremVolume, IsNeverWrongOfEdgeOnFacesAndAClosedSocket) {
  test::Dice dice(2);
  Counts counts;
  const TriangleMesh shell = test::joined(test::inside_out(octahedron(9.0)), octahedron(11.0));
  for (std::size_t k = 0; k < random_cases() / 50; ++k) {
    const BallSocketPair joint{test::grid_joint(dice).ball, shell};
    ASSERT_TRUE(BodyPairs(joint, {}).has_inside());
    attack(joint, {}, dice, counts);
  }
  EXPECT_GT(counts.free, random_cases());
  EXPECT_GT(counts.unseen, random_cases() / 50);
}

}  // namespace
}  // namespace impinge
