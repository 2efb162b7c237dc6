// SPDX-License-Identifier: GPL-3.0-or-later
// @can     touch contact steps turns
// @links   gap peer::fcl
//
// FCL's trees of boxes on both surfaces, which answer for a whole pose. fcl_obb and fcl_collide use oriented
// boxes: do the surfaces meet? They ask for one contact without its depth, which ends the search. The thesis
// compares with RAPID (Gottschalk, Lin and Manocha 1996), whose licence allows no commercial use. FCL is its
// maintained successor from the same group, with the same tree. fcl_distance gives the smallest distance with
// boxes that have a rectangle swept by a sphere inside, to the last digits (no tolerance).
//
// For turns: fcl_continuous is FCL's conservative advancement on the same trees, along a rotation, to 1e-9 of
// the turn with at most 10,000 advances; points and edges are triangles that repeat corners. fcl_linear is
// FCL's test for cloth, of corners with faces and edges with edges; corners move along chords of one degree.

#include <algorithm>
#include <array>
#include <memory>

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/math/motion/interp_motion.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/continuous_collision.h>
#include <fcl/narrowphase/detail/traversal/collision/intersect.h>
#include <fcl/narrowphase/distance.h>

#include "methods/contact.hpp"
#include "methods/turns.hpp"

namespace impinge::lab {
namespace {

template <class Volume>
void fill(fcl::BVHModel<Volume>& model, const TriangleMesh& mesh) {
  std::vector<fcl::Triangle> triangles;
  triangles.reserve(mesh.faces.size());
  for (const Face& face : mesh.faces) triangles.emplace_back(face[0], face[1], face[2]);
  model.beginModel(static_cast<int>(mesh.faces.size()), static_cast<int>(mesh.vertices.size()));
  model.addSubModel(mesh.vertices, triangles);
  model.endModel();
}

template <class Volume>
struct Trees {
  explicit Trees(const BallSocketPair& pair) {
    fill(ball, pair.ball);
    fill(socket, pair.socket);
  }
  fcl::BVHModel<Volume> ball;
  fcl::BVHModel<Volume> socket;
};

// From the ball's frame to the socket's.
fcl::Transform3<double> placed(const Pose& pose) {
  fcl::Transform3<double> transform = fcl::Transform3<double>::Identity();
  transform.linear() = pose.rotation;
  transform.translation() = pose.translation;
  return transform;
}

Touch fcl_touch(const BallSocketPair& pair) {
  return [trees = std::make_shared<const Trees<fcl::OBB<double>>>(pair)](const Pose& pose) {
    const fcl::CollisionRequest<double> request(1, /*enable_contact_=*/false);
    fcl::CollisionResult<double> result;
    fcl::collide(&trees->ball, placed(pose), &trees->socket, fcl::Transform3<double>::Identity(), request,
                 result);
    return result.isCollision();
  };
}

// mm; 0 where they touch
std::function<double(const Pose&)> smallest_distance(const BallSocketPair& pair) {
  return [trees = std::make_shared<const Trees<fcl::OBBRSS<double>>>(pair)](const Pose& pose) {
    const fcl::DistanceRequest<double> request;
    fcl::DistanceResult<double> result;
    return std::max(fcl::distance(&trees->ball, placed(pose), &trees->socket,
                                  fcl::Transform3<double>::Identity(), request, result),
                    0.0);
  };
}

FindTurn advancing(const TurnQuery& query) {
  using Tree = fcl::BVHModel<fcl::OBBRSS<double>>;
  const auto turning = std::make_shared<Tree>();
  const auto resting = std::make_shared<Tree>();
  fill(*turning, query.turning);
  fill(*resting, query.resting);
  return [&query, turning, resting]() -> TurnAnswer {
    const auto start = fcl::Transform3<double>::Identity();
    const fcl::InterpMotion<double> motion(start, placed(turned_pose(query, query.largest)));
    const fcl::InterpMotion<double> rest(start, start);
    const fcl::ContinuousCollisionRequest<double> request(10'000, 1e-9, fcl::CCDM_LINEAR, fcl::GST_LIBCCD,
                                                          fcl::CCDC_CONSERVATIVE_ADVANCEMENT);
    fcl::ContinuousCollisionResult<double> result;
    fcl::continuousCollide(turning.get(), &motion, resting.get(), &rest, request, result);
    if (!result.is_collide) return {};
    return {result.time_of_contact * query.largest};
  };
}

using Corners = std::array<Vec3, 3>;

// The positions of both features at two times; gives the share of the time at which they first meet, or more
// than 1.
class LinearStep {
 public:
  LinearStep(const Corners& turning, const Corners& turned, const Corners& resting)
      : from_(turning), to_(turned), rest_(resting) {}

