// SPDX-License-Identifier: GPL-3.0-or-later
#include "cohort/member.hpp"

#include <stdexcept>

#include <gsl/gsl_cdf.h>

#include "harness/provenance.hpp"
#include "hip/hip.hpp"
#include "hip/hip_checks.hpp"
#include "hip/hip_surface.hpp"
#include "hip/joint.hpp"
#include "mesh/declared_axes.hpp"
#include "mesh/io.hpp"

namespace impinge::lab {
namespace {

BallSocketPair meshes_of(const HipParameters& parameters, std::size_t faces) {
  Hip hip = make_hip(parameters, faces);
  return {std::move(hip.ball), std::move(hip.socket)};
}

std::string files_digest(const JointFolder& at) {
  const std::filesystem::path said = at.ball.parent_path() / "subject.json";
  return sha256_of_file(at.ball) + sha256_of_file(at.socket) +
         (std::filesystem::exists(said) ? sha256_of_file(said) : "");
}

constexpr std::size_t kAttempts = 100;

HipParameters drawn(const Study& study, std::size_t j, std::size_t attempt) {
  const std::size_t count = study.spreads.size();
  Eigen::VectorXd scores(static_cast<Eigen::Index>(count));
  for (std::size_t k = 0; k < count; ++k) {
    const double u = uniform_draw(study.seed, std::string(study.spreads[k].parameter->name), j, attempt);
    scores[static_cast<Eigen::Index>(k)] = gsl_cdf_ugaussian_Pinv(u);
  }
  scores = study.mixing * scores;
  HipParameters parameters = study.start;
  for (std::size_t k = 0; k < count; ++k)
    parameters.*study.spreads[k].parameter->value =
        value_at(study.spreads[k], scores[static_cast<Eigen::Index>(k)]);
  return parameters;
}

}  // namespace

Members::Members(const Study& study) : study_(study) {
  if (study.joints.empty()) return;
  if (!std::filesystem::is_directory(study.joints))
    throw std::runtime_error(study.joints.string() + ": no folder; give that of the joints in the study");
  const JointFolders found = find_joints(study.joints);
  left_out_ = found.left_out;
  for (const JointFolder& at : found.joints) {
    if (at.subject.find_first_of(",\"\r\n") != std::string::npos)
      throw std::runtime_error(study.joints.string() +
                               ": a folder in it has a comma, a quote or a line end in "
                               "its name, which a row cannot hold; rename it");
    try {
      joints_.push_back(joint_of(at));
      digest_ += at.subject + files_digest(at) + "\n";
    } catch (const std::runtime_error& error) {
      left_out_.push_back(at.subject + ": " + error.what());
    }
  }
  if (joints_.empty())
    throw std::runtime_error(study.joints.string() + ": none of its joints can be used, the first because " +
                             left_out_.front());
  digest_ = sha256_hex(digest_);
}

// A joint as `impinge limits --joints` takes it.
Members::Named Members::joint_of(const JointFolder& at) {
  if (at.landmarks || !at.ball_parts.empty() || !at.socket_parts.empty())
    throw std::runtime_error(
        "its subject.json has landmarks or parts, of which a row knows nothing; leave them out");
  JointInput input{.ball = {at.ball.string(), read_mesh(at.ball)},
                   .socket = {at.socket.string(), read_mesh(at.socket)},
                   .centre = at.centre,
                   .side = at.side,
                   .axes = agreed_axes_of({at.ball, at.socket}, at.axes, "\"axes\"").code,
                   .wording = {"in subject.json", "ball and socket", "axes, then side, in subject.json", ""}};
  const Joint joint = assemble_joint(input);
  require_mm(joint, input.ball.name);
  if (joint.has_parts())
    throw std::runtime_error(
        "it is of whole bones, and a row is about the surfaces of a joint; cut them "
        "(experiments/real_joints)");
  for (const std::string& warning : joint.warnings) warnings_.push_back(at.subject + ": " + warning);
  const Eigen::Matrix3d axes = input_to_joint(joint.axes);
  Named named{at.subject, {joint.ball.mesh, joint.socket.mesh}, at.side};
  for (TriangleMesh* mesh : {&named.meshes.ball, &named.meshes.socket}) {
    for (Vec3& x : mesh->vertices) x = axes * x;
  }
  return named;
}

std::size_t Members::size() const { return study_.joints.empty() ? study_.hips : joints_.size(); }

std::vector<Column> Members::description_columns() const {
  if (!study_.joints.empty()) return {{"joint", "", "folder of the joint"}};
  std::vector<Column> columns;
  for (const Spread& spread : study_.spreads)
    columns.push_back({std::string(spread.parameter->name), std::string(spread.parameter->unit), "as drawn"});
  columns.insert(columns.end(), {{"alpha_3_00", "deg", "of the smooth surface at 3:00 about the neck"},
                                 {"alpha_1_30", "deg", "the same at 1:30"},
                                 {"redrawn", "1", "draws before that make no hip"}});
  return columns;
}

Member Members::member(std::size_t j) const {
  Member member = study_.joints.empty() ? drawn(j) : read(j);
  member.volume = study_.questions.volume && j % study_.questions.volume_every == 0;
  return member;
}

Member Members::read(std::size_t j) const {
  const Named& joint = joints_.at(j);
  return {joint.meshes, joint.side, {joint.name}, std::nullopt};
}

Member Members::drawn(std::size_t j) const {
  const DrawnHip hip = draw_hip(study_, j);
  Member member{meshes_of(hip.parameters, study_.faces), hip.parameters.side, {}, std::nullopt};
  for (const Spread& spread : study_.spreads)
    member.description.emplace_back(hip.parameters.*spread.parameter->value);
  HipParameters right = hip.parameters;
  right.side = Side::right;
  const HipSurface surface = hip_surface(right);
  for (const double hours : {3.0, 1.5}) member.description.emplace_back(alpha_angle_deg(surface, hours));
  member.description.emplace_back(hip.redrawn);
  if (study_.check_every > 0 && j % study_.check_every == 0)
    member.fine = meshes_of(hip.parameters, study_.check_faces);
  return member;
}

double uniform_draw(std::uint64_t seed, const std::string& tag, std::size_t hip, std::size_t attempt) {
  const std::string text =
      std::to_string(seed) + "/" + tag + "/" + std::to_string(hip) + "/" + std::to_string(attempt);
  const std::uint64_t digits = std::stoull(sha256_hex(text).substr(0, 13), nullptr, 16);
  return (static_cast<double>(digits) + 0.5) * 0x1p-52;
}

DrawnHip draw_hip(const Study& study, std::size_t j) {
  std::string why;
  for (std::size_t attempt = 0; attempt < kAttempts; ++attempt) {
    const HipParameters parameters = drawn(study, j, attempt);
    try {
      HipParameters right = parameters;
      right.side = Side::right;
      require_free_at_rest(hip_surface(right));
      return {parameters, attempt};
    } catch (const std::invalid_argument& error) {
      why = error.what();
    }
  }
  throw std::runtime_error("hip " + std::to_string(j) + ": " + std::to_string(kAttempts) +
                           " draws make no hip, the last one because " + why +
                           "; narrow the distributions of the study");
}

}  // namespace impinge::lab
