// SPDX-License-Identifier: GPL-3.0-or-later
// Recorded motions of a hip, replayed: each turns the ball about one axis of the joint, from the pose as
// modelled to the angle recorded. In every pose the gaps of both surfaces, and where on the dial of the
// socket they are small (thesis, Section 5.2, Tables 11 to 13).
#pragma once

#include <string>
#include <vector>

#include "21_motion_frames/hip_scan.hpp"
#include "files/csv.hpp"

namespace impinge::lab {

// One motion to its end; names as in hip/motion.hpp, degrees.
struct RecordedMotion {
  std::string motion;      // one of motion_names()
  double angle_deg = 0.0;  // at its end
};

// How finely a motion is followed, and what is told of it.
struct ReplayOptions {
  double precision_deg = 0.5;  // of the tables, RSID
  double step_deg = 1.0;       // at most, between the poses of a motion: they are evenly spread
  // Gaps up to which a zone is told, mm: contact; the colours of Tables 12 and 13, red, orange and yellow;
  // and the cartilage of Section 3.4.
  std::vector<double> thresholds{0.0, 2.0, 4.0, 6.0};
};

// Rows joint,motion,angle_deg,... of every pose, and of every zone of every pose.
struct ReplayTables {
  Table frames;  // a row a pose
  Table zones;   // a row a zone of a pose
};
ReplayTables replay_tables();  // with their columns, and no row

// Adds the poses of a hip to the tables.
void replay(const ReplayedHip& hip, const std::vector<RecordedMotion>& motions, const ReplayOptions& options,
            ReplayTables& tables);

}  // namespace impinge::lab
