// SPDX-License-Identifier: GPL-3.0-or-later
// Equal-area conchoid spiral: entries uniform on the surface of the rotational conchoid r = a + b cos(phi),
// the hip's shape by Menschik (thesis, Section 5.1, Eq. 11), seen from the conchoid's origin.
//
// The thesis' weighting (Eq. 16) makes the segments of each meridian equal and leaves the rings of entries
// crowded at the pole. Here every entry stands for the same area of the surface, and neighbours are h apart
// along a turn and across turns: see ConchoidSteps, where the closed forms are derived.
//
// In directions the spacing is h / sqrt(a^2 + b^2 + 2 a b cos(phi)) across turns and h / r along them, so
// that entries are dense round the north pole, the axis of the hip, and sparse round the south pole, which
// the hip does not have: with Menschik's shape 14 times as far apart. The covering radius is the gap at the
// south pole.
#pragma once

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string_view>

#include "sphere/conchoid_shape.hpp"
#include "sphere/conchoid_steps.hpp"
#include "sphere/scheme.hpp"
#include "sphere/spiral.hpp"

namespace impinge {

class Conchoid : public Spiral<ConchoidSteps> {
 public:
  static constexpr std::string_view name = "conchoid";
  static constexpr std::string_view label = "Conchoid spiral, equal area";
  static constexpr std::string_view citation =
      "own, on the conchoid of the thesis, Section 5.1, Eq. 11, and of Menschik 1997";

  Conchoid() : Conchoid({}, 60000) {}

  /// Menschik's shape with entries `degrees` apart along the turn at phi = 90 degrees. Throws
  /// std::invalid_argument above 90 and below 2.5e-4 degrees.
  static Conchoid with_precision(double degrees);

  /// Any shape with 0 <= b < a (lengths in mm). Throws std::invalid_argument for other shapes, for fewer
  /// entries than two turns have, and for more than 1e12.
  static Conchoid with_shape(const ConchoidShape& shape, std::size_t entries);

  const ConchoidShape& shape() const { return shape_; }  // on whose surface the entries are uniform
  /// h, the distance of turns, and of entries along them, on the surface, mm.
  double spacing() const { return placement().spacing() * shape_.a; }

  /// Entries of the turn round the equator: 2 pi over the spacing there, where r = a.
  std::size_t equator_points() const {
    return static_cast<std::size_t>(std::round(2.0 * kPi / placement().spacing()));
  }
  double precision_deg() const { return placement().spacing() / kDegree; }

  friend bool operator==(const Conchoid&, const Conchoid&) = default;

 private:
  static constexpr double kMostEntries =
      1e12;  // beyond them angles have too few digits to tell entries apart

  Conchoid(const ConchoidShape& shape, std::size_t entries)
      : Spiral(ConchoidSteps(shape, entries)), shape_(shape) {}

  ConchoidShape shape_;
};

inline Conchoid Conchoid::with_shape(const ConchoidShape& shape, std::size_t entries) {
  if (!(shape.a > 0.0 && shape.b >= 0.0 && std::isfinite(shape.a) && std::isfinite(shape.b)))
    throw std::invalid_argument("a conchoid has a finite a above 0 mm and a finite b of 0 mm or more");
  if (shape.a < shape.b) {
    throw std::invalid_argument(
        "a conchoid with a < b has a loop through its origin, which directions meet twice: take a > b");
  }
  if (!(shape.b / shape.a < 1.0)) {
    throw std::invalid_argument(
        "a conchoid with a = b has a cusp in its origin, where no direction has a radius: take a > b");
  }
  if (static_cast<double>(entries) > kMostEntries)
    throw std::invalid_argument("a conchoid spiral has at most 1e12 entries");
  if (entries < 6 || ConchoidSteps(shape, entries).turns() < 2.0)
    throw std::invalid_argument("a conchoid spiral has 2 turns or more: ask for more entries");
  return {shape, entries};
}

inline Conchoid Conchoid::with_precision(double degrees) {
  if (!(degrees > 0.0 && degrees <= 90.0)) {
    throw std::invalid_argument("a conchoid spiral has a precision above 0 and at most 90 degrees");
  }
  const ConchoidShape shape;
  const double b = shape.b / shape.a;
  const double area = ConchoidCap(Pole::north, b).whole_area() + ConchoidCap(Pole::south, b).whole_area();
  const double spacing = degrees * kDegree;  // in units of a
  const double size = std::round(area / spacing / spacing);
  if (!(size <= kMostEntries)) {
    throw std::invalid_argument("a conchoid spiral has a precision of at least 2.5e-4 degrees");
  }
  return with_shape(shape, static_cast<std::size_t>(size));
}

static_assert(SamplingScheme<Conchoid>);

}  // namespace impinge
