// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/least_radii.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include <Eigen/Geometry>

#include "contact/triangle_halves.hpp"

namespace impinge {
namespace {

constexpr auto kCells = LeastRadii::kFinest;
// The width of a piece is the radius of a ball round it over its distance.
constexpr double kNarrow = 2.0 / kCells;                    // a piece of this width is not cut
constexpr double kWide = 0.125;                             // a wider one counts in all directions
constexpr int kMostCuts = 16;                               // of a triangle, one after the other
constexpr std::size_t kCutsOfMesh = std::size_t{1} << 17U;  // most cuts of all triangles
constexpr std::size_t kCutsOfFace = 2;
// Longest chord from the direction of a ball's middle to the direction of a point in it, over the width of
// the ball: 2 sin(a / 2) / sin(a) = 1 / cos(a / 2), which is this for a = 30 degrees.
constexpr double kLongestChord = 1.04;
constexpr double kDirectionSlack = 1e-5;
constexpr double kSliver = 1e-12;      // square of the sine of an angle
constexpr double kLengthSlack = 1e-6;  // share of lengths, more than the rounding of floats

// Lower bound on the distance of the piece from the centre, mm. A sliver's plane is too uncertain to use.
double least_radius(const Triangle& piece, double distance, double radius) {
  const Vec3 ab = piece[1] - piece[0];
  const Vec3 ac = piece[2] - piece[0];
  const bool sliver = ab.cross(ac).squaredNorm() <= kSliver * ab.squaredNorm() * ac.squaredNorm();
  const double least =
      sliver ? distance - radius
             : std::sqrt(squared_distance_to_triangle(Vec3::Zero(), piece[0], piece[1], piece[2]));
  return std::max(0.0, least - kLengthSlack * (distance + radius));
}

// Marks the cells of triangles, cut into pieces that are narrow as the centre sees them.
class LeastMarks {
 public:
  LeastMarks(LeastRadii& radii, std::size_t cuts) : radii_(radii), cuts_left_(cuts) {}

  void mark(const Triangle& piece, int cuts = 0) {
    const Vec3 middle = (piece[0] + piece[1] + piece[2]) / 3.0;
    const double distance = middle.norm();
    const double radius =
        std::max({(piece[0] - middle).norm(), (piece[1] - middle).norm(), (piece[2] - middle).norm()});
    if (!(radius <= kNarrow * distance) && cuts < kMostCuts && cuts_left_ > 0) {
      --cuts_left_;
      for (const Triangle& half : halves(piece)) mark(half, cuts + 1);
      return;
    }
    const double least = least_radius(piece, distance, radius);
    const auto square = static_cast<float>(least * least * (1.0 - kLengthSlack));
    if (radius <= kWide * distance)
      mark_about(middle / distance, kLongestChord * radius / distance + kDirectionSlack, square);
    else
      everywhere_ = std::min(everywhere_, square);
  }
  void finish() {
    for (float& square : radii_.square) square = std::min(square, everywhere_);
  }

 private:
  void mark_about(const Vec3& direction, double chord, float square) {
    const auto cell = [](double x) {
      const double at = (x + 1.0) * (0.5 * kCells);
      return static_cast<std::int32_t>(std::clamp(at, 0.0, kCells - 1.0));
    };
    const Vec3 low = direction - Vec3::Constant(chord);
    const Vec3 high = direction + Vec3::Constant(chord);
    for (std::int32_t z = cell(low.z()); z <= cell(high.z()); ++z) {
      for (std::int32_t y = cell(low.y()); y <= cell(high.y()); ++y) {
        for (std::int32_t x = cell(low.x()); x <= cell(high.x()); ++x) {
          const std::int32_t place = (z * kCells + y) * kCells + x;
          float& least = radii_.square[static_cast<std::size_t>(place)];
          least = std::min(least, square);
        }
      }
    }
  }

  LeastRadii& radii_;
  std::size_t cuts_left_;
  float everywhere_ = HUGE_VALF;
};

// Makes each cell of a level with `cells` along an axis the least of eight cells of the finer level.
void halve(const float* finer, float* level, std::size_t cells) {
  const std::size_t twice = 2 * cells;
  for (std::size_t at = 0; at < twice * twice * twice; ++at) {
    const std::size_t row = at / twice;
    float& least = level[(row / twice / 2 * cells + row % twice / 2) * cells + at % twice / 2];
    least = std::min(least, finer[at]);
  }
}

// Makes each cell the least of itself and its neighbours along an axis, `stride` apart. At the borders of the
// cube cells of the other side count too, which only makes the bound lower.
void spread(std::span<float> level, std::size_t stride, std::vector<float>& scratch) {
  scratch.assign(level.begin(), level.end());
  float* __restrict least = level.data();
  const float* __restrict of = scratch.data();
  for (std::size_t at = stride; at < level.size(); ++at) least[at] = std::min(least[at], of[at - stride]);
  for (std::size_t at = stride; at < level.size(); ++at)
    least[at - stride] = std::min(least[at - stride], of[at]);
}

}  // namespace

LeastRadii::LeastRadii(const FaceRuns& surface) {
  const auto cells = [](std::size_t level) { return static_cast<std::size_t>(kFinest) >> level; };
  const auto cube = [&](std::size_t level) { return cells(level) * cells(level) * cells(level); };
  for (std::size_t level = 0; level < kLevels; ++level)
    first[level + 1] = first[level] + static_cast<std::uint32_t>(cube(level));
  square.assign(first.back() + 1, HUGE_VALF);
  LeastMarks marks(*this, kCutsOfMesh + kCutsOfFace * surface.faces.size());
  for (const Face& f : surface.faces)
    marks.mark({surface.vertices[f[0]], surface.vertices[f[1]], surface.vertices[f[2]]});
  marks.finish();
  for (std::size_t level = 1; level < kLevels; ++level)
    halve(square.data() + first[level - 1], square.data() + first[level], cells(level));
  square.back() = 0.0F;
  std::vector<float> scratch;
  for (std::size_t level = 0; level < kLevels; ++level) {
    const std::span<float> all(square.data() + first[level], cube(level));
    for (const std::size_t stride : {std::size_t{1}, cells(level), cells(level) * cells(level)})
      spread(all, stride, scratch);
  }
}

}  // namespace impinge
