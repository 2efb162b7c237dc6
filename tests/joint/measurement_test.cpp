// SPDX-License-Identifier: GPL-3.0-or-later
// What of a pose is not asked for is not worked out, and what is asked for stays the same, bit for bit.
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "joint/document.hpp"
#include "joint/gaps.hpp"
#include "joint/touch.hpp"
#include "mesh/generated_pair.hpp"
#include "table/pairwise.hpp"

namespace impinge {
namespace {

Session hip() {
  const BallSocketPair pair = make_ball_socket_pair(800, impinging_cam());
  Joint joint;
  joint.ball.mesh = pair.ball;
  joint.socket.mesh = pair.socket;
  return {std::move(joint), std::nullopt, "ALS"};
}

GapsRequest flexed(const char* angle) {
  GapsRequest options;
  options.precision_deg = 2.0;  // bounds of finer tables take a while
  options.pose = parse_motion(std::string("flexion=") + angle);
  return options;
}

void expect_same(const std::vector<double>& a, const std::vector<double>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i)
    EXPECT_TRUE(a[i] == b[i] || (std::isnan(a[i]) && std::isnan(b[i]))) << "vertex " << i;
}

TEST(Measurements, GapsAloneAreTheGaps) {
  Session session = hip();
  GapsRequest options = flexed("60");
  const GapsAnswer everything = answer(session, options);
  EXPECT_TRUE(everything.left_out.empty());
  ASSERT_TRUE(everything.radial_overlap);
  options.outputs = {Output::gaps};
  const GapsAnswer gaps = answer(session, options);
  expect_same(gaps.ball.gap, everything.ball.gap);
  expect_same(gaps.socket.gap, everything.socket.gap);
  EXPECT_TRUE(gaps.ball.bound.empty() && gaps.ball.distance.empty() && !gaps.radial_overlap);
  EXPECT_EQ(gaps.entries_per_table, everything.entries_per_table) << "of the scheme";
}

TEST(Measurements, TouchHasTheSmallestOfAllGaps) {
  Session session = hip();
  for (const double angle : {0.0, 30.0, 60.0}) {
    GapsRequest gaps;
    gaps.pose.flexion = angle;
    const GapsAnswer all = answer(session, gaps);
    double smallest = HUGE_VAL;
    for (const double g : all.ball.gap) smallest = std::fmin(smallest, g);
    for (const double g : all.socket.gap) smallest = std::fmin(smallest, g);
    EXPECT_EQ(all.smallest_gap.value().gap_mm, smallest);
    const TouchAnswer touch = answer(session, TouchRequest{.pose = gaps.pose});
    EXPECT_NEAR(touch.smallest_gap.value().gap_mm, smallest, 1e-9);
    EXPECT_EQ(touch.smallest_gap->surface, all.smallest_gap->surface);
    EXPECT_EQ(touch.smallest_gap->vertex, all.smallest_gap->vertex);
    EXPECT_EQ(touch.smallest_gap->position, all.smallest_gap->position);
    EXPECT_EQ(json_of(touch.contact), json_of(all.contact.value()));
    EXPECT_EQ(touch.contact.state == Contact::yes, smallest <= 0.0);
  }
}

// Asked for no table, a single pose is measured on the faces: gaps are those of rays, a table's are within
// its bounds of them, and contact is the same.
TEST(Measurements, TheFacesAnswerASinglePose) {
  Session session = hip();
  for (const char* angle : {"0", "30", "60"}) {
    GapsRequest options = flexed(angle);
    const GapsAnswer table = answer(session, options);
    EXPECT_EQ(table.table_bytes, 2 * sizeof(double) * table.entries_per_table);

    options.precision_deg.reset();
    const GapsAnswer faces = answer(session, options);
    EXPECT_EQ(faces.entries_per_table, 0U);
    EXPECT_LT(faces.error_bound->largest_mm, 1e-9);
    EXPECT_EQ(faces.radial_overlap->surfaces_impinged, table.radial_overlap->surfaces_impinged);
    EXPECT_EQ(faces.radial_overlap->ball.impinged, table.radial_overlap->ball.impinged);
    EXPECT_EQ(faces.radial_overlap->ball.refuted + faces.radial_overlap->socket.refuted, 0U);
    const RayCaster socket(session.joint->joint.socket.mesh);
    for (std::size_t i = 0; i < faces.ball.gap.size(); ++i) {
      const Vec3 x = to_socket(faces.pose, session.joint->joint.ball.mesh.vertices[i]);
      const double gap = socket.cast(x.normalized(), Layer::nearest) - x.norm();
      ASSERT_EQ(std::isnan(faces.ball.gap[i]), std::isnan(gap)) << i;
      if (std::isnan(gap)) continue;
      EXPECT_LE(std::abs(gap - faces.ball.gap[i]), faces.ball.bound[i] + 1e-11) << i;
      if (std::isnan(table.ball.gap[i])) continue;
      EXPECT_LE(std::abs(gap - table.ball.gap[i]), table.ball.bound[i] + 1e-11) << i;
    }
    EXPECT_EQ(faces.contact.value().state == Contact::yes, faces.radial_overlap->surfaces_impinged);
    options.surfaces = Scanned::ball;
    options.outputs = {Output::gaps};
    const GapsAnswer ball = answer(session, options);
    expect_same(ball.ball.gap, faces.ball.gap);
    EXPECT_TRUE(ball.socket.gap.empty() && ball.ball.bound.empty());
    EXPECT_NE(ball.way.find("measured on the faces near it"), std::string::npos) << ball.way;
  }
}

// Where edges cross and no vertex is beyond, the surfaces touch, and vertices alone would not say so.
TEST(Measurements, ATouchBetweenVerticesIsOne) {
  Session session = hip();
  GapsRequest options = flexed("30");

  options.precision_deg.reset();
  options.outputs = {Output::gaps, Output::verdicts};
  bool between = false;
  for (double angle = 30.0; angle < 60.0 && !between; angle += 0.05) {
    options.pose.flexion = angle;
    const Certificate certificate = *answer(session, options).radial_overlap;
    between = certificate.surfaces_impinged && !certificate.vertices_impinged();
  }
  ASSERT_TRUE(between);
  EXPECT_EQ(answer(session, TouchRequest{.pose = options.pose}).contact.state, Contact::yes);
}

}  // namespace
}  // namespace impinge
