// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/joint.hpp"

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <system_error>

#include "mesh/io.hpp"
#include "scene/arrangement.hpp"
#include "scene/cartilage_file.hpp"
#include "scene/length_unit.hpp"

namespace impinge {
namespace {

// A ball beside its centre fills less than half of the view and sums to no solid angle. A closed ball round
// the centre sums to 4 pi; a shell of cartilage sums to 0 and is known by the view it fills.
constexpr double kHalfOfTheView = 0.5;
constexpr double kHalfOfTheSphere = 2.0 * kPi;

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

// The output has fixed names; in the folder of the input it could replace it.
void require_other_folder(const SceneOptions& options) {
  for (const std::filesystem::path& input : {options.ball, options.socket}) {
    for (const char* name : {"ball.ply", "socket.ply"}) {
      std::error_code ignored;
      if (std::filesystem::equivalent(input, options.out / name, ignored)) {
        throw std::runtime_error(input.string() +
                                 ": would be replaced by the output; choose another folder with --out");
      }
    }
  }
}

// A joint has two surfaces: given twice, one of the names is a slip.
void require_two_files(const SceneOptions& options) {
  std::error_code ignored;  // the reader says what is wrong with a file
  if (!std::filesystem::equivalent(options.ball, options.socket, ignored)) return;
  throw FileError(options.socket, "is the mesh of the ball and of the socket",
                  "give two files with --ball and --socket");
}

void require_centre_inside(const Joint& joint, const SceneOptions& options) {
  const StarShapeReport& ball = joint.ball.star_shape;
  if (std::abs(ball.solid_angle) < kHalfOfTheSphere && ball.covered < kHalfOfTheView) {
    char share[16];
    std::snprintf(share, sizeof share, "%.0f", 100.0 * ball.covered);
    throw std::runtime_error(
        options.ball.string() + ": fills only " + share + " % of the view from the centre " +
        text_of(joint.centre) +
        ", so the centre lies outside of the ball or the mesh is a small part of one; give a "
        "centre inside with --centre X,Y,Z, or check that the files are not swapped and in mm");
  }
  if (joint.socket.star_shape.covered == 0.0) {
    throw std::runtime_error(options.socket.string() + ": no direction from the centre " +
                             text_of(joint.centre) +
                             " meets the socket; check that both meshes are in one frame and in mm");
  }
}

void check_units(const SceneOptions& options, Joint& joint) {
  const Reach ball = reach_of(joint.ball.mesh);
  const std::string apart = different_units(ball, reach_of(joint.socket.mesh));
  if (!apart.empty()) throw std::runtime_error(options.socket.string() + ": " + apart);
  const std::string doubt = doubtful_unit(ball);
  if (!doubt.empty()) joint.warnings.push_back(options.ball.string() + ": " + doubt);
}

void check_arrangement(const SceneOptions& options, Joint& joint) {
  if (look_swapped(joint.ball.mesh, joint.socket.mesh)) {
    throw FileError(options.ball, "lies outside of the socket and does not close about the centre",
                    "check that the files of --ball and --socket are not swapped");
  }
  if (!options.side) return;
  TriangleMesh socket = joint.socket.mesh;
  const Eigen::Matrix3d axes = input_to_joint(options.axes);
  for (Vec3& x : socket.vertices) x = axes * x;
  if (!looks_lateral(socket, *options.side)) return;
  const std::string side = *options.side == Side::right ? "right" : "left";
  joint.warnings.push_back(options.socket.string() + ": lies to the " + side + " of the ball, which no " +
                           side + " socket does; check --side and --axes");
}

void warn(const JointPart& part, const std::string& file, const std::string& policy, Joint& joint) {
  const MeshReport& report = part.validation;
  if (report.degenerate_faces + report.duplicate_faces + report.flipped_faces + report.non_manifold_edges +
          report.unreferenced_vertices >
      0) {
    std::string found = describe(report);
    for (char& c : found) c = c == '\n' ? ' ' : c;
    joint.warnings.push_back(file + ": " + found);
  }
  if (!part.star_shape.star_shaped) {
    joint.warnings.push_back(file + ": " + describe(part.star_shape) + "; " + policy);
  }
}

}  // namespace

Joint load_joint(const SceneOptions& options) {
  require_other_folder(options);
  require_two_files(options);
  TriangleMesh ball = read_mesh(options.ball);
  TriangleMesh socket = read_mesh(options.socket);
  Joint joint;
  if (options.centre) {
    joint.centre = *options.centre;
  } else {
    try {
      joint.fit = fit_ball(ball);
    } catch (const std::invalid_argument& error) {
      throw std::runtime_error(options.ball.string() + ": " + error.what() +
                               "; give the centre with --centre X,Y,Z");
    }
    joint.centre = joint.fit->centre;
  }
  joint.ball = examine(std::move(ball), joint.centre);
  joint.socket = examine(std::move(socket), joint.centre);
  require_centre_inside(joint, options);
  check_units(options, joint);
  check_arrangement(options, joint);
  if (options.cartilage_map) joint.cartilage = read_cartilage(*options.cartilage_map, joint.centre);
  warn(joint.ball, options.ball.string(), "the outermost layer stands for the ball", joint);
  warn(joint.socket, options.socket.string(), "the layer nearest to the centre stands for the socket", joint);
  return joint;
}

}  // namespace impinge
