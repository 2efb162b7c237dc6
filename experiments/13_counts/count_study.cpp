// SPDX-License-Identifier: GPL-3.0-or-later
#include "13_counts/count_study.hpp"

#include <algorithm>
#include <sstream>
#include <string>

#include <Eigen/Geometry>

#include "contact/culled_joint.hpp"
#include "mesh/generated_pair.hpp"
#include "methods/benchmark_scene.hpp"
#include "methods/contact.hpp"
#include "methods/gaps.hpp"
#include "methods/instruction_set.hpp"

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

// One of each kind, as it is recommended; building the certified table takes too long under valgrind.
std::vector<GapCase> counted_scans(const AskedSurface& surface) {
  const GapSizes sizes{{kMainCells}, {0.5}, {0.5}, false, {kMainCells}};
  std::vector<GapCase> methods = cases_of(gaps_methods(), &Method::gaps, surface, sizes);
  std::erase_if(methods, [](const GapCase& method) { return !method.counted; });
  return methods;
}

std::vector<ContactCase> counted_touches(const BallSocketPair& joint) {
  std::vector<ContactCase> methods = cases_of(contact_methods(), &Method::contact, joint);
  std::erase_if(methods, [](const ContactCase& method) { return !method.counted; });
  return methods;
}

void count_scans(const AskedSurface& surface, const AskedPoints& asked, int poses) {
  for (const GapCase& method : counted_scans(surface)) {
    const GapQuery query = method.make();
    GapScratch scratch;
    for (const std::string& set : instruction_sets()) {
      if (!method.kernel && set != instruction_sets().front()) continue;
      use_instruction_set(set);
      const std::string direction = surface.scanned == Surface::ball ? "ball->socket" : "socket->ball";
      const auto units = static_cast<double>(poses) * static_cast<double>(asked.points.size());
      count_run(label_of({method.name, method.setting, method.storage, direction,
                          method.kernel ? set : std::string("none"), "vertex"},
                         units),
                [&] {
                  for (int k = 0; k < poses; ++k) query.scan(asked, motion_pose(-Vec3::UnitY(), k), scratch);
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
  const std::vector<Pose> poses = near_poses(culled);
  std::size_t touching = 0;
  for (const ContactCase& method : counted_touches(pair)) {
    const ContactQuery query = method.make();
    count_run(label_of({method.name, "none", "none", "both", "none", "pose"}, kTouchPoses), [&] {
      for (const Pose& pose : poses) touching += query.touches(pose) ? 1U : 0U;
    });
  }
}

}  // namespace

void run_counted(const CountOptions& options) {
  const BallSocketPair pair = make_ball_socket_pair(options.triangles);
  count_scans({pair.ball, Layer::farthest, Surface::socket}, AskedPoints(pair.socket.vertices),
              options.poses);
  count_scans({pair.socket, Layer::nearest, Surface::ball}, AskedPoints(pair.ball.vertices), options.poses);
  count_touch(pair);
}

std::map<std::string, std::string> counted_labels() {
  const BallSocketPair pair = make_ball_socket_pair(300);
  std::map<std::string, std::string> labels;
  add_labels(labels, counted_scans({pair.socket, Layer::nearest, Surface::ball}));
  add_labels(labels, counted_touches(pair));
  return labels;
}

Table count_table(const std::vector<EventCounts>& counts) {
  Table table{{{"method", "", "as in data/all_gaps.csv and data/contact.csv"},
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
