// SPDX-License-Identifier: GPL-3.0-or-later
// One joint with the methods of the thesis' Tables 4 and 9, the poses they are timed over and the oracle
// that each of them must agree with first.
#pragma once

#include <memory>
#include <vector>

#include "mesh/ball_socket_pair.hpp"
#include "methods/pose_set.hpp"
#include "methods/table_scan.hpp"
#include "table/exact_raster.hpp"

namespace impinge::lab {

// Tables of both surfaces by the exact raster: farthest layer of the ball, nearest of the socket.
template <SamplingScheme S>
std::shared_ptr<const TablePair<S>> make_tables(const BallSocketPair& pair, double precision_deg) {
  const S scheme = S::with_precision(precision_deg);
  return std::make_shared<const TablePair<S>>(TablePair<S>{fill_exact(pair.ball, scheme, Layer::farthest),
                                                           fill_exact(pair.socket, scheme, Layer::nearest)});
}

struct DetectionBenchmark {
  std::vector<NamedPose> poses;                       // that all of them are asked
  std::unique_ptr<TouchMethod> oracle;                // exact predicates
  std::vector<std::unique_ptr<TouchMethod>> methods;  // pairwise, fcl_obb, rsid, usid

  // Throws std::out_of_range when nobody has this name.
  TouchMethod& method(std::string_view name) const;
};

// Meshes in their centre frames, mm; the precision is that of the tables of rsid and usid.
DetectionBenchmark make_detection_benchmark(const BallSocketPair& pair, double precision_deg);

}  // namespace impinge::lab
