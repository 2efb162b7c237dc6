// SPDX-License-Identifier: GPL-3.0-or-later
// The contact of a rigid sphere with an elastic layer that is bonded to rigid bone, without friction. It is
// the linear solution for any thickness and Poisson ratio (Lebedev and Ufliand 1958; equations in the .cpp),
// with which strain by gap is compared. Bone is the plane z = 0, the layer is h thick, and in the circle of
// contact r <= a its surface sinks by d - r^2 / (2 R).
//
// Two equal layers on bones with 1 / R_1 - 1 / R_2 = 1 / R are two such problems, mirror images of each
// other, each with half of d and twice R: h is the thickness of one layer, and friction has no effect.
#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "hip/cartilage_map.hpp"

namespace impinge::lab {

// The layer, in units of its shear modulus mu and of the radius R of the sphere.
struct ElasticLayer {
  double poisson = 0.5;    // nu, 0 to 1/2
  double thickness = 1.0;  // h over R
};

// The contact with one radius. Everything is linear in 1 / R. Lengths in units of R, stresses of mu.
class LayerContact {
 public:
  // `contact` is a / R. Throws std::invalid_argument for a Poisson ratio outside 0 to 1/2, for lengths that
  // are not positive, and for h / a outside 0.05 to 50, where the limits suffice.
  LayerContact(const ElasticLayer& layer, double contact);

  double contact() const { return a_; }   // a
  double approach() const { return d_; }  // d: how far the sphere has come since it touched
  double force() const;                   // in units of mu R^2
  double pressure(double r) const;        // on the surface; 0 where r >= a
  double sunk(double r) const;            // depth by which the surface sinks
  double bone_strain(double r) const;     // compression along z at the bone
  double bone_shear(double r) const;      // engineering shear strain at the bone, positive outwards
  double middle_surface_strain() const;   // compression along z at the surface, r = 0
  double strain_by_gap(double r) const;   // overlap of the undeformed shapes over h, 0 without one
  double aggregate_modulus() const;       // lambda + 2 mu, infinite for nu = 1/2

 private:
  double bend(double t) const;  // -phi'(t) / t

  ElasticLayer layer_;
  double a_;
  double d_ = 0.0;
  Eigen::ArrayXd t_;          // nodes in (0, a)
  Eigen::ArrayXd phi_;        // phi times the weight, at them
  Eigen::ArrayXd xi_;         // nodes in transform space
  Eigen::ArrayXd xi_step_;    // their weights
  Eigen::ArrayXd missing_;    // g times the weight, at them
  Eigen::ArrayXd transform_;  // integral of phi(t) cos(xi t), at them
};

// What a gap says about the strain of the cartilage: the thesis calls its colours "approximate strain"
// (Section 3.4). Two layers that are h thick together and lie in a gap g < h overlap by h - g. They are
// squeezed into the gap, so their compression along the ray, averaged over both, is
//   1 - g / h.
// Experiment 24 measures how far that holds:
// - It is neither a stress nor the largest strain. It leaves out how the layers bulge and shear, and it is
//   engineering strain, which no linear theory follows far.
// - The place of overlap is not the place of contact: thick layers sink before they are touched, and
//   incompressible ones rise beside the overlap and touch there too.
// - Both lengths are taken along the ray. If the ray meets the bone at the angle psi to its normal and h was
//   measured along the normal, the layers are h / cos psi thick along the ray: a strain with h itself is too
//   small, one with g cos psi is right.

// Compression of the cartilage in a gap: 0 where its layers do not touch, 1 where nothing is left between the
// bones or they overlap. `gap` is in mm; NaN, where the other surface is not met, is returned. `thickness` of
// both layers together is in mm, 0 or more, along the same line.
double gap_strain(double gap, double thickness);

// The compression at each place (centre frame, posed), with the map's thickness there.
std::vector<double> gap_strains(std::span<const double> gap, std::span<const Vec3> places,
                                const CartilageMap& map);

}  // namespace impinge::lab
