// SPDX-License-Identifier: GPL-3.0-or-later
// @question  What does a scene save by leaving out what it does not need, at the same answer?
// @writes    scene_needs scene_needs_totals scene_needs_samples
// @bones     yes
// @timing    yes
// @seconds   20 300
// @links     harness real_joints methods joint
//
// Everything is done with RSID tables at 0.1 degrees, for three questions about each joint: all gaps in one
// pose, the smallest gap in it, and touch along a motion there and back in 19 poses. Left out are entries
// that no vertex reads, then also vertices that cannot change the answer (joint/needed_work.hpp). The gaps
// along the motion in 181 poses, to within 0.05 mm, need no table: exact cells give them. Distances and exact
// verdicts are outputs that a scene of one pose may leave out. Answers are compared before anything is timed,
// and one that is not the same fails the run.

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <benchmark/benchmark.h>

#include "contact/euclidean_distance.hpp"
#include "gap/measured_gap.hpp"
#include "gap/simd/exact_cells.hpp"
#include "harness/driver.hpp"
#include "harness/real_joints.hpp"
#include "harness/timing.hpp"
#include "joint/certificate.hpp"
#include "joint/needed_work.hpp"
#include "mesh/generated_pair.hpp"
#include "methods/heap_use.hpp"
#include "sphere/schemes/rsid.hpp"
#include "table/exact_raster.hpp"
#include "table/pairwise.hpp"
#include "table/partial_table.hpp"

namespace {

using namespace impinge;
using namespace impinge::lab;

constexpr std::size_t kFaces = 12000;  // of each generated model
constexpr std::size_t kFacesInQuick = 3000;
constexpr std::size_t kJointsInQuick = 1;  // the smallest
constexpr int kRounds = 5;
constexpr int kRoundsInQuick = 3;
constexpr double kPrecision = 0.1;  // degrees
constexpr double kAccuracy = 0.05;  // mm

using JointPtr = std::shared_ptr<const BallSocketPair>;  // centre frames, mm

// One way to do the work of a scene.
struct NeedsCase {
  std::string scene;          // joint and question
  std::string left_out;       // "nothing", one kind of work, or "all"
  std::function<void()> run;  // what is timed
  double bytes = 0.0;         // of memory, of one run
  bool output = false;        // is it an output that may be left out, by itself?
};

constexpr std::size_t scan_of(Surface scanned) { return scanned == Surface::ball ? 0 : 1; }

Pose turned(const Vec3& axis, double degrees) {
  return {Eigen::AngleAxisd(degrees * kDegree, axis).toRotationMatrix(), Vec3::Zero()};
}

// From 0 to 90 degrees, in steps of so many.
std::vector<Pose> there_and_back(const Vec3& axis, int step) {
  std::vector<Pose> motion;
  for (int angle = 0; angle <= 90; angle += step) motion.push_back(turned(axis, angle));
  for (int angle = 90 - step; angle >= 0; angle -= step) motion.push_back(turned(axis, angle));
  return motion;
}

// By tables of what the vertices of ball and socket meet.
template <class Table>
SceneAnswer answer_with(const BallSocketPair& joint, const SceneNeeds& needs, const NeededVertices& vertices,
                        const std::array<Table, 2>& tables) {
  const auto gap = [&](Surface of, std::size_t /*vertex*/, const Vec3& x) {
    return signed_gap(of, tables[scan_of(of)].radius_at(x), x.norm());
  };
  SceneAnswer answer = answer_from(joint, needs, vertices, gap);
  for (const Table& table : tables) answer.bytes += table.bytes();
  return answer;
}

SceneAnswer answer_of(const BallSocketPair& joint, const SceneNeeds& needs, std::string_view left_out) {
  const AnyScheme scheme(Rsid::name, kPrecision);
  if (left_out == "all") return answer_by_table(joint, needs, scheme);
  const NeededVertices vertices = all_vertices(joint, needs);
  if (left_out == "nothing") {
    const Rsid rsid = Rsid::with_precision(kPrecision);
    const std::array tables{fill_exact(joint.socket, rsid, Layer::nearest),
                            fill_exact(joint.ball, rsid, Layer::farthest)};
    return answer_with(joint, needs, vertices, tables);
  }
  const NearFaces socket(joint.socket, scheme.stencil_radius());
  const NearFaces ball(joint.ball, scheme.stencil_radius());
  const auto table = [&](const NearFaces& faces, Surface scanned) {
    return fill_partial(faces, scheme, needed_entries(joint, needs, vertices, scanned, scheme),
                        facing_layer(other(scanned)));
  };
  const std::array tables{table(socket, Surface::ball), table(ball, Surface::socket)};
  SceneAnswer answer = answer_with(joint, needs, vertices, tables);
  answer.bytes += socket.bytes() + ball.bytes();
  return answer;
}

bool same_gaps(const std::vector<double>& a, const std::vector<double>& b) {
  return std::ranges::equal(a, b,
                            [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); });
}

