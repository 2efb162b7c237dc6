// SPDX-License-Identifier: GPL-3.0-or-later
// A sphere whose centre moves away from the centre of rotation, until that is on the surface and beyond it.
#include <array>
#include <cmath>
#include <vector>

#include "mesh/icosphere.hpp"
#include "mesh/star_shape.hpp"
#include "sphere/uniform_directions.hpp"
#include "stress/family.hpp"
#include "stress/measure.hpp"

namespace impinge::lab {
namespace {

constexpr double kOffCentreOriginRadius = 22.0;  // mm
constexpr std::array kOffsets{0.0, 0.5, 0.9, 0.99, 0.9999, 0.999999, 1.0, 1.5};

// Shifted towards a vertex, since only there a polyhedron reaches the sphere. Vertex 7 is on no axis.
TriangleMesh off_centre(double offset, std::size_t halvings) {
  TriangleMesh mesh = icosphere(kOffCentreOriginRadius, halvings);
  const Vec3 origin = offset * mesh.vertices[7];
  for (Vec3& v : mesh.vertices) v -= origin;
  return mesh;
}

// Half of them are close to the direction in which the surface is near and steep.
std::vector<Vec3> directions_towards(const Vec3& near, double offset, std::size_t count) {
  std::vector<Vec3> directions = uniform_directions(count / 2, 21);
  const double angle = std::fmax(1.0 - offset, 1e-7);
  for (const Vec3& aside : uniform_directions(count / 2, 22))
    directions.push_back((near + 4.0 * angle * aside).normalized());
  return directions;
}

// Is it reported that the origin is no longer inside?
StabilityCase star_shape_case(const TriangleMesh& mesh, double offset) {
  StabilityCase row;
  row.magnitude = offset;
  row.method = "star_shape";
  row.kind = "ours";
  row.questions = 1;
  const StarShapeReport report = star_shape(mesh);
  if (report.star_shaped != (offset < 1.0)) row.wrong = 1;
  if (!report.star_shaped) row.refused = describe(report);
  return row;
}

std::vector<StabilityCase> run_off_centre_origin(const StabilityRun& options) {
  const std::size_t halvings = options.quick ? 1 : 2;
  const Vec3 towards = icosphere(1.0, halvings).vertices[7];
  MeasureOptions with_flaw = measure_options(options);
  with_flaw.flaw = Flaw::behind;
  std::vector<StabilityCase> rows;
  for (const double offset : kOffsets) {
    StabilityScene scene;
    scene.mesh = off_centre(offset, halvings);
    scene.directions = directions_towards(towards, offset, options.quick ? 100 : 1000);
    rows.push_back(star_shape_case(scene.mesh, offset));
    const std::vector<StabilityCase> measured = measure(scene, offset, with_flaw);
    rows.insert(rows.end(), measured.begin(), measured.end());
  }
  return rows;
}

}  // namespace

StabilityFamily off_centre_origin_family() {
  StabilityFamily family;
  family.name = "off_centre_origin";
  family.parameter = "distance of the centre of rotation from the middle of a sphere, over its radius";
  family.unit = "1";
  family.expected =
      "errors at entries grow with the condition alone, about 1 / (1 - offset), and look-ups stay below "
      "their bound, "
      "which grows likewise; on the surface and outside of it the mesh is told not to be star-shaped, the "
      "nearest "
      "layer is kept and no bound is claimed that does not hold";
  family.threshold = kRadiusThreshold;
  family.derivation = kRadiusDerivation;
  family.mutation = describe(Flaw::behind);
  family.seen = {4.3, 0.92};
  family.run = run_off_centre_origin;
  return family;
}

}  // namespace impinge::lab
