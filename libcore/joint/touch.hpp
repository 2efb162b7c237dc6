// SPDX-License-Identifier: GPL-3.0-or-later
// Do the bones touch in a pose, and where is the smallest gap?
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "files/fields.hpp"
#include "hip/motion.hpp"
#include "joint/pose_answer.hpp"
#include "limits/body_pairs.hpp"

namespace impinge {

/// Contact of bones (limits/body_pairs.hpp).
struct ContactDocument {
  Contact state = Contact::no;
  std::optional<ContactRule> by;
  std::optional<std::string> ball_part;
  std::optional<std::string> socket_part;

  static constexpr auto fields() {
    using Found = ContactDocument;
    return std::tuple{
        Field{"state", "", "no, yes, or unknown where only an opening of a mesh could tell", &Found::state},
        Field{"by", "", "by what it was told: surfaces meet, one bone is inside the other, or radii overlap",
              &Found::by},
        Field{"ball_part", "", "part of the ball's bone that touches; null: its main surface, or no contact",
              &Found::ball_part},
        Field{"socket_part", "", "the same of the socket's", &Found::socket_part}};
  }
};

struct SmallestGapDocument {
  double gap_mm = 0.0;
  std::optional<double> error_bound_mm;
  std::optional<std::vector<double>> euclidean_distance_mm;
  Surface surface = Surface::ball;
  std::size_t vertex = 0;
  Vec3 position = Vec3::Zero();
  std::optional<std::string> clock;

  static constexpr auto fields() {
    using Gap = SmallestGapDocument;
    return std::tuple{
        Field{"gap_mm", "mm", "along the ray from the centre; below 0 the main surfaces overlap",
              &Gap::gap_mm},
        Field{"error_bound_mm", "mm", "proven bound on its error; null where there is none",
              &Gap::error_bound_mm},
        Field{"euclidean_distance_mm", "mm",
              "proven ends of the vertex' distance from the other surface; null if not asked for",
              &Gap::euclidean_distance_mm},
        Field{"surface", "", "whose vertex it is", &Gap::surface},
        Field{"vertex", "1", "its place in the mesh", &Gap::vertex},
        Field{"position", "mm", "x, y, z in the pose, frame of the meshes", &Gap::position},
        Field{"clock", "", "on the rim's clock; null where the socket has none", &Gap::clock}};
  }
};

/// Two bones of which one at least is a part.
struct NearestPartDocument {
  double distance_mm = 0.0;
  bool touch = false;
  std::optional<std::string> ball_part;
  std::optional<std::string> socket_part;

  static constexpr auto fields() {
    using Part = NearestPartDocument;
    return std::tuple{
        Field{"distance_mm", "mm", "of their surfaces; 0 in contact", &Part::distance_mm},
        Field{"touch", "", "do they?", &Part::touch},
        Field{"ball_part", "", "part of the ball's bone; null: its main surface", &Part::ball_part},
        Field{"socket_part", "", "part of the socket's bone; null: its main surface", &Part::socket_part}};
  }
};

struct TouchRequest {
  Motion pose;

  static constexpr auto fields() {
    return std::tuple{Field{"pose", "",
                            "of the ball, from the pose of the scan, as flexion=90,internal_rotation=10",
                            &TouchRequest::pose}};
  }
};

struct TouchAnswer {
  ContactDocument contact;
  std::optional<SmallestGapDocument> smallest_gap;
  std::optional<NearestPartDocument> nearest_part;

  static constexpr auto fields() {
    using Found = TouchAnswer;
    return std::tuple{
        Field{"contact", "", "of all bones, decided exactly", &Found::contact},
        Field{"smallest_gap", "", "of a vertex of the main surfaces; null where they do not face each other",
              &Found::smallest_gap},
        Field{"nearest_part", "",
              "the bones nearest to each other of which one is a part; null without parts",
              &Found::nearest_part}};
  }
};

TouchAnswer answer(Session& session, const TouchRequest& request);

/// A verdict with the names of the joint's parts.
ContactDocument contact_of(const Joint& joint, const BodyPairs::Verdict& verdict);
std::optional<NearestPartDocument> nearest_part(SessionJoint& joint, const Pose& pose);

/// The line for a terminal, such as "contact             yes: the surfaces of ball and socket meet".
std::string describe(const ContactDocument& contact);

}  // namespace impinge
