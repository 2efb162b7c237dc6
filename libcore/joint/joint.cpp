// SPDX-License-Identifier: GPL-3.0-or-later
#include "joint/joint.hpp"

#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <utility>

#include "files/file_error.hpp"
#include "joint/arrangement.hpp"
#include "joint/length_unit.hpp"

namespace impinge {
namespace {

// A ball beside its centre fills less than half of the view and sums to no solid angle. A closed ball round
// the centre sums to 4 pi; a shell of cartilage sums to 0 and is known by the view it fills.
constexpr double kHalfOfTheView = 0.5;
constexpr double kHalfOfTheSphere = 2.0 * kPi;

[[noreturn]] void refuse_mesh(const NamedMesh& mesh, const std::string& reason) {
  throw std::runtime_error(mesh.name + ": " + reason);
}

std::string text_of(const Vec3& x) {
  char text[96];
  std::snprintf(text, sizeof text, "%.3f,%.3f,%.3f", x.x(), x.y(), x.z());
  return text;
}

JointPart examine(TriangleMesh mesh, const Vec3& centre) {
  JointPart part;
  part.validation = validate(mesh);
  part.mesh = relative_to(std::move(mesh), centre);
  part.star_shape = star_shape(part.mesh);
  return part;
}

// Finds the centre where it is not given.
void place_centre(const JointInput& input, Joint& joint) {
  if (input.centre) {
    joint.centre = *input.centre;
    return;
  }
  try {
    joint.fit = fit_ball(input.ball.mesh);
  } catch (const std::invalid_argument& error) {
    refuse_mesh(input.ball, error.what() + ("; give the centre " + input.wording.centre));
  }
  joint.centre = joint.fit->centre;
}

void require_centre_inside(const JointInput& input, const Joint& joint) {
  const StarShapeReport& ball = joint.ball.star_shape;
  if (std::abs(ball.solid_angle) < kHalfOfTheSphere && ball.covered < kHalfOfTheView) {
    char share[16];
    std::snprintf(share, sizeof share, "%.0f", 100.0 * ball.covered);
    refuse_mesh(input.ball,
                std::string("fills only ") + share + " % of the view from the centre " +
                    text_of(joint.centre) +
                    ", so the centre lies outside of the ball or the mesh is a small part of one; "
                    "give a centre inside " +
                    input.wording.centre + ", or check that the files are not swapped and in mm");
  }
  if (joint.socket.star_shape.covered == 0.0) {
    refuse_mesh(input.socket, "no direction from the centre " + text_of(joint.centre) +
                                  " meets the socket; check that both meshes are in one frame and in mm");
  }
}

void check_units(const JointInput& input, Joint& joint) {
  const Reach ball = reach_of(joint.ball.mesh);
  const std::string apart = different_units(ball, reach_of(joint.socket.mesh));
  if (!apart.empty()) refuse_mesh(input.socket, apart);
  const std::string doubt = doubtful_unit(ball);
  if (!doubt.empty()) joint.warnings.push_back(input.ball.name + ": " + doubt);
}

void check_arrangement(const JointInput& input, Joint& joint) {
  if (look_swapped(joint.ball.mesh, joint.socket.mesh)) {
    throw FileError(input.ball.name, "lies outside of the socket and does not close about the centre",
                    "check that " + input.wording.meshes + " are not swapped");
  }
  if (!input.side) return;
  TriangleMesh socket = joint.socket.mesh;
  const Eigen::Matrix3d axes = input_to_joint(input.axes);
  for (Vec3& x : socket.vertices) x = axes * x;
  if (!looks_lateral(socket, *input.side)) return;
  const std::string side = *input.side == Side::right ? "right" : "left";
  joint.warnings.push_back(input.socket.name + ": lies to the " + side + " of the ball, which no " + side +
                           " socket does; check " + input.wording.side);
}

void warn(const JointPart& part, const std::string& name, const std::string& policy, Joint& joint) {
  const MeshReport& report = part.validation;
  if (report.degenerate_faces + report.duplicate_faces + report.flipped_faces + report.non_manifold_edges +
          report.unreferenced_vertices >
      0) {
    std::string found = describe(report);
    for (char& c : found) c = c == '\n' ? ' ' : c;
    joint.warnings.push_back(name + ": " + found);
  }
  if (!part.star_shape.star_shaped) {
    joint.warnings.push_back(name + ": " + describe(part.star_shape) + "; " + policy);
  }
}

}  // namespace

Joint assemble_joint(JointInput input) {
  Joint joint;
  place_centre(input, joint);
  joint.ball = examine(std::move(input.ball.mesh), joint.centre);
  joint.socket = examine(std::move(input.socket.mesh), joint.centre);
  require_centre_inside(input, joint);
  check_units(input, joint);
  check_arrangement(input, joint);
  warn(joint.ball, input.ball.name, "the outermost layer stands for the ball", joint);
  warn(joint.socket, input.socket.name, "the layer nearest to the centre stands for the socket", joint);
  return joint;
}

}  // namespace impinge
