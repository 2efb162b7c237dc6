// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Published values, in degrees, for those measures of hip/measure_list.hpp whose definition is the same.
#pragma once

#include <optional>
#include <string_view>

namespace impinge {

/// As the source has it: mean and standard deviation, or median and quartiles; degrees.
struct PublishedMeasure {
  std::string_view measure;  // as Measure::name
  std::optional<double> mean;
  std::optional<double> sd;
  std::optional<double> median;
  std::optional<double> lower_quartile;
  std::optional<double> upper_quartile;
  std::string_view of;      // the group, and how it was measured
  std::string_view source;  // author and year, then where
};

/// Published values of the measure of that name; all members are empty if there are none.
///
/// Alpha is measured in radial planes about the neck axis, where the contour leaves the circle of the head
/// (Noetzli 2002). Neck-shaft angle and torsion are in space. Version is in the transverse plane through the
/// centre, where it cuts the rim's plane. The centre-edge angle is Wiberg's, from the vertical, as the
/// radiograph shows it; ours is in the coronal plane through the centre. The half opening is from the rim to
/// the axis of its plane. Two depend on how the joint lies in its frame: torsion is comparable if the
/// transverse axis is the knee's, version if the pelvis lies as in a scanner.
///
/// Left out: head_neck_offset (ours is from the neck's mean radius; the published one is anterior, and its
/// ratio to the head's diameter), coverage (ours is a share of all directions; the published one is a share
/// of the head, by several definitions), inclination (the published one is Sharp's angle, from the teardrop,
/// or the rim's in the anterior pelvic plane), alpha at the other hours and both radii (no source at hand).
PublishedMeasure published_measure(std::string_view measure);

}  // namespace impinge
