// SPDX-License-Identifier: GPL-3.0-or-later
// @question  What does each stage from the true surface to the stored number add to the error of a gap?
// @writes    error_budget
// @writes-with-bones  error_budget_bones
// @timing    no
// @seconds   2 40
// @links     harness real_joints table hip reference
//
// The generated pair has a formula, so the error of its mesh is measured; for a real joint it is estimated
// from the angles between its faces. The wrong centre is that of a sphere fitted to the ball; the true centre
// is that of the pair, or of the joint's subject.json.

#include <array>

#include "04_error_budget/error_budget.hpp"
#include "harness/driver.hpp"
#include "harness/real_joints.hpp"
#include "hip/sphere_fit.hpp"
#include "mesh/generated_pair.hpp"
#include "sphere/scheme.hpp"
#include "sphere/scheme_list.hpp"

namespace {

using namespace impinge;
using namespace impinge::lab;

constexpr std::array kPrecisions{1.0, 0.5, 0.1};  // degrees
constexpr double kFinestInQuick = 0.5;
constexpr std::size_t kFaces = 12000;

struct AddScheme {
  const DriverRun& run;
  const BudgetJoint& joint;
  const std::vector<Stage>& exact;
  Table& table;

  template <SamplingScheme S>
  void operator()() const {
    for (const double precision : kPrecisions) {
      if (run.quick() && precision < kFinestInQuick) continue;
      const auto scheme = scheme_of_precision<S>(precision);
      if (!scheme) continue;
      for (const StoredStages& stored : table_stages(joint, *scheme)) {
        std::vector<Stage> stages = exact;
        stages.insert(stages.end(), stored.stages.begin(), stored.stages.end());
        add_budget(table, {joint.name, S::name, precision, stored.storage}, stages);
      }
    }
  }
};

Result budget_of(DriverRun& run, const char* name, std::vector<BudgetJoint> joints) {
  Result result{name,
                "What does each stage from the true surface to the stored number add to the error of a gap?",
                budget_table()};
  for (BudgetJoint& joint : joints) {
    joint.wrong_centre = fit_ball(joint.meshes.ball).centre;
    result.parameters["centre_off_mm_" + joint.name] = joint.wrong_centre.norm();
    add_sagittas(result.table, joint.name, face_sagittas(joint.meshes.socket));
    for_each_scheme(AddScheme{run, joint, exact_stages(joint), result.table});
    run.progress.say("measured " + joint.name);
  }
  return result;
}

void body(DriverRun& run) {
  const PairShape shape;
  const auto socket_radius = [&shape](const Vec3& u) {
    const bool open = angle_between(u, Vec3::UnitZ()) > shape.half_opening_deg * kDegree;
    return open ? kNoSurface : shape.socket_radius;
  };
  run.write(budget_of(run, "error_budget",
                      {{"generated", make_ball_socket_pair(kFaces, shape), Vec3::Zero(), socket_radius}}));
  if (!run.bones) return;
  std::vector<BudgetJoint> real;
  for (const RealJoint& joint : read_real_joints(*run.bones, run.progress))
    real.push_back({joint.subject, joint.meshes, Vec3::Zero(), {}});
  run.write(budget_of(run, "error_budget_bones", std::move(real)));
}

}  // namespace

int main(int argc, char** argv) {
  return impinge::lab::run_driver(argc, argv,
                                  {"04_error_budget", "Error budget of a gap, stage by stage (Section 3.5).",
                                   /*takes_bones=*/true},
                                  body);
}
