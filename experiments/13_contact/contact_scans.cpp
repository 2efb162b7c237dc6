// SPDX-License-Identifier: GPL-3.0-or-later
#include "13_contact/contact_scans.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <utility>

#include <benchmark/benchmark.h>

#include "13_contact/centred_table.hpp"
#include "kernels/corner_table.hpp"
#include "kernels/joint_scan.hpp"
#include "kernels/thread_team.hpp"
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

constexpr double kMostError = 1.0;      // mm, of the coarsest mesh here
constexpr double kLeastAnswered = 0.9;  // of the vertices that meet the other surface; others are at the rim

using Flat = InverseDepthTable<CubeGnomonic>;

RadialTable<CubeGnomonic> filled(const TriangleMesh& mesh, std::size_t cells, Layer layer) {
  return fill_exact(mesh, CubeGnomonic::with_precision(90.0 / static_cast<double>(cells)), layer);
}

// Vertices and the tables that `made` makes of mesh, cells and layer, and their scan.
template <class Made>
std::function<void(const Pose&, JointGaps&)> scan_of(const BallSocketPair& pair, ScanCells cells,
                                                     const Made& made) {
  auto lanes = packed_joint(made(pair.ball, cells.ball, Layer::farthest),
                            made(pair.socket, cells.socket, Layer::nearest), pair.ball, pair.socket);
  const auto joint = std::make_shared<const decltype(lanes)>(std::move(lanes));
  return [joint](const Pose& pose, JointGaps& gaps) { scan_joint(*joint, pose, gaps.ball, gaps.socket); };
}

bool same_bits(const std::vector<float>& a, const std::vector<float>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0;
}

// Gaps to the faces, mm.
struct ExactGaps {
  std::vector<double> ball;
  std::vector<double> socket;
};

ExactGaps exact_gaps(const CulledJoint& joint, const Pose& pose) {
  ExactGaps gaps;
  for (const Vec3& v : joint.meshes().ball.vertices)
    gaps.ball.push_back(joint.gap(Surface::ball, to_socket(pose, v)));
  for (const Vec3& v : joint.meshes().socket.vertices)
    gaps.socket.push_back(joint.gap(Surface::socket, to_ball(pose, v)));
  return gaps;
}

// Of the gaps of one pose.
struct Misfit {
  double largest = 0.0;      // error, mm
  std::size_t faced = 0;     // vertices that meet the other surface
  std::size_t answered = 0;  // of these, by the table
};

void add_misfit(Misfit& misfit, const std::vector<float>& gaps, const std::vector<double>& exact) {
  for (std::size_t i = 0; i < exact.size(); ++i) {
    if (std::isnan(exact[i])) continue;
    ++misfit.faced;
    if (std::isnan(gaps[i])) continue;
    ++misfit.answered;
    misfit.largest = std::max(misfit.largest, std::abs(static_cast<double>(gaps[i]) - exact[i]));
  }
}

void require_good(const std::string& method, const Misfit& misfit) {
  const auto faced = static_cast<double>(misfit.faced);
  if (misfit.largest <= kMostError && static_cast<double>(misfit.answered) >= kLeastAnswered * faced) return;
  throw std::runtime_error(method + ": a gap is off by " + std::to_string(misfit.largest) + " mm, and " +
                           std::to_string(misfit.answered) + " of " + std::to_string(misfit.faced) +
                           " are answered: its time means nothing until that is resolved");
}

void require_same(const ContactScan& way, std::span<const JointGaps> gaps) {
  for (std::size_t thread = 1; thread < way.threads; ++thread)
    if (!same_bits(gaps[thread].ball, gaps[0].ball) || !same_bits(gaps[thread].socket, gaps[0].socket))
      throw std::runtime_error(way.method + ": threads find different gaps in one pose");
}

}  // namespace

bool any_at_most_zero(const JointGaps& gaps) {
  const auto at_most_zero = [](float gap) { return gap <= 0.0F; };
  return std::ranges::any_of(gaps.ball, at_most_zero) || std::ranges::any_of(gaps.socket, at_most_zero);
}

ContactScans::ContactScans(const BallSocketPair& pair) {
  const auto rows = [](const auto&... of) { return packed_table<std::uint16_t>(filled(of...)); };
  const auto sampled = [](const auto&... of) { return corner_table(packed_table<float>(filled(of...))); };
  const auto centred = [](const TriangleMesh& mesh, std::size_t cells, Layer layer) {
    return corner_table(packed_table<float>(centred_table(mesh, filled(mesh, cells, layer), layer)));
  };
  ways.push_back({"all_vertices", scan_of(pair, kRowsCells, rows)});
  ways.push_back({"all_corners", scan_of(pair, kCentredCells, centred)});
  ways.push_back({"all_corners_2_threads", ways.back().scan, 2});
  ways.push_back({"all_corners_sampled", scan_of(pair, kSampledCells, sampled)});
  for (JointGaps& own : gaps) {
    own.ball.resize(pair.ball.vertices.size());
    own.socket.resize(pair.socket.vertices.size());
  }
}

void scan_poses(ContactScans& scans, const ContactScan& way, std::span<const Pose> poses) {
  const auto scan = [&](std::size_t thread) {
    const Share share = share_of(poses.size(), thread, way.threads);
    for (const Pose& pose : poses.subspan(share.first, share.end - share.first)) {
      way.scan(pose, scans.gaps[thread]);
      benchmark::ClobberMemory();
    }
  };
  way.threads == 1 ? scan(0) : on_threads(way.threads, scan);
}

std::map<std::string, double> scan_errors(ContactScans& scans, const CulledJoint& exact, const Pose& pose) {
  const ExactGaps truth = exact_gaps(exact, pose);
  std::map<std::string, double> errors;
  for (const ContactScan& way : scans.ways) {
    const std::vector<Pose> poses(way.threads, pose);
    scan_poses(scans, way, poses);
    Misfit misfit;
    add_misfit(misfit, scans.gaps.front().ball, truth.ball);
    add_misfit(misfit, scans.gaps.front().socket, truth.socket);
    require_good(way.method, misfit);
    require_same(way, scans.gaps);
    errors[way.method] = misfit.largest;
  }
  return errors;
}

}  // namespace impinge::lab
