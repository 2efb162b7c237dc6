// SPDX-License-Identifier: GPL-3.0-or-later
// Questions about one joint: what the library works out for one of them and for all of them at once, and how
// another library answers the same question.
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

/// A joint about which questions are asked. It is not moved in memory.
struct AskedJoint {
  explicit AskedJoint(const TurnedJoint& turned);
  AskedJoint(const AskedJoint&) = delete;
  /// Begins a session in which nothing has been worked out.
  void renew() { session = std::make_unique<Session>(joint, side, "RAS"); }
  /// All faces of a bone, about the centre.
  const TriangleMesh& mesh(Surface of) const { return session->joint->mesh(of); }
  std::size_t faces() const { return bones.ball.faces.size() + bones.socket.faces.size(); }

  std::string name;
  BallSocketPair bones;  // as other libraries take them, joint frame, mm
  std::optional<Side> side;
  Joint joint;  // as our library takes it
  std::unique_ptr<Session> session;
};

/// The numbers of an answer, in a fixed order, NaN where there is none; and what was made for it.
struct Answered {
  std::vector<double> numbers;
  Kept kept{};
};

/// One way to answer a question.
struct Way {
  std::string name;                  // "needed": ours; else a method of another library
  std::function<Answered()> answer;  // starts from the meshes, or from a session that has worked out nothing
  double share = 1.0;                // share of the work that it does; the time is scaled up by it
};

/// Faces and vertices of both bones that our method looks at one by one, after trees and caps of all of them
/// were made; empty if not counted.
struct LookedAt {
  std::optional<std::size_t> faces{};
  std::optional<std::size_t> vertices{};
};

struct AskedQuestion {
  std::string name;
  std::vector<Way> ways;  // our own first
  LookedAt looked_at;
};

/// How much work is asked for.
struct Asking {
  double width = 0.0;     // of the volume
  double step_deg = 0.0;  // for a library that finds limits
  std::size_t poses = 0;  // for a library that samples the volume
};

/// All questions of the experiment, in the order of its head. Adds the labels of methods.
std::vector<AskedQuestion> questions_of(AskedJoint& joint, const Asking& asking,
                                        std::map<std::string, std::string>& labels);

/// The answers to them, in the same order, from a session that works out a whole report with every output.
std::vector<Answered> everything(AskedJoint& joint, const Asking& asking);

}  // namespace impinge::lab
