// SPDX-License-Identifier: GPL-3.0-or-later
#include "change/orientation.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "table/face_cap.hpp"

namespace impinge {
namespace {

// A part of a leg that is open in a cell, and where it may touch.
struct OpenPart {
  LegPart part;
  CellHint hint;
};

// The parts of legs that are not free in all orientations of a cell.
struct Left {
  std::vector<OpenPart> open;
  std::optional<std::size_t> unknown;  // a leg with a part that is unknown in all of them
};

class Map {
 public:
  Map(const CellTest& joint, const OrientationQuestion& question)
      : search_(joint),
        asked_(question),
        from_rest_(cup_rotation(question.at_rest, question.side).transpose()),
        tilt_(pelvic_tilt(question.tilt_deg)) {}

  std::vector<OrientationCell> cells() {
    std::vector<OpenPart> legs;
    for (std::size_t leg = 0; leg < asked_.legs.size(); ++leg)
      legs.push_back({{leg, 0.0, asked_.legs[leg].largest_deg}, {}});
    const double half = 0.5 * asked_.width_deg;
    const CupAngles middle{asked_.least.inclination_deg + half, asked_.least.anteversion_deg + half};
    refine({middle, half, CellState::open, {}}, {legs, {}});
    return std::move(found_);
  }

 private:
  // Rotations, relative to the socket at rest, that hold all poses of a part in all orientations of a cell.
  RotationBall rotations(const OrientationCell& cell, const LegPart& part) const {
    const RotationBall poses = poses_of(asked_.legs[part.leg], part);
    const Eigen::Matrix3d turned = tilt_ * cup_rotation(cell.middle, asked_.side) * from_rest_;
    return {turned.transpose() * poses.rotation, poses.radius + spread(cell.half_deg)};
  }

  // theta of the theorem in the header, rounded up: sin^2(theta / 2) = sin^2(h / 2) (2 - sin^2(h / 2)).
  static double spread(double half_deg) {
    const double sine = std::sin(0.5 * half_deg * kDegree);
    return 2.0 * std::asin(std::min(1.0, std::sqrt(sine * sine * (2.0 - sine * sine)))) + kCapSlack;
  }

  // Decides the parts. They are halved until they spread the rotations less than the cell does; what stays
  // open is kept for the cell's quarters.
  Left decide(OrientationCell& cell, Left before) {
    const double narrow_deg = spread(cell.half_deg) / kDegree;
    Left left{{}, before.unknown};
    std::vector<OpenPart>& parts = before.open;
    while (!parts.empty()) {
      const auto [part, hint] = parts.back();
      parts.pop_back();
      const CellVerdict verdict = search_.decide(rotations(cell, part), hint);
      if (verdict.state == CellState::blocked) {
        cell.state = CellState::blocked;
        cell.leg = part.leg;
        return {};
      }
      if (verdict.state == CellState::unknown) left.unknown = part.leg;
      if (verdict.state != CellState::open) continue;
      if (part.to_deg - part.from_deg <= narrow_deg) {
        left.open.push_back({part, verdict.hint});
        continue;
      }
      const double middle = 0.5 * (part.from_deg + part.to_deg);
      parts.push_back({{part.leg, part.from_deg, middle}, verdict.hint});
      parts.push_back({{part.leg, middle, part.to_deg}, verdict.hint});
    }
    cell.state = !left.open.empty() ? CellState::open : left.unknown ? CellState::unknown : CellState::free;
    cell.leg = left.open.empty() ? left.unknown : left.open.front().part.leg;
    return left;
  }

  void refine(OrientationCell cell, const Left& before) {
    const Left left = decide(cell, before);
    if (cell.state != CellState::open || 2.0 * cell.half_deg <= asked_.resolution_deg) {
      found_.push_back(cell);
      return;
    }
    const double half = 0.5 * cell.half_deg;
    for (const double a : {-half, half}) {
      for (const double b : {-half, half}) {
        const CupAngles middle{cell.middle.inclination_deg + a, cell.middle.anteversion_deg + b};
        refine({middle, half, CellState::open, {}}, left);
      }
    }
  }

  CellSearch search_;
  const OrientationQuestion& asked_;
  Eigen::Matrix3d from_rest_;
  Eigen::Matrix3d tilt_;
  std::vector<OrientationCell> found_;
};

}  // namespace

std::vector<OrientationCell> orientation_map(const CellTest& joint, const OrientationQuestion& question) {
  return Map(joint, question).cells();
}

// The turn, degrees. sin^2(t / 2) = sin^2(d / 2) + sin^2(e / 2) - sin^2(d / 2) sin^2(e / 2) keeps its digits
// for small turns. t grows with |d| and |e|, so that the nearest place of a cell has the least of both.
static double turn_of(const CupAngles& change) {
  const double d = std::sin(0.5 * change.inclination_deg * kDegree);
  const double e = std::sin(0.5 * change.anteversion_deg * kDegree);
  return 2.0 * std::asin(std::min(1.0, std::sqrt(d * d + e * e * (1.0 - d * d)))) / kDegree;
}

std::optional<NearestOrientation> nearest_orientation(std::span<const OrientationCell> cells,
                                                      const CupAngles& from,
                                                      std::initializer_list<CellState> states) {
  std::optional<NearestOrientation> nearest;
  for (const OrientationCell& cell : cells) {
    if (std::find(states.begin(), states.end(), cell.state) == states.end()) continue;
    const auto near = [&](double CupAngles::*angle) {
      return std::clamp(from.*angle, cell.middle.*angle - cell.half_deg, cell.middle.*angle + cell.half_deg);
    };
    const CupAngles at{near(&CupAngles::inclination_deg), near(&CupAngles::anteversion_deg)};
    const CupAngles change{at.inclination_deg - from.inclination_deg,
                           at.anteversion_deg - from.anteversion_deg};
    const double turn = turn_of(change);
    if (!nearest || turn < nearest->turn_deg) nearest = NearestOrientation{at, change, turn};
  }
  return nearest;
}

}  // namespace impinge
