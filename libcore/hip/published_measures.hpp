// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Published values of populations for the measures of hip/measure_list.hpp whose definition is the same.
/// Angles in degrees.
///
/// Alpha is that of radial planes about the neck axis, where the contour leaves the circle of the head
/// (Noetzli 2002); neck-shaft angle and torsion are in space; version is in the transverse plane through the
/// centre, where the rim's plane meets it; the centre-edge angle is Wiberg's, from the vertical, as the
/// radiograph shows it (ours is in the coronal plane through the centre); the half opening is from the rim to
/// the axis of its plane. Two depend on how the joint lies in its frame: torsion is comparable if the
/// transverse axis is that of the knee, version if the pelvis lies as in a scanner.
///
/// Left out: head_neck_offset (ours is from the neck's mean radius; published is the anterior one, and its
/// ratio to the head's diameter), coverage (ours is a share of all directions; published is of the head, by
/// several definitions), inclination (published is Sharp's angle, from the teardrop, or that of a rim in the
/// anterior pelvic plane), alpha at the other hours and both radii (no source at hand).
#pragma once

#include <optional>
#include <string_view>

namespace impinge {

/// As the source has it: mean and standard deviation, or median and quartiles; degrees.
struct PublishedMeasure {
  std::string_view measure;  // its name, as Measure::name
  std::optional<double> mean;
  std::optional<double> sd;
  std::optional<double> median;
  std::optional<double> lower_quartile;
  std::optional<double> upper_quartile;
  std::string_view of;      // the group, and how it was measured
  std::string_view source;  // author and year, then where
};

/// Published values of the measure of that name; all members are empty if there are none.
PublishedMeasure published_measure(std::string_view measure);

}  // namespace impinge
