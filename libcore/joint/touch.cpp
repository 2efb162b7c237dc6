// SPDX-License-Identifier: GPL-3.0-or-later
#include "joint/touch.hpp"

#include <algorithm>
#include <cmath>

#include "files/formatted.hpp"
#include "gap/measured_gap.hpp"
#include "joint/needed_work.hpp"
#include "sphere/infinity.hpp"
#include "sphere/radial_table.hpp"

namespace impinge {
namespace {

template <class Pair>
std::string both_of(const Pair& bones) {
  return bones.ball_part.value_or("ball") + " and " + bones.socket_part.value_or("socket");
}

std::string place_of(const SmallestOfPose& gap) {
  return gap.hours ? " at " + clock_text(*gap.hours) + " o'clock" : "";
}

void warn(const std::string& line, SessionJoint& joint) {
  if (!line.empty()) joint.joint.warnings.push_back(line);
}

// `faces` are the other surface's.
SmallestOfPose told_gap(const SessionJoint& joint, const LeastGap& least, const NearFaces& faces,
                        const Pose& pose) {
  const auto [scanned, vertex] = least.at;
  SmallestOfPose told = smallest_at(joint, pose, scanned, vertex, least.gap_mm);
  const Vec3& x = joint.bone(scanned).mesh.vertices[vertex];
  const CertifiedGap ends = measured_gap(scanned, faces, to_other(scanned, pose, x));
  told.error_bound_mm = ends.cover == Cover::none  // a rim that rounding decides about
                            ? kInfinity
                            : std::max(ends.high - least.gap_mm, least.gap_mm - ends.low);
  return told;
}

}  // namespace

SmallestOfPose smallest_at(const SessionJoint& joint, const Pose& pose, Surface of, std::size_t vertex,
                           double gap_mm) {
  const Vec3& x = joint.bone(of).mesh.vertices[vertex];
  const Vec3 place = of == Surface::ball ? to_socket(pose, x) : x;
  return {.gap_mm = gap_mm,
          .error_bound_mm = {},
          .euclidean_distance_mm = {},
          .surface = of,
          .vertex = vertex,
          .position = place + joint.joint.centre,
          .hours = joint.hours(place)};
}

ContactDocument contact_of(const Joint& joint, const BodyPairs::Verdict& verdict) {
  ContactDocument contact{.state = verdict.contact, .by = {}, .ball_part = {}, .socket_part = {}};
  if (verdict.contact == Contact::no) return contact;
  if (verdict.contact == Contact::yes) contact.by = verdict.rule;
  contact.ball_part = body_name(joint.ball.parts, verdict.pair.ball);
  contact.socket_part = body_name(joint.socket.parts, verdict.pair.socket);
  return contact;
}

std::optional<NearestPartDocument> nearest_part(SessionJoint& joint, const Pose& pose) {
  const auto nearest = joint.bodies().nearest_part(pose);
  if (!nearest) return std::nullopt;
  const std::optional<bool> touch =
      nearest->touch == Contact::unknown ? std::nullopt : std::optional(nearest->touch == Contact::yes);
  return NearestPartDocument{nearest->distance_mm, touch,
                             body_name(joint.joint.ball.parts, nearest->pair.ball),
                             body_name(joint.joint.socket.parts, nearest->pair.socket)};
}

std::optional<SmallestOfPose> smallest_gap(const SessionJoint& joint, const CulledJoint& culled,
                                           const Pose& pose) {
  const std::optional<LeastGap> least = culled.least_gap(pose);
  if (!least) return std::nullopt;
  return told_gap(joint, *least, culled.faces(other(least->at.scanned)), pose);
}

std::optional<SmallestOfPose> smallest_gap(SessionJoint& joint, const Pose& pose) {
  const FacesMet met{&joint.faces(Surface::socket), &joint.faces(Surface::ball)};
  const auto gap = [&](Surface of, std::size_t /*vertex*/, const Vec3& x) {
    if (x.isZero(0.0)) return kNoSurface;
    const Surface facing = other(of);
    return signed_gap(of, joint.faces(facing).radius(x.normalized(), facing_layer(facing)), x.norm());
  };
  const SceneAnswer found = answer_on_faces({met[1]->mesh(), met[0]->mesh()},
                                            {.question = Question::smallest_gap, .pose = pose}, met, gap);
  if (!found.smallest) return std::nullopt;
  const auto& [gap_mm, scanned, vertex] = *found.smallest;
  return told_gap(joint, {gap_mm, {scanned, vertex}}, joint.faces(other(scanned)), pose);
}

Pose pose_of(const SessionJoint& joint, const Motion& motion, const Vec3& translation) {
  return {joint.axes.transpose() * joint_rotation(motion, joint.side) * joint.axes, translation};
}

std::string describe(const ContactDocument& contact) {
  const std::string line = "contact             ";
  if (contact.state == Contact::no) return line + "none\n";
  const std::string both = both_of(contact);
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

std::string describe(const std::optional<SmallestOfPose>& gap) {
  if (!gap) return "smallest gap        none: the surfaces do not face each other\n";
  std::string text =
      formatted("smallest gap        %.3f mm%s at %s vertex %zu", gap->gap_mm,
                gap->gap_mm < 0.0 ? ", depth along a ray," : "", name(gap->surface).data(), gap->vertex);
  if (gap->hours) text += ", " + clock_text(*gap->hours) + " o'clock";
  if (gap->error_bound_mm && std::isfinite(*gap->error_bound_mm))
    text += " (error of this gap at most " + rounded_up(*gap->error_bound_mm, 3) + " mm)";
  if (gap->euclidean_distance_mm) {
    text += "\nEuclidean distance  " + rounded_down(gap->euclidean_distance_mm->front(), 3) + " to " +
            rounded_up(gap->euclidean_distance_mm->back(), 3) + " mm there";
  }
  return text + "\n";
}

std::string describe(const std::optional<NearestPartDocument>& part) {
  if (!part) return "";
  const std::string bodies = both_of(*part);
  if (part->touch == true) return "parts               " + bodies + " touch\n";
  return "parts               " + bodies + " are nearest, " + rounded_down(part->distance_mm, 3) +
         (part->touch ? " mm apart\n" : " mm between their surfaces; whether one is inside is not known\n");
}

TouchAnswer touch_in(SessionJoint& joint, const Pose& pose) {
  return {.contact = contact_of(joint.joint, joint.bodies().verdict(pose)),
          .smallest_gap = smallest_gap(joint, pose),
          .nearest_part = {}};
}

TouchAnswer answer(Session& session, const TouchRequest& request) {
  shift_ball(session, Vec3::Zero());
  const Pose pose = pose_of(*session.joint, request.pose);
  TouchAnswer found = touch_in(*session.joint, pose);
  found.nearest_part = nearest_part(*session.joint, pose);
  return found;
}

std::string describe_contact(const TouchAnswer& found, const std::string& pose,
                             const ScanContactOptions& options) {
  if (found.contact.state != Contact::yes) return {};
  const auto& gap = found.smallest_gap;
  const bool of_parts = found.contact.ball_part || found.contact.socket_part;  // rays ignore parts
  const bool overlap = gap && gap->gap_mm < 0.0 && !of_parts;
  const std::string depth =
      overlap ? ", " + rounded_up(-gap->gap_mm, 3) + " mm deep along a ray" + place_of(*gap) : "";
  const std::string on_top =
      overlap && !options.overlap.empty() ? "; " + options.overlap + " accepts it" : "";
  const std::string blocked = options.rim ? "blocked where the rim itself touches neck or shaft" : "blocked";
  return both_of(found.contact) + " touch " + pose + depth + ": every motion that begins there is " +
         blocked +
         "; check the centre, the frame and the segmentation of both (a head "
         "and a liner of equal radius need a clearance)" +
         on_top;
}

std::string describe_threshold(const TouchAnswer& found, const std::string& pose,
                               const ScanContactOptions& options) {
  const auto& gap = found.smallest_gap;
  if (found.contact.state == Contact::yes || !gap || gap->gap_mm > options.threshold_mm) return {};
  return "the smallest gap " + pose + " is " + rounded_down(gap->gap_mm, 3) + " mm" + place_of(*gap) +
         formatted(", not above the %g mm of ", options.threshold_mm) + options.threshold +
         ": every limit for that gap is blocked from the start; give a smaller one";
}

const char* name_of_rest(const Joint& joint) {
  return joint.from_neutral() ? "neutral pose of the landmarks" : "pose of the scan";
}

Pose scanned_pose(const SessionJoint& joint) {
  const auto& frames = joint.joint.frames;
  Pose scanned;
  if (joint.joint.from_neutral()) scanned.rotation = frames->femur->transpose() * frames->pelvis;
  return scanned;
}

Eigen::Matrix3d turn_from_scan(const SessionJoint& joint) {
  return joint.axes * scanned_pose(joint).rotation.transpose() * joint.axes.transpose();
}

void warn_of_contact(SessionJoint& joint, const ScanContactOptions& options) {
  const bool turned = joint.joint.from_neutral();
  const std::string start = turned ? std::string("in the ") + name_of_rest(joint.joint) : "as scanned";
  const TouchAnswer found = touch_in(joint, Pose());
  warn(describe_contact(found, start, options), joint);
  if (options.threshold_mm > 0.0) warn(describe_threshold(found, start, options), joint);
  if (turned) warn(describe_contact(touch_in(joint, scanned_pose(joint)), "as scanned", options), joint);
}

}  // namespace impinge
