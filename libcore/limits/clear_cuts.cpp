// SPDX-License-Identifier: GPL-3.0-or-later
#include "limits/clear_cuts.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <utility>

#include "limits/cut_choice.hpp"

namespace impinge {
namespace {

constexpr double kTurnScale = 1 << 30;  // length of half angles
constexpr double kWidestArc = 120.0;    // degrees
constexpr double kNarrowestArc = 1e-3;  // degrees
constexpr double kGoodCut = 0.75;       // a cut that leaves a larger share of the pairs: the arc is halved
constexpr std::size_t kMostCuts = 100'000;  // a longer proof is not worth checking
constexpr double kFewPairs = 256;           // up to so many pairs, each is tested for a crossing

// Makes the tree depth first, first children first.
class Divider {
 public:
  Divider(const UncertainMesh& ball, const UncertainMesh& socket, const CutMotion& motion)
      : ball_(ball), motion_(motion), axis_(motion.outer * motion.axis), socket_(socket_faces(socket)) {}

  CutAnswer answer() {
    std::vector<std::uint32_t> all(ball_.mesh.faces.size());
    std::iota(all.begin(), all.end(), 0U);
    add_arc({{1, 0}, motion_.last}, {all, socket_.face});
    while (!pending_.empty() && !found_.crossing && !found_.open) {
      const Node node = std::move(pending_.back());
      pending_.pop_back();
      divide(node);
    }
    if (found_.crossing || found_.open) found_.cuts.clear();
    return std::move(found_);
  }

 private:
  struct Node {
    CutArc arc;
    std::shared_ptr<const CutFaces> ball;  // faces of the ball during the arc
    CutNode faces;                         // indices into these, and into the socket's
  };

  // Indices, in the mesh, of the node's faces of the ball.
  void add_arc(const CutArc& arc, CutNode faces) {
    auto ball = std::make_shared<const CutFaces>(ball_faces(ball_, faces.ball, motion_, arc));
    std::iota(faces.ball.begin(), faces.ball.end(), 0U);
    pending_.push_back({arc, std::move(ball), std::move(faces)});
  }

  void divide(const Node& node) {
    const auto& [arc, ball, faces] = node;
    if (faces.proven()) return found_.cuts.push_back({});
    if (arc.degrees() > kWidestArc) return halve(node);
    if (!arc.moves() && faces.pairs() <= kFewPairs && crosses(node)) return;
    CutChoice choice = choose_cut(*ball, socket_, faces, axis_);
    const auto helps = [&] {
      return std::max(choice.first.pairs(), choice.second.pairs()) < node.faces.pairs();
    };
    if (choice.pairs() > kGoodCut * faces.pairs()) {
      if (arc.degrees() > kNarrowestArc) return halve(node);
      if (!helps()) choice = cut_between_first(*ball, socket_, faces);
    }
    if (helps() && found_.cuts.size() < kMostCuts) {
      found_.cuts.push_back(choice.cut);
      pending_.push_back({arc, ball, std::move(choice.second)});
      pending_.push_back({arc, ball, std::move(choice.first)});
    } else if (arc.moves() || !crosses(node)) {
      found_.open = {ball->of(faces.ball.front()).front(), degrees_of(arc.from)};
    }
  }

  void halve(const Node& node) {
    const auto& [from, to] = node.arc;
    const HalfAngle middle = half_angle(0.5 * (degrees_of(from) + degrees_of(to)));
    found_.cuts.push_back({ClearCut::Kind::turn, {middle[0], middle[1], 0}, 0});
    CutNode faces = node.faces;
    for (std::uint32_t& k : faces.ball) k = node.ball->face[k];
    add_arc({middle, to}, faces);
    add_arc({from, middle}, std::move(faces));
  }

  bool crosses(const Node& node) {
    for (const std::uint32_t k : node.faces.ball) {
      for (const std::uint32_t j : node.faces.socket) {
        if (!certainly_cross(node.ball->of(k), socket_.of(j), node.ball->off + socket_.off)) continue;
        found_.crossing = {node.ball->face[k], j};
        return true;
      }
    }
    return false;
  }

  const UncertainMesh& ball_;
  const CutMotion& motion_;
  Vec3 axis_;
  CutFaces socket_;
  std::vector<Node> pending_;
  CutAnswer found_;
};

}  // namespace

HalfAngle half_angle(double degrees) {
  if (degrees == 0.0) return {1, 0};
  const double half = 0.5 * degrees * kDegree;
  return {std::llround(kTurnScale * std::cos(half)), std::llround(kTurnScale * std::sin(half))};
}

double degrees_of(const HalfAngle& half) {
  return 2.0 * std::atan2(static_cast<double>(half[1]), static_cast<double>(half[0])) / kDegree;
}

CutAnswer clear_cuts(const UncertainMesh& ball, const UncertainMesh& socket, const CutMotion& motion) {
  return Divider(ball, socket, motion).answer();
}

}  // namespace impinge
