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
  /// To be called before each vertex, face and so on: in ascii files each has its own line.
  virtual void next_record() = 0;
  /// The next number; std::nullopt at the end (of the line), or if the text there is not a number.
  virtual std::optional<double> next(NumberType type) = 0;
};

/// The numbers of a file. The bytes from which `header` was parsed must outlive the result.
std::unique_ptr<PlyValues> ply_values(const PlyHeader& header);

}  // namespace impinge
