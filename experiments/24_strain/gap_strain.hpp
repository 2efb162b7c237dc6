// SPDX-License-Identifier: GPL-3.0-or-later
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
#pragma once

#include <span>
#include <vector>

#include "hip/cartilage_map.hpp"

namespace impinge::lab {

// Compression of the cartilage in a gap, from 0, where its layers do not touch, to 1, where nothing is left
// between the bones or they overlap. gap in mm, NaN (which comes back) where the other surface is not met;
// thickness of both layers together in mm, 0 or more, along the same line.
double gap_strain(double gap, double thickness);

// The same at each place (centre frame, posed), with the thickness of the map there.
std::vector<double> gap_strains(std::span<const double> gap, std::span<const Vec3> places,
                                const CartilageMap& map);

}  // namespace impinge::lab
