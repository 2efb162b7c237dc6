// SPDX-License-Identifier: GPL-3.0-or-later
#include "joint/measures.hpp"

#include <stdexcept>
#include <tuple>

namespace impinge {

std::vector<Measure> answer_measures(const SessionJoint& joint) {
  if (!joint.side) throw std::invalid_argument("measures need to know the side; give left or right");
  const auto& [ball, socket] = std::tie(joint.joint.ball, joint.joint.socket);
  return measure_hip({in_joint_frame(joint, whole_main(ball.mesh, ball.parts)),
                      in_joint_frame(joint, main_surface(socket.mesh, socket.parts))},
                     *joint.side);
}

}  // namespace impinge
