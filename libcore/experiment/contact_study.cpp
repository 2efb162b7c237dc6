// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiment/contact_study.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <memory>
#include <stdexcept>
#include <utility>

#include <benchmark/benchmark.h>

#include "contenders/fcl_distance.hpp"
#include "contenders/fcl_obb.hpp"
#include "contenders/vtk_collision.hpp"
#include "culling/coherent_contact.hpp"
#include "experiment/contact_motions.hpp"
#include "kernels/gap_kernels.hpp"
#include "sampling/exact_raster.hpp"

namespace impinge {
namespace {

constexpr double kCubePrecision =
    90.0 / 291.0;  // degrees, of the kernels' tables: the main ones of experiment 13_fast
constexpr std::size_t kSlowStride = 16;  // FCL measures distances in one pose of so many
constexpr double kExactTests = 3e5;      // vertices looked at for each joint and case, to compare

using CubeTable = LaneTable<CubeGnomonic, std::uint16_t>;

CubeTable cube_table(const TriangleMesh& mesh, Layer layer) {
  const auto scheme = CubeGnomonic::with_precision(kCubePrecision);
  return lane_table<std::uint16_t>(InverseDepthTable(fill_exact(mesh, scheme, layer)));
}

// One joint and all that answers.
struct ContactStage {
  explicit ContactStage(std::size_t triangles)
      : pair(make_ball_socket_pair(triangles)),
        culled(pair),
        coherent(culled),
        fcl(make_fcl_obb(pair.ball, pair.socket)),
        distance(pair.ball, pair.socket),
        vtk(make_vtk_collision(pair.ball, pair.socket)),
        ball_table(cube_table(pair.ball, Layer::farthest)),
        socket_table(cube_table(pair.socket, Layer::nearest)),
        ball(vertex_lanes<float>(pair.ball.vertices)),
        socket(vertex_lanes<float>(pair.socket.vertices)),
        ball_gaps(ball.size()),
        socket_gaps(socket.size()) {}

  void scan_all(const Pose& pose) {
    scan_gaps(socket_table, {ball, pose, Scan::ball}, ball_gaps);
    scan_gaps(ball_table, {socket, pose, Scan::socket}, socket_gaps);
  }
  bool any_at_most_zero() const {
    const auto at_most_zero = [](float gap) { return gap <= 0.0F; };
    return std::ranges::any_of(ball_gaps, at_most_zero) || std::ranges::any_of(socket_gaps, at_most_zero);
  }

