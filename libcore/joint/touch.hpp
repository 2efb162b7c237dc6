// SPDX-License-Identifier: GPL-3.0-or-later
// Do the bones touch in a pose, and where is the smallest gap?
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <tuple>

#include "contact/culled_joint.hpp"
#include "files/fields.hpp"
#include "hip/motion.hpp"
#include "joint/session.hpp"
#include "limits/body_pairs.hpp"

namespace impinge {

/// Contact of bones (limits/body_pairs.hpp).
struct ContactDocument {
  Contact state = Contact::no;
  std::optional<ContactRule> by;
  std::optional<std::string> ball_part;
  std::optional<std::string> socket_part;

  static constexpr std::tuple fields{
      Field{"state", "", "no, yes, or unknown where only an opening of a mesh could tell",
            &ContactDocument::state},
      Field{"by", "", "by what it was told: surfaces meet, one bone is inside the other, or radii overlap",
            &ContactDocument::by},
      Field{"ball_part", "", "part of the ball's bone that touches; null: its main surface, or no contact",
            &ContactDocument::ball_part},
      Field{"socket_part", "", "the same of the socket's", &ContactDocument::socket_part}};
};

/// The vertex of a main surface with the smallest gap of a pose.
struct SmallestOfPose {
  double gap_mm = 0.0;
  std::optional<double> error_bound_mm;  // infinite where nothing is proven
  std::optional<std::array<double, 2>> euclidean_distance_mm;
  Surface surface = Surface::ball;
  std::size_t vertex = 0;
  Vec3 position = Vec3::Zero();
  std::optional<double> hours;  // on the dial

  std::optional<std::string> clock() const { return clock_text(hours); }

  static constexpr std::tuple fields{
      Field{"gap_mm", "mm", "along the ray from the centre; below 0 the main surfaces overlap",
            &SmallestOfPose::gap_mm},
      Field{"error_bound_mm", "mm", "proven bound on its error; null where there is none",
            &SmallestOfPose::error_bound_mm},
      Field{"euclidean_distance_mm", "mm",
            "proven ends of the vertex' distance from the other surface; null if not asked for",
            &SmallestOfPose::euclidean_distance_mm},
      Field{"surface", "", "whose vertex it is", &SmallestOfPose::surface},
      Field{"vertex", "1", "its place in the mesh", &SmallestOfPose::vertex},
      Field{"position", "mm", "x, y, z in the pose, frame of the meshes", &SmallestOfPose::position},
      Field{"clock", "", "on the rim's clock; null where the socket has none", &SmallestOfPose::clock}};
};

/// Two bones, of which at least one is a part.
struct NearestPartDocument {
  double distance_mm = 0.0;
  std::optional<bool> touch;
  std::optional<std::string> ball_part;
  std::optional<std::string> socket_part;

  static constexpr std::tuple fields{
      Field{"distance_mm", "mm", "of their surfaces; 0 in contact", &NearestPartDocument::distance_mm},
      Field{"touch", "", "do they? null where only an opening of a mesh could tell",
            &NearestPartDocument::touch},
      Field{"ball_part", "", "part of the ball's bone; null: its main surface",
            &NearestPartDocument::ball_part},
      Field{"socket_part", "", "part of the socket's bone; null: its main surface",
            &NearestPartDocument::socket_part}};
};

struct TouchRequest {
  Motion pose;

  static constexpr std::tuple fields{
      Field{"pose", "", "of the ball, as flexion=90,internal_rotation=10", &TouchRequest::pose}};
};

struct TouchAnswer {
  ContactDocument contact;
  std::optional<SmallestOfPose> smallest_gap;
  std::optional<NearestPartDocument> nearest_part;

  static constexpr std::tuple fields{
      Field{"contact", "", "of all bones, decided exactly", &TouchAnswer::contact},
      Field{"smallest_gap", "", "of a vertex of the main surfaces; null where they do not face each other",
            &TouchAnswer::smallest_gap},
      Field{"nearest_part", "", "the bones nearest to each other of which one is a part; null without parts",
            &TouchAnswer::nearest_part}};
};

TouchAnswer answer(Session& session, const TouchRequest& request);
/// As answer(), in any pose of the ball in the socket, without the nearest part.
TouchAnswer touch_in(SessionJoint& joint, const Pose& pose);

/// The pose of the ball in the centre frame of the socket after a motion.
Pose pose_of(const SessionJoint& joint, const Motion& motion, const Vec3& translation = Vec3::Zero());
/// A verdict, with the names of the joint's parts.
ContactDocument contact_of(const Joint& joint, const BodyPairs::Verdict& verdict);
std::optional<NearestPartDocument> nearest_part(SessionJoint& joint, const Pose& pose);
/// The smallest gap in one pose, measured on the faces for the vertices that can have it
/// (joint/needed_work.hpp). None where the surfaces do not face each other.
std::optional<SmallestOfPose> smallest_gap(SessionJoint& joint, const Pose& pose);
/// The smallest gap in one of many poses, without looking at most vertices. `culled` must be of the joint's
/// main surfaces.
std::optional<SmallestOfPose> smallest_gap(const SessionJoint& joint, const CulledJoint& culled,
                                           const Pose& pose);
/// The answer of a vertex with this gap, without what bounds it.
SmallestOfPose smallest_at(const SessionJoint& joint, const Pose& pose, Surface of, std::size_t vertex,
                           double gap_mm);

/// Lines for a terminal; empty where there is nothing to say.
std::string describe(const std::optional<SmallestOfPose>& gap);
std::string describe(const std::optional<NearestPartDocument>& part);
/// A line such as "contact             yes: the surfaces of ball and socket meet".
std::string describe(const ContactDocument& contact);

/// The options that the lines below advise the user to set; empty if there is no such option.
struct ScanContactOptions {
  std::string overlap{};      // what makes an overlap no contact (JointInput::overlap_mm)
  double threshold_mm = 0.0;  // gaps up to this are asked about, too; 0: none
  std::string threshold{};    // the option that gave it
  bool rim = false;           // is the rim alone asked about (joint/limits.hpp)?
};

/// One line if bones touch in the pose of the scan, where real bones cannot: every motion from there would
/// only be "blocked". It says how deep, where, and what to do. Empty if nothing touches. `pose` names the
/// pose, such as "as scanned".
std::string describe_contact(const TouchAnswer& found, const std::string& pose,
                             const ScanContactOptions& options);

/// One line if nothing touches but the gap is at most the threshold, so that each answer about a gap of that
/// size is "blocked"; else empty.
std::string describe_threshold(const TouchAnswer& found, const std::string& pose,
                               const ScanContactOptions& options);

/// The pose in which all angles are 0, in words: that of the scan, unless landmarks of a femur turned it.
const char* name_of_rest(const Joint& joint);

/// The pose of the scan, before landmarks of a femur turned it to neutral.
Pose scanned_pose(const SessionJoint& joint);
/// Its inverse in the joint frame: how landmarks turned the ball.
Eigen::Matrix3d turn_from_scan(const SessionJoint& joint);

/// Adds these lines to the joint's warnings for the pose of the scan, where motions begin. If landmarks
/// turned the femur to neutral, it adds them for both poses.
void warn_of_contact(SessionJoint& joint, const ScanContactOptions& options = {});

}  // namespace impinge
