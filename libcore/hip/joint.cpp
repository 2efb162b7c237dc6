// SPDX-License-Identifier: GPL-3.0-or-later
#include "hip/joint.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <stdexcept>
#include <utility>

#include "files/file_error.hpp"
#include "files/formatted.hpp"
#include "files/thread_team.hpp"
#include "gap/surface.hpp"
#include "hip/arrangement.hpp"
#include "hip/length_unit.hpp"
#include "hip/whole_bone.hpp"
#include "mesh/edges.hpp"
#include "mesh/mesh_pieces.hpp"
#include "mesh/surface_vertices.hpp"
#include "mesh/weld.hpp"

namespace impinge {
namespace {

// Seen from its centre, a closed ball has a solid angle of 4 pi and a closed shell of cartilage 0. One that
// fills less than half of the view is a cap, or lies beside its centre.
constexpr double kHalfOfTheView = 0.5;
constexpr double kHalfOfTheSphere = 2.0 * kPi;
// mm between the surfaces as scanned: both layers of cartilage have 3 to 5.
constexpr double kFarApart = 12.0;
// Share of all directions: 7 mm^2 on a head of 24 mm. Below it are folds of a segmentation, as every real
// head has them (0.007 to 0.06 %); no gap that matters is read there.
constexpr double kFewRays = 0.001;
// How far a given centre may be from that of the sphere that fits the ball: mm, or a share of its radius.
constexpr double kOffCentre = 5.0;
constexpr double kOffCentreShare = 0.25;

[[noreturn]] void refuse_mesh(const NamedMesh& mesh, const std::string& reason) {
  throw std::runtime_error(mesh.name + ": " + reason);
}

std::string text_of(const Vec3& x) { return formatted("%.3f,%.3f,%.3f", x.x(), x.y(), x.z()); }

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

bool is_cap(const StarShapeReport& ball) {
  return std::abs(ball.solid_angle) < kHalfOfTheSphere && ball.covered < kHalfOfTheView;
}

// A given centre is taken, whatever sphere fits; this warns where the two differ.
void check_centre(const JointInput& input, Joint& joint) {
  if (joint.fit || is_cap(joint.ball.star_shape)) return;
  try {
    const SphereFit fit = fit_ball(joint.ball.mesh);
    const double off = fit.centre.norm();
    if (off <= std::min(kOffCentre, kOffCentreShare * fit.radius)) return;
    joint.warnings.push_back(input.ball.name + ": the centre that was given, " + text_of(joint.centre) +
                             formatted(", is %.1f mm from ", off) + text_of(joint.centre + fit.centre) +
                             formatted(", that of the sphere of radius %.1f mm that fits the ball; "
                                       "check it, or leave it out",
                                       fit.radius));
  } catch (const std::invalid_argument&) {  // no sphere fits it
  }
}

// The sphere that fits a ball, or all of a cap that is too small for that.
SphereFit fit_cap(const TriangleMesh& mesh) {
  try {
    return fit_ball(mesh);
  } catch (const std::invalid_argument&) {
    return fit_sphere(mesh.vertices, vertex_areas(mesh));
  }
}

// Why a given centre cannot be the centre of a cap; empty where it can. A fitted centre always can.
std::string refused_centre(const Joint& joint) {
  if (joint.fit) return {};
  try {
    const SphereFit fit = fit_cap(joint.ball.mesh);
    return fit.centre.norm() < fit.radius ? "" : "which lies outside of the ball";
  } catch (const std::invalid_argument&) {
    return "and no sphere fits it";
  }
}

// A joint has two surfaces: the same mesh for both is a slip, whatever the names of the files.
void require_two_meshes(const JointInput& input) {
  if (input.ball.mesh.vertices != input.socket.mesh.vertices ||
      input.ball.mesh.faces != input.socket.mesh.faces)
    return;
  throw FileError(input.socket.name, "is the mesh of the ball and of the socket",
                  "check " + input.wording.meshes);
}

// A cap answers for the directions it covers; a ball beside the centre is refused.
void check_view(const JointInput& input, Joint& joint) {
  const StarShapeReport& ball = joint.ball.star_shape;
  const bool cap = is_cap(ball);
  const std::string share = formatted("%.0f %% of the view from the centre ", 100.0 * ball.covered);
  const std::string refused = cap ? refused_centre(joint) : "";
  if (!refused.empty()) {
    refuse_mesh(input.ball, "fills only " + share + text_of(joint.centre) + ", " + refused +
                                "; give a centre inside " + input.wording.centre +
                                ", or check that the files are not swapped and in mm");
  }
  if (joint.socket.star_shape.covered == 0.0) {
    refuse_mesh(input.socket, "no direction from the centre " + text_of(joint.centre) +
                                  " meets the socket; check that both meshes are in one frame and in mm");
  }
  if (cap)
    joint.warnings.push_back(input.ball.name + ": is a cap, " + share + text_of(joint.centre) +
                             "; beyond its edge there is no gap and no contact");
}

void add_doubt(Joint& joint, const std::string& doubt) {
  joint.warnings.insert(joint.warnings.begin() + static_cast<std::ptrdiff_t>(joint.doubts++), doubt);
}

void check_units(const JointInput& input, const Facing& found, Joint& joint) {
  const std::string apart =
      different_units(reach_of(joint.ball.mesh), reach_of(joint.socket.mesh), found.ratio);
  if (!apart.empty()) refuse_mesh(input.socket, apart);
  const std::string doubt = doubtful_unit(found.ball_radius);
  if (!doubt.empty()) {
    add_doubt(joint, input.ball.name + ": " + doubt);
  } else if (found.nearest > kFarApart) {
    const std::string where = std::isfinite(found.nearest)
                                  ? formatted("is nowhere nearer to the ball than %.0f mm", found.nearest)
                                  : "shares no ray from the centre with the ball";
    add_doubt(joint, input.socket.name + ": " + where +
                         " as scanned, which no joint is; check that both meshes are in one frame");
  }
}

void check_arrangement(const JointInput& input, const Facing& found, Joint& joint) {
  if (look_swapped(found, is_cap(joint.ball.star_shape))) {
    throw FileError(input.ball.name, "lies outside of the socket and does not close about the centre",
                    "check that " + input.wording.meshes + " are not swapped");
  }
  if (!input.side) return;
  TriangleMesh socket = joint.socket.mesh;
  socket.vertices = mapped(input_to_joint(input.axes), socket.vertices);
  if (!looks_lateral(socket, *input.side)) return;
  const std::string side = *input.side == Side::right ? "right" : "left";
  add_doubt(joint, input.socket.name + ": lies to the " + side + " of the ball, which no " + side +
                       " socket does; check " + input.wording.side);
}

void warn_of_flaws(const MeshReport& report, const std::string& name, Joint& joint) {
  if (report.degenerate_faces + report.duplicate_faces + report.flipped_faces + report.non_manifold_edges +
          report.unreferenced_vertices ==
      0)
    return;
  std::string found = describe(report);
  for (char& c : found) c = c == '\n' ? ' ' : c;
  joint.warnings.push_back(name + ": " + found);
}

// Specks of a segmentation count as bone. The mesh is as it was given.
void warn_of_pieces(const TriangleMesh& mesh, const std::string& name, const JointWording& wording,
                    Joint& joint) {
  const std::vector<MeshPiece> pieces = mesh_pieces(mesh);
  if (pieces.size() < 2) return;
  joint.warnings.push_back(
      name + formatted(": has %zu pieces that do not hang together, ", pieces.size()) + sizes_text(pieces) +
      "; each counts as bone, and a speck of a segmentation can block all motion: remove what is no bone" +
      (wording.keep.empty() ? "" : ", or take the largest piece alone with " + wording.keep));
}

const std::string& name_of_part(const NamedMesh& of, std::size_t k) {
  return k < of.part_names.size() ? of.part_names[k] : of.name;
}

void warn_of_pieces(const NamedMesh& of, const JointWording& wording, Joint& joint) {
  warn_of_pieces(main_surface(of.mesh, of.parts), of.name, wording, joint);
  for (std::size_t k = 0; k < of.parts.size(); ++k)
    warn_of_pieces(part_surface(of.mesh, of.parts, k), name_of_part(of, k), wording, joint);
}

// Says which layer gaps are measured to where rays meet a surface more than once.
void warn_of_layers(const JointPart& part, const std::string& name, const std::string& layer, Joint& joint) {
  if (part.star_shape.violating < kFewRays) return;
  joint.warnings.push_back(name + ": " + describe(part.star_shape) + "; gaps are measured to the " + layer +
                           " layer along each ray, contact considers all surfaces");
}

// Returns the whole mesh, and leaves only the main surface behind.
NamedMesh take_whole(NamedMesh& of) {
  TriangleMesh main = main_surface(of.mesh, of.parts);
  return {of.name, std::exchange(of.mesh, std::move(main)), std::move(of.parts), of.part_names};
}

void add_parts(NamedMesh whole, JointPart& to, Joint& joint) {
  warn_of_flaws(to.validation, whole.name, joint);
  if (whole.parts.empty()) return;
  for (std::size_t k = 0; k < whole.parts.size(); ++k) {
    if (whole.parts[k].of_main) continue;  // was examined with the main surface
    const MeshReport report = validate(part_surface(whole.mesh, whole.parts, k));
    warn_of_flaws(report, name_of_part(whole, k), joint);
    to.validation += report;
  }
  to.mesh = relative_to(std::move(whole.mesh), joint.centre);
  to.parts = std::move(whole.parts);
  for (std::size_t f = to.parts.front().first_face; f < to.mesh.faces.size(); ++f)
    to.star_shape.edge_on += is_edge_on(to.mesh, to.mesh.faces[f]) ? 1U : 0U;
}

// Radius of the ball, mm; none if neither mesh is a whole bone or no sphere round the centre fits the ball.
std::optional<double> head_radius(const Joint& joint) {
  if (joint.fit) return joint.fit->radius;
  const double nearest = reach_of(joint.ball.mesh).nearest;  // no head has a smaller radius
  if (std::ranges::none_of(std::array{&joint.ball, &joint.socket}, [&](const JointPart* part) {
        return is_whole_bone(part->mesh, part->star_shape.violating, nearest);
      }))
    return std::nullopt;
  try {
    const SphereFit fit = fit_ball(joint.ball.mesh);
    return fit.centre.norm() < fit.radius ? std::optional(fit.radius) : std::nullopt;
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

// Makes the surface of the joint the main surface of a whole bone. False if the bone is said to be a ball but
// no head closes about the centre.
bool take_surface(Surface of, double radius, NamedMesh& whole, Joint& joint) {
  JointPart& part = of == Surface::ball ? joint.ball : joint.socket;
  if (!is_whole_bone(part.mesh, part.star_shape.violating, radius)) return true;
  const std::vector<bool> taken = faces_of_joint(part.mesh, of, radius);
  const auto faces = static_cast<std::size_t>(std::ranges::count(taken, true));
  if (faces == 0 || faces == taken.size()) return of == Surface::socket;
  NamedMesh split = whole;
  split_bone(split.mesh, split.parts, taken, "rest of " + std::filesystem::path(whole.name).stem().string());
  TriangleMesh main = relative_to(main_surface(split.mesh, split.parts), joint.centre);
  const StarShapeReport seen = star_shape(main);
  if (of == Surface::ball && std::abs(seen.solid_angle) < kHalfOfTheSphere) return false;
  split.part_names.insert(split.part_names.begin(), whole.name);
  whole = std::move(split);
  part.mesh = std::move(main);
  part.star_shape = seen;
  part.taken = TakenFaces{faces, taken.size(), kJointEnds * radius, {}};
  for (const bool first : {true, false}) {
    for (std::uint32_t f = 0; f < taken.size(); ++f) {
      if (taken[f] == first) part.taken->given.push_back(f);
    }
  }
  return true;
}

// A part was cut from the bone if the two share sides of their borders; then it continues the main surface.
void join_what_goes_on(JointPart& bone) {
  const auto border = [](const TriangleMesh& mesh) { return boundary_edges(weld(mesh)).size(); };
  for (std::size_t k = 0; k < bone.parts.size(); ++k) {
    if (bone.parts[k].of_main) continue;
    const std::size_t apart =
        border(whole_main(bone.mesh, bone.parts)) + border(part_surface(bone.mesh, bone.parts, k));
    bone.parts[k].of_main = true;
    if (border(whole_main(bone.mesh, bone.parts)) < apart) continue;
    bone.parts[k].of_main = false;
    return;  // parts of the main bone come first
  }
}

// Every point moves along its ray, so the surface looks the same from the centre.
void make_smaller(const JointInput& input, Joint& joint) {
  if (input.overlap_mm == 0.0) return;
  for (Vec3& x : joint.ball.mesh.vertices) {
    const double radius = x.norm();
    if (radius <= input.overlap_mm)
      refuse_mesh(input.ball,
                  formatted("has a point %.3g mm from the centre, which an overlap of %g mm takes "
                            "beyond it; give less",
                            radius, input.overlap_mm));
    x *= 1.0 - input.overlap_mm / radius;
  }
  joint.overlap_mm = input.overlap_mm;
}

}  // namespace

Joint assemble_joint(JointInput input) {
  require_two_meshes(input);
  Joint joint;
  for (const NamedMesh* bone : {&input.ball, &input.socket}) warn_of_pieces(*bone, input.wording, joint);
  NamedMesh ball = take_whole(input.ball);
  NamedMesh socket = take_whole(input.socket);
  joint.axes = input.axes;
  place_centre(input, joint);
  on_threads(kSurfaces.size(), [&](std::size_t k) {
    const bool of_ball = kSurfaces[k] == Surface::ball;
    (of_ball ? joint.ball : joint.socket) =
        examine(std::move((of_ball ? input.ball : input.socket).mesh), joint.centre);
  });
  const auto radius = head_radius(joint);
  if (radius && take_surface(Surface::ball, *radius, ball, joint))
    take_surface(Surface::socket, *radius, socket, joint);
  check_view(input, joint);
  check_centre(input, joint);
  const Facing found = facing(joint.ball.mesh, joint.socket.mesh);
  check_units(input, found, joint);
  check_arrangement(input, found, joint);
  add_parts(std::move(ball), joint.ball, joint);
  add_parts(std::move(socket), joint.socket, joint);
  warn_of_layers(joint.ball, input.ball.name, "outermost", joint);
  warn_of_layers(joint.socket, input.socket.name, "nearest", joint);
  join_what_goes_on(joint.ball);
  join_what_goes_on(joint.socket);
  make_smaller(input, joint);
  return joint;
}

Joint without_parts(Joint joint) {
  for (JointPart* part : {&joint.ball, &joint.socket}) {
    part->mesh = part->main();
    part->parts.clear();
  }
  return joint;
}

Joint with_whole_socket(Joint joint) {
  JointPart& socket = joint.socket;
  if (!socket.taken.has_value()) return joint;
  NamedMesh whole{"", whole_main(socket.mesh, socket.parts), {}};
  for (std::size_t k = 0; k < socket.parts.size(); ++k) {
    if (!socket.parts[k].of_main)
      append_part(whole.mesh, whole.parts, socket.parts[k].name, part_surface(socket.mesh, socket.parts, k));
  }
  socket.mesh = std::move(whole.mesh);
  socket.parts = std::move(whole.parts);
  socket.taken.reset();
  return joint;
}

void require_mm(const Joint& joint, const std::string& ball) {
  const std::string wrong = joint.fit ? wrong_unit(joint.fit->radius) : "";
  if (!wrong.empty()) throw std::runtime_error(ball + ": " + wrong);
}

void require_no_parts(const Joint& joint, const std::string& what) {
  for (const JointPart* bone : {&joint.ball, &joint.socket}) {
    for (const MeshPart& part : bone->parts) {
      if (part.of_main) continue;
      throw std::runtime_error(what + ": bone beside the joint, such as " + part.name +
                               ", is not taken into account here; leave it out");
    }
  }
}

void use_frames(Joint& joint, const AnatomicalFrames& frames) {
  joint.frames = frames;
  if (!frames.femur) return;
  std::vector<Vec3>& ball = joint.ball.mesh.vertices;
  ball = mapped(frames.pelvis.transpose() * *frames.femur, ball);
}

}  // namespace impinge
