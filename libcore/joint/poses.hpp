// SPDX-License-Identifier: GPL-3.0-or-later
// Touch and the smallest gap in many poses.
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "files/fields.hpp"
#include "joint/pose_file.hpp"
#include "joint/pose_series.hpp"
#include "joint/session.hpp"

namespace impinge {

/// What is worked out of each pose.
enum class PosesOutput { touch, gap, areas };
template <>
inline constexpr std::array<std::string_view, 3> words_of<PosesOutput>{"touch", "gap", "areas"};

struct PosesRequest {
  std::optional<std::filesystem::path> poses;
  std::optional<std::string> path;
  std::vector<PosesOutput> outputs{PosesOutput::touch, PosesOutput::gap};
  double cartilage_mm = 4.0;

  static constexpr auto fields() {
    using Asked = PosesRequest;
    return std::tuple{
        Field{"poses", "", "a CSV of angles, quaternions or matrices, or a motion of OpenSim (.mot, .sto)",
              &Asked::poses},
        Field{"path", "", "all combinations of angles and shifts in mm, as flexion=0..120/1,tx=-2..2/1",
              &Asked::path},
        Field{"outputs", "", "touch, the smallest gap, impinged areas [touch,gap]", &Asked::outputs},
        Field{"cartilage_mm", "mm", "thickness of both layers together, for areas", &Asked::cartilage_mm,
              kNotNegative}};
  }
  /// std::invalid_argument where what is asked does not go together.
  void check() const;
};

/// A row of poses.csv; the columns that were given follow.
struct PoseRow {
  std::size_t pose = 0;
  std::string_view touch;
  std::optional<bool> certified;
  std::optional<double> smallest_gap_mm;
  std::optional<Surface> surface;
  std::optional<std::size_t> vertex;
  std::optional<std::string> clock;
  std::optional<double> bound_mm;

  static constexpr auto fields() {
    using Row = PoseRow;
    return std::tuple{
        Field{"pose", "1", "from 1", &Row::pose},
        Field{"touch", "", "yes, no, untracked where the row has no numbers; empty where it is not known",
              &Row::touch},
        Field{"certified", "", "is that decided exactly?", &Row::certified},
        Field{"smallest_gap_mm", "mm", "along a ray, of a vertex", &Row::smallest_gap_mm},
        Field{"surface", "", "whose vertex it is", &Row::surface},
        Field{"vertex", "1", "its place in the mesh", &Row::vertex},
        Field{"clock", "", "on the rim's clock", &Row::clock},
        Field{"bound_mm", "mm", "proven bound on the error of that gap", &Row::bound_mm}};
  }
};

/// Further columns where areas are asked for.
struct PoseAreas {
  double bone_ball_mm2 = 0.0;
  double bone_socket_mm2 = 0.0;
  double cartilage_ball_mm2 = 0.0;
  double cartilage_socket_mm2 = 0.0;

  static constexpr auto fields() {
    using Row = PoseAreas;
    return std::tuple{
        Field{"bone_ball_mm2", "mm^2", "of the ball with a gap of 0 or less", &Row::bone_ball_mm2},
        Field{"bone_socket_mm2", "mm^2", "of the socket with a gap of 0 or less", &Row::bone_socket_mm2},
        Field{"cartilage_ball_mm2", "mm^2", "of the ball where the layers touch", &Row::cartilage_ball_mm2},
        Field{"cartilage_socket_mm2", "mm^2", "of the socket where the layers touch",
              &Row::cartilage_socket_mm2}};
  }
};

/// The pose with the smallest gap.
struct SmallestOfPoses {
  std::size_t pose = 0;
  double gap_mm = 0.0;
  std::string surface;
  std::size_t vertex = 0;
  std::optional<std::string> clock;

  static constexpr auto fields() {
    using Gap = SmallestOfPoses;
    return std::tuple{Field{"pose", "1", "from 1", &Gap::pose},
                      Field{"gap_mm", "mm", "along a ray", &Gap::gap_mm},
                      Field{"surface", "", "whose vertex it is", &Gap::surface},
                      Field{"vertex", "1", "its place in the mesh", &Gap::vertex},
                      Field{"clock", "", "on the rim's clock", &Gap::clock}};
  }
};

struct PosesAnswer {
  std::size_t number_of_poses = 0;
  std::size_t untracked = 0;
  std::optional<std::size_t> touching;
  std::optional<SmallestOfPoses> smallest_gap;
  std::optional<std::string> doubt;

  static constexpr auto fields() {
    using Found = PosesAnswer;
    return std::tuple{
        Field{"number_of_poses", "1", "rows of poses.csv", &Found::number_of_poses},
        Field{"untracked", "1", "of these without numbers", &Found::untracked},
        Field{"touching", "1", "of these in contact; null if not asked for", &Found::touching},
        Field{"smallest_gap", "", "of all poses; null if there is none or it was not asked for",
              &Found::smallest_gap},
        Field{"doubt", "", "what looks wrong with the poses; null if nothing does", &Found::doubt}};
  }
};

/// Reads or makes the poses. FileError or std::invalid_argument, one line.
PoseList list_of(const PosesRequest& request, const SessionJoint& joint);

/// Of a row of the list, in the centre frame.
Pose pose_in(const SessionJoint& joint, const PoseList& list, std::size_t row);

/// One line where poses are in another unit or frame; empty where they look right.
std::string doubt_of(const PosesRequest& request, const SessionJoint& joint, const PoseList& list);

SeriesOutputs outputs_of(const PosesRequest& request);

/// The row of a pose of the list.
PoseRow row_of(const SessionJoint& joint, const PoseList& list, std::size_t row, const SeriesAnswer& answer);

}  // namespace impinge
