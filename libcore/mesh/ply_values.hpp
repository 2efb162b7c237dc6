// SPDX-License-Identifier: GPL-3.0-or-later
// The numbers of a PLY body, one after the other, whatever its format.
#pragma once

#include <memory>
#include <optional>

#include "mesh/ply_header.hpp"

namespace impinge {

class PlyValues {
 public:
  virtual ~PlyValues() = default;
  /// Call it before each vertex, face, ...: in ascii files each has its own line.
  virtual void next_record() = 0;
  /// The next number; none past the end (of the line), or if the text there is no number.
  virtual std::optional<double> next(NumberType type) = 0;
};

/// The bytes that `header` was parsed from must outlive the result.
std::unique_ptr<PlyValues> ply_values(const PlyHeader& header);

}  // namespace impinge
