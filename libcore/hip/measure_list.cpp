// SPDX-License-Identifier: GPL-3.0-or-later
#include "hip/measure_list.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <stdexcept>
#include <utility>

#include "files/formatted.hpp"
#include "hip/hip_measures.hpp"

namespace impinge {
namespace {

constexpr double kMostAtEnd = 0.1;  // of the rim
constexpr double kNotThere = std::numeric_limits<double>::quiet_NaN();

// The values of one measurement, in the order of the names; NaN where the mesh does not have it.
struct Values {
  std::vector<double> all;
  std::string refused;  // why all of them are refused
  bool at_end = false;  // is the rim the end of the mesh?
};

struct Named {
  std::string name;
  std::string unit;
  std::string missing;  // why it may be missing
};

std::vector<Named> femur_names() {
  const std::string shaft = "the mesh has no straight shaft";
  std::vector<Named> names{{"head_radius", "mm", ""},
                           {"head_neck_offset", "mm", ""},
                           {"neck_shaft_angle", "deg", shaft},
                           {"femoral_torsion", "deg", shaft}};
  const auto add_alpha = [&names](const std::string& time) {
    names.push_back({"alpha_at_" + time, "deg", "the surface does not leave the head there"});
  };
  for (std::size_t hour = 0; hour < kClockHours; ++hour) {
    add_alpha(std::to_string(hour == 0 ? kClockHours : hour));
    if (hour == 1) add_alpha("1_30");
  }
  names.push_back({"alpha_notzli", "deg", "the contour does not leave the head's circle"});
  return names;
}

std::vector<Named> socket_names() {
  return {{"socket_radius", "mm", ""},
          {"inclination", "deg", ""},
          {"version", "deg", ""},
          {"half_opening", "deg", ""},
          {"lateral_centre_edge", "deg", "the rim does not cross the coronal plane through the head"},
          {"coverage", "1", ""}};
}

Values femur_values(const TriangleMesh& ball, Side side, const MeasureChoices& choices) {
  try {
    const FemurMeasures found = measure_femur(ball, side, choices);
    Values values{{found.head.radius, found.head_neck_offset, found.neck_shaft_angle.value_or(kNotThere),
                   found.femoral_torsion.value_or(kNotThere)},
                  "",
                  false};
    for (std::size_t hour = 0; hour < kClockHours; ++hour) {
      values.all.push_back(found.alpha[hour]);
      if (hour == 1) values.all.push_back(found.alpha_at_1_30);
    }
    values.all.push_back(found.alpha_notzli);
    return values;
  } catch (const std::invalid_argument& error) {
    return {{}, error.what(), false};
  }
}

Values socket_values(const TriangleMesh& socket, const SphereFit& head, Side side,
                     const MeasureChoices& choices) {
  try {
    const AcetabulumMeasures found = measure_acetabulum(socket, head, side, choices);
    return {{found.socket.radius, found.inclination, found.version, found.half_opening,
             found.lateral_centre_edge.value_or(kNotThere), found.coverage},
            "",
            found.at_mesh_end > kMostAtEnd};
  } catch (const std::invalid_argument& error) {
    return {{}, error.what(), false};
  }
}

// A choice, with a value to either side of the usual one.
struct Varied {
  double MeasureChoices::*choice;
  double low;
  double high;
  const char* words;
};
constexpr double kLeastShare = 0.005;
constexpr const char* kSphere = "which points make the sphere";

// Where the head ends is varied by how far the head itself is off its sphere.
std::array<Varied, 5> of_femur(const SphereFit& head) {
  const double off = std::max(kLeastShare, 2.0 * head.rms / head.radius);
  return {Varied{&MeasureChoices::trim, 0.04, 0.08, kSphere},
          Varied{&MeasureChoices::neck_section, 1.3, 1.4, "where the neck is cut"},
          Varied{&MeasureChoices::alpha_share, std::max(kLeastShare, kAlphaShare - off), kAlphaShare + off,
                 "how far off its sphere the head ends"},
          Varied{&MeasureChoices::alpha_window, 0.15, 0.45, "how wide about the position"},
          Varied{&MeasureChoices::shaft_share, 0.25, 0.45, "how much is taken for shaft"}};
}
constexpr std::array kOfSocket{
    Varied{&MeasureChoices::trim, 0.04, 0.08, kSphere},
    Varied{&MeasureChoices::rim_band, 0.1, 0.2, "how far off its sphere the rim may be"},
    Varied{&MeasureChoices::first_meridian, 0.33, 0.67, "on which meridians the rim is sought"},
    Varied{&MeasureChoices::plane_tolerance, 0.5, 2.0, "which points of the rim make its plane"}};

double most_of(const std::string& unit) { return unit == "deg" ? 10.0 : unit == "mm" ? 2.0 : 0.1; }

// others: with each choice varied, two of a kind.
Measure judged(const Named& named, double value, const std::vector<double>& others,
               std::span<const Varied> choices) {
  if (std::isnan(value))
    return {named.name, std::nullopt, std::nullopt, named.unit, "refused: " + named.missing};
  double moved = 0.0;
  double most = value;
  const char* by = "";
  for (std::size_t k = 0; k < others.size(); ++k) {
    if (std::isnan(others[k]))
      return {named.name, std::nullopt, std::nullopt, named.unit,
              std::string("refused: found or not, depending on ") + choices[k / 2].words};
    if (std::abs(others[k] - value) <= moved) continue;
    moved = std::abs(others[k] - value);
    most = others[k];
    by = choices[k / 2].words;
  }
  if (moved > most_of(named.unit)) {
    const auto [low, high] = std::minmax(value, most);
    return {named.name, std::nullopt, moved, named.unit,
            "refused: " + formatted("%.3g to %.3g ", low, high) + named.unit + ", depending on " + by};
  }
  return {named.name, value, moved, named.unit, "measured"};
}

// Measures one surface with the usual choices and with each choice varied.
template <class Ask>
void add_measures(const std::vector<Named>& names, std::span<const Varied> choices, const Ask& ask,
                  std::vector<Measure>& measures) {
  const Values usual = ask(MeasureChoices{});
  std::vector<Values> others;
  if (usual.refused.empty()) {
    for (const Varied& varied : choices) {
      for (const double value : {varied.low, varied.high}) {
        MeasureChoices otherwise;
        otherwise.*varied.choice = value;
        others.push_back(ask(otherwise));
      }
    }
  }
  for (std::size_t k = 0; k < names.size(); ++k) {
    if (!usual.refused.empty()) {
      measures.push_back(
          {names[k].name, std::nullopt, std::nullopt, names[k].unit, "refused: " + usual.refused});
      continue;
    }
    std::vector<double> other;
    other.reserve(others.size());
    for (const Values& values : others) other.push_back(values.refused.empty() ? values.all[k] : kNotThere);
    measures.push_back(judged(names[k], usual.all[k], other, choices));
    Measure& last = measures.back();
    if (usual.at_end && last.value && last.name != "socket_radius")
      last.state = "measured to the end of the mesh";
  }
}

}  // namespace

SphereFit head_or_centre(const TriangleMesh& ball) {
  SphereFit head;
  try {
    head = fit_ball(ball);
  } catch (const std::invalid_argument&) {
    head.radius = ball.vertices.front().norm();
  }
  return head;
}

std::vector<Measure> measure_socket(const TriangleMesh& socket, const SphereFit& head, Side side) {
  std::vector<Measure> measures;
  add_measures(
      socket_names(), kOfSocket,
      [&](const MeasureChoices& choices) { return socket_values(socket, head, side, choices); }, measures);
  return measures;
}

std::vector<Measure> measure_hip(const BallSocketPair& joint, Side side) {
  const SphereFit head = head_or_centre(joint.ball);
  std::vector<Measure> measures;
  add_measures(
      femur_names(), of_femur(head),
      [&](const MeasureChoices& choices) { return femur_values(joint.ball, side, choices); }, measures);
  for (Measure& measure : measure_socket(joint.socket, head, side)) measures.push_back(std::move(measure));
  return measures;
}

TrustedOpening trusted_opening(const BallSocketPair& joint, Side side) {
  const SphereFit head = head_or_centre(joint.ball);
  TrustedOpening found;
  for (const Measure& measure : measure_socket(joint.socket, head, side)) {
    if (measure.name != "inclination" && measure.name != "version") continue;
    if (!measure.value) throw std::runtime_error(measure.name + " is " + measure.state);
    found.state = measure.state;
  }
  found.angles = cup_angles(measure_acetabulum(joint.socket, head, side).opening, side);
  return found;
}

}  // namespace impinge
