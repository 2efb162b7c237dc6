// SPDX-License-Identifier: GPL-3.0-or-later
// The test set of turns (README.md), made by turns.py.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "methods/turns.hpp"

namespace impinge::lab {

/// A query and its exact answer, rounded once.
struct KnownTurn {
  std::string name;
  std::string kind;  // vertex_face, edge_edge, face_face or mesh
  std::string family;
  TurnQuery query;
  std::optional<double> first;  // radians; none if they do not meet
};

struct TurnSetSizes {
  std::uint64_t seed = 1;
  std::size_t pairs = 10'000;
  std::size_t meshes = 200;
};

/// Makes a set in a temporary folder, and reads it. Throws std::runtime_error if Python fails.
std::vector<KnownTurn> make_turn_set(const TurnSetSizes& sizes);

/// The queries of pairs.csv and meshes.csv in the folder. Throws std::runtime_error if one cannot be read.
std::vector<KnownTurn> read_turn_set(const std::filesystem::path& folder);

}  // namespace impinge::lab
