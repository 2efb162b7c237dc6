// SPDX-License-Identifier: GPL-3.0-or-later
// Are certified verdicts ever wrong, how many vertices do they leave undecided, and what do scans of vertices
// miss of the surfaces?
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "10_certified/certified_scan.hpp"
#include "files/csv.hpp"
#include "files/stopwatch.hpp"
#include "gap/overlay.hpp"
#include "harness/contact_poses.hpp"
#include "mesh/ball_socket_pair.hpp"

namespace impinge::lab {

// A pose and what the oracle (reference/shadow.hpp) says about it.
struct JudgedPose {
  Pose pose;                 // of the ball in the socket
  std::vector<bool> ball;    // vertices that impinge
  std::vector<bool> socket;  // the same
  bool surfaces = false;     // seen from either centre

  bool vertices() const;  // is some vertex impinged?
};

// A joint with poses that the oracle has judged.
struct CertifiedJoint {
  std::string name;                  // in the results
  SurfaceOverlay overlay;            // the library's own exact answer
  std::vector<JudgedPose> poses;     // judged
  std::size_t crossings_matter = 0;  // poses with all vertices clear and the surfaces impinged
  double largest_missed = 0.0;       // mm, the deepest of those
};

// What judging leaves in certified.csv and certified_poses.csv. A pose that refutes a verdict is kept in
// folder/certified_witness.json, the first one only.
struct CertifiedStudy {
  std::filesystem::path folder;  // of the results
  Table schemes;                 // certified.csv
  Table poses;                   // certified_poses.csv
  std::size_t wrong = 0;         // refuted verdicts, of vertices and surfaces
};
CertifiedStudy make_certified_study(const std::filesystem::path& folder);  // without a row

// Throws std::runtime_error, one line that says how many verdicts were wrong and where the pose is, unless
// none was.
void require_none_wrong(const CertifiedStudy& study);

// Makes poses of the joint, asks the oracle and the overlay about each of them, and adds the joint's row to
// study.poses. A verdict on surfaces is wrong where the two differ, or where CGAL finds a common point of
// surfaces that are called clear.
CertifiedJoint judge_joint(CertifiedStudy& study, std::string name, const BallSocketPair& meshes,
                           const ContactOptions& options);

// What one scheme decides.
struct SchemeVerdicts {
  std::size_t poses = 0;  // that were judged
  VerdictCount vertices;  // before undecided ones are resolved
  std::size_t wrong = 0;  // before and after
  double seconds = 0.0;   // both scans, undecided vertices resolved
};

// Vertices of either surface with a verdict, other than undecided, that is not the oracle's. They are counted
// in the study as well, and the pose is kept.
std::size_t count_wrong(CertifiedStudy& study, const CertifiedJoint& joint, const JudgedPose& judged,
                        std::span<const CertifiedGap> ball, std::span<const CertifiedGap> socket);

// Which poses of a joint: every `step`-th from `first` on.
struct PosePart {
  std::size_t first = 0;  // place of the first
  std::size_t step = 1;   // from one to the next
};

// Poses of a joint with the ranges of one scheme: the verdicts as the ranges give them, and again with
// undecided vertices resolved, are compared with the oracle's.
template <SamplingScheme S>
SchemeVerdicts judge_scheme(CertifiedStudy& study, const CertifiedJoint& joint, const S& scheme,
                            PosePart part = {}) {
  const TriangleMesh& ball = joint.overlay.ball();
  const TriangleMesh& socket = joint.overlay.socket();
  const RangeTable<S> ball_ranges = fill_ranges(ball, scheme);
  const RangeTable<S> socket_ranges = fill_ranges(socket, scheme);
  std::vector<CertifiedGap> ball_gaps(ball.vertices.size());
  std::vector<CertifiedGap> socket_gaps(socket.vertices.size());
  SchemeVerdicts found;
  for (std::size_t k = part.first; k < joint.poses.size(); k += part.step) {
    const JudgedPose& judged = joint.poses[k];
    const Pose& pose = judged.pose;
    ++found.poses;
    Stopwatch watch;
    certify(Surface::ball, socket_ranges, ball.vertices, pose, ball_gaps);
    certify(Surface::socket, ball_ranges, socket.vertices, pose, socket_gaps);
    found.seconds += watch.lap_s();
    found.wrong += count_wrong(study, joint, judged, ball_gaps, socket_gaps);
    found.vertices += count_verdicts(ball_gaps);
    found.vertices += count_verdicts(socket_gaps);
    watch.lap_s();  // the counting is not of the method
    resolve(Surface::ball, joint.overlay.faces(Surface::socket), ball.vertices, pose, ball_gaps);
    resolve(Surface::socket, joint.overlay.faces(Surface::ball), socket.vertices, pose, socket_gaps);
    found.seconds += watch.lap_s();
    found.wrong += count_wrong(study, joint, judged, ball_gaps, socket_gaps);
  }
  return found;
}

// The row of a scheme in study.schemes.
void add_scheme_row(CertifiedStudy& study, const CertifiedJoint& joint, std::string_view scheme,
                    double precision_deg, const SchemeVerdicts& found);

}  // namespace impinge::lab
