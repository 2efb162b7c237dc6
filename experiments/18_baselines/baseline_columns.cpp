// SPDX-License-Identifier: GPL-3.0-or-later
#include "18_baselines/baseline_study.hpp"

namespace impinge::lab {

std::vector<Column> baseline_columns() {
  return {
      {"joint", "", "generated, or the folder of a real joint"},
      {"method", "", "hu_voxels, maciel_triangles, cartesian_field, or rsid, the thesis' own"},
      {"setting", "", "its resolution, with unit"},
      {"size", "", "the number in the setting"},
      {"bytes", "B", "kept to answer"},
      {"build_ms", "ms", "median time of everything done once for the joint"},
      {"build_iqr_ms", "ms", "interquartile range; empty when extrapolated"},
      {"build_extrapolated", "", "yes: scaled by rays times faces from the largest size that was timed"},
      {"pose_us", "us", "median time of a pose, mean over the poses round a contact"},
      {"pose_iqr_us", "us", "interquartile range"},
      {"faces", "1", "triangles of the ball"},
      {"faces_missed", "1", "of them, without an entry of the table; empty where there is none by direction"},
      {"points", "1", "vertices that the other surface is exactly known for"},
      {"points_missed", "1", "of them, without an answer"},
      {"largest_error_mm", "mm", "of the answers: radius of the ball, or distance from the socket"},
      {"rms_error_mm", "mm", "root mean square of the same"},
      {"poses", "1", "on either side of a first contact, 0.05 to 4 mm of way from it"},
      {"false_touches", "1", "poses said to touch that are free"},
      {"missed_touches", "1", "poses said to be free that touch"},
      {"wrong_within_mm", "mm", "largest way from the contact with a wrong answer"},
      {"gives_distance", "", "yes: the work also yields distances everywhere"}};
}

std::vector<Column> baseline_keys() {
  return {{"joint", "", "generated, or the folder of a real joint"},
          {"method", "", "of detection"},
          {"setting", "", "its resolution"},
          {"step", "", "build: done once; pose: one pose"}};
}

}  // namespace impinge::lab
