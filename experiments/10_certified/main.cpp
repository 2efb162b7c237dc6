// SPDX-License-Identifier: GPL-3.0-or-later
// @question  Are certified verdicts ever wrong, how much do they leave undecided, and what do vertices miss?
// @writes    certified certified_poses
// @bones     yes
// @timing    yes
// @seconds   15 400
// @links     harness contact_poses real_joints methods reference
//
// Poses of the generated pair and of real joints, most of them within 0.3 mm of the first contact. The oracle
// clips every face against every shadow in exact arithmetic (reference/shadow.hpp), CGAL's tree looks for
// common points. A wrong verdict fails the run and leaves its pose in certified_witness.json.

#include <array>

#include "10_certified/certified_study.hpp"
#include "harness/driver.hpp"
#include "harness/real_joints.hpp"
#include "mesh/generated_pair.hpp"
#include "sphere/scheme.hpp"
#include "sphere/scheme_list.hpp"

namespace {

using namespace impinge;
using namespace impinge::lab;

struct Generated {
  std::size_t faces;
  std::size_t quick;  // poses
  std::size_t full;
};

constexpr std::array kGenerated{Generated{100, 200, 65000}, Generated{300, 60, 30000},
                                Generated{1000, 12, 4600}, Generated{3000, 4, 400}};
constexpr std::array kPrecisions{4.0, 2.0, 1.0, 0.5};  // degrees
constexpr double kFinestInQuick = 2.0;
constexpr double kFinestOfReal = 2.0;  // joints of many faces
constexpr std::size_t kStep = 3;       // in the full run each scheme and precision scans every third pose
constexpr std::size_t kRealPoses = 64;
constexpr std::size_t kRealPosesInQuick = 4;

struct JudgeScheme {
  DriverRun& run;
  CertifiedStudy& study;
  const CertifiedJoint& joint;
  double finest;

  template <SamplingScheme S>
  void operator()() const {
    const std::size_t step = run.quick() ? 1 : kStep;
    for (std::size_t k = 0; k < kPrecisions.size(); ++k) {
      const double precision = kPrecisions[k];
      if (precision < finest) continue;
      const auto scheme = scheme_of_precision<S>(precision);
      if (!scheme) continue;
      add_scheme_row(study, joint, S::name, precision, judge_scheme(study, joint, *scheme, {k % step, step}));
    }
  }
};

void judge_all(DriverRun& run, CertifiedStudy& study, const std::string& name, const BallSocketPair& meshes,
               const ContactOptions& options, double finest) {
  const CertifiedJoint joint = judge_joint(study, name, meshes, options);
  for_each_scheme(JudgeScheme{run, study, joint, finest});
  run.progress.say("judged " + std::to_string(options.count) + " poses of " + name);
}

void judge_generated(DriverRun& run, CertifiedStudy& study) {
  for (const Generated& pair : kGenerated) {
    ContactOptions options;
    options.seed = run.record.seed;
    options.count = run.quick() ? pair.quick : pair.full;
    judge_all(run, study, "generated_" + std::to_string(pair.faces),
              make_ball_socket_pair(pair.faces, impinging_cam()), options,
              run.quick() ? kFinestInQuick : kPrecisions.back());
  }
}

void judge_real(DriverRun& run, CertifiedStudy& study) {
  ContactOptions options;
  options.seed = run.record.seed;
  options.count = run.quick() ? kRealPosesInQuick : kRealPoses;
  for (const RealJoint& joint : read_real_joints(*run.bones, run.progress))
    judge_all(run, study, joint.subject, joint.meshes, options,
              run.quick() ? kPrecisions.front() : kFinestOfReal);
}

void body(DriverRun& run) {
  CertifiedStudy study = make_certified_study(run.record.folder);
  judge_generated(run, study);
  if (run.bones) judge_real(run, study);
  require_none_wrong(study);
  Result result{"certified",
                "Are certified verdicts on vertices ever wrong, and how many are left undecided?",
                std::move(study.schemes)};
  result.parameters = {{"poses", "three of four within 10^-5 to 10^-0.5 mm of the first contact"},
                       {"oracle", "clipping by intervals and rationals, all pairs of faces"}};
  run.write(result);
  result.name = "certified_poses";
  result.question = "Are certified verdicts on surfaces ever wrong, and what do scans of vertices miss?";
  result.table = std::move(study.poses);
  run.write(result);
}

}  // namespace

int main(int argc, char** argv) {
  return impinge::lab::run_driver(
      argc, argv, {"10_certified", "Certified verdicts against an exact oracle.", /*takes_bones=*/true},
      body);
}
