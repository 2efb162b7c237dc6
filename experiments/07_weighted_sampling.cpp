// SPDX-License-Identifier: GPL-3.0-or-later
// @question  How well does the thesis' weighted sampling (Eq. 16) sample an acetabular cap?
// @writes    weighted_sampling weighted_sampling_samples
// @bones     yes
// @timing    yes
// @seconds   20 60
// @links     harness real_joints curves gap hip
//
// The axis of each cap is the axis of the table. The caps are Menschik's conchoid as a mesh, the sockets of
// the thesis' two stand-ins, and real sockets. The error is that of a gap: the radius of a look-up minus the
// mesh's, along random directions that meet the cap within 80 degrees of its axis.

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <memory>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "curves/conchoid.hpp"
#include "curves/weighted_rings.hpp"
#include "harness/driver.hpp"
#include "harness/real_joints.hpp"
#include "harness/timing.hpp"
#include "hip/hip.hpp"
#include "hip/hip_presets.hpp"
#include "mesh/generated_pair.hpp"
#include "sphere/schemes/conchoid.hpp"
#include "sphere/schemes/rsid.hpp"
#include "sphere/schemes/usid.hpp"
#include "sphere/uniform_directions.hpp"
#include "table/own_scheme.hpp"
#include "table/pairwise.hpp"

namespace {

using namespace impinge;
using namespace impinge::lab;

constexpr std::array kPrecisions{2.0, 1.0, 0.5};  // degrees
constexpr std::size_t kFaces = 12000;             // of a generated cap
constexpr std::size_t kAsked = 20000;             // directions
constexpr std::size_t kChecked = 500;             // entries of a table that are checked before it is used
constexpr double kRounding = 1e-9;                // mm
const double kEdge = std::cos(80.0 * kDegree);    // cosine of the largest angle of a direction from the axis
constexpr const char* kTimed = "patient_a";       // cap on which times are taken

struct Cap {
  std::string joint;
  TriangleMesh mesh;  // about the origin, its axis +z
  std::vector<Vec3> asked = {};
  std::vector<double> radius = {};  // of the mesh along the directions
  std::shared_ptr<const RayCaster> caster = nullptr;
};

// The mesh turned so that the mean direction of its vertices is +z.
TriangleMesh upright(TriangleMesh mesh) {
  Vec3 axis = Vec3::Zero();
  for (const Vec3& v : mesh.vertices) axis += v.normalized();
  const Eigen::Quaterniond turn = Eigen::Quaterniond::FromTwoVectors(axis, Vec3::UnitZ());
  for (Vec3& v : mesh.vertices) v = turn * v;
  return mesh;
}

// Menschik's cap, with the faces of the generated cup, which follow no grid.
TriangleMesh conchoid_cap() {
  const ConchoidShape shape;
  TriangleMesh mesh = upright(make_ball_socket_pair(kFaces).socket);
  for (Vec3& v : mesh.vertices) v = conchoid_radius(shape, to_angles(v).phi) * v.normalized();
  return mesh;
}

std::vector<Cap> caps(DriverRun& run) {
  std::vector<Cap> found{{"conchoid", conchoid_cap()}};
  for (const char* name : {kTimed, "patient_b"})
    found.push_back({name, upright(make_hip(hip_preset(name), kFaces).socket)});
  if (run.bones) {
    for (const RealJoint& real : read_real_joints(*run.bones, run.progress))
      found.push_back({real.subject, upright(real.meshes.socket)});
  }
  std::mt19937_64 random(run.record.seed);
  for (Cap& cap : found) {
    cap.caster = std::make_shared<RayCaster>(cap.mesh);
    for (std::size_t i = 0; i < kAsked; ++i) {
      const Vec3 u = uniform_direction(random);
      if (u.z() < kEdge) continue;
      const double radius = cap.caster->cast(u, Layer::nearest);
      if (!std::isfinite(radius)) continue;
      cap.asked.push_back(u);
      cap.radius.push_back(radius);
    }
  }
  return found;
}

template <SamplingScheme S>
std::size_t entries_on_cap(const S& scheme) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < scheme.size(); ++i) count += scheme.direction(i).z() >= -1e-12 ? 1U : 0U;
  return count;
}

std::vector<Cell> key_of(const std::string& joint, std::string_view scheme, double precision,
                         const char* what) {
  return {joint, scheme, precision, what};
}

// Checks some entries against the radii of the mesh by brute force. Throws std::runtime_error if they differ.
template <SamplingScheme S>
void require_exact(const RadialTable<S>& table, const Cap& cap) {
  const std::size_t step = std::max<std::size_t>(table.scheme().size() / kChecked, 1);
  for (std::size_t i = 0; i < table.scheme().size(); i += step) {
    const double exact = cap.caster->cast(table.scheme().direction(i), Layer::nearest);
    const double off = std::abs(table.radius_of(i) - exact);
    if (std::isfinite(exact) != std::isfinite(table.radius_of(i)) || off > kRounding)
      throw std::runtime_error(std::string(S::name) + ": an entry is off by " + std::to_string(off) + " mm");
  }
}

// One cap, scheme and precision: its cells before the errors, the error of each gap (mm; NaN without an
// answer), and on the timed cap the cases that time it.
struct Sampled {
  std::vector<Cell> cells;
  std::vector<double> off;
  std::vector<TimedCase> cases;
};

