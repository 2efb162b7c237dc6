// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The two scans of gap/gap_scan.hpp with vector instructions: several vertices at a time, moved
/// by the pose in the same pass, without functions of libm.
///
///   gap(u) = S(u) - B(u), mm; NaN where the other surface is not met, in a cell that has no answer, and for
///   a vertex at the centre itself, which has no direction
///
/// Rounding. With u = 2^-24 (2^-53 for tables in double), a vertex is moved by at most
///   E = 10.4 u (|v| + |t|)       (6 u |v| + 2 u |t| a coordinate, Cauchy-Schwarz; times sqrt 3)
/// and at the moved vertex x the gap is off from that of the table in exact arithmetic by at most
///   u (20 (r + |x|) + (c m + 5) D)
/// r being the radius at x, m the cells of a quarter turn along a row and D how far a cell there can change
/// it: for tables of radii the largest difference between its corners; for inverse depths r (C - 1), C the
/// largest of its numbers over the least, since r = 1 / q changes by r |q' - q| / q', which a cell that is
/// seen steeply makes much more than its radii differ. The share of 5 is for differences of corners. The two
/// coordinates of a place on the grid are together accurate to c m u cells, c = 13
/// for `cube_gnomonic` (each 2.5 for two products, a quotient and a sum, and 4 for a grid that is smaller by
/// 8 u of itself so that no place is beyond it) and c = 28 for `rsid` (15 u for theta, whose last step is 2
/// pi minus an angle, and 9 u for phi, each with 2 u of itself for the product). `cube_gnomonic` in 16 bits
/// adds u 5 Q r, Q the largest of its numbers over the least: codes are rounded relative to the largest.
/// `usid`, which works in double whatever it stores, has u (20 (r + |x|) + (10 m + 52 m^2) D): an entry of
/// the 6.5 m^2 that it has is off by 8 u of them all, since the places along its turns follow from the cosine
/// of a turn's height, and the height between two turns by 10 u m. No product is fused with a sum, so that
/// all instruction sets, the scalar one too, answer alike bit for bit.
///
/// Of the 20 of a cube, r takes 15.7: 8.7 for what 13 m u cells are on a sphere, where no radius differs but
/// the depth does, 6 for the secant and the product with it, and 1 for the quotient; numbers in float take 4.
#pragma once

#include <cstdint>
#include <span>

#include "gap/simd/packed_vertices.hpp"
#include "table/packed_table.hpp"

namespace impinge {

/// gap has the size of the vertices; the table is that of the other surface.
void scan_gaps(const PackedTable<CubeGnomonic, float>& table, const PackedVertices<float>& vertices,
               const Pose& pose, Surface scanned, std::span<float> gap);
void scan_gaps(const PackedTable<CubeGnomonic, std::uint16_t>& table, const PackedVertices<float>& vertices,
               const Pose& pose, Surface scanned, std::span<float> gap);
void scan_gaps(const PackedTable<Rsid, float>& table, const PackedVertices<float>& vertices, const Pose& pose,
               Surface scanned, std::span<float> gap);
void scan_gaps(const PackedTable<Rsid, std::uint16_t>& table, const PackedVertices<float>& vertices,
               const Pose& pose, Surface scanned, std::span<float> gap);
void scan_gaps(const PackedTable<Rsid, double>& table, const PackedVertices<double>& vertices,
               const Pose& pose, Surface scanned, std::span<double> gap);
void scan_gaps(const PackedTable<Usid, float>& table, const PackedVertices<double>& vertices,
               const Pose& pose, Surface scanned, std::span<double> gap);
void scan_gaps(const PackedTable<Usid, std::uint16_t>& table, const PackedVertices<double>& vertices,
               const Pose& pose, Surface scanned, std::span<double> gap);
void scan_gaps(const PackedTable<Usid, double>& table, const PackedVertices<double>& vertices,
               const Pose& pose, Surface scanned, std::span<double> gap);

}  // namespace impinge
