// SPDX-License-Identifier: GPL-3.0-or-later
#include "13_counts/count_study.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <sstream>
#include <string>

#include <Eigen/Geometry>

#include "13_fast/fast_study.hpp"
#include "contact/coherent_contact.hpp"
#include "kernels/instruction_set.hpp"
#include "mesh/generated_pair.hpp"
#include "methods/fcl_obb.hpp"

namespace impinge::lab {
namespace {

constexpr char kBetween = ';';         // words of a label
constexpr double kTouchGap = 0.5;      // mm, smallest gap of the first pose whose contact is asked
constexpr double kTouchStepDeg = 0.5;  // from pose to pose
constexpr int kTouchPoses = 16;
constexpr int kHalvings = 20;

std::string label_of(std::vector<Cell> words, double units) {
  words.emplace_back(units);
  std::string label;
  for (const Cell& word : words) label += (label.empty() ? "" : std::string(1, kBetween)) + word.text();
  return label;
}

std::string main_setting() { return "n=" + std::to_string(kMainCells); }

// One of each kind, as it is recommended; building the certified table takes too long under valgrind.
bool is_counted(const GapMethodMaker& maker) {
  static constexpr std::array kTables{"cube_gnomonic_mesh_exact", "rsid", "usid"};
  const bool corners = maker.storage == kCorners && maker.setting == main_setting();
  if (std::ranges::find(kTables, maker.name) != kTables.end()) return maker.storage == "uint16" || corners;
  if (maker.name == "cube_cells_exact") return maker.setting.starts_with("4");
  if (maker.name == "floor") return maker.setting == main_setting();
  return maker.name.starts_with("embree_ray") || maker.name.ends_with("_scalar");
}

void count_scans(const AskedSurface& surface, const AskedPoints& asked, int poses) {
  for (const GapMethodMaker& maker :
       fast_methods(surface, {{kMainCells}, {0.5}, {0.5}, false, {}, {kMainCells}})) {
    if (!is_counted(maker)) continue;
    const auto method = maker.make();
    GapMethod::Scratch scratch;
    for (const std::string& set : instruction_sets()) {
      if (!maker.kernel && set != instruction_sets().front()) continue;
      use_instruction_set(set);
      const std::string direction = surface.scanned == Surface::ball ? "ball->socket" : "socket->ball";
      const auto units = static_cast<double>(poses) * static_cast<double>(asked.points.size());
      count_run(label_of({maker.name, maker.setting, maker.storage, direction,
                          maker.kernel ? set : std::string("none"), "vertex"},
                         units),
                [&] {
                  for (int k = 0; k < poses; ++k) method->scan(asked, motion_pose(k), scratch);
                });
    }
  }
  use_best_instruction_set();
}

// A motion from where the ball, pushed into the socket, has that smallest gap.
std::vector<Pose> near_poses(const CulledJoint& joint) {
  double free = 0.0;
  double near = 8.0;
  Pose pose;
  for (int k = 0; k < kHalvings; ++k) {
    pose.translation = Vec3(0.0, 0.0, 0.5 * (free + near));
    const auto least = joint.least_gap(pose);
    (least && least->gap_mm > kTouchGap ? free : near) = pose.translation.z();
  }
  std::vector<Pose> poses(kTouchPoses, pose);
  for (std::size_t k = 0; k < poses.size(); ++k)
    poses[k].rotation =
        Eigen::AngleAxisd(static_cast<double>(k) * kTouchStepDeg * kDegree, Vec3::UnitY()).toRotationMatrix();
  return poses;
}

void count_touch(const BallSocketPair& pair) {
  const CulledJoint culled(pair);
  CoherentContact coherent(culled);
  const auto fcl = make_fcl_obb(pair.ball, pair.socket);
  const std::vector<Pose> poses = near_poses(culled);
  std::size_t touching = 0;
  const auto count = [&](const char* name, const std::function<bool(const Pose&)>& touches) {
    count_run(label_of({name, "none", "none", "both", "none", "pose"}, kTouchPoses), [&] {
      for (const Pose& pose : poses) touching += touches(pose) ? 1U : 0U;
    });
  };
  count("fcl_collide", [&](const Pose& pose) { return fcl->touches(pose); });
  count("culled", [&](const Pose& pose) { return culled.impinged(pose).has_value(); });
  count("coherent", [&](const Pose& pose) { return coherent.impinged(pose).has_value(); });
}

}  // namespace

void run_counted(const CountOptions& options) {
  const BallSocketPair pair = make_ball_socket_pair(options.triangles);
  count_scans({pair.ball, Layer::farthest, Surface::socket}, AskedPoints(pair.socket.vertices),
              options.poses);
  count_scans({pair.socket, Layer::nearest, Surface::ball}, AskedPoints(pair.ball.vertices), options.poses);
  count_touch(pair);
}

Table count_table(const std::vector<EventCounts>& counts) {
  Table table{{{"method", "", "as in data/fast.csv and data/contact.csv"},
               {"setting", "", "likewise"},
               {"storage", "", "likewise"},
               {"direction", "", "whose vertices are looked up -> in whose surface; both for a touch"},
               {"instruction_set", "", "of a kernel, the best that valgrind knows first; none: as compiled"},
               {"unit", "", "that the counts are of: a vertex or a pose"},
               {"instructions", "1", "instructions of a unit"},
               {"l1_misses", "misses", "data of a unit that were not in a simulated cache of 32 KiB, 8 ways"},
               {"l2_misses", "misses", "of these, not in one of 1 MiB, 16 ways, either"}},
              {}};
  for (const EventCounts& one : counts) {
    std::istringstream label(one.label);
    std::vector<Cell> row;
    std::string word;
    while (row.size() < 6 && std::getline(label, word, kBetween)) row.emplace_back(word);
    double units = 0.0;
    label >> units;
    for (const double events : {one.instructions, one.first_misses, one.second_misses})
      row.emplace_back(events / units);
    table.add_row(std::move(row));
  }
  return table;
}

}  // namespace impinge::lab
