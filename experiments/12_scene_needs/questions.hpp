// SPDX-License-Identifier: GPL-3.0-or-later
// Questions about one joint: what the library works out for each alone and for all of them at once, and how
// another library answers the same.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "12_scene_needs/used_memory.hpp"
#include "17_limit_time/limit_times.hpp"
#include "hip/joint.hpp"
#include "joint/session.hpp"

namespace impinge::lab {

/// A joint that is asked. It stays where it is.
struct AskedJoint {
  explicit AskedJoint(const TurnedJoint& turned);
  AskedJoint(const AskedJoint&) = delete;
  /// Begins a session that has worked out nothing yet.
  void renew() { session = std::make_unique<Session>(joint, side, "RAS"); }
  /// All faces of a side, about the centre.
  const TriangleMesh& mesh(Surface of) const { return session->joint->mesh(of); }
  std::size_t faces() const { return bones.ball.faces.size() + bones.socket.faces.size(); }

  std::string name;
  BallSocketPair bones;  // as others' libraries take them, joint frame, mm
  std::optional<Side> side;
  Joint joint;  // as the library does
  std::unique_ptr<Session> session;
};

/// The numbers of an answer, in a fixed order; NaN where there is none. And what was made for it.
struct Answered {
  std::vector<double> numbers;
  Kept kept{};
};

/// One way to an answer.
struct Way {
  std::string name;                  // "needed": ours; else a method of another library
  std::function<Answered()> answer;  // from the meshes, or a session that has worked out nothing
  double share = 1.0;                // of the work that it does; the time of all is so much more
};

/// Faces and vertices of both sides that ours looks at one by one, when trees and caps have been made of all
/// of them; none: not counted.
struct LookedAt {
  std::optional<std::size_t> faces{};
  std::optional<std::size_t> vertices{};
};

struct AskedQuestion {
  std::string name;
  std::vector<Way> ways;  // ours first
  LookedAt looked_at;
};

/// How much is asked.
struct Asking {
  double width = 0.0;     // of the volume
  double step_deg = 0.0;  // of a library that finds limits
  std::size_t poses = 0;  // of a library that stands in a grid of poses for the volume
};

/// Touch, smallest gap and all gaps of a pose, limits of all named motions, volume and measures. Adds the
/// labels of methods.
std::vector<AskedQuestion> questions_of(AskedJoint& joint, const Asking& asking,
                                        std::map<std::string, std::string>& labels);

/// Their answers, in the same order, by a session that works out all that a report says, with every output.
std::vector<Answered> everything(AskedJoint& joint, const Asking& asking);

}  // namespace impinge::lab
