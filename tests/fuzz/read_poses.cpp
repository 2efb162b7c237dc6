// SPDX-License-Identifier: GPL-3.0-or-later
// Contract: for any bytes, parse_poses() gives rows that are not tracked or have a rotation, or throws a
// FileError of one line that names the file and says what to do. The first byte says which file it is.
#include <cstdint>
#include <string_view>

#include "files/file_error.hpp"
#include "fuzz/require.hpp"
#include "joint/pose_list.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace impinge;
  if (size == 0) return 0;
  const std::string bytes(data + 1, data + size);
  const bool opensim = data[0] % 2 == 1;
  try {
    const PoseList list = parse_poses(opensim ? "poses.sto" : "poses.csv", bytes, Side::right);
    test::require(list.size() > 0 && list.values.size() % list.width() == 0, "rows are whole");
    for (std::size_t row = 0; row < list.size(); ++row) {
      if (!list.tracked(row)) continue;
      const Eigen::Matrix3d turn = list.pose(row, Side::right).rotation;
      test::require((turn * turn.transpose() - Eigen::Matrix3d::Identity()).norm() < 1e-12,
                    "it is a rotation");
    }
  } catch (const FileError& error) {
    test::require_message(error.what(), "poses.");
  }
  return 0;
}