  BallSocketPair pair;
  CulledJoint culled;
  CoherentContact coherent;
  std::unique_ptr<Contender> fcl;
  FclDistance distance;
  std::unique_ptr<Contender> vtk;
  CubeTable ball_table;
  CubeTable socket_table;
  VertexLanes<float> ball;
  VertexLanes<float> socket;
  std::vector<float> ball_gaps;
  std::vector<float> socket_gaps;
};

struct ContactCase {
  TimedCase timed;
  std::size_t poses = 0;
  std::size_t touching = 0;
  double least_gap_mm = 0.0;  // median over the poses
};

// Answers of one method in poses of one gap.
struct Asked {
  std::string method;
  std::vector<Pose> poses;
  std::function<bool(const Pose&)> work;     // what is timed
  std::function<bool(const Pose&)> touches;  // what it says
};

std::vector<Asked> methods_of(ContactStage& stage, const std::vector<Pose>& poses) {
  std::vector<Pose> few;
  for (std::size_t k = 0; k < poses.size(); k += kSlowStride) few.push_back(poses[k]);
  const auto fcl = [&stage](const Pose& pose) { return stage.fcl->touches(pose); };
  const auto distance = [&stage](const Pose& pose) { return stage.distance.distance(pose) <= 0.0; };
  const auto vtk = [&stage](const Pose& pose) { return stage.vtk->touches(pose); };
  const auto all = [&stage](const Pose& pose) {
    stage.scan_all(pose);
    benchmark::ClobberMemory();
    return false;
  };
  const auto all_touch = [&stage](const Pose& pose) {
    stage.scan_all(pose);
    return stage.any_at_most_zero();
  };
  const auto culled = [&stage](const Pose& pose) { return stage.culled.impinged(pose).has_value(); };
  const auto coherent = [&stage](const Pose& pose) { return stage.coherent.impinged(pose).has_value(); };
  const auto least = [&stage](const Pose& pose) {
    const auto gap = stage.culled.least_gap(pose);
    return gap && gap->gap_mm <= 0.0;
  };
  return {{"fcl_collide", poses, fcl, fcl},         {"fcl_distance", few, distance, distance},
          {"vtk_collide", few, vtk, vtk},           {"all_vertices", poses, all, all_touch},
          {"culled", poses, culled, culled},        {"coherent", poses, coherent, coherent},
          {"culled_least_gap", poses, least, least}};
}

// The exact test of every vertex.
bool any_impinged(const ContactStage& stage, const Pose& pose) {
  return std::ranges::any_of(stage.pair.ball.vertices,
                             [&](const Vec3& x) {
                               return stage.culled.exactly_impinged(ScannedSurface::ball, to_socket(pose, x));
                             }) ||
         std::ranges::any_of(stage.pair.socket.vertices, [&](const Vec3& y) {
           return stage.culled.exactly_impinged(ScannedSurface::socket, to_ball(pose, y));
         });
}

// Throws where the culled answers are not those of all vertices, or those of VTK not those of FCL.
void compare(ContactStage& stage, const std::vector<Pose>& poses) {
  const auto vertices =
      static_cast<double>(stage.pair.ball.vertices.size() + stage.pair.socket.vertices.size());
  const auto most = static_cast<std::size_t>(kExactTests / vertices) + 1;
  const std::size_t stride = std::max<std::size_t>(1, poses.size() / most);
  for (std::size_t k = 0; k < poses.size(); k += stride) {
    const bool truth = any_impinged(stage, poses[k]);
    const auto least = stage.culled.least_gap(poses[k]);
    if (stage.culled.impinged(poses[k]).has_value() != truth || (least && least->gap_mm <= 0.0) != truth)
      throw std::runtime_error(
          "a culled answer is not that of all vertices: its time means nothing until that is resolved");
    if (stage.vtk->touches(poses[k]) != stage.fcl->touches(poses[k]))
      throw std::runtime_error(
          "VTK and FCL differ on a contact: their times mean nothing until that is resolved");
  }
}

double median_gap(const CulledJoint& joint, const std::vector<Pose>& poses) {
  std::vector<double> gaps;
  gaps.reserve(poses.size());
  for (const Pose& pose : poses) gaps.push_back(joint.least_gap(pose)->gap_mm);
  return summarise(gaps).median;
}

void add_cases(ContactStage& stage, const GapCase& gap, const ContactOptionsTimed& options,
               std::vector<ContactCase>& cases) {
  const std::vector<Pose> poses = contact_motions(stage.culled, gap, options.seed);
  compare(stage, poses);
  for (const Asked& asked : methods_of(stage, poses)) {
    ContactCase added;
    added.poses = asked.poses.size();
    added.touching = static_cast<std::size_t>(std::ranges::count_if(asked.poses, asked.touches));
    added.least_gap_mm = median_gap(stage.culled, asked.poses);
    added.timed.key = {asked.method, gap.name, stage.pair.ball.faces.size()};
    added.timed.units = static_cast<double>(asked.poses.size());
    added.timed.rounds = options.rounds;
    added.timed.run = [asked] {
      for (const Pose& pose : asked.poses) benchmark::DoNotOptimize(asked.work(pose));
    };
    cases.push_back(std::move(added));
  }
}

// Median of a method in the same case, ms a pose.
double median_of(const TimingRun& run, const std::string& method, const Timing& like) {
  return find(run, {method, like.key[1], like.key[2]}).summary.median;
}

Table contact_table(const std::vector<ContactCase>& cases, const TimingRun& run) {
  constexpr double kMicroseconds = 1e3;  // in a millisecond
  Table table{contact_keys(), {}};
  for (const Column& column : std::vector<Column>{
           {"us_pose", "us", "median time of a pose"},
           {"iqr_us", "us", "interquartile range of it over the rounds"},
           {"rounds", "1", "rounds measured"},
           {"poses", "1", "poses of a round: motions of 16, half a degree from one to the next"},
           {"touching", "1", "of these, by this method"},
           {"least_gap_mm", "mm", "median of the smallest gap of a pose"},
           {"times_fcl_collide", "1", "median of fcl_collide over this one"},
           {"times_fcl_distance", "1", "median of fcl_distance over this one"}}) {
    table.columns.push_back(column);
  }
  for (std::size_t k = 0; k < cases.size(); ++k) {
    const Timing& timing = run.timings[k];
    const double median = timing.summary.median;
    std::vector<Cell> row = timing.key;
    row.insert(row.end(), {kMicroseconds * median, kMicroseconds * timing.summary.iqr, timing.summary.count,
                           cases[k].poses, cases[k].touching, cases[k].least_gap_mm,
                           median_of(run, "fcl_collide", timing) / median,
                           median_of(run, "fcl_distance", timing) / median});
    table.add_row(std::move(row));
  }
  return table;
}

}  // namespace

std::vector<Column> contact_keys() {
  return {{"method", "",
           "fcl_collide, vtk_collide: trees of oriented boxes; fcl_distance: smallest distance; "
           "all_vertices: both scans by the kernels, all gaps; culled: touch; coherent: touch, from one pose "
           "to the next; "
           "culled_least_gap: smallest gap"},
          {"gap_case", "", "smallest gap in the poses"},
          {"triangles", "1", "of each of the two models"}};
}

ContactTables contact_tables(const ContactOptionsTimed& options, Progress& progress) {
  std::vector<std::unique_ptr<ContactStage>> stages;
  std::vector<ContactCase> cases;
  for (const std::size_t triangles : options.triangles) {
    stages.push_back(std::make_unique<ContactStage>(triangles));
    for (const GapCase& gap : kGapCases) add_cases(*stages.back(), gap, options, cases);
    progress.say("made the poses of " + std::to_string(triangles) + " triangles");
  }
  std::vector<TimedCase> timed;
  timed.reserve(cases.size());
  for (const ContactCase& one : cases) timed.push_back(one.timed);
  ContactTables tables;
  tables.timing = run_interleaved(timed, options.timing, progress);
  tables.table = contact_table(cases, tables.timing);
  return tables;
}

}  // namespace impinge
