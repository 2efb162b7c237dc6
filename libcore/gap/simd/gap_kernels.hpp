// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The two scans of gap/gap_scan.hpp with vector instructions: several vertices at a time, moved by the pose
/// in the same pass. A gap is S(u) - B(u), mm; NaN where the other surface is not met, in a cell that has no
/// answer, and for a vertex at the centre, which has no direction. No product is fused with a sum, so that
/// all instruction sets, the scalar one too, give the same bits.
///
/// Rounding, with u = 2^-24 (2^-53 for tables in double). A moved vertex is off by at most
///   E = 10.4 u (|v| + |t|)       (6 u |v| + 2 u |t| a coordinate, Cauchy-Schwarz; times sqrt 3).
/// At the moved vertex x the gap differs from the gap of the table in exact arithmetic by at most
///   u (20 (r + |x|) + (c m + 5) D)             for `cube_gnomonic` (c = 13) and `rsid` (c = 28),
///   u (20 (r + |x|) + (10 m + 52 m^2) D)       for `usid`, which works in double whatever it stores.
/// Here r is the radius at x, m the number of cells of a quarter turn along a row, and D how much the radius
/// can change in a cell: for radii the largest difference between its corners; for inverse depths r (C - 1),
/// C the largest of its numbers over the least, since r = 1 / q changes by r |q' - q| / q'. `cube_gnomonic`
/// in 16 bits adds u 5 Q r, Q the largest of all numbers over the least, as codes are rounded relative to the
/// largest.
///
/// The two coordinates of a place are together accurate to c m u cells. On a cube each has 2.5 for two
/// products, a quotient and a sum, and 4 for a grid that is made smaller by 8 u. On `rsid` theta has 15, its
/// last step being 2 pi minus an angle, phi 9, and each 2 for the product. Differences of corners take the 5.
/// On `usid` an entry of its 6.5 m^2 is off by 8 u of them all, as its place follows from the cosine of a
/// turn's height, and the height between two turns by 10 u m. Of the 20 of a cube, r takes 15.7: 8.7 for 13 m
/// u cells on a sphere, where the depth changes though the radius does not, 6 for the secant and its product,
/// 1 for the quotient; numbers in float take 4.
#pragma once

#include <cstdint>
#include <span>

#include "gap/simd/packed_vertices.hpp"
#include "table/packed_table.hpp"

namespace impinge {

/// Writes to `gap` the gaps of the vertices, mm; it has their size. The table belongs to the other surface.
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