void require_same(const SceneAnswer& a, const SceneAnswer& b, const std::string& scene) {
  const bool same = a.touches == b.touches && a.smallest == b.smallest &&
                    std::ranges::equal(a.gaps, b.gaps, [](const PoseGaps& one, const PoseGaps& two) {
                      return same_gaps(one[0], two[0]) && same_gaps(one[1], two[1]);
                    });
  if (!same) throw std::runtime_error(scene + ": the answer is not the same");
}

void add_question(const std::string& scene, const JointPtr& joint, const SceneNeeds& needs,
                  std::vector<NeedsCase>& cases) {
  const SceneAnswer everything = answer_of(*joint, needs, "nothing");
  for (const char* left_out : {"nothing", "entries", "all"}) {
    const SceneAnswer answer = answer_of(*joint, needs, left_out);
    require_same(answer, everything, scene + ", left out " + left_out);
    const auto run = [=] { benchmark::DoNotOptimize(answer_of(*joint, needs, left_out).look_ups); };
    cases.push_back({scene, left_out, run, static_cast<double>(answer.bytes)});
  }
}

// The gaps of all vertices of a surface, without a table.
struct CellScan {
  CellScan(const BallSocketPair& joint, Surface scanned)
      : of(scanned),
        cells(exact_cells(mesh_of(joint, other(of)), facing_layer(other(of)))),
        vertices(packed_vertices<float>(mesh_of(joint, of).vertices)),
        gap(vertices.size()) {}
  void run(const Pose& pose) { scan_gaps(cells, vertices, pose, of, gap); }

  Surface of;
  ExactCells cells;
  PackedVertices<float> vertices;
  std::vector<float> gap;  // mm, of the last pose
};

// Are its gaps in the last pose within the accuracy of every ray against every face? In float a vertex beside
// a rim may be across it.
bool is_accurate(const BallSocketPair& joint, const Pose& pose, const CellScan& scan) {
  const TriangleMesh& met = mesh_of(joint, other(scan.of));
  const RayCaster oracle(met);
  const NearFaces faces(met, 0.0);
  for (std::size_t v = 0; v < scan.gap.size(); ++v) {
    const Vec3 x = to_other(scan.of, pose, mesh_of(joint, scan.of).vertices[v]);
    const double radius = oracle.cast(x.normalized(), facing_layer(other(scan.of)));
    const double off = std::abs(static_cast<double>(scan.gap[v]) - signed_gap(scan.of, radius, x.norm()));
    const bool both_none = std::isnan(scan.gap[v]) && std::isnan(radius);
    if (!(off <= kAccuracy) && !both_none && !(std::isnan(off) && faces.near(x).rim)) return false;
  }
  return true;
}

