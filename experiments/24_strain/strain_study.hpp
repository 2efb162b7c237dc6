// SPDX-License-Identifier: GPL-3.0-or-later
// How far strain by gap (24_strain/layer_contact.hpp) is from that of elastic layers, at oblique rays, and in
// a hip.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "files/csv.hpp"
#include "hip/motion.hpp"

namespace impinge::lab {

// strain_layer.csv: one contact of an elastic layer a row, see 24_strain/layer_contact.hpp. What the gap
// says, or what follows from it for independent springs, over the elastic answer; strains over that by gap in
// the middle of the contact.
Table layer_table();
// Adds its row: a layer of that Poisson ratio, `thickness` radii of contact thick.
void add_layer(Table& table, double poisson, double thickness);

// A rigid ball in a socket about the same centre, looked at from a centre of rotation that is off: every gap
// is equally wide, and rays meet it at every angle.
struct ObliqueJoint {
  double ball_radius = 24.0;   // mm
  double gap = 2.0;            // mm, along the normal
  double cartilage = 4.0;      // mm, both layers, along the normal
  double off = 0.95;           // of the centre of rotation, over the radius of the ball
  std::size_t faces = 20000;   // of each surface
  double precision_deg = 0.5;  // of the table
};

// strain_incidence.csv: ten degrees of the angle between ray and normal a row.
Table incidence_table();
void add_incidence(Table& table, const ObliqueJoint& joint);  // adds its rows

// A preset (hip/hip_presets.hpp) in a pose.
struct StrainedHip {
  std::string preset;          // its name
  std::string pose;            // as parse_motion() reads it
  double cartilage = 4.0;      // mm, both layers: everywhere, or in the middle
  std::size_t faces = 12000;   // of each surface
  double precision_deg = 0.5;  // of the table
};

// strain_hip.csv: an hour of the socket's dial and a choice of cartilage a row; hours without strain are left
// out.
Table hip_strain_table();
void add_hip_strain(Table& table, const StrainedHip& hip);  // adds its rows

// By place the cartilage is thicker in front and above, by this share of its mean, and as much thinner at the
// other end: our choice, to show what it changes.
inline constexpr double kThicker = 0.3;

}  // namespace impinge::lab
