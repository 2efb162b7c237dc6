// SPDX-License-Identifier: GPL-3.0-or-later
// Touch and the smallest gap in many poses.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "contact/culled_joint.hpp"
#include "files/fields.hpp"
#include "gap/simd/exact_cells.hpp"
#include "gap/simd/joint_scan.hpp"
#include "joint/pose_list.hpp"
#include "joint/touch.hpp"

namespace impinge {

/// What is worked out for each pose.
enum class PosesOutput { touch, gap, areas };
template <>
inline constexpr std::array<std::string_view, 3> words_of<PosesOutput>{"touch", "gap", "areas"};

struct PosesRequest {
  std::optional<std::filesystem::path> poses{};
  std::optional<std::string> path{};
  std::vector<PosesOutput> outputs{PosesOutput::touch, PosesOutput::gap};
  double cartilage_mm = 4.0;

  static constexpr std::tuple fields{
      Field{"poses", "", "a CSV of angles, quaternions or matrices, or a motion of OpenSim (.mot, .sto)",
            &PosesRequest::poses},
      Field{"path", "", "all combinations of angles and shifts in mm, as flexion=0..120/1,tx=-2..2/1",
            &PosesRequest::path},
      Field{"outputs", "", "touch, the smallest gap, impinged areas [touch,gap]", &PosesRequest::outputs},
      Field{"cartilage_mm", "mm", "thickness of both layers together, for areas", &PosesRequest::cartilage_mm,
            kNotNegative}};
  /// Throws std::invalid_argument for options that exclude each other.
  void check() const;
  bool uses_cartilage() const { return asks(PosesOutput::areas); }
  bool asks(PosesOutput output) const { return std::ranges::count(outputs, output) > 0; }
};

/// Impinged areas from the vertices' gaps in float: extra columns if they are asked for.
struct PoseAreas {
  double bone_ball_mm2 = 0.0;
  double bone_socket_mm2 = 0.0;
  double cartilage_ball_mm2 = 0.0;
  double cartilage_socket_mm2 = 0.0;

  static constexpr std::tuple fields{
      Field{"bone_ball_mm2", "mm^2", "of the ball with a gap of 0 or less", &PoseAreas::bone_ball_mm2},
      Field{"bone_socket_mm2", "mm^2", "of the socket with a gap of 0 or less", &PoseAreas::bone_socket_mm2},
      Field{"cartilage_ball_mm2", "mm^2", "of the ball where the layers touch",
            &PoseAreas::cartilage_ball_mm2},
      Field{"cartilage_socket_mm2", "mm^2", "of the socket where the layers touch",
            &PoseAreas::cartilage_socket_mm2}};
};

/// A row of poses.csv; the areas and the given angles follow it.
struct PoseRow {
  std::size_t pose = 0;
  bool tracked = true;
  std::optional<BodyPairs::Verdict> verdict{};  // exact; empty if not asked for
  std::optional<SmallestOfPose> smallest{};
  std::optional<PoseAreas> areas{};  // empty if not asked for

  std::string_view touch() const {
    if (!verdict) return tracked ? "" : "untracked";
    return verdict->contact == Contact::unknown ? "" : word_of(verdict->contact);
  }
  std::optional<bool> certified() const {
    if (!verdict) return std::nullopt;
    return verdict->contact == Contact::no ||
           (verdict->contact == Contact::yes && verdict->rule != ContactRule::radii);
  }

  static constexpr std::tuple fields{
      Field{"pose", "1", "from 1", &PoseRow::pose},
      Field{"touch", "", "yes, no, untracked where the row has no numbers; empty where it is not known",
            &PoseRow::touch},
      Field{"certified", "", "is that decided exactly?", &PoseRow::certified},
      Field{"smallest_gap_mm", "mm", "along a ray, of a vertex",
            via(&PoseRow::smallest, &SmallestOfPose::gap_mm)},
      Field{"surface", "", "whose vertex it is", via(&PoseRow::smallest, &SmallestOfPose::surface)},
      Field{"vertex", "1", "its place in the mesh", via(&PoseRow::smallest, &SmallestOfPose::vertex)},
      Field{"clock", "", "on the rim's clock", via(&PoseRow::smallest, &SmallestOfPose::clock)},
      Field{"bound_mm", "mm", "proven bound on the error of that gap",
            via(&PoseRow::smallest, &SmallestOfPose::error_bound_mm)}};
};

/// The pose with the smallest gap.
struct SmallestOfPoses {
  std::size_t pose = 0;
  double gap_mm = 0.0;
  std::string surface;
  std::size_t vertex = 0;
  std::optional<std::string> clock;