void add_accurate_gaps(const std::string& scene, const JointPtr& joint, const Vec3& axis,
                       std::vector<NeedsCase>& cases) {
  constexpr std::size_t kEveryPose = 30;  // is compared with every face
  SceneNeeds needs;
  needs.poses = there_and_back(axis, 1);
  std::array scans{CellScan(*joint, Surface::ball), CellScan(*joint, Surface::socket)};
  for (std::size_t p = 0; p < needs.poses.size(); p += kEveryPose) {
    for (CellScan& scan : scans) {
      scan.run(needs.poses[p]);
      if (!is_accurate(*joint, needs.poses[p], scan))
        throw std::runtime_error(scene + ": a gap of exact cells is not that of the faces");
    }
  }
  const auto tables = [=] { benchmark::DoNotOptimize(answer_of(*joint, needs, "nothing").look_ups); };
  const double bytes = 2.0 * static_cast<double>(RadialTable<Rsid>::bytes(Rsid::with_precision(kPrecision)));
  cases.push_back({scene, "nothing", tables, bytes});
  const auto cells = [=] {
    std::array anew{CellScan(*joint, Surface::ball), CellScan(*joint, Surface::socket)};
    for (const Pose& pose : needs.poses) {
      for (CellScan& scan : anew) scan.run(pose);
    }
    benchmark::DoNotOptimize(anew[0].gap.data());
  };
  cases.push_back(
      {scene, "all", cells, static_cast<double>(scans[0].cells.bytes() + scans[1].cells.bytes())});
}

// One of the outputs: it makes something, which is kept while its memory is counted.
template <class Make>
void add_output(const std::string& scene, const char* output, const Make& make,
                std::vector<NeedsCase>& cases) {
  const auto run = [make] {
    const auto product = make();
    benchmark::DoNotOptimize(&product);
    return heap_bytes();
  };
  const double before = heap_bytes();
  cases.push_back({scene, output, run, run() - before, true});
}

void add_outputs(const std::string& scene, const JointPtr& joint, const Pose& pose,
                 std::vector<NeedsCase>& cases) {
  const auto distances = [=] {
    auto ball = std::make_unique<EuclideanDistance>(joint->ball);
    auto socket = std::make_unique<EuclideanDistance>(joint->socket);
    std::vector<DistanceBracket> found;
    for (const Vec3& v : joint->ball.vertices) found.push_back(socket->at(to_socket(pose, v)));
    for (const Vec3& v : joint->socket.vertices) found.push_back(ball->at(to_ball(pose, v)));
    return std::tuple(std::move(ball), std::move(socket), std::move(found));
  };
  add_output(scene, "distances", distances, cases);
  std::array<std::vector<double>, 2> gap;
  std::array<std::vector<double>, 2> bound;
  for (const Surface of : kSurfaces) {
    const NearFaces faces(mesh_of(*joint, other(of)), 0.0);
    for (const Vec3& v : mesh_of(*joint, of).vertices) {
      const CertifiedGap ends = measured_gap(of, faces, to_other(of, pose, v));
      gap[scan_of(of)].push_back(ends.cover == Cover::none ? kNoSurface : 0.5 * (ends.low + ends.high));
      bound[scan_of(of)].push_back(0.5 * (ends.high - ends.low));
    }
  }
  const auto verdicts = [=] {
    auto overlay = std::make_unique<SurfaceOverlay>(joint->ball, joint->socket);
    const Certificate certificate = certify(*overlay, pose, {gap[0], bound[0]}, {gap[1], bound[1]});
    return std::pair(std::move(overlay), certificate);
  };
  add_output(scene, "exact_verdicts", verdicts, cases);
}

void add_joint(const std::string& name, const BallSocketPair& meshes, const Vec3& axis, DriverRun& run,
               std::vector<NeedsCase>& cases) {
  const auto joint = std::make_shared<const BallSocketPair>(meshes);
  const Pose pose = turned(axis, 30.0);
  add_question(name + " all gaps", joint, {.poses = {pose}}, cases);
  add_outputs(name + " all gaps", joint, pose, cases);
  add_question(name + " smallest gap", joint, {.question = Question::first_contact, .poses = {pose}}, cases);
  add_question(name + " touch in a motion", joint,
               {.question = Question::touch, .poses = there_and_back(axis, 10)}, cases);
  add_accurate_gaps(name + " gaps in a motion", joint, axis, cases);
  run.progress.say("compared the answers of " + name);
}

