// SPDX-License-Identifier: GPL-3.0-or-later
#include "contenders/detection_race.hpp"

#include <stdexcept>
#include <string>

#include "contenders/cgal_tree.hpp"
#include "contenders/fcl_obb.hpp"
#include "contenders/pairwise.hpp"
#include "sampling/exact_raster.hpp"

namespace impinge {

std::shared_ptr<const TablePair<Rsid>> make_rsid_tables(const BallSocketPair& pair, double precision_deg) {
  const Rsid scheme = Rsid::with_precision(precision_deg);
  return std::make_shared<const TablePair<Rsid>>(TablePair<Rsid>{
      fill_exact(pair.ball, scheme, Layer::farthest), fill_exact(pair.socket, scheme, Layer::nearest)});
}

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
  race.contenders.push_back(
      std::make_unique<TableScan<Rsid>>(pair.ball, pair.socket, make_rsid_tables(pair, precision_deg)));
  return race;
}

}  // namespace impinge
