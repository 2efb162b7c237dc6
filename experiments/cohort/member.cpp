// SPDX-License-Identifier: GPL-3.0-or-later
#include "cohort/member.hpp"

#include <stdexcept>

#include <gsl/gsl_cdf.h>

#include "harness/provenance.hpp"
#include "harness/real_joints.hpp"
#include "hip/hip.hpp"
#include "hip/hip_checks.hpp"
#include "hip/hip_surface.hpp"

namespace impinge::lab {
namespace {

BallSocketPair meshes_of(const HipParameters& parameters, std::size_t faces) {
  Hip hip = make_hip(parameters, faces);
  return {std::move(hip.ball), std::move(hip.socket)};
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
  Progress silent("cohort", nullptr);
  for (const RealJoint& joint : read_real_joints(study.joints, silent)) {
    if (joint.subject.find_first_of(",\"\r\n") != std::string::npos)
      throw std::runtime_error(study.joints.string() +
                               ": a folder in it has a comma, a quote or a line end in "
                               "its name, which a row cannot hold; rename it");
    joints_.push_back({joint.subject, in_joint_frame(joint), joint.side});
  }
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
