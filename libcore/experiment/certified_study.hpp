// SPDX-License-Identifier: GPL-3.0-or-later
// Are certified verdicts ever wrong, how many vertices do they leave undecided, and what do scans of vertices
// miss of the surfaces?
#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "detection/certified_gap.hpp"
#include "detection/overlay.hpp"
#include "experiment/contact_poses.hpp"
#include "experiment/csv.hpp"
#include "mesh/ball_socket_pair.hpp"
#include "sampling/cell_range.hpp"

namespace impinge {

// A pose and what the oracle (reference/shadow.hpp) says about it.
struct JudgedPose {
  Pose pose;
  std::vector<bool> ball;    // vertices that impinge
  std::vector<bool> socket;  // the same
  bool surfaces = false;     // seen from either centre

  bool vertices() const;  // is some vertex impinged?
};

struct CertifiedJoint {
  std::string name;
  SurfaceOverlay overlay;
  std::vector<JudgedPose> poses;
  std::size_t crossings_matter = 0;  // poses with all vertices clear and the surfaces impinged
  double largest_missed = 0.0;       // mm, the deepest of those
};

// A verdict that the oracle refutes. what() is one line that names the joint and where the pose was written.
class WrongVerdict : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// What judging leaves in certified.csv and certified_poses.csv; and where a refuted pose is kept.
struct CertifiedStudy {
  std::filesystem::path folder;  // of the witness
  Table schemes;
  Table poses;
};
CertifiedStudy make_certified_study(const std::filesystem::path& folder);

// Makes poses of the joint, asks the oracle and the overlay about each of them, and adds the joint's row to
// study.poses. Throws WrongVerdict, with the pose in certified_witness.json, where they differ, or where CGAL
// finds a common point of surfaces that are not impinged.
CertifiedJoint judge_joint(CertifiedStudy& study, std::string name, const BallSocketPair& meshes,
                           const ContactOptions& options);

// What one scheme decides.
struct SchemeVerdicts {
  VerdictCount vertices;  // before undecided ones are resolved
  double seconds = 0.0;   // both scans, undecided vertices resolved
};

// Throws WrongVerdict, with the pose in certified_witness.json, where a verdict is not the oracle's.
void require_verdicts(const CertifiedStudy& study, const CertifiedJoint& joint, const JudgedPose& judged,
                      const std::vector<CertifiedGap>& ball, const std::vector<CertifiedGap>& socket);

// All poses of a joint with the ranges of one scheme: the verdicts as the ranges give them, and again with
// undecided vertices resolved, are compared with the oracle's.
template <SamplingScheme S>
SchemeVerdicts judge_scheme(const CertifiedStudy& study, const CertifiedJoint& joint, const S& scheme) {
  const TriangleMesh& ball = joint.overlay.ball();
  const TriangleMesh& socket = joint.overlay.socket();
  const RangeTable<S> ball_ranges = fill_ranges(ball, scheme);
  const RangeTable<S> socket_ranges = fill_ranges(socket, scheme);
  std::vector<CertifiedGap> ball_gaps(ball.vertices.size());
  std::vector<CertifiedGap> socket_gaps(socket.vertices.size());
  SchemeVerdicts found;
  for (const JudgedPose& judged : joint.poses) {
    const Pose& pose = judged.pose;
    const auto start = std::chrono::steady_clock::now();
    certify_ball(socket_ranges, ball.vertices, pose, ball_gaps);
    certify_socket(ball_ranges, socket.vertices, pose, socket_gaps);
    const auto scanned = std::chrono::steady_clock::now();
    require_verdicts(study, joint, judged, ball_gaps, socket_gaps);
    for (const auto& gaps : {ball_gaps, socket_gaps}) found.vertices += count_verdicts(gaps);
    const auto resumed = std::chrono::steady_clock::now();
    resolve_ball(socket, joint.overlay.socket_index(), ball.vertices, pose, ball_gaps);
    resolve_socket(ball, joint.overlay.ball_index(), socket.vertices, pose, socket_gaps);
    const auto resolved = std::chrono::steady_clock::now();
    require_verdicts(study, joint, judged, ball_gaps, socket_gaps);
    found.seconds += std::chrono::duration<double>((scanned - start) + (resolved - resumed)).count();
  }
  return found;
}

// The row of a scheme in study.schemes.
void add_scheme_row(CertifiedStudy& study, const CertifiedJoint& joint, std::string_view scheme,
                    double precision_deg, const SchemeVerdicts& found);

}  // namespace impinge
