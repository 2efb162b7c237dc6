// SPDX-License-Identifier: GPL-3.0-or-later
// How far strain by gap (24_strain/layer_contact.hpp) is from the strain of elastic layers: in contacts of a
// sphere, along oblique rays, and in a hip.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "files/csv.hpp"
#include "hip/motion.hpp"

namespace impinge::lab {

// strain_layer.csv: one contact of an elastic layer per row (24_strain/layer_contact.hpp). Pressure and force
// by gap, as for independent springs, are divided by the elastic ones; strains are divided by strain by gap
// in the middle of the contact.
Table layer_table();
// Adds the row of a layer with this Poisson ratio, `thickness` radii of contact thick.
void add_layer(Table& table, double poisson, double thickness);

// A rigid ball in a concentric socket, seen from an eccentric centre of rotation: all gaps are equally wide,
// and rays meet them at every angle.
struct ObliqueJoint {
  double ball_radius = 24.0;   // mm
  double gap = 2.0;            // mm, along the normal
  double cartilage = 4.0;      // mm, both layers, along the normal
  double off = 0.95;           // of the centre of rotation from theirs, over the ball's radius
  std::size_t faces = 20000;   // of each surface
  double precision_deg = 0.5;  // of the table
};

// strain_incidence.csv: one row per ten degrees of the angle between ray and normal.
Table incidence_table();
void add_incidence(Table& table, const ObliqueJoint& joint);  // adds its rows

// A preset (hip/hip_presets.hpp) in a pose.
struct StrainedHip {
  std::string preset;          // its name
  std::string pose;            // in the form that parse_motion() reads
  double cartilage = 4.0;      // mm, both layers: everywhere, or in the middle if it varies
  std::size_t faces = 12000;   // of each surface
  double precision_deg = 0.5;  // of the table
};

// strain_hip.csv: one row per hour of the dial and choice of cartilage, without hours that have no strain.
Table hip_strain_table();
void add_hip_strain(Table& table, const StrainedHip& hip);  // adds its rows

// Where the cartilage varies with the place, it is thicker in front and above by this share of its mean, and
// as much thinner at the other end. Our choice, to show the effect.
inline constexpr double kThicker = 0.3;

}  // namespace impinge::lab
