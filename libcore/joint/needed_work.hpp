// SPDX-License-Identifier: GPL-3.0-or-later
// Works out only that part of a scene that the answer needs; no bit of the answer changes.
//
//   question                                  answered by              vertices  entries
//   one pose: do the surfaces touch           exact signs (overlay)    none      none
//   one pose: gaps, the smallest gap          answer_on_faces()        needed    none
//   gaps of a table, not their bounds         answer_by_table()        needed    needed
//   gaps of a table and their bounds          tables of a session      all       all
//   many poses: touch, smallest gap           caps of faces (contact)  few       none
//   many poses: all gaps                      exact cells (gap/simd)   all       none
//
// Gaps on the faces are exact but for rounding, and for one pose they take less time than to fill a table.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gap/surface.hpp"
#include "sphere/any_scheme.hpp"
#include "sphere/entry_set.hpp"
#include "sphere/infinity.hpp"
#include "table/near_faces.hpp"

namespace impinge {

/// What is asked of a pose.
enum class Question {
  smallest_gap,  // the smallest gap of any vertex
  all_gaps,      // the gap of every vertex
};

/// A question, about which vertices, in which pose.
struct SceneNeeds {
  Question question = Question::all_gaps;
  bool ball = true;    // the first scan: vertices of the ball against the socket
  bool socket = true;  // the second scan
  Pose pose{};         // of the ball in the socket

  /// Are the vertices of this surface asked about?
  bool scans(Surface of) const { return of == Surface::ball ? ball : socket; }
};

/// One kind of work that was left out.
struct LeftOut {
  std::string_view what;     // in one word
  std::string_view meaning;  // in one clause
  std::string reason;        // meaning, with the numbers that it rests on
  double bytes_saved = 0.0;  // memory saved; negative if leaving it out takes more
};

/// The vertices to look at in each scan, and what their choice rests on.
struct NeededVertices {
  std::array<std::vector<VertexIndex>, 2> of;  // ball, socket
  double limit_mm = kInfinity;                 // some gap is proven to be this small or smaller
};

/// The faces of the other surface that the vertices of ball and socket meet; null: not scanned.
using FacesMet = std::array<const NearFaces*, 2>;

/// All vertices that are on a face.
NeededVertices all_vertices(const BallSocketPair& joint, const SceneNeeds& needs);
/// The vertices that can change the answer. Meshes in their centre frames, mm.
///
/// A look-up along x averages entries within the stencil radius s of x. NearFaces with a margin of s (0 where
/// the faces answer) gives a range that holds the radii of all of them, so it holds the answer. Before
/// anything is filled this tells
///   no face within the margin             there is no gap
///   upper end of the gap, not at a rim    some gap is as small as that; the least of these ends is the limit
///   lower end of the gap above the limit  the vertex does not have the smallest gap
/// A table has no answer in cells beside a rim, and these may reach beyond the margin. If therefore no gap
/// keeps the limit, all vertices are looked at.
NeededVertices needed_vertices(const BallSocketPair& joint, const SceneNeeds& needs, const FacesMet& faces);
/// The entries that the look-ups of these vertices read.
EntrySet needed_entries(const BallSocketPair& joint, const SceneNeeds& needs, const NeededVertices& vertices,
                        Surface scanned, const AnyScheme& scheme);

/// The smallest gap; of equal ones the first in the order of scans and vertices.
struct SmallestGap {
  double gap_mm = 0.0;              // of the vertex
  Surface scanned = Surface::ball;  // whose vertex it is
  std::size_t vertex = 0;           // index in the mesh
  bool operator==(const SmallestGap&) const = default;
};

/// Gaps of all vertices of ball and socket, mm; NaN where the other surface is not met, empty where there is
/// no such scan.
using PoseGaps = std::array<std::vector<double>, 2>;

/// The answer to a scene, and what it took.
struct SceneAnswer {
  std::optional<SmallestGap> smallest;  // for `smallest_gap`; none where the surfaces do not meet
  PoseGaps gaps;                        // for `all_gaps`
  std::size_t bytes = 0;                // memory of tables or what replaced them, without the answer
  std::size_t entries = 0;              // number worked out
  std::size_t look_ups = 0;             // number done
  std::vector<LeftOut> left_out;        // what was left out, and why
};

/// Gap of a vertex at x in the frame of the other surface, mm, NaN where there is none.
using GapAt = std::function<double(Surface scanned, std::size_t vertex, const Vec3& x)>;

/// The answer from the gaps of the vertices in `vertices`.
SceneAnswer answer_from(const BallSocketPair& joint, const SceneNeeds& needs, const NeededVertices& vertices,
                        const GapAt& gap);

/// Answers by gaps on the faces (gap/measured_gap.hpp, gap/exact_side.hpp). Throws std::invalid_argument for
/// a scene without scans.
SceneAnswer answer_on_faces(const BallSocketPair& joint, const SceneNeeds& needs, const FacesMet& faces,
                            const GapAt& gap);
/// Answers by a table in double of each surface; only what is read is filled (table/partial_table.hpp).
SceneAnswer answer_by_table(const BallSocketPair& joint, const SceneNeeds& needs, const AnyScheme& scheme);

}  // namespace impinge