template <SamplingScheme S>
Sampled sample(const Cap& cap, double precision, std::string_view label) {
  const S scheme = S::with_precision(precision);
  const auto table = std::make_shared<RadialTable<S>>(fill_exact(cap.mesh, scheme, Layer::nearest));
  require_exact(*table, cap);
  Sampled found{{cap.joint, S::name, label, precision, entries_on_cap(scheme), cap.asked.size()}, {}, {}};
  for (std::size_t i = 0; i < cap.asked.size(); ++i)
    found.off.push_back(std::abs(table->radius_at(cap.asked[i]) - cap.radius[i]));
  if (cap.joint != kTimed) return found;
  TimedCase look_up;
  look_up.key = key_of(cap.joint, S::name, precision, "look-up");
  look_up.units = static_cast<double>(cap.asked.size());
  look_up.run = [table, &cap] {
    for (const Vec3& u : cap.asked) benchmark::DoNotOptimize(table->radius_at(u));
  };
  TimedCase fill;
  fill.key = key_of(cap.joint, S::name, precision, "fill");
  fill.run = [scheme, &cap] {
    const auto filled = fill_exact(cap.mesh, scheme, Layer::nearest);
    benchmark::DoNotOptimize(filled.radii().data());
  };
  found.cases = {std::move(look_up), std::move(fill)};
  return found;
}

// Adds the cells of the errors, over the gaps that all answer, since some leave out what is beside a rim.
void add_errors(std::vector<Sampled>& every) {
  for (Sampled& one : every) {
    one.cells.emplace_back(std::ranges::count_if(one.off, [](double off) { return std::isfinite(off); }));
    double largest = 0.0;
    double squares = 0.0;
    std::size_t compared = 0;
    for (std::size_t i = 0; i < one.off.size(); ++i) {
      if (!std::ranges::all_of(every, [i](const Sampled& other) { return std::isfinite(other.off[i]); }))
        continue;
      ++compared;
      largest = std::max(largest, one.off[i]);
      squares += one.off[i] * one.off[i];
    }
    one.cells.emplace_back(1e3 * largest);
    one.cells.emplace_back(1e3 * std::sqrt(squares / static_cast<double>(compared)));
  }
}

std::vector<Column> columns() {
  return {{"joint", "", "whose cap: the conchoid, a stand-in or a real joint"},
          {"scheme", "", "name of the sampling scheme"},
          {"label", "", "the same for text"},
          {"precision_deg", "deg", "spacing of the entries at the rim"},
          {"entries", "1", "of the table no farther than 90 degrees from the axis"},
          {"asked", "1", "directions, within 80 degrees of the axis"},
          {"answered", "1", "of them, by the table"},
          {"max_um", "um", "largest error of a gap, of those that all schemes answer at this precision"},
          {"rms_um", "um", "root mean square of the errors"},
          {"look_up_ns", "ns", "median time of a look-up; empty where it is not timed"},
          {"look_up_iqr_ns", "ns", "interquartile range of it"},
          {"fill_ms", "ms", "median time to fill the table"},
          {"fill_iqr_ms", "ms", "interquartile range of it"},
          {"rounds", "1", "rounds measured"}};
}

void body(DriverRun& run) {
  const std::vector<Cap> all = caps(run);
  std::vector<Sampled> sampled;
  std::vector<TimedCase> cases;
  for (const Cap& cap : all) {
    for (const double precision : kPrecisions) {
      std::vector<Sampled> every{sample<Rsid>(cap, precision, Rsid::label),
                                 sample<WeightedRings>(cap, precision, WeightedRings::label),
                                 sample<Usid>(cap, precision, Usid::label),
                                 sample<Conchoid>(cap, precision, Conchoid::label)};
      add_errors(every);
      std::ranges::move(every, std::back_inserter(sampled));
    }
  }
  for (const Sampled& one : sampled) cases.insert(cases.end(), one.cases.begin(), one.cases.end());
  if (run.quick()) {
    for (TimedCase& one : cases) one.rounds = 7;
  }
  const TimingRun timed = run_interleaved(cases, {}, run.progress);
  Result result{"weighted_sampling", "How well is an acetabular cap sampled?", {columns()}};
  for (Sampled& one : sampled) {
    for (const TimedCase& work : one.cases) {
      const Summary summary = find(timed, work.key).summary;
      const double unit = work.units > 1.0 ? 1e6 : 1.0;  // a look-up in ns
      one.cells.emplace_back(unit * summary.median);
      one.cells.emplace_back(unit * summary.iqr);
      if (&work == &one.cases.back()) one.cells.emplace_back(summary.count);
    }
    one.cells.resize(result.table.columns.size());
    result.table.add_row(std::move(one.cells));
  }
  result.parameters = {{"faces_of_generated_caps", kFaces}, {"timed_on", kTimed}};
  const std::vector<Column> keys{columns()[0], columns()[1], columns()[3], {"what", "", "look-up or fill"}};
  write_timed(run, std::move(result), keys, timed);
}

}  // namespace

int main(int argc, char** argv) {
  return impinge::lab::run_driver(
      argc, argv,
      {"07_weighted_sampling", "Weighted sampling of an acetabular cap (Eq. 16).", /*takes_bones=*/true},
      body);
}