  static constexpr std::tuple fields{Field{"pose", "1", "from 1", &SmallestOfPoses::pose},
                                     Field{"gap_mm", "mm", "along a ray", &SmallestOfPoses::gap_mm},
                                     Field{"surface", "", "whose vertex it is", &SmallestOfPoses::surface},
                                     Field{"vertex", "1", "its place in the mesh", &SmallestOfPoses::vertex},
                                     Field{"clock", "", "on the rim's clock", &SmallestOfPoses::clock}};
};

struct PosesAnswer {
  std::size_t number_of_poses = 0;
  std::size_t untracked = 0;
  std::optional<std::size_t> touching;
  std::optional<std::size_t> unknown;
  std::optional<SmallestOfPoses> smallest_gap;
  std::optional<std::string> doubt;

  static constexpr std::tuple fields{
      Field{"number_of_poses", "1", "rows of poses.csv", &PosesAnswer::number_of_poses},
      Field{"untracked", "1", "of these without numbers", &PosesAnswer::untracked},
      Field{"touching", "1", "of these in contact; null if not asked for", &PosesAnswer::touching},
      Field{"unknown", "1", "of these in which contact hangs on an opening of a mesh; null if not asked for",
            &PosesAnswer::unknown},
      Field{"smallest_gap", "", "of all poses; null if there is none or it was not asked for",
            &PosesAnswer::smallest_gap},
      Field{"doubt", "", "what looks wrong with the poses; null if nothing does", &PosesAnswer::doubt}};
};

/// Adds the next row to the summary of all rows; `touch` and `gap` are what the row says.
void add_row(std::string_view touch, const std::optional<SmallestOfPoses>& gap, PosesAnswer& all);
void add_row(const PoseRow& row, PosesAnswer& all);

/// Reads or makes the poses. Throws FileError or std::invalid_argument, one line.
PoseList list_of(const PosesRequest& request, const SessionJoint& joint);

/// The pose of a row of the list, in the centre frame.
Pose pose_in(const SessionJoint& joint, const PoseList& list, std::size_t row);

/// A warning in one line if poses look as if they were in another unit or frame; else empty.
std::string doubt_of(const PosesRequest& request, const SessionJoint& joint, const PoseList& list);

/// The motion x' = rotation x + translation of the ball in the input frame (mm), as a pose in the centre
/// frame. `centre` is in the input frame, too.
Pose pose_about(const Vec3& centre, const Eigen::Matrix3d& rotation, const Vec3& translation);

/// Answers many poses; everything that does not depend on the pose is made once. It finds contact exactly
/// (limits/body_pairs.hpp), the smallest gap between the main surfaces without looking at most vertices
/// (contact/culled_joint.hpp), and areas of all gaps by the kernels for the faces (gap/simd/exact_cells.hpp).
class PoseSeries {
 public:
  /// Throws std::invalid_argument for lengths that CulledScan refuses. Keeps a reference to `joint`.
  PoseSeries(const SessionJoint& joint, const PosesRequest& asked);
  PoseSeries(const PoseSeries&) = delete;
  PoseSeries& operator=(const PoseSeries&) = delete;

  /// The row of a pose, without its number. Several threads may call it at the same time.
  PoseRow answer(const Pose& pose) const;

 private:
  PoseAreas areas(const Pose& pose) const;

  const SessionJoint& joint_;
  PosesRequest asked_;
  BallSocketPair meshes_;            // the main surfaces
  std::optional<BodyPairs> bodies_;  // if touch is asked for
  CulledJoint culled_;
  std::optional<PackedJoint<ExactCells>> cells_;  // if areas are asked for
};

}  // namespace impinge
