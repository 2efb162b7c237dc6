// SPDX-License-Identifier: GPL-3.0-or-later
// Contract: close to contact too every answer is that of the exact test of every vertex; what FCL finds
// beyond it is a contact of the surfaces, of which that test misses some.
#include "10_error_against_time/contact_agreement.hpp"

#include <gtest/gtest.h>

#include "mesh/generated_pair.hpp"

namespace impinge::lab {
namespace {

TEST(ContactAgreement, VerticesMissContactsOfTheSurfacesAndNothingElseDiffers) {
  const AgreementOptions options{300, 200, 5};
  const Agreement found = contact_agreement(make_ball_socket_pair(options.triangles), options);
  EXPECT_EQ(found.poses, 200U);
  EXPECT_GT(found.impinged, 40U);
  EXPECT_LT(found.impinged, 160U);
  EXPECT_EQ(found.culled_wrong, 0U);
  EXPECT_EQ(found.least_gap_wrong, 0U);
  EXPECT_EQ(found.unexplained, 0U);
  EXPECT_GT(found.missed, 0U);
  EXPECT_GE(found.missed, found.between_vertices);
  EXPECT_EQ(agreement_table(options, found).rows.size(), 1U);
}

}  // namespace
}  // namespace impinge::lab
