// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a joint touches, and its smallest gap: culled, by scans of all vertices, and by libraries.
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

// A method of a joint, made once, with what that took.
struct MadeContact {
  ContactCase method;
  std::shared_ptr<const ContactQuery> query;
  double build_s = 0.0;
  double bytes = 0.0;  // of the heap; NaN where it is not counted
};
// Those of all methods, of a joint that outlives them.
std::vector<MadeContact> made_contacts(const BallSocketPair& pair);

QuestionTable make_contact_table();  // contact.csv

// scene, method, gap_case, triangles.
std::vector<Column> contact_keys();

// Every culled answer that is timed is compared with the exact test of all vertices first, or one of several
// where there are many; other methods with the exact overlay of the faces in every pose. std::runtime_error
// where one differs by more than float explains. The methods are those of the scene's joint. Adds the rows of
// the scene; a gap case that it has no motions of is left out, and the progress says so.
void run_contact(const BenchmarkScene& scene, std::span<const MadeContact> methods,
                 const BenchmarkOptions& options, QuestionTable& found, Progress& progress);

// The gaps of all vertices to the faces in a pose, and how far those of a method are off.

/// Does the exact test of every vertex find one that is impinged?
bool any_impinged(const CulledJoint& joint, const Pose& pose);

/// Gaps to the faces, mm, by the exact reference (reference/exact_radius.hpp); NaN where the other surface is
/// not met.
struct ExactGaps {
  std::vector<double> ball;
  std::vector<double> socket;
};
ExactGaps exact_gaps(const BallSocketPair& pair, const Pose& pose);

/// Largest difference of the gaps that the library calls exact, mm, over vertices that both answer.
double own_difference(const CulledJoint& joint, const ExactGaps& exact, const Pose& pose);

/// Largest error of a gap, mm; a vertex without an answer has none. std::runtime_error where it is larger
/// than a table allows.
double gap_error(const MadeContact& made, const ExactGaps& exact, const Pose& pose);

// Motions of a joint in which the smallest gap is known, to time contact in: how long an answer takes depends
// on it.

// The ball is turned by up to a radian about any axis and pushed towards the socket, in a direction up to a
// quarter turn from its axis (methods/pose_set.hpp), until the smallest gap is as wanted; then it turns on,
// the gap staying within the limits.
struct MotionGap {
  std::string_view name;  // in the results
  double from_mm;         // smallest gap in the first pose of a motion, drawn evenly
  double to_mm;
  double least_mm;  // in every pose
  double most_mm;
};
// From free to touching.
inline constexpr std::array kMotionGaps{MotionGap{"over 2 mm", 2.1, 2.5, 2.0, 3.0},
                                        MotionGap{"0.5 mm", 0.45, 0.55, 0.4, 0.6},
                                        MotionGap{"touching", -0.3, 0.05, -0.5, 0.1}};

inline constexpr std::size_t kMotions = 16;      // of each case
inline constexpr std::size_t kMotionPoses = 16;  // of each, one after the other
inline constexpr double kMotionStepDeg = 0.5;    // from one to the next, about any axis

// Poses of all motions, one motion after the other; none where the joint has not so many.
std::vector<Pose> contact_motions(const CulledJoint& joint, const MotionGap& gap, std::uint64_t seed);

// How far a joint turns until its surfaces first touch: proven brackets (limits/turn_limit.hpp) beside what
// is done with a test of touch: steps until one touches, then halvings.

QuestionTable make_first_contact_table();  // first_contact.csv

// scene, method, setting, triangles.
std::vector<Column> first_contact_keys();

// Turns about random axes from the pose as it is, those that end in a common point of the surfaces.
// std::runtime_error where the exact overlay contradicts a bracket. The methods are those of the scene's
// joint. Adds the rows; none where the joint impinges already.
void run_first_contact(const BenchmarkScene& scene, std::span<const MadeContact> methods, bool quick,
                       const BenchmarkOptions& options, QuestionTable& found, Progress& progress);

// Do all ways to say whether a joint touches agree, close to contact too?

// What is asked how often.
struct AgreementOptions {
  std::size_t triangles = 3000;  // of each surface
  std::size_t poses = 10000;     // of the ball
  std::uint64_t seed = 0;        // of ways and places on them
};

// How many poses the ways differ in.
struct Agreement {
  std::size_t poses = 0;         // that were asked
  std::size_t impinged = 0;      // by the exact test of every vertex
  std::size_t missed = 0;        // by that test, where the exact overlay finds that the surfaces impinge
  std::size_t culled_wrong = 0;  // against that
  std::size_t least_gap_wrong =
      0;  // smallest gap at or below zero and no vertex impinged, or the other way round
  std::size_t between_vertices =
      0;                   // FCL finds a contact and the exact overlay of the surfaces does, no vertex does
  std::size_t beyond = 0;  // a vertex is beyond the other surface, along its ray, without a contact of faces
  std::size_t unexplained = 0;  // FCL differs and nothing explains it
};

// On a generated pair. Of four poses one lies anywhere on its way and three are within 10^-5 to 10^-0.5 mm of
// the first contact of a vertex; see contact_poses.hpp.
Agreement contact_agreement(const BallSocketPair& joint, const AgreementOptions& options);

Table agreement_table(const AgreementOptions& options, const Agreement& agreement);  // One row.

}  // namespace impinge::lab
