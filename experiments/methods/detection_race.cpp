// SPDX-License-Identifier: GPL-3.0-or-later
#include "methods/detection_race.hpp"

#include <stdexcept>
#include <string>

#include "methods/cgal_tree.hpp"
#include "methods/fcl_obb.hpp"
#include "methods/pairwise.hpp"
#include "sphere/schemes/rsid.hpp"
#include "sphere/schemes/usid.hpp"

namespace impinge::lab {
namespace {

template <SamplingScheme S>
std::unique_ptr<Contender> make_table_scan(const BallSocketPair& pair, double precision_deg) {
  return std::make_unique<TableScan<S>>(pair.ball, pair.socket, make_tables<S>(pair, precision_deg));
}

}  // namespace

Contender& DetectionRace::contender(std::string_view name) const {
  for (const auto& candidate : contenders) {
    if (candidate->name() == name) return *candidate;
  }
  throw std::out_of_range(std::string(name) + ": no such contender");
}

DetectionRace make_detection_race(const BallSocketPair& pair, double precision_deg) {
  DetectionRace race;
  race.poses = pose_set(pair.ball, pair.socket);
  race.oracle = make_cgal_tree(pair.ball, pair.socket);
  race.contenders.push_back(make_pairwise(pair.ball, pair.socket));
  race.contenders.push_back(make_fcl_obb(pair.ball, pair.socket));
  race.contenders.push_back(make_table_scan<Rsid>(pair, precision_deg));
  race.contenders.push_back(make_table_scan<Usid>(pair, precision_deg));
  return race;
}

}  // namespace impinge::lab