std::vector<Cell> key_of(const NeedsCase& work) { return {work.scene, work.left_out}; }

TimingRun timed(const std::vector<NeedsCase>& cases, int rounds, Progress& progress) {
  std::vector<TimedCase> timed;
  for (const NeedsCase& work : cases) {
    TimedCase one;
    one.key = key_of(work);
    one.run = work.run;
    one.rounds = rounds;
    timed.push_back(std::move(one));
  }
  TimingOptions protocol;
  protocol.slow_ms = 50.0;  // cases that take longer are long enough to be their own warm-up
  return run_interleaved(timed, protocol, progress);
}

// scene_needs.csv and scene_needs_totals.csv.
std::pair<Table, Table> tables_of(const std::vector<NeedsCase>& cases, const TimingRun& timing) {
  Table needs{{{"scene", "", "joint and question"},
               {"left_out", "", "entries that no vertex reads, all that can be, or an output"},
               {"bytes_saved", "bytes", "memory of tables and what stands in for them, or of the output"},
               {"time_saved_us", "us", "median of the time; below 0 where it takes longer"},
               {"identical", "", "yes: the same answer bit for bit; gaps in a motion within 0.05 mm"}},
              {}};
  Table totals{{{"scene", "", "joint and question"},
                {"tables_bytes", "bytes", "whole tables and all look-ups"},
                {"tables_us", "us", "median"},
                {"needed_bytes", "bytes", "what the answer needs"},
                {"needed_us", "us", "median"}},
               {}};
  const auto us = [&](const NeedsCase& work) { return 1000.0 * find(timing, key_of(work)).summary.median; };
  std::map<std::string, const NeedsCase*> everything;
  for (const NeedsCase& work : cases) {
    if (work.left_out == "nothing") {
      everything[work.scene] = &work;
      continue;
    }
    const NeedsCase& full = *everything.at(work.scene);
    needs.add_row({work.scene, work.left_out, work.output ? work.bytes : full.bytes - work.bytes,
                   work.output ? us(work) : us(full) - us(work), true});
    if (work.left_out == "all") totals.add_row({work.scene, full.bytes, us(full), work.bytes, us(work)});
  }
  return {std::move(needs), std::move(totals)};
}

void body(DriverRun& run) {
  std::vector<NeedsCase> cases;
  const std::size_t faces = run.quick() ? kFacesInQuick : kFaces;
  add_joint("generated", make_ball_socket_pair(faces, impinging_cam()), -Vec3::UnitY(), run, cases);
  if (run.bones) {
    std::vector<RealJoint> joints = read_real_joints(*run.bones, run.progress);
    if (run.quick() && joints.size() > kJointsInQuick) {
      std::ranges::stable_sort(joints, {}, [](const RealJoint& j) { return j.meshes.ball.faces.size(); });
      joints.resize(kJointsInQuick);
    }
    for (const RealJoint& joint : joints) add_joint(joint.subject, joint.meshes, Vec3::UnitX(), run, cases);
  }
  const TimingRun timing = timed(cases, run.quick() ? kRoundsInQuick : kRounds, run.progress);
  auto [needs, totals] = tables_of(cases, timing);
  Result result{"scene_needs_totals", "What does a scene save by all that it leaves out?", std::move(totals)};
  result.parameters = {{"scheme", "rsid"},
                       {"precision_deg", kPrecision},
                       {"faces_of_the_generated_models", faces},
                       {"bytes", "counted by the structures; of outputs, growth of the heap (mallinfo2)"}};
  result.timing = timing_record(timing);
  run.write(result);
  result.name = "scene_needs";
  result.question = "What does leaving out each kind of work save?";
  result.table = std::move(needs);
  write_timed(run, result, {{"scene", "", "joint and question"}, {"left_out", "", "what is left out"}},
              timing);
}

}  // namespace

int main(int argc, char** argv) {
  return impinge::lab::run_driver(
      argc, argv,
      {"12_scene_needs", "What a scene saves by leaving out what it does not need.", /*takes_bones=*/true},
      body);
}
