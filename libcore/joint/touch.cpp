// SPDX-License-Identifier: GPL-3.0-or-later
#include "joint/touch.hpp"

#include "joint/posed_gap.hpp"

namespace impinge {
namespace {

// Null for a main surface.
std::optional<std::string> part_or_null(const std::vector<MeshPart>& parts, std::size_t body) {
  std::string name = body_name(parts, body);
  return name.empty() ? std::nullopt : std::optional(std::move(name));
}

SmallestGapDocument smallest_of(const SessionJoint& joint, const PosedGap& found) {
  SmallestGapDocument gap{.gap_mm = found.least.gap_mm,
                          .error_bound_mm = found.bound_mm,
                          .euclidean_distance_mm = {},
                          .surface = found.least.at.scanned,
                          .vertex = found.least.at.vertex,
                          .position = found.place + joint.joint.centre,
                          .clock = {}};
  if (joint.dial) gap.clock = clock_text(joint.dial->hours(joint.axes * found.place));
  return gap;
}

}  // namespace

ContactDocument contact_of(const Joint& joint, const BodyPairs::Verdict& verdict) {
  ContactDocument contact{.state = verdict.contact, .by = {}, .ball_part = {}, .socket_part = {}};
  if (verdict.contact == Contact::no) return contact;
  if (verdict.contact == Contact::yes) contact.by = verdict.rule;
  contact.ball_part = part_or_null(joint.ball.parts, verdict.pair.ball);
  contact.socket_part = part_or_null(joint.socket.parts, verdict.pair.socket);
  return contact;
}

std::optional<NearestPartDocument> nearest_part(SessionJoint& joint, const Pose& pose) {
  const auto nearest = joint.bodies().nearest_part(pose);
  if (!nearest) return std::nullopt;
  return NearestPartDocument{nearest->distance_mm, nearest->touch,
                             part_or_null(joint.joint.ball.parts, nearest->pair.ball),
                             part_or_null(joint.joint.socket.parts, nearest->pair.socket)};
}

std::string describe(const ContactDocument& contact) {
  const std::string line = "contact             ";
  if (contact.state == Contact::no) return line + "none\n";
  const std::string both =
      contact.ball_part.value_or("ball") + " and " + contact.socket_part.value_or("socket");
  if (contact.state == Contact::unknown) {
    return line + "not known: the surfaces of " + both +
           " do not meet, and whether one is inside the other hangs on an opening of a mesh; close it, or "
           "give the whole "
           "bone\n";
  }
  switch (*contact.by) {
    case ContactRule::surfaces:
      return line + "yes: the surfaces of " + both + " meet\n";
    case ContactRule::inside:
      return line + "yes: of " + both + " one is inside the other\n";
    case ContactRule::radii:
      break;
  }
  return line +
         "yes, by radii: no surfaces meet, but the ball reaches beyond the socket, which is a sheet without "
         "an inside; "
         "the whole bone would decide\n";
}

TouchAnswer answer(Session& session, const TouchRequest& request) {
  SessionJoint& joint = *session.joint;
  const Pose pose = pose_of(joint, request.pose);
  TouchAnswer found{.contact = contact_of(joint.joint, joint.bodies().verdict(pose)),
                    .smallest_gap = {},
                    .nearest_part = {}};
  const BallSocketPair meshes{joint.main(Surface::ball), joint.main(Surface::socket)};
  if (const auto smallest = posed_gap(CulledJoint(meshes), meshes, pose))
    found.smallest_gap = smallest_of(joint, *smallest);
  found.nearest_part = nearest_part(joint, pose);
  return found;
}

}  // namespace impinge
