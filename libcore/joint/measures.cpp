// SPDX-License-Identifier: GPL-3.0-or-later
#include "joint/measures.hpp"

#include <stdexcept>

namespace impinge {

BallSocketPair measured_meshes(const SessionJoint& joint) {
  const JointPart& ball = joint.joint.ball;
  return {in_joint_frame(joint, whole_main(ball.mesh, ball.parts)),
          in_joint_frame(joint, joint.joint.socket.main())};
}

MeasureAnswer answer(Session& session, const MeasureRequest& /*request*/) {
  const SessionJoint& joint = *session.joint;
  if (!joint.side) throw std::invalid_argument("side: measures need to know it; give left or right");
  MeasureAnswer found;
  for (const Measure& measure : measure_hip(measured_meshes(joint), *joint.side))
    found.measures.push_back({measure, published_measure(measure.name)});
  return found;
}

}  // namespace impinge
