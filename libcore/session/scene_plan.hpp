// SPDX-License-Identifier: GPL-3.0-or-later
// Decides, from the needs of a scene and its meshes, which work is done and which is left out, before any
// table is filled.
//
// Without an accuracy, leaving work out changes no bit of the answers. All entries that a look-up along x
// reads are within the stencil radius s of x, and the answer is a mean of them. NearFaces with a margin of s
// or more gives a range that holds all of their radii, hence the answer:
//   no face within the margin     every entry is empty, and so is the answer
//   lower end of the gap > limit  the gap is above the limit, or there is none
//   upper end of the gap <= 0     the vertex touches, away from any rim: nothing else matters for `touch`
// For `touch` the limit is 0. For `first_contact` it is the least upper end of the gaps of all vertices that
// are not near a rim, so that some gap is at or below it (answer_scene() checks this). A scan without any
// vertex left is dropped. Entries that no look-up reads cannot change an answer.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "gap/surface.hpp"
#include "session/needs.hpp"
#include "table/partial_table.hpp"

namespace impinge {

/// One omission.
struct LeftOut {
  Omission what;             // what it is
  std::string reason;        // one clause, with the numbers that it rests on
  double bytes_saved = 0.0;  // of memory; negative if leaving it out takes more
};

/// One scan: vertices of `scanned` against the other surface.
struct ScanPlan {
  Surface scanned = Surface::ball;  // whose vertices
  bool wanted = true;               // asked for, and not dropped
  /// Those to look up in each pose; none given: all.
  std::optional<std::vector<std::vector<std::uint32_t>>> vertices;
  std::unique_ptr<NearFaces> faces;  // of the other surface, where something is left out because of it
  std::optional<EntrySet> entries;   // those to keep; none given: all
};

/// What is looked up: a table. With an accuracy, the faces themselves where that is cheaper or the table is
/// not proven to be that accurate.
struct TableChoice {
  AnyScheme scheme;                                  // of the table
  Storage storage = Storage::double_precision;       // of the numbers in the table
  std::optional<double> accuracy_mm = std::nullopt;  // given where the table was chosen for it
  bool rays_only = false;                            // there are too few look-ups for any table to pay
};

struct ScenePlan {
  explicit ScenePlan(const AnyScheme& given) : table{given} {}  // of everything, with that table

  TableChoice table;              // what both scans look up
  std::array<ScanPlan, 2> scans;  // ball, socket
  double limit_mm = 0.0;          // gaps above it do not matter; infinite for all_gaps
  std::string way;                // how the vertices that matter are found, and why so, in one clause
  std::vector<bool> touches;      // of each pose: is touch proven? See is_as_planned()
  std::vector<LeftOut> left_out;  // what is not done, and why

  /// Memory of the plan itself, which the answer needs.
  std::size_t bytes() const;
};

/// Meshes in their centre frames; they must outlive the plan. `given` is the table that everything would be
/// done with. std::invalid_argument for an accuracy that is not above 0 or a scene without poses or scans.
ScenePlan plan_scene(const BallSocketPair& joint, const SceneNeeds& needs, const AnyScheme& given,
                     Omissions omissions);

/// Is the table proven to be within its accuracy along x? `near`: the faces within the stencil radius of x or
/// more. storage_bound in mm.
bool keeps_accuracy(const TableChoice& table, double storage_bound, const NearFaces::Near& near);

}  // namespace impinge
