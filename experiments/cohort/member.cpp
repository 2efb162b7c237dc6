// SPDX-License-Identifier: GPL-3.0-or-later
#include "cohort/member.hpp"

#include <stdexcept>

#include "cohort/draw.hpp"
#include "harness/real_joints.hpp"
#include "hip/hip.hpp"
#include "hip/hip_surface.hpp"

namespace impinge::lab {
namespace {

BallSocketPair meshes_of(const HipParameters& parameters, std::size_t faces) {
  Hip hip = make_hip(parameters, faces);
  return {std::move(hip.ball), std::move(hip.socket)};
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

}  // namespace impinge::lab
