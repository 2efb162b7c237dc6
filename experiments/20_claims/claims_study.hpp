// SPDX-License-Identifier: GPL-3.0-or-later
// Claims of the thesis that it never showed (Chapter 6), one function each.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "files/csv.hpp"
#include "harness/timing.hpp"
#include "mesh/triangle_mesh.hpp"
#include "sphere/walker.hpp"

namespace impinge::lab {

// A row of the table: a number for or against a claim.
struct Claim {
  std::string claim;     // claim of the thesis, in words
  std::string setting;   // such as the precision
  std::string quantity;  // what the number is
  double value = 0.0;    // the number
  std::string unit;      // of it
};

struct ClaimsStudy {
  std::vector<Claim> rows;       // what is measured without timing
  std::vector<TimedCase> cases;  // key: claim, setting, quantity; the cases own what they work on
};

// Sizes of the experiments.
struct ClaimsOptions {
  std::size_t faces = 12000;                                 // of each surface
  double precision_deg = 0.5;                                // of the tables
  std::vector<double> collision_precisions{1.0, 0.5, 0.25};  // degrees
  std::vector<double> caps{5.0, 10.0, 20.0, 45.0};           // degrees, of the part that moves
  int rounds = 9;                                            // of each timed case
};

// Times a cap of the ball that moves in and out again: the table is updated in place, or filled anew. Throws
// std::runtime_error unless both are the same, bit for bit.
void add_deforming(ClaimsStudy& study, const ClaimsOptions& options);

// Presses a layer of cartilage through the bone under it, and compares the pairs of triangles that are found
// with those that cross exactly.
void add_self_collision(ClaimsStudy& study, const ClaimsOptions& options);

// Compares the place of the cartilage with a distance added to the radius of the bone.
void add_layers(ClaimsStudy& study, const ClaimsOptions& options);

// The result and its times.
struct ClaimsTables {
  Table table;       // rows and times
  TimingRun timing;  // of the cases
};
std::vector<Column> claims_keys();  // claim, setting, quantity
// Times the cases and appends them to the rows.
ClaimsTables claims_tables(const ClaimsStudy& study, Progress& progress);

// Finds self-collision while a table is filled, as the thesis proposes (Chapter 6): two triangles without a
// common vertex put the same radius into one entry. "The same" means within a tolerance. Two planes that
// cross between entries differ, at the entry nearest to the crossing, by up to r rho (tan psi_1 + tan psi_2),
// where rho is the covering radius. A smaller tolerance misses crossings; layers closer than the tolerance
// are reported though they are apart.

// Indices of two faces, the smaller first.
using FacePair = std::pair<std::size_t, std::size_t>;

// Do the faces share a vertex?
inline bool are_neighbours(const Face& a, const Face& b) {
  return std::ranges::any_of(a, [&b](VertexIndex v) { return std::ranges::find(b, v) != b.end(); });
}

// Every pair once, in order. `mesh` is in the centre frame; the tolerance is in mm, 0 or more.
template <SamplingScheme S>
std::vector<FacePair> self_collisions(const TriangleMesh& mesh, const S& scheme, double tolerance) {
  struct Sample {
    std::size_t entry;
    double radius;
    std::size_t face;
  };
  std::vector<Sample> samples;
  const auto& walker = walker_of(scheme);
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const TriangleCone cone = cone_of(mesh, mesh.faces[f]);
    if (cone.edge_on()) continue;
    for_each_entry_inside(walker, cone, [&](std::size_t entry, const Vec3& u) {
      samples.push_back({entry, cone.radius(u), f});
    });
  }
  std::ranges::sort(samples, {}, [](const Sample& s) { return std::tuple(s.entry, s.radius, s.face); });
  std::vector<FacePair> pairs;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    for (std::size_t j = i + 1; j < samples.size() && samples[j].entry == samples[i].entry &&
                                samples[j].radius - samples[i].radius <= tolerance;
         ++j) {
      const auto [a, b] = std::minmax(samples[i].face, samples[j].face);
      if (!are_neighbours(mesh.faces[a], mesh.faces[b])) pairs.emplace_back(a, b);
    }
  }
  std::ranges::sort(pairs);
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

}  // namespace impinge::lab
