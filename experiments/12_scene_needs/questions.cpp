// SPDX-License-Identifier: GPL-3.0-or-later
#include "12_scene_needs/questions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <set>
#include <stdexcept>
#include <utility>

#include <Eigen/Geometry>

#include "contact/moved_faces.hpp"
#include "hip/named_motion.hpp"
#include "joint/gaps.hpp"
#include "joint/limits.hpp"
#include "joint/measures.hpp"
#include "joint/needed_work.hpp"
#include "joint/touch.hpp"
#include "joint/volume.hpp"
#include "methods/contact.hpp"
#include "methods/gaps.hpp"
#include "rotations/volume.hpp"
#include "sphere/infinity.hpp"
#include "sphere/radial_table.hpp"

namespace impinge::lab {
namespace {

constexpr Motion kPose{.flexion = 60.0};
constexpr double kResolution = 0.01;  // degrees, to which a library's steps are halved
constexpr const char* kOurs = "needed";

Pose pose_of(const AskedJoint& joint) { return {joint_rotation(kPose, joint.side), Vec3::Zero()}; }

// A motion that grows from its start.
struct AskedMotion {
  JointTurn turn;
  double largest_deg;
};
std::vector<AskedMotion> motions_of(const AskedJoint& joint) {
  std::vector<AskedMotion> motions;
  for (const NamedMotion& named : named_motions()) {
    const MotionName& growing = motion_name(named.growing);
    motions.push_back({joint_turn(named.start, growing, joint.side), largest_growth(named.start, growing)});
  }
  return motions;
}

std::vector<double> numbers_of(const MeasureAnswer& answer) {
  std::vector<double> numbers;
  for (const MeasureRow& row : answer.measures) numbers.push_back(row.value.value_or(kNoSurface));
  return numbers;
}
std::vector<double> numbers_of(const GapsAnswer& answer) {
  std::vector<double> numbers = answer.ball.gap;
  numbers.insert(numbers.end(), answer.socket.gap.begin(), answer.socket.gap.end());
  return numbers;
}
std::vector<double> numbers_of(const VolumeAnswer& answer) {
  const VolumeShares& shares = answer.shares();
  return {shares.low(), shares.high(), shares.reached(), shares.within_reach()};
}
void add(const TurnLimit& limit, std::vector<double>& numbers) {
  numbers.insert(numbers.end(), {limit.low_deg, limit.high_deg});
}

// What is built for the surfaces alone.
struct MetFaces {
  explicit MetFaces(const AskedJoint& joint)
      : ball(joint.mesh(Surface::ball)), socket(joint.mesh(Surface::socket)) {}
  MovedFaces ball;
  FixedFaces socket;
};

Answered our_touch(AskedJoint& joint) {
  auto faces = std::make_shared<const MetFaces>(joint);
  return {{surfaces_meet(faces->ball, faces->socket, pose_of(joint)) ? 1.0 : 0.0}, faces};
}

std::vector<double> numbers_of(const std::optional<SmallestOfPose>& gap) {
  return {gap ? gap->gap_mm : kNoSurface};
}

Answered our_smallest_gap(AskedJoint& joint) {
  return {numbers_of(smallest_gap(*joint.session->joint, pose_of(joint))), {}};
}

Answered our_gaps(AskedJoint& joint) {
  GapsRequest request;
  request.pose = kPose;
  request.outputs = {Output::gaps};
  const auto found = std::make_shared<const GapsAnswer>(answer(*joint.session, request));
  return {numbers_of(*found), found};
}

CentredLimits limits_of(const AskedJoint& joint) {
  return {
      joint.session->joint->joint, {joint.mesh(Surface::ball), joint.mesh(Surface::socket)}, Vec3::Zero()};
}

Answered our_limits(AskedJoint& joint) {
  auto limits = std::make_shared<const CentredLimits>(limits_of(joint));
  Answered found{{}, limits};
  for (const AskedMotion& motion : motions_of(joint))
    add(limits->limits.first_contact(motion.turn, motion.largest_deg), found.numbers);
  return found;
}

Answered our_volume(AskedJoint& joint, double width) {
  const auto found =
      std::make_shared<const VolumeAnswer>(answer(*joint.session, VolumeRequest{.width = width}));
  return {numbers_of(*found), found};
}

Answered our_measures(AskedJoint& joint) {
  return {numbers_of(answer(*joint.session, MeasureRequest{})), {}};
}

// Counted with the library's own parts, which choose as the whole does.

LookedAt looked_at_by_touch(const AskedJoint& joint) {
  const MetFaces faces(joint);
  std::size_t count = 0;
  surfaces_meet(faces.ball, faces.socket, pose_of(joint), &count);
  return {count, {}};
}

// Every vertex looks for near faces. Those that can change the answer look at the faces in whose caps they
// lie.
LookedAt looked_at_by_gaps(AskedJoint& joint, Question question) {
  SessionJoint& session = *joint.session->joint;
  const BallSocketPair meshes{session.main(Surface::ball), session.main(Surface::socket)};
  const FacesMet met{&session.faces(Surface::socket), &session.faces(Surface::ball)};
  const SceneNeeds needs{.question = question, .pose = pose_of(joint)};
  const NeededVertices vertices = needed_vertices(meshes, needs, met);
  std::size_t count = 0;
  for (std::size_t scan = 0; scan < 2; ++scan) {
    std::set<std::size_t> faces;
    for (const VertexIndex v : vertices.of[scan]) {
      const Vec3 x = to_other(kSurfaces[scan], needs.pose, mesh_of(meshes, kSurfaces[scan]).vertices[v]);
      met[scan]->any_hit(x, [&](std::size_t f, int /*side*/) {
        faces.insert(f);
        return false;
      });
    }
    count += faces.size();
  }
  return {count, meshes.ball.vertices.size() + meshes.socket.vertices.size()};
}

// Faces whose spheres may meet before the limit; a best-first search compares these.
LookedAt looked_at_by_limits(const AskedJoint& joint) {
  constexpr double kWithin = 4e-12;  // of the radius: limits/turn_contact.hpp
  const CentredLimits limits = limits_of(joint);
  const std::array<TurnBody, 2> body{TurnBody(joint.mesh(Surface::ball)),
                                     TurnBody(joint.mesh(Surface::socket))};
  const double within =
      kWithin * std::max(body[0].faces.nodes()[0].farthest, body[1].faces.nodes()[0].farthest);
  std::array<std::set<std::uint32_t>, 2> faces;
  std::array<std::set<VertexIndex>, 2> vertices;
  for (const AskedMotion& motion : motions_of(joint)) {
    const TurnLimit limit = limits.limits.first_contact(motion.turn, motion.largest_deg);
    const Eigen::Matrix3d upright =
        Eigen::Quaterniond::FromTwoVectors(motion.turn.axis, Vec3::UnitZ()).toRotationMatrix();
    const double last = limit.high_deg * kDegree;
    visit_meetings(
        {body[0].faces, upright * motion.turn.inner, body[1].faces, upright * motion.turn.outer.transpose()},
        0.0, last, [&](double) { return within; },
        [&](std::uint32_t a, std::uint32_t b) {
          faces[0].insert(body[0].faces.nodes()[a].at);
          faces[1].insert(body[1].faces.nodes()[b].at);
          return last;
        });
  }
  for (std::size_t k = 0; k < 2; ++k) {
    for (const std::uint32_t f : faces[k]) {
      for (const VertexIndex v : joint.mesh(kSurfaces[k]).faces[f]) vertices[k].insert(v);
    }
  }
  return {faces[0].size() + faces[1].size(), vertices[0].size() + vertices[1].size()};
}

// Other libraries.

// The case of that name, with its label; none if its library is not installed.
template <class OneCase>
const OneCase* find_case(const std::vector<OneCase>& cases, const std::string& name,
                         std::map<std::string, std::string>& labels) {
  const auto found = std::ranges::find(cases, name, &OneCase::name);
  if (found == cases.end()) return nullptr;
  labels.emplace(found->name, found->label);
  return &*found;
}

// Steps until a pose touches, then halves the last step.
double stepped(const Touch& touches, const AskedMotion& motion, double step_deg) {
  const auto at = [&](double angle) {
    const Eigen::Matrix3d grown = Eigen::AngleAxisd(angle * kDegree, motion.turn.axis).toRotationMatrix();
    return Pose{motion.turn.outer * grown * motion.turn.inner, Vec3::Zero()};
  };
  double free = 0.0;
  double touching = 0.0;
  while (!touches(at(touching))) {
    if (touching >= motion.largest_deg) return motion.largest_deg;
    free = touching;
    touching = std::min(touching + step_deg, motion.largest_deg);
  }
  while (touching - free > kResolution) {
    const double middle = 0.5 * (free + touching);
    (touches(at(middle)) ? touching : free) = middle;
  }
  return touching;
}

std::function<Answered()> touch_by(const AskedJoint& joint, const ContactCase& method) {
  return [&joint, make = method.make] {
    auto query = std::make_shared<const ContactQuery>(make());
    return Answered{{query->touches(pose_of(joint)) ? 1.0 : 0.0}, query};
  };
}

std::function<Answered()> limits_by(const AskedJoint& joint, const ContactCase& method, double step_deg) {
  return [&joint, make = method.make, step_deg] {
    auto query = std::make_shared<const ContactQuery>(make());
    Answered found{{}, query};
    for (const AskedMotion& motion : motions_of(joint)) {
      const double limit = stepped(query->touches, motion, step_deg);
      found.numbers.insert(found.numbers.end(), {limit, limit});
    }
    return found;
  };
}

// Random rotations in place of a grid that comes as near to every pose as the finest cells do.
Way volume_by(const ContactCase& method, const MotionVolume& volume, std::size_t poses) {
  std::uint32_t level = 0;
  volume.for_each([&](const VolumeCell& at) { level = std::max(level, at.cell.level); });
  const auto query = std::make_shared<const ContactQuery>(method.make());
  const auto answer = [query, poses] {
    std::mt19937_64 engine(12);
    std::normal_distribution<double> normal;
    std::size_t clear = 0;
    for (std::size_t k = 0; k < poses; ++k) {
      Eigen::Quaterniond q(normal(engine), normal(engine), normal(engine), normal(engine));
      clear += query->touches({q.normalized().toRotationMatrix(), Vec3::Zero()}) ? 0U : 1U;
    }
    return Answered{{static_cast<double>(clear) / static_cast<double>(poses)}, query};
  };
  return {method.name, answer, static_cast<double>(poses) / (4.0 * std::pow(8.0, level))};
}

// Both main surfaces, the vertices of each, and the surface against which they are measured.
struct RayAsking {
  explicit RayAsking(const SessionJoint& joint)
      : meshes{joint.main(Surface::ball), joint.main(Surface::socket)} {}
  AskedSurface surface(Surface scanned) const {
    return {mesh_of(meshes, other(scanned)), facing_layer(other(scanned)), scanned};
  }
  BallSocketPair meshes;
  std::array<AskedPoints, 2> points{AskedPoints(meshes.ball.vertices), AskedPoints(meshes.socket.vertices)};
};

// All gaps of the pose, or only the smallest.
std::function<Answered()> rays_by(const AskedJoint& joint, const std::string& method,
                                  std::map<std::string, std::string>& labels, bool least) {
  const auto asking = std::make_shared<const RayAsking>(*joint.session->joint);
  std::array<std::function<GapQuery()>, 2> make;
  for (std::size_t k = 0; k < 2; ++k) {
    const std::vector<GapCase> cases =
        cases_of(gaps_methods(), &Method::gaps, asking->surface(kSurfaces[k]), GapSizes{});
    const GapCase* found = find_case(cases, method, labels);
    if (found == nullptr) return {};
    make[k] = found->make;
  }
  return [&joint, asking, make, least] {
    auto query = std::make_shared<std::array<GapQuery, 2>>();
    Answered found{{}, query};
    for (std::size_t k = 0; k < 2; ++k) {
      (*query)[k] = make[k]();
      GapScratch scratch;
      (*query)[k].scan(asking->points[k], pose_of(joint), scratch);
      for (std::size_t v = 0; v < asking->points[k].points.size(); ++v)
        found.numbers.push_back(scratch.gap(v));
      found.numbers.resize(
          found.numbers.size() + joint.mesh(kSurfaces[k]).vertices.size() - asking->points[k].points.size(),
          kNoSurface);  // for vertices of parts
    }
    if (!least) return found;
    double smallest = kInfinity;
    for (const double gap : found.numbers) smallest = gap < smallest ? gap : smallest;
    found.numbers = {smallest};
    return found;
  };
}

}  // namespace

AskedJoint::AskedJoint(const TurnedJoint& turned)
    : name(turned.name), bones(turned.bones), side(turned.side) {
  JointInput input;
  input.ball = {name + " ball", bones.ball};
  input.socket = {name + " socket", bones.socket};
  input.centre = Vec3::Zero();
  input.side = side;
  joint = assemble_joint(std::move(input));
  renew();
}

std::vector<AskedQuestion> questions_of(AskedJoint& joint, const Asking& asking,
                                        std::map<std::string, std::string>& labels) {
  const auto ours = [&joint](const auto& answer) {
    return Way{kOurs, [&joint, answer] { return answer(joint); }};
  };
  const auto volume = [width = asking.width](AskedJoint& of) { return our_volume(of, width); };
  std::vector<AskedQuestion> all{
      {"touch", {ours(our_touch)}, looked_at_by_touch(joint)},
      {"smallest gap", {ours(our_smallest_gap)}, looked_at_by_gaps(joint, Question::smallest_gap)},
      {"all gaps", {ours(our_gaps)}, looked_at_by_gaps(joint, Question::all_gaps)},
      {"limits", {ours(our_limits)}, looked_at_by_limits(joint)},
      {"volume", {ours(volume)}, {}},
      {"measures", {ours(our_measures)}, {}}};
  const std::vector<ContactCase> cases = cases_of(steps_methods(), &Method::steps, joint.bones);
  for (const char* name : {"fcl_collide", "ode_collide"}) {
    if (const ContactCase* found = find_case(cases, name, labels))
      all[0].ways.push_back({name, touch_by(joint, *found)});
  }
  for (const char* name : {"embree_ray8", "cgal_first_hit"}) {
    for (const std::size_t question : {1U, 2U}) {
      if (auto rays = rays_by(joint, name, labels, question == 1))
        all[question].ways.push_back({name, std::move(rays)});
    }
  }
  if (const ContactCase* found = find_case(cases, "fcl_collide", labels)) {
    all[3].ways.push_back({found->name, limits_by(joint, *found, asking.step_deg)});
    const VolumeAnswer known = answer(*joint.session, VolumeRequest{.width = asking.width});
    all[4].ways.push_back(volume_by(*found, known.volume, asking.poses));
  }
  return all;
}

std::vector<Answered> everything(AskedJoint& joint, const Asking& asking) {
  Session& session = *joint.session;
  GapsRequest all_of_gaps;
  all_of_gaps.pose = kPose;
  const auto gaps = std::make_shared<const GapsAnswer>(answer(session, all_of_gaps));
  const TouchAnswer touch = answer(session, TouchRequest{kPose});
  Answered limits;
  for (const LimitAnswer& limit : answer(session, LimitsRequest{}).limits) {
    if (limit.centre == name(Surface::ball)) add(limit.told.limit, limits.numbers);
  }
  const auto volume =
      std::make_shared<const VolumeAnswer>(answer(session, VolumeRequest{.width = asking.width}));
  const MeasureAnswer measures = answer(session, MeasureRequest{});
  const bool meet = touch.contact.state == impinge::Contact::yes && touch.contact.by == ContactRule::surfaces;
  return {{{meet ? 1.0 : 0.0}}, {numbers_of(touch.smallest_gap)}, {numbers_of(*gaps), gaps},
          std::move(limits),    {numbers_of(*volume), volume},    {numbers_of(measures)}};
}

}  // namespace impinge::lab
