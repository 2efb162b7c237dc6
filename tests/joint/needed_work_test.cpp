// SPDX-License-Identifier: GPL-3.0-or-later
// Leaving out what a scene does not need changes no bit of its answer:
//   answer_by_table(needs) == the two scans of all vertices over whole tables
//   answer_on_faces(needs) == the gaps of all vertices on the faces
#include "joint/needed_work.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <stdexcept>

#include <gtest/gtest.h>

#include "gap/gap_scan.hpp"
#include "gap/measured_gap.hpp"
#include "mesh/bodies.hpp"
#include "mesh/generated_pair.hpp"
#include "mesh/surface_vertices.hpp"
#include "sphere/infinity.hpp"
#include "sphere/schemes/cube_gnomonic.hpp"
#include "sphere/schemes/icosahedral_sine.hpp"
#include "sphere/schemes/latitude_rows.hpp"
#include "sphere/schemes/rsid.hpp"
#include "sphere/schemes/usid.hpp"
#include "support/poses.hpp"
#include "support/soup.hpp"
#include "table/exact_raster.hpp"
#include "table/partial_table.hpp"

namespace impinge {
namespace {

BallSocketPair cam() { return make_ball_socket_pair(500, impinging_cam()); }
// Contact along a rim, which takes answers of a table away.
BallSocketPair tight_cup() { return {sphere(20.0, 1000), cup(19.9, 60.0, 300)}; }
// Folds, jumps and steep faces all over the place.
BallSocketPair faces_at_random() { return {test::soup(20, 9), test::soup(20, 10)}; }
// A socket with a narrow dent towards every second entry of a coarse grid: a table reads it from beside it,
// where the surface itself is far.
BallSocketPair dented(const Rsid& grid, std::size_t faces) {
  BallSocketPair joint{sphere(23.0, 400), sphere(25.0, faces)};
  for (Vec3& v : joint.socket.vertices) {
    for (std::size_t entry = 0; entry < grid.size(); entry += 2) {
      if (v.dot(grid.direction(entry)) > std::cos(3.0 * kDegree) * v.norm()) v = 20.0 * v.normalized();
    }
  }
  return joint;
}

// Near contact and far from it, in turns.
std::vector<Pose> poses(std::size_t count, unsigned seed) {
  std::vector<Pose> all = test::random_poses(count, 1.5, 4.5, seed);
  const std::vector<Pose> near = test::random_poses(count, 0.1, 0.3, seed + 1);
  all.insert(all.end(), near.begin(), near.end());
  return all;
}

std::vector<SceneNeeds> all_needs(const Pose& pose) {
  std::vector<SceneNeeds> all;
  for (const Question question : {Question::smallest_gap, Question::all_gaps}) {
    for (const auto& [ball, socket] : {std::pair(true, true), std::pair(true, false), std::pair(false, true)})
      all.push_back({question, ball, socket, pose});
  }
  return all;
}

// The answer that the gaps of all vertices hold.
SceneAnswer answer_in(const PoseGaps& gaps, const SceneNeeds& needs) {
  SceneAnswer answer;
  for (std::size_t k = 0; k < 2; ++k) {
    if (!needs.scans(kSurfaces[k])) continue;
    if (needs.question == Question::all_gaps) {
      answer.gaps[k] = gaps[k];
      continue;
    }
    for (std::size_t v = 0; v < gaps[k].size(); ++v) {
      if (gaps[k][v] < (answer.smallest ? answer.smallest->gap_mm : kInfinity))
        answer.smallest = SmallestGap{gaps[k][v], kSurfaces[k], v};
    }
  }
  return answer;
}

bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
  return std::ranges::equal(a, b, [](double x, double y) {
    return (std::isnan(x) && std::isnan(y)) ||
           std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
  });
}

bool same(const SceneAnswer& a, const SceneAnswer& b) {
  return a.smallest == b.smallest && same_bits(a.gaps[0], b.gaps[0]) && same_bits(a.gaps[1], b.gaps[1]);
}

// Two scans a pose over whole tables.
template <class S>
std::vector<PoseGaps> scans(const BallSocketPair& joint, const std::vector<Pose>& poses, double precision) {
  const S scheme = S::with_precision(precision);
  std::vector<PoseGaps> gaps(poses.size());
  for (const Surface of : kSurfaces) {
    const RadialTable<S> table = fill_exact(mesh_of(joint, other(of)), scheme, facing_layer(other(of)));
    const std::vector<Vec3>& vertices = mesh_of(joint, of).vertices;
    const std::vector<bool> used = on_surface(mesh_of(joint, of));
    for (std::size_t p = 0; p < poses.size(); ++p) {
      std::vector<double>& gap = gaps[p][of == Surface::ball ? 0 : 1];
      gap.resize(vertices.size());
      scan_gaps(table, vertices, poses[p], of, gap);
      for (std::size_t v = 0; v < gap.size(); ++v) gap[v] = used[v] ? gap[v] : kNoSurface;
    }
  }
  return gaps;
}

template <class S>
class NeededWork : public ::testing::Test {
 protected:
  static void expect_same(const BallSocketPair& joint, double precision, const std::vector<Pose>& poses) {
    const std::vector<PoseGaps> gaps = scans<S>(joint, poses, precision);
    const AnyScheme scheme(S::name, precision);
    for (std::size_t p = 0; p < poses.size(); ++p) {
      for (const SceneNeeds& needs : all_needs(poses[p])) {
        const SceneAnswer found = answer_by_table(joint, needs, scheme);
        EXPECT_TRUE(same(found, answer_in(gaps[p], needs)))
            << S::name << " at " << precision << " degrees, question " << static_cast<int>(needs.question)
            << (needs.ball ? ", ball" : "") << (needs.socket ? ", socket" : "");
      }
    }
  }
};
using Schemes = ::testing::Types<Rsid, Usid, CubeGnomonic, IcosahedralSine, LatitudeRows>;
TYPED_TEST_SUITE(NeededWork, Schemes);

TYPED_TEST(NeededWork, IsAllThatChangesTheAnswer) {
  for (const double precision : {2.0, 15.0}) {
    this->expect_same(cam(), precision, poses(3, 31));
    this->expect_same(tight_cup(), precision, test::random_poses(6, 0.05, 0.3, 33));
    this->expect_same(faces_at_random(), precision, poses(2, 35));
    this->expect_same(dented(Rsid::with_precision(15.0), 1500), precision,
                      test::random_poses(2, 3.0, 0.3, 34));
  }
}

// The same of the faces, each gap by itself; and where gaps up to 1 mm are taken away, as by a rim, so that
// the limits that ranges prove are not kept.
TEST(NeededVertices, AreAllThatChangeTheAnswerOfTheFaces) {
  for (const BallSocketPair& joint : {cam(), tight_cup(), faces_at_random()}) {
    const NearFaces ball(joint.ball, 0.0);
    const NearFaces socket(joint.socket, 0.0);
    for (const double taken : {-kInfinity, 1.0}) {
      const auto gap = [&](Surface of, std::size_t /*vertex*/, const Vec3& x) {
        const CertifiedGap ends = measured_gap(of, of == Surface::ball ? socket : ball, x);
        return ends.cover == Cover::none || ends.high < taken ? kNoSurface : 0.5 * (ends.low + ends.high);
      };
      for (const Pose& pose : poses(20, 41)) {
        for (const SceneNeeds& needs : all_needs(pose)) {
          const SceneAnswer found = answer_on_faces(joint, needs, {&socket, &ball}, gap);
          const SceneAnswer all = answer_from(joint, needs, all_vertices(joint, needs), gap);
          EXPECT_TRUE(same(found, all)) << static_cast<int>(needs.question) << ' ' << taken;
          EXPECT_LE(found.look_ups, all.look_ups);
        }
      }
    }
  }
}

TEST(NeededWorkOf, AJointIsASmallPartOfAllWork) {
  const BallSocketPair joint = cam();
  const AnyScheme scheme("rsid", 0.5);
  const std::size_t all = joint.ball.vertices.size() + joint.socket.vertices.size();
  for (const Pose& pose : poses(10, 51)) {
    EXPECT_LT(answer_by_table(joint, {.pose = pose}, scheme).entries, scheme.size() / 2);
    const SceneAnswer found =
        answer_by_table(joint, {.question = Question::smallest_gap, .pose = pose}, scheme);
    EXPECT_LT(found.look_ups, all / 2);
    EXPECT_LT(found.entries, scheme.size() / 20);
    ASSERT_EQ(found.left_out.size(), 4U) << "entries and vertices of both scans";
  }
}

// Mutants: what leaves out more than it may is seen by the comparison. The ball is one face, whose first
// vertex is the nearest but for the dents.
TEST(NeededWorkOf, ANarrowerMarginOrFewerEntriesAreNotEnough) {
  const AnyScheme scheme("rsid", 15.0);
  BallSocketPair joint = dented(Rsid::with_precision(15.0), 5000);
  joint.ball = {{{23.0, 0.0, 0.0}, {22.9, 0.5, 0.0}, {22.9, 0.0, 0.5}}, {{0, 1, 2}}};
  const std::vector<Pose> turns = test::random_poses(300, 3.0, 0.3, 34);
  const std::vector<PoseGaps> gaps = scans<Rsid>(joint, turns, 15.0);
  const NearFaces narrow(joint.socket, 0.0);
  const NearFaces socket(joint.socket, scheme.stencil_radius());
  const auto is_same = [&](Question question, const NearFaces& faces, std::size_t dropped) {
    for (std::size_t p = 0; p < turns.size(); ++p) {
      const SceneNeeds needs{question, true, false, turns[p]};
      const NeededVertices vertices = needed_vertices(joint, needs, {&faces, nullptr});
      EntrySet entries(scheme.size());
      needed_entries(joint, needs, vertices, Surface::ball, scheme).for_each([&](std::size_t entry) {
        if (entry != dropped) entries.insert(entry);
      });
      entries.number();
      const PartialTable table = fill_partial(socket, scheme, std::move(entries), Layer::nearest);
      const SceneAnswer answer =
          answer_from(joint, needs, vertices, [&](Surface of, std::size_t /*vertex*/, const Vec3& x) {
            return signed_gap(of, table.radius_at(x), x.norm());
          });
      if (!same(answer, answer_in(gaps[p], needs))) return false;
    }
    return true;
  };
  const std::size_t none = scheme.size();
  EXPECT_TRUE(is_same(Question::smallest_gap, socket, none));
  EXPECT_FALSE(is_same(Question::smallest_gap, narrow, none));
  EXPECT_TRUE(is_same(Question::all_gaps, socket, none));
  EXPECT_FALSE(is_same(Question::all_gaps, socket, none / 2));
}

TEST(NeededWorkOf, WhatAsksNothingIsRefused) {
  EXPECT_THROW(
      answer_by_table(make_ball_socket_pair(100), {.ball = false, .socket = false}, AnyScheme("rsid", 5.0)),
      std::invalid_argument);
}

}  // namespace
}  // namespace impinge