  double first(TurnQuery::Kind kind, bool point_turns) {
    using enum TurnQuery::Kind;
    const std::size_t sides = kind == face_face ? 3 : 1;
    const std::size_t points = kind == vertex_face ? 1 : 3;
    for (std::size_t k = 0; k < points && kind != edge_edge; ++k) {
      if (kind == face_face || point_turns) point(from_[k], to_[k], rest_, rest_);
      if (kind == face_face || !point_turns) point(rest_[k], rest_[k], from_, to_);
    }
    for (std::size_t k = 0; k < sides && kind != vertex_face; ++k)
      for (std::size_t l = 0; l < sides; ++l) edges(k, l);
    return first_;
  }

 private:
  using Intersect = fcl::detail::Intersect<double>;
  void point(const Vec3& from, const Vec3& to, const Corners& face, const Corners& moved) {
    note(Intersect::intersect_VF(face[0], face[1], face[2], from, moved[0], moved[1], moved[2], to, &time_,
                                 &place_));
  }
  void edges(std::size_t k, std::size_t l) {
    const std::size_t m = (k + 1) % 3;
    const std::size_t n = (l + 1) % 3;
    note(Intersect::intersect_EE(from_[k], from_[m], rest_[l], rest_[n], to_[k], to_[m], rest_[l], rest_[n],
                                 &time_, &place_));
  }
  void note(bool met) {
    if (met) first_ = std::min(first_, time_);
  }

  const Corners& from_;
  const Corners& to_;
  const Corners& rest_;
  double time_ = 0.0;
  Vec3 place_ = Vec3::Zero();
  double first_ = 2.0;
};

FindTurn along_chords(const TurnQuery& query) {
  constexpr double kStep = kDegree;
  return [&query]() -> TurnAnswer {
    const Corners turning = corners_of(query.turning, query.turning.faces.front());
    const Corners resting = corners_of(query.resting, query.resting.faces.front());
    const auto at = [&](double angle) {
      const Pose pose = turned_pose(query, angle);
      return Corners{to_socket(pose, turning[0]), to_socket(pose, turning[1]), to_socket(pose, turning[2])};
    };
    for (double angle = 0.0; angle < query.largest; angle += kStep) {
      const double next = std::min(angle + kStep, query.largest);
      const double share =
          LinearStep(at(angle), at(next), resting).first(query.kind, turning[0] == turning[1]);
      if (share <= 1.0) return {angle + share * (next - angle)};
    }
    return {};
  };
}

}  // namespace

Method fcl_method() {
  Method method;
  method.touch = [](const BallSocketPair& pair, double /*precision_deg*/) {
    return std::vector{TouchCase{{"fcl_obb", "OBB tree (FCL)", "", 1}, fcl_touch(pair)}};
  };
  method.contact = [](const BallSocketPair& pair) {
    std::vector cases{touch_only("fcl_collide", "FCL, touch", 0, pair, fcl_touch),
                      ContactCase{{"fcl_distance", "FCL, distance", "", 1}}};
    cases[1].measure = Measure::euclidean;
    cases[1].few = true;
    cases[1].make = [&pair] {
      const auto distance = smallest_distance(pair);
      return ContactQuery{[distance](const Pose& pose) { return distance(pose) <= 0.0; }, {}, distance};
    };
    return cases;
  };
  method.steps = [](const BallSocketPair& pair) {
    return std::vector{touch_only("fcl_collide", "FCL", 0, pair, fcl_touch)};
  };
  method.turns = [] {
    using enum TurnQuery::Kind;
    TurnCase advance{{"fcl_continuous", "FCL, conservative advancement", "", 10},
                     {vertex_face, edge_edge, face_face, mesh}};
    advance.make = advancing;
    TurnCase chords{{"fcl_linear", "FCL, along chords of a degree", "", 11},
                    {vertex_face, edge_edge, face_face}};
    chords.make = along_chords;
    return std::vector{advance, chords};
  };
  return method;
}

}  // namespace impinge::lab
