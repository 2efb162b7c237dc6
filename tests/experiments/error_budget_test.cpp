// SPDX-License-Identifier: GPL-3.0-or-later
#include "04_error_budget/error_budget.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "mesh/generated_pair.hpp"
#include "mesh/icosphere.hpp"

namespace impinge::lab {
namespace {

BudgetJoint generated() {
  const PairShape shape;
  return {"generated", make_ball_socket_pair(3000, shape), Vec3(0.1, -0.2, 0.05), [shape](const Vec3& u) {
            return angle_between(u, Vec3::UnitZ()) > shape.half_opening_deg * kDegree ? kNoSurface
                                                                                      : shape.socket_radius;
          }};
}

// The faces of a sphere's mesh lie inside of it, by the sagitta at most.
TEST(ErrorBudget, MeshStageIsTheSagittaOfTheFaces) {
  const BudgetJoint joint = generated();
  const std::vector<Stage> stages = exact_stages(joint);
  ASSERT_EQ(stages.at(1).adds, "mesh");
  double largest = 0.0;
  for (std::size_t i = 0; i < stages[0].gap.size(); ++i)
    largest = std::fmax(largest, std::abs(stages[1].gap[i] - stages[0].gap[i]));
  const std::vector<double> sagittas = face_sagittas(joint.meshes.socket);
  const double estimate = *std::ranges::max_element(sagittas);
  EXPECT_GT(largest, 0.3 * estimate);
  EXPECT_LT(largest, 1.05 * estimate);
}

// Off by e, concentric spheres of radii B and S are both seen e.u nearer: of the gap only e_t^2 / 2 (1 / B -
// 1 / S) is left, e_t the part of e across the ray. Faces seen obliquely add what is of first order and has
// either sign: the mean over all vertices is that of the spheres. The socket is far from the ball and the
// faces are small, so that the spheres' part, 12 um at 1 mm, is far above what the faces leave of theirs in
// the mean.
// Every seventh vertex is enough: the mean changes by 0.4 %.
struct MeanChange {
  double measured = 0.0;
  double spheres = 0.0;
};

MeanChange mean_change(double off) {
  PairShape shape;
  shape.cam_height = 0.0;
  shape.head_radius = 20.0;
  shape.socket_radius = 80.0;
  BudgetJoint joint{"spheres", make_ball_socket_pair(12000, shape), off * Vec3(0.48, 0.6, 0.64), {}};
  std::vector<Vec3> some;
  for (std::size_t i = 0; i < joint.meshes.ball.vertices.size(); i += 7)
    some.push_back(joint.meshes.ball.vertices[i]);
  joint.meshes.ball.vertices = some;
  const std::vector<Stage> stages = exact_stages(joint);
  MeanChange mean;
  double count = 0.0;
  for (std::size_t i = 0; i < joint.meshes.ball.vertices.size(); ++i) {
    const double change = stages.at(1).gap[i] - stages.at(0).gap[i];
    if (std::isnan(change)) continue;
    const double across = joint.wrong_centre.cross(joint.meshes.ball.vertices[i].normalized()).squaredNorm();
    mean.measured += change;
    mean.spheres += 0.5 * across * (1.0 / shape.head_radius - 1.0 / shape.socket_radius);
    count += 1.0;
  }
  mean.measured /= count;
  mean.spheres /= count;
  return mean;
}

TEST(ErrorBudget, CentreStageIsOfSecondOrderForConcentricSpheres) {
  const MeanChange near = mean_change(1.0);
  const MeanChange far = mean_change(2.0);
  EXPECT_NEAR(std::log2(far.measured / near.measured), 2.0, 0.1);
  EXPECT_NEAR(near.measured / near.spheres, 1.0, 0.05);
}

TEST(FaceSagittas, AreThoseOfASphere) {
  const TriangleMesh sphere = icosphere(25.0, 3);
  const std::vector<double> sagittas = face_sagittas(sphere);
  for (std::size_t f = 0; f < sphere.faces.size(); ++f) {
    const Vec3& a = sphere.vertices[sphere.faces[f][0]];
    const Vec3& b = sphere.vertices[sphere.faces[f][1]];
    const Vec3& c = sphere.vertices[sphere.faces[f][2]];
    const Vec3 normal = (b - a).cross(c - a).normalized();
    const double exact = 25.0 - normal.dot(a);  // from the circumcentre to the sphere
    EXPECT_GT(sagittas[f], 0.9 * exact);
    EXPECT_LT(sagittas[f], 1.6 * exact);
  }
}

}  // namespace
}  // namespace impinge::lab
