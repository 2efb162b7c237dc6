// SPDX-License-Identifier: GPL-3.0-or-later
// @can     turns
// @links   limits
//
// Our methods. turn_contact is the closed form alone (limits/turn_contact.hpp), which counts as touching what
// is within 2e-12 of the radius, or so near that its steps give out. turn_limit also tests exactly what it
// finds (limits/turn_limit.hpp); its answer is the upper end of its bracket.

#include <memory>

#include "contact/moved_faces.hpp"
#include "limits/turn_limit.hpp"
#include "mesh/meeting_faces.hpp"
#include "methods/turns.hpp"

namespace impinge::lab {
namespace {

using enum TurnQuery::Kind;

// A point has a corner, an edge has a side, and a face that meets a point needs neither.
TurnBody body_of(const TurnQuery& query, const TriangleMesh& of) {
  if (query.kind == mesh || query.kind == face_face) return TurnBody(of);
  const auto [a, b, c] = corners_of(of, of.faces.front());
  const bool point = a == b;
  TurnBody body;
  body.faces = SweptParts({point ? turn_point(a) : turn_face(a, b, c)});
  body.first_corner = {{point, false, false}};
  body.first_side = {{query.kind == edge_edge, false, false}};
  return body;
}

bool meet_at_start(const TurnQuery& query) {
  if (query.kind == face_face)
    return faces_meet(corners_of(query.turning, query.turning.faces.front()),
                      corners_of(query.resting, query.resting.faces.front()));
  return query.kind == mesh && surfaces_meet(MovedFaces(query.turning), FixedFaces(query.resting), Pose{});
}

struct Bodies {
  TurnBody turning;
  TurnBody resting;
  bool meet;
};

FindTurn closed_form(const TurnQuery& query) {
  const auto bodies = std::make_shared<const Bodies>(
      Bodies{body_of(query, query.turning), body_of(query, query.resting), meet_at_start(query)});
  return [&query, bodies]() -> TurnAnswer {
    if (bodies->meet) return {0.0};
    JointTurn turn;
    turn.axis = query.axis;
    const auto contact = first_contact({bodies->turning, bodies->resting, turn}, {0.0, query.largest});
    return {contact ? std::optional(contact->angle) : std::nullopt};
  };
}

FindTurn bracket(const TurnQuery& query) {
  const auto limits = std::make_shared<const TurnLimits>(BallSocketPair{query.turning, query.resting});
  return [&query, limits]() -> TurnAnswer {
    JointTurn turn;
    turn.axis = query.axis;
    const TurnLimit limit = limits->first_contact(turn, query.largest / kDegree);
    if (limit.state == LimitState::free) return {};
    const bool unknown = limit.state == LimitState::unknown;
    return {(unknown ? limit.low_deg : limit.high_deg) * kDegree, !unknown};
  };
}

}  // namespace

Method turn_search_method() {
  Method method;
  method.turns = [] {
    TurnCase form{{"turn_contact", "ours, closed form", "", 0}, {vertex_face, edge_edge, face_face, mesh}};
    form.make = closed_form;
    TurnCase limit{{"turn_limit", "ours, bracket", "", 1}, {mesh}};
    limit.make = bracket;
    return std::vector{form, limit};
  };
  return method;
}

}  // namespace impinge::lab
