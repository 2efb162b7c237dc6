// SPDX-License-Identifier: GPL-3.0-or-later
// A rigid sphere pressed into an elastic layer that is bonded to rigid bone, without friction: the linear
// solution for any thickness and Poisson ratio, against which strain by gap is held.
//
// Bone is the plane z = 0, the layer is h thick, and in the circle of contact r <= a its surface sinks by
// d - r^2 / (2 R). With J0 and J1 the Hankel transforms turn the equations of elasticity into ordinary ones
// in z, whose solutions with no displacement at the bone are, with s = xi z, k = 3 - 4 nu and amplitudes A
// and B,
//   u_z: A s sinh s + B (s cosh s - k sinh s),   u_r: -A (s cosh s + k sinh s) - B s sinh s,   over xi.
// The pressure p = integral of xi P(xi) J0(xi r) and no shear at the surface give A and B, and the
// displacement there (1 - nu) / (mu xi) P (1 - g(xi h)) with
//   g(x) = 1 - (k sinh x cosh x - x) / (k sinh^2 x + x^2 + 4 (1 - nu)^2).
// P(xi) = mu / (1 - nu) times the integral of phi(t) cos(xi t) over 0 <= t <= a leaves no pressure outside of
// the circle, and Abel's inversion of what sinks inside gives Lebedev and Ufliand's equation (1958)
//   phi(t) - 2 / pi integral over s of phi(s) integral over xi of g cos(xi t) cos(xi s)
//     = 2 / pi (d - t^2 / R),
// second kind, solved at Gauss-Legendre nodes. phi(a) = 0, as the pressure ends smoothly, gives d. Limits:
// Hertz for h >> a, p = (lambda + 2 mu) (d - r^2 / 2R) / h for h << a (Johnson 1985, Section 5.8), and for
// nu = 1/2 and h << a p = 3 mu (a^2 - r^2)^2 / (32 R h^3) with d = a^2 / (4 R) (Jaffar 1989, Barber 1990).
//
// Two equal layers on bones with 1 / R_1 - 1 / R_2 = 1 / R are two such problems, mirror images of each other
// with half of d and twice R: h is the thickness of one layer, and friction between them does nothing.
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

// The contact of one radius. All of it is linear in 1 / R: lengths in units of R, stresses of mu.
class LayerContact {
 public:
  // contact: a, over R. std::invalid_argument for a Poisson ratio outside of 0 to 1/2, lengths that are not
  // positive, and h / a outside of 0.05 to 50, where the limits will do.
  LayerContact(const ElasticLayer& layer, double contact);

  double contact() const { return a_; }   // a
  double approach() const { return d_; }  // d: how far the sphere has come since it touched
  double force() const;                   // in units of mu R^2
  double pressure(double r) const;        // on the surface; 0 where r >= a
  double sunk(double r) const;            // of the surface, positive towards the bone
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
// (Section 3.4).
//
// Two layers that are h thick together and stand in a gap g < h overlap by h - g. They are squeezed into the
// gap, so that
//   1 - g / h
// is their compression along the ray, averaged over both. Experiment 24 measures how far that holds:
// - It is no stress and no largest strain. How the layers give way, where they bulge and how they shear is
//   not in it, and it is engineering strain, which nothing linear follows far.
// - Where layers overlap is not where they touch: thick ones sink before they are touched, incompressible
//   ones rise beside the overlap and touch there too.
// - Both lengths are taken along the ray. Where it meets the bone at the angle psi to its normal and h was
//   measured along the normal, the layers are as thick as h / cos psi along the ray: a strain that takes h
//   is too small, and one of g cos psi is not.

// Compression of the cartilage in a gap, from 0, where its layers do not touch, to 1, where nothing is left
// between the bones or they overlap. gap in mm, NaN (which comes back) where the other surface is not met;
// thickness of both layers together in mm, 0 or more, along the same line.
double gap_strain(double gap, double thickness);

// The same at each place (centre frame, posed), with the thickness of the map there.
std::vector<double> gap_strains(std::span<const double> gap, std::span<const Vec3> places,
                                const CartilageMap& map);

}  // namespace impinge::lab
