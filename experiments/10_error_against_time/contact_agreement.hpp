// SPDX-License-Identifier: GPL-3.0-or-later
// Do all ways to say whether a joint touches agree, close to contact too?
#pragma once

#include <cstddef>
#include <cstdint>

#include "files/csv.hpp"
#include "mesh/ball_socket_pair.hpp"

namespace impinge::lab {

// What is asked how often.
struct AgreementOptions {
  std::size_t triangles = 3000;  // of each surface
  std::size_t poses = 10000;     // of the ball
  std::uint64_t seed = 0;        // of ways and places on them
};

// How many poses the ways differ in.
struct Agreement {
  std::size_t poses = 0;         // that were asked
  std::size_t impinged = 0;      // by the exact test of every vertex
  std::size_t missed = 0;        // by that test, where the exact overlay finds that the surfaces impinge
  std::size_t culled_wrong = 0;  // against that
  std::size_t least_gap_wrong =
      0;  // smallest gap at or below zero and no vertex impinged, or the other way round
  std::size_t between_vertices =
      0;                   // FCL finds a contact and the exact overlay of the surfaces does, no vertex does
  std::size_t beyond = 0;  // a vertex is beyond the other surface, along its ray, without a contact of faces
  std::size_t unexplained = 0;  // FCL differs and nothing explains it
};

// On a generated pair. Of four poses one lies anywhere on its way and three are within 10^-5 to 10^-0.5 mm of
// the first contact of a vertex; see contact_poses.hpp.
Agreement contact_agreement(const BallSocketPair& joint, const AgreementOptions& options);

Table agreement_table(const AgreementOptions& options, const Agreement& agreement);  // One row.

}  // namespace impinge::lab
