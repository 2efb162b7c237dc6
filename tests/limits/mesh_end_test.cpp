// SPDX-License-Identifier: GPL-3.0-or-later
// Patches between two meridians and two arcs of great circles over them turn past directions: where the
// cover of a direction ends is known in closed form.
#include "limits/mesh_end.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "support/dice.hpp"
#include "support/random_cases.hpp"

namespace impinge {
namespace {

using test::Dice;

constexpr std::size_t kPoints = 4;
constexpr double kFarthestEnd = 2.5;  // radians: no patch comes round again before

// Corners at latitudes +-height and at azimuths width before and behind its middle, radians.
struct Patch {
  double middle;
  double width;
  double height;

  double slope() const { return std::tan(height) / std::cos(width); }  // tan of the latitude amid the arcs
  // Angles at which it covers a direction; none if they end before they begin.
  AngleSpan over(double azimuth, double latitude) const {
    const double share = std::tan(std::abs(latitude)) / slope();
    const double half = std::abs(latitude) <= height ? width : share <= 1.0 ? std::acos(share) : -1.0;
    return {azimuth - middle - half, azimuth - middle + half};
  }
};

Vec3 direction(double azimuth, double latitude) {
  return turned(Vec3(std::cos(latitude), 0, std::sin(latitude)), azimuth);
}

// Borders may be at any radius.
void add_border(const Patch& patch, Dice& random, MeshEnd& end) {
  const auto first = static_cast<VertexIndex>(end.ball.size());
  for (const auto& [x, y] : {std::array{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
    end.ball.emplace_back(random.between(10.0, 30.0) *
                          direction(patch.middle + x * patch.width, y * patch.height));
  for (VertexIndex k = 0; k < 4; ++k) end.border.push_back({first + k, first + (k + 1) % 4});
}

// One patch, or two, which may overlap: a border of one is then covered by the other.
struct EndCase {
  MeshEnd end;
  std::vector<std::vector<AngleSpan>> covered;  // of each point, by each patch
};

EndCase random_end(Dice& random) {
  EndCase made;
  std::vector<Patch> patches(random.between(0.0, 1.0) < 0.5 ? 1 : 2);
  for (Patch& patch : patches) {
    patch = {random.between(-1.0, 1.0), random.between(0.1, 1.3), random.between(0.1, 1.0)};
    add_border(patch, random, made.end);
  }
  for (std::size_t k = 0; k < kPoints; ++k) {
    const double azimuth = random.between(-1.0, 1.0);
    const double latitude = random.between(-0.999, 0.999) * std::atan(patches[0].slope());
    made.end.socket.emplace_back(random.between(20.0, 40.0) * direction(azimuth, latitude));
    auto& spans = made.covered.emplace_back();
    for (const Patch& patch : patches) spans.push_back(patch.over(azimuth, latitude));
  }
  return made;
}

// The end of the cover over an angle, by one patch after the other; nothing where there is none.
std::optional<double> end_of_cover(const std::vector<AngleSpan>& spans, double angle) {
  for (const AngleSpan& span : spans) {
    if (span.from <= angle && angle < span.to) return end_of_cover(spans, span.to).value_or(span.to);
  }
  return std::nullopt;
}

std::optional<double> known_end(const EndCase& given, double largest) {
  std::optional<double> first;
  for (const auto& spans : given.covered) {
    const std::optional<double> end = end_of_cover(spans, 0.0);
    if (end && *end <= first.value_or(largest)) first = end;
  }
  return first;
}

TEST(MeshEnd, IsWhereTheCoverOfADirectionEnds) {
  Dice random(23);
  std::size_t ended = 0;
  const std::size_t cases = random_cases();
  for (std::size_t k = 0; k < cases && !HasFailure(); ++k) {
    EndCase given = random_end(random);
    given.end.covered = [&](std::size_t point, double angle) {
      return end_of_cover(given.covered[point], angle).has_value();
    };
    const double largest = random.between(0.0, kFarthestEnd);
    const std::optional<double> known = known_end(given, largest);
    const std::optional<double> found = first_beyond(given.end, largest);
    ASSERT_EQ(found.has_value(), known.has_value()) << k;
    if (!known) continue;
    ASSERT_NEAR(*found, *known, 1e-9) << k;
    ++ended;
  }
  EXPECT_GT(ended, cases / 4);
  EXPECT_LT(ended, cases * 3 / 4);
}

}  // namespace
}  // namespace impinge
