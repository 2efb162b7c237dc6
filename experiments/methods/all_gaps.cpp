// SPDX-License-Identifier: GPL-3.0-or-later
// @can     contact
// @links   gap_simd
//
// all_vertices: the gaps of all vertices of a joint, by the kernels on tables in 16 bits.

#include <algorithm>
#include <memory>

#include "gap/simd/joint_scan.hpp"
#include "methods/contact.hpp"
#include "table/exact_raster.hpp"

namespace impinge::lab {
namespace {

// Cells along an edge of the cube, for the tables of both surfaces. On joints of 12,000 triangles the error
// of a gap stays below 7 um in every direction.
constexpr double kCellsOfAnEdge = 291.0;

PackedTable<CubeGnomonic, std::uint16_t> filled(const TriangleMesh& mesh, Layer layer) {
  return packed_table<std::uint16_t>(
      fill_exact(mesh, CubeGnomonic::with_precision(90.0 / kCellsOfAnEdge), layer));
}

// A joint in the form that the kernels read, and the gaps of its last pose.
class ScannedJoint {
 public:
  explicit ScannedJoint(const BallSocketPair& pair)
      : joint_(packed_joint(filled(pair.ball, Layer::farthest), filled(pair.socket, Layer::nearest),
                            pair.ball, pair.socket)),
        gaps_{std::vector<float>(pair.ball.vertices.size()),
              std::vector<float>(pair.socket.vertices.size())} {}

  const JointGaps& scan(const Pose& pose) {
    scan_joint(joint_, pose, gaps_.ball, gaps_.socket);
    return gaps_;
  }

 private:
  PackedJoint<PackedTable<CubeGnomonic, std::uint16_t>> joint_;
  JointGaps gaps_;
};

bool any_at_most_zero(const JointGaps& gaps) {
  const auto at_most_zero = [](float gap) { return gap <= 0.0F; };
  return std::ranges::any_of(gaps.ball, at_most_zero) || std::ranges::any_of(gaps.socket, at_most_zero);
}

ContactQuery query_of(const BallSocketPair& pair) {
  const auto joint = std::make_shared<ScannedJoint>(pair);
  return {[joint](const Pose& pose) { return any_at_most_zero(joint->scan(pose)); },
          [joint](std::span<const Pose> poses) {
            for (const Pose& pose : poses) joint->scan(pose);
          },
          {},
          [joint](const Pose& pose) -> const JointGaps& { return joint->scan(pose); }};
}

std::vector<ContactCase> scan_cases(const BallSocketPair& pair) {
  ContactCase one{{"all_vertices", "all gaps, 16 bits", "", 4}};
  one.contact = Contact::gaps;
  one.make = [&pair] { return query_of(pair); };
  return {one};
}

}  // namespace

Method all_gaps_method() {
  Method method;
  method.contact = scan_cases;
  return method;
}

}  // namespace impinge::lab
