// SPDX-License-Identifier: GPL-3.0-or-later
#include "rotations/play.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "files/formatted.hpp"
#include "mesh/triangle_distance.hpp"

namespace impinge {
namespace {

constexpr double kShiftRounding = 1e-12;  // relative
constexpr double kAway = -0.5;  // a shift with less than this along a contact's direction leads away from it
constexpr double kWiderAway = 4.0;  // such shifts are tried in cells so many times wider
constexpr std::uint32_t kAllShut = (1U << (kShiftBalls - 1)) - 1;

double nearest_to_origin(const TriangleMesh& mesh) {
  double least = HUGE_VAL;
  for (const Face& face : mesh.faces)
    least = std::min(least, nearest_point(Vec3::Zero(), corners_of(mesh, face)).norm());
  return least;
}

}  // namespace

ShiftBall shift_ball(std::size_t place) {
  if (place == 0) return {};
  const std::array<std::size_t, 3> third{(place - 1) % 3, (place - 1) / 3 % 3, (place - 1) / 9};
  Vec3 sign;
  Vec3 low;  // the near corner of the box about the shifts, signs apart
  for (Eigen::Index k = 0; k < 3; ++k) {
    sign[k] = static_cast<double>(third[static_cast<std::size_t>(k)]) - 1.0;
    low[k] = sign[k] == 0.0 ? 0.0 : 1.0 / 3.0;
  }
  ShiftBall ball;
  Vec3 reach;  // half of the box's sides
  for (Eigen::Index k = 0; k < 3; ++k) {
    const double high = std::sqrt(1.0 - low.squaredNorm() + low[k] * low[k]);
    ball.middle[k] = sign[k] * 0.5 * (low[k] + high);
    reach[k] = sign[k] == 0.0 ? 1.0 / 3.0 : 0.5 * (high - low[k]);
  }
  const double length = ball.middle.norm();
  const double within = std::min(1.0, (1.0 - kShiftRounding) / std::max(length, 1e-300));
  reach += (1.0 - within) * ball.middle.cwiseAbs();
  ball.middle *= within;
  ball.radius = reach.norm() * (1.0 + kShiftRounding);
  return ball;
}

PlayTests::PlayTests(BallSocketPair joint, const CellQuestion& question, BoneParts beside)
    : joint_(std::move(joint)),
      question_(question),
      beside_(std::move(beside)),
      made_(std::make_unique<std::array<Made, kShiftBalls>>()) {
  const double nearest = std::min(nearest_to_origin(joint_.socket),
                                  beside_.whole_socket ? nearest_to_origin(*beside_.whole_socket) : HUGE_VAL);
  if (question_.play_mm > 0.0 && !(question_.play_mm < nearest))
    throw std::invalid_argument(
        "motion volume: the play must be less than " +
        formatted("%.3g mm, which the socket is from the centre: beyond it the ball is out of it", nearest));
}

const CellTest& PlayTests::test(std::size_t place) const {
  if (still_ != nullptr) return *still_;
  Made& made = (*made_)[place];
  std::call_once(made.once, [&] {
    const Vec3 by = shift(place);
    BoneParts beside = beside_;
    for (TriangleMesh& part : beside.socket) part = relative_to(std::move(part), by);
    if (beside.whole_socket) beside.whole_socket = relative_to(std::move(*beside.whole_socket), by);
    made.test.emplace(BallSocketPair{joint_.ball, relative_to(joint_.socket, by)}, question_, beside,
                      place > 0 ? &test(0) : nullptr);
  });
  return *made.test;
}

PlaySearch::Searches& PlaySearch::at(std::size_t place) {
  if (!made_[place]) {
    const CellTest& test = tests_.test(place);
    const double within = tests_.play_mm() * shift_ball(place).radius;
    made_[place] = std::make_unique<Searches>(Searches{CellSearch(test), CellSearch(test, within)});
  }
  return *made_[place];
}

CellVerdict PlaySearch::decide(const RotationCell& cell, const CellHint& from) {
  CellVerdict verdict = at(0).still.decide(cell, from);
  if (tests_.play_mm() == 0.0) return verdict;
  verdict.hint.place = 0;
  verdict.hint.shut = from.shut;
  if (verdict.state == CellState::free || verdict.state == CellState::unknown) return verdict;
  const auto is_shut = [&](std::size_t place, const CellVerdict& still) {
    return still.state == CellState::blocked &&
           at(place).shifted.decide(cell, still.hint).state == CellState::blocked;
  };
  if (is_shut(0, verdict)) return verdict;
  verdict.state = CellState::open;
  const SeenSurface& socket = tests_.test(0).surface(Surface::socket);
  const double way = angular_radius(cell) * socket.least_radius();
  const Vec3 contact = verdict.hint.socket_face == CellHint::kNone
                           ? Vec3::Zero()
                           : socket.faces()[verdict.hint.socket_face].cap.axis;
  for (std::size_t place = 1; place < kShiftBalls; ++place) {
    const std::uint32_t bit = 1U << (place - 1);
    const ShiftBall ball = shift_ball(place);
    const double wide = tests_.play_mm() * ball.radius;
    const bool away = ball.middle.dot(contact) < kAway && way <= kWiderAway * wide;
    if ((verdict.hint.shut & bit) != 0 || (way > wide && !away)) continue;
    const CellVerdict found = at(place).still.decide(cell);
    if (found.state == CellState::free || found.state == CellState::unknown) {
      verdict.state = found.state;
      verdict.hint.place = static_cast<std::uint8_t>(place);
      return verdict;
    }
    if (way <= wide && is_shut(place, found)) verdict.hint.shut |= bit;
  }
  if (verdict.hint.shut == kAllShut) verdict.state = CellState::blocked;
  return verdict;
}

CellPart PlaySearch::part_of(const RotationCell& cell, const CellHint& hint) {
  return tests_.play_mm() > 0.0 ? CellPart{} : at(0).still.part_of(cell, hint);
}

}  // namespace impinge
