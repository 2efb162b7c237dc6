// SPDX-License-Identifier: GPL-3.0-or-later
// How far joints turn: every named motion, about the centre of the head and about the socket's, up to contact
// and up to thresholds of the gap.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "files/csv.hpp"
#include "hip/clock.hpp"
#include "hip/named_motion.hpp"
#include "limits/told_limit.hpp"
#include "phantoms/phantom.hpp"

namespace impinge::lab {

// Meshes in the joint frame, mm, the centre of the head as origin.
struct StudiedJoint {
  std::string name;          // in the results
  BallSocketPair meshes;     // mm
  std::optional<Side> side;  // without a side only flexion and extension are known
};

// The point about which the joint turns.
enum class CentreStrategy {
  head,    // fixed: the centre of the head in the pose of the scan
  socket,  // equidistant: the head is moved to the centre of a sphere fitted to the socket, so the joint
           // space is even (the static form of Puls et al. 2010)
};

// One motion of one joint, to contact or to a gap.
struct LimitCase {
  std::string joint;                             // its name
  const NamedMotion* motion = nullptr;           // one of named_motions()
  CentreStrategy centre = CentreStrategy::head;  // the joint turns about it
  double shift_mm = 0.0;                         // of the head from the pose of the scan
  ToldLimit told;                                // as the program reports it
  std::string clock;                             // of the contact on the socket; empty where there is none
  std::optional<double> smallest_gap;            // of a vertex, mm, at the lower end of the bracket
};

// All motions up to contact, and about the head's centre up to each of these gaps, mm.
std::vector<LimitCase> limits_of(const StudiedJoint& joint, const std::vector<double>& gaps_mm);

// The tables motion_limits and motion_limit_details.
Table limit_table(const std::vector<LimitCase>& cases);
// Brackets, places, and what half a millimetre of the input changes.
Table limit_detail_table(const std::vector<LimitCase>& cases);

Table phantom_table(const std::vector<PhantomRow>& rows);  // the table of validation (phantoms/phantom.hpp)

}  // namespace impinge::lab
