// SPDX-License-Identifier: GPL-3.0-or-later
// Times whether a joint touches, and its smallest gap: culled, by scans of all vertices, and by libraries.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "10_error_against_time/report.hpp"
#include "contact/culled_joint.hpp"
#include "files/csv.hpp"
#include "mesh/ball_socket_pair.hpp"
#include "methods/contact.hpp"

namespace impinge::lab {

// A method prepared for a joint, with the cost of preparing it.
struct MadeContact {
  ContactCase method;
  std::shared_ptr<const ContactQuery> query;
  double build_s = 0.0;
  double bytes = 0.0;  // heap memory; NaN where it is not counted
};
// All methods, prepared for a joint that must outlive them.
std::vector<MadeContact> made_contacts(const BallSocketPair& pair);

QuestionTable make_contact_table();  // contact.csv

// The key columns scene, method, gap_case, triangles.
std::vector<Column> contact_keys();

// First compares the answers that are timed. Every culled answer is compared with the exact test of all
// vertices, or one of several if there are many; other methods with the exact overlay of the faces in every
// pose. Throws std::runtime_error if one differs by more than float explains. The methods must be those of
// the scene's joint. Adds the rows of the scene; a gap case without motions is left out and reported.
void run_contact(const BenchmarkScene& scene, std::span<const MadeContact> methods,
                 const BenchmarkOptions& options, QuestionTable& found, Progress& progress);

// Gaps of all vertices to the faces in a pose, and the errors of a method.

/// Does the exact test find an impinged vertex?
bool any_impinged(const CulledJoint& joint, const Pose& pose);

/// Gaps to the faces, mm, by the exact reference (reference/exact_radius.hpp); NaN where the other surface is
/// not met.
struct ExactGaps {
  std::vector<double> ball;
  std::vector<double> socket;
};
ExactGaps exact_gaps(const BallSocketPair& pair, const Pose& pose);

/// Largest difference, mm, between our own exact gaps and `exact`, over vertices that both answer.
double own_difference(const CulledJoint& joint, const ExactGaps& exact, const Pose& pose);

/// Largest error of a gap, mm, over the vertices that are answered. Throws std::runtime_error if it is larger
/// than a table allows.
double gap_error(const MadeContact& made, const ExactGaps& exact, const Pose& pose);

// Motions of a joint with a known smallest gap, for timing contact: the time of an answer depends on the gap.

// A motion whose smallest gap stays within limits. The ball is first turned by up to a radian about any axis
// and pushed towards the socket, up to a quarter turn from the socket's axis (methods/pose_set.hpp), until
// the gap is as wanted. Then it turns on, and every pose must keep the limits.
struct MotionGap {
  std::string_view name;  // in the results
  double from_mm;         // smallest gap in the first pose of a motion, evenly distributed
  double to_mm;
  double least_mm;  // limits in every pose
  double most_mm;
};
// From free to touching.
inline constexpr std::array kMotionGaps{MotionGap{"over 2 mm", 2.1, 2.5, 2.0, 3.0},
                                        MotionGap{"0.5 mm", 0.45, 0.55, 0.4, 0.6},
                                        MotionGap{"touching", -0.3, 0.05, -0.5, 0.1}};

inline constexpr std::size_t kMotions = 16;      // of each case
inline constexpr std::size_t kMotionPoses = 16;  // of each motion, one after the other
inline constexpr double kMotionStepDeg = 0.5;    // turn between two poses, about any axis

// The poses of all motions, one motion after the other; empty if the joint has too few.
std::vector<Pose> contact_motions(const CulledJoint& joint, const MotionGap& gap, std::uint64_t seed);

// Do all ways to test a joint for touch agree, even close to contact?

// How often what is asked.
struct AgreementOptions {
  std::size_t triangles = 3000;  // of each surface
  std::size_t poses = 10000;     // of the ball
  std::uint64_t seed = 0;        // for paths, and for places on them
};

// The number of poses in which the ways differ.
struct Agreement {
  std::size_t poses = 0;     // poses that were tested
  std::size_t impinged = 0;  // impinged by the exact test of every vertex
  std::size_t missed = 0;    // missed by that test, though the exact overlay finds that the surfaces impinge
  std::size_t culled_wrong = 0;  // culled answers that differ from the exact test
  std::size_t least_gap_wrong =
      0;  // smallest gap at or below zero and no vertex impinged, or the other way round
  std::size_t between_vertices =
      0;  // a contact by FCL and by the exact overlay of the surfaces, but of no vertex
  std::size_t beyond =
      0;  // a vertex is beyond the other surface along its ray, but the faces have no contact
  std::size_t unexplained = 0;  // FCL differs, and none of the above explains it
};

// Compares on a generated pair. Of four poses one lies anywhere on its path, and three lie within 10^-5 to
// 10^-0.5 mm of the first contact of a vertex; see contact_poses.hpp.
Agreement contact_agreement(const BallSocketPair& joint, const AgreementOptions& options);

Table agreement_table(const AgreementOptions& options, const Agreement& agreement);  // One row.

}  // namespace impinge::lab
