// SPDX-License-Identifier: GPL-3.0-or-later
// @can     contact
// @links   gap_simd centred_table
//
// The gaps of all vertices of a joint by the kernels: all_vertices, of tables in 16 bits; all_corners, of
// tables with the corners of a cell together and centred errors, as accurate; all_corners_2_threads, the
// same, two threads sharing the poses; all_corners_sampled, corners of finer tables, not centred, as
// accurate.

#include <algorithm>
#include <memory>
#include <utility>

#include "files/thread_team.hpp"
#include "gap/simd/corner_table.hpp"
#include "gap/simd/joint_scan.hpp"
#include "methods/centred_table.hpp"
#include "methods/contact.hpp"
#include "table/exact_raster.hpp"

namespace impinge::lab {
namespace {

// Cells along an edge of the cube, of the tables of both surfaces.
struct ScanCells {
  std::size_t ball, socket;
};
// Those with which errors of gaps stay below 7 um at 12,000 triangles, along every direction. The socket,
// which is wider and smoother, is as accurate with fewer; so are both once their errors are centred.
constexpr ScanCells kRowsCells{291, 291};
constexpr ScanCells kSampledCells{291, 128};
constexpr ScanCells kCentredCells{150, 64};

using Scan = std::function<void(const Pose&, JointGaps&)>;  // in one pose; threads may ask at the same time

RadialTable<CubeGnomonic> filled(const TriangleMesh& mesh, std::size_t cells, Layer layer) {
  return fill_exact(mesh, CubeGnomonic::with_precision(90.0 / static_cast<double>(cells)), layer);
}

// Vertices and the tables that `made` makes of mesh, cells and layer, and their scan.
template <class Made>
Scan scan_of(const BallSocketPair& pair, ScanCells cells, const Made& made) {
  auto packed = packed_joint(made(pair.ball, cells.ball, Layer::farthest),
                             made(pair.socket, cells.socket, Layer::nearest), pair.ball, pair.socket);
  const auto joint = std::make_shared<const decltype(packed)>(std::move(packed));
  return [joint](const Pose& pose, JointGaps& gaps) { scan_joint(*joint, pose, gaps.ball, gaps.socket); };
}

// A scan and what its threads write to.
struct Threads {
  Threads(Scan by, std::size_t threads, const BallSocketPair& pair)
      : scan(std::move(by)),
        gaps(threads, JointGaps{std::vector<float>(pair.ball.vertices.size()),
                                std::vector<float>(pair.socket.vertices.size())}) {}

  // The threads share the poses.
  void run(std::span<const Pose> poses) {
    const auto one = [&](std::size_t thread) {
      const std::size_t first = poses.size() * thread / gaps.size();
      const std::size_t end = poses.size() * (thread + 1) / gaps.size();
      for (const Pose& pose : poses.subspan(first, end - first)) scan(pose, gaps[thread]);
    };
    gaps.size() == 1 ? one(0) : on_threads(gaps.size(), one);
  }

  Scan scan;
  std::vector<JointGaps> gaps;  // of each thread, of its last pose
};

bool any_at_most_zero(const JointGaps& gaps) {
  const auto at_most_zero = [](float gap) { return gap <= 0.0F; };
  return std::ranges::any_of(gaps.ball, at_most_zero) || std::ranges::any_of(gaps.socket, at_most_zero);
}

ContactQuery query_of(const BallSocketPair& pair, Scan scan, std::size_t threads) {
  const auto team = std::make_shared<Threads>(std::move(scan), threads, pair);
  return {[team](const Pose& pose) {
            team->scan(pose, team->gaps.front());
            return any_at_most_zero(team->gaps.front());
          },
          [team](std::span<const Pose> poses) { team->run(poses); },
          {},
          [team](const Pose& pose) {
            team->run(std::vector<Pose>(team->gaps.size(), pose));
            return std::span<const JointGaps>(team->gaps);
          }};
}

std::vector<ContactCase> scan_cases(const BallSocketPair& pair) {
  const auto rows = [](const auto&... of) { return packed_table<std::uint16_t>(filled(of...)); };
  const auto sampled = [](const auto&... of) { return corner_table(packed_table<float>(filled(of...))); };
  const auto centred = [](const TriangleMesh& mesh, std::size_t cells, Layer layer) {
    return corner_table(packed_table<float>(centred_table(mesh, filled(mesh, cells, layer), layer)));
  };
  const auto scan_case = [&pair](const char* name, const char* label, ScanCells cells, const auto& made,
                                 std::size_t threads = 1) {
    ContactCase one{{name, label, "", 4}};
    one.contact = Contact::gaps;
    one.make = [&pair, cells, made, threads] { return query_of(pair, scan_of(pair, cells, made), threads); };
    return one;
  };
  return {scan_case("all_vertices", "all gaps, 16 bits", kRowsCells, rows),
          scan_case("all_corners", "all gaps, corners", kCentredCells, centred),
          scan_case("all_corners_2_threads", "all gaps, corners, two threads", kCentredCells, centred, 2),
          scan_case("all_corners_sampled", "all gaps, corners, not centred", kSampledCells, sampled)};
}

}  // namespace

Method all_gaps_method() {
  Method method;
  method.contact = scan_cases;
  return method;
}

}  // namespace impinge::lab
