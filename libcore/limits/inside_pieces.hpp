// SPDX-License-Identifier: GPL-3.0-or-later
// Is a piece of one mesh inside a closed piece of another, where their surfaces do not meet?
//
// Pieces are connected across corners; corners with equal coordinates are one. A piece is closed if each of
// its edges belongs to an even number of its faces: then a ray from a point off it, through no edge, crosses
// it oddly often if the point is inside. As the surfaces do not meet, one point tells this of all of a piece.
#pragma once

#include "limits/clear_cuts.hpp"

namespace impinge {

enum class Inside : std::uint8_t { no, yes, open };  // open: every ray passes too near to an edge to tell

/// Are all pieces closed?
bool all_closed(const TriangleMesh& mesh);

/// `of` where it lies in the frame of `in`.
Inside inside_pieces(const UncertainMesh& of, const UncertainMesh& in);

}  // namespace impinge
