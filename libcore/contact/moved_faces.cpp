// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/moved_faces.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <span>

#include "mesh/meeting_faces.hpp"
#include "sphere/plane_side.hpp"
#include "sphere/vector_clones.hpp"

namespace impinge {
namespace {

constexpr std::size_t kWidth = FaceRuns::kWidth;
using Lanes = std::array<float, kWidth>;
using WholeLanes = std::array<std::int32_t, kWidth>;

constexpr float kFloatSlack = 2e-6F;    // share of a length, for a point that is rounded to floats and moved
constexpr float kSquareSlack = 1e-5F;   // share of a squared length
constexpr float kGridSlack = 1e-4F;     // in cells of the grid
constexpr float kTiny = 1e-30F;         // mm^2; smaller squares are not precise
constexpr float kLongestChord = 1.04F;  // times a ball's radius over its distance, see least_radii.cpp
constexpr float kChordSlack = 1e-3F;    // in cells of directions
constexpr float kUnknown = 1e6F;        // in cells; wider than cells of any level
constexpr float kFirst = 4096.0F;       // puts runs in a cell of the surface before all others

// A block that waits for its turn in a search.
struct Pending {
  std::size_t level;
  std::size_t block;  // of the level
};
// More blocks than can wait in a depth-first search of 2^32 faces.
constexpr std::size_t kMostPending = kWidth * 11;

// Calls visit(block, lane, faces) for each run of all levels.
template <class Visit>
void for_each_run(const FaceRuns& runs, const Visit& visit) {
  const std::span<const Face> all = runs.faces;
  std::size_t length = 1;
  for (const std::size_t first : runs.first) {
    std::size_t run = first * kWidth;
    for (std::size_t from = 0; from < all.size(); from += length, ++run)
      visit(run / kWidth, run % kWidth, all.subspan(from, std::min(length, all.size() - from)));
    length *= kWidth;
  }
}

Triangle corners(const FaceRuns& runs, const Face& f) {
  return {runs.vertices[f[0]], runs.vertices[f[1]], runs.vertices[f[2]]};
}

// Floats that are surely not above and not below x.
float below(double x) { return static_cast<float>(x - 1e-7 * std::abs(x) - 1e-44); }
float above(double x) { return static_cast<float>(x + 1e-7 * std::abs(x) + 1e-44); }

// A box round a triangle, mm, rounded outwards.
struct FloatBox {
  std::array<float, 3> low;
  std::array<float, 3> high;
};
FloatBox box_of(const Triangle& of) {
  const Vec3 low = of[0].cwiseMin(of[1]).cwiseMin(of[2]);
  const Vec3 high = of[0].cwiseMax(of[1]).cwiseMax(of[2]);
  return {{below(low.x()), below(low.y()), below(low.z())},
          {above(high.x()), above(high.y()), above(high.z())}};
}

// Returns a bit for each lane whose box overlaps this one.
[[gnu::flatten]] IMPINGE_VECTOR_CLONES std::uint32_t overlapping(const FixedFaces::Boxes& boxes,
                                                                 const FloatBox& with) {
  WholeLanes bit;
  for (std::size_t k = 0; k < kWidth; ++k) {
    std::int32_t overlap = 1 << k;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const float low = boxes.low[axis][k];
      const float high = boxes.high[axis][k];
      overlap = low <= with.high[axis] ? overlap : 0;
      overlap = high >= with.low[axis] ? overlap : 0;
    }
    bit[k] = overlap;
  }
  std::int32_t all = 0;
  for (std::size_t k = 0; k < kWidth; ++k) all |= bit[k];
  return static_cast<std::uint32_t>(all);
}

bool on_one_side(const Triangle& plane, const Triangle& of) {
  const int side = plane_side(plane[0], plane[1], plane[2], of[0]);
  return side != 0 && side == plane_side(plane[0], plane[1], plane[2], of[1]) &&
         side == plane_side(plane[0], plane[1], plane[2], of[2]);
}

// As faces_meet(), but its usual answer, no, takes only a few signs.
bool triangles_meet(const Triangle& a, const Triangle& b) {
  return !on_one_side(b, a) && !on_one_side(a, b) && faces_meet(a, b);
}

// A pose and the cells, as floats.
struct FloatPose {
  std::array<std::array<float, 3>, 3> rotation;
  std::array<float, 3> translation;  // mm
  float shift, shift_square;         // mm, mm^2
  std::array<float, 3> origin;       // mm, of the cells
  std::array<float, 3> last;         // cells: the border of the grid
  float per_mm, row, layer;          // cells
  float slack;                       // cells
};

FloatPose in_floats(const Pose& pose, const NearCells& cells) {
  FloatPose floats{};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto axis = static_cast<Eigen::Index>(i);
    for (std::size_t j = 0; j < 3; ++j)
      floats.rotation[i][j] = static_cast<float>(pose.rotation(axis, static_cast<Eigen::Index>(j)));
    floats.translation[i] = static_cast<float>(pose.translation[axis]);
    floats.origin[i] = static_cast<float>(cells.origin[axis]);
    floats.last[i] = std::nextafter(static_cast<float>(cells.cells[i]), 0.0F);
  }
  const double shift = pose.translation.lpNorm<1>();
  floats.shift = static_cast<float>(pose.translation.norm()) * (1.0F + kFloatSlack);
  floats.shift_square = floats.shift * floats.shift;
  floats.per_mm = static_cast<float>(1.0 / cells.size) * (1.0F + kFloatSlack);
  floats.row = static_cast<float>(cells.cells[0]);
  floats.layer = static_cast<float>(cells.cells[0] * cells.cells[1]);
  floats.slack =
      kGridSlack + kFloatSlack * static_cast<float>((shift + cells.origin.lpNorm<1>()) / cells.size);
  return floats;
}

// Balls after the move by a pose, and the cells in which to look them up.
struct MovedBalls {
  Lanes outside;     // cells, square of the distance from the grid
  Lanes reach;       // cells, square of the radius
  Lanes farthest;    // mm^2: no point is farther from the centre
  WholeLanes cell;   // of the grid
  WholeLanes level;  // of the least radii
  WholeLanes about;  // cell of that level
};

inline float within(float x, float most) {
  const float low = x > 0.0F ? x : 0.0F;
  return low < most ? low : most;
}

using FloatPoint = std::array<float, 3>;

inline float dot(const FloatPoint& a, const FloatPoint& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

inline void find_cell(const FloatPoint& middle, float radius, const FloatPose& pose, std::size_t k,
                      MovedBalls& moved) {
  FloatPoint cell;
  float outside = 0.0F;
  for (std::size_t i = 0; i < 3; ++i) {
    const float at = (middle[i] - pose.origin[i]) * pose.per_mm;
    const float inside = within(at, pose.last[i]);
    outside += (at - inside) * (at - inside);
    cell[i] = static_cast<float>(static_cast<std::int32_t>(inside));
  }
  const float reach = radius * pose.per_mm + pose.slack;
  moved.outside[k] = outside;
  moved.reach[k] = reach * std::abs(reach);
  moved.cell[k] = static_cast<std::int32_t>(cell[0] + cell[1] * pose.row + cell[2] * pose.layer);
}

inline void find_direction(const FloatPoint& middle, float radius, std::size_t k, MovedBalls& moved) {
  constexpr float kHalf = 0.5F * LeastRadii::kFinest;
  const float square = dot(middle, middle);
  const float inverse = 1.0F / std::sqrt(square);
  const float asked = radius * inverse * (kLongestChord * kHalf) + kChordSlack;  // cells of the finest level
  const float wide = square > kTiny && asked < kUnknown ? asked : kUnknown;
  const float chord = wide > 1.0F ? wide : 1.0F;
  const std::int32_t octave = ((std::bit_cast<std::int32_t>(chord) + 0x7fffff) >> 23) - 127;  // rounded up
  moved.level[k] = octave < LeastRadii::kLevels ? octave : LeastRadii::kLevels;
  const float half = kHalf * std::bit_cast<float>((127 - moved.level[k]) << 23);  // cells of that level
  FloatPoint cell;
  for (std::size_t i = 0; i < 3; ++i) {
    const float at = within((middle[i] * inverse + 1.0F) * half, 2.0F * half - 1.0F);
    cell[i] = static_cast<float>(static_cast<std::int32_t>(at));
  }
  moved.about[k] = static_cast<std::int32_t>(cell[0] + 2.0F * half * (cell[1] + 2.0F * half * cell[2]));
}

inline void move_ball(const MovedFaces::Balls& balls, const FloatPose& pose, std::size_t k,
                      MovedBalls& moved) {
  const FloatPoint of{balls.x[k], balls.y[k], balls.z[k]};
  const float radius = balls.radius[k];
  const FloatPoint turned{dot(pose.rotation[0], of), dot(pose.rotation[1], of), dot(pose.rotation[2], of)};
  FloatPoint middle;
  for (std::size_t i = 0; i < 3; ++i) middle[i] = turned[i] + pose.translation[i];
  // |R x + t|^2 = |x|^2 + 2 R x . t + |t|^2
  const float along = dot(turned, pose.translation) + radius * pose.shift;
  const float lengths = balls.square[k] + pose.shift_square;
  moved.farthest[k] = lengths * (1.0F + kSquareSlack) + 2.0F * along + kTiny;
  find_cell(middle, radius, pose, k, moved);
  find_direction(middle, radius, k, moved);
}

// Finds a margin for each ball: positive if it is clear of the surface. Among others the least is opened
// first.
[[gnu::flatten]] IMPINGE_VECTOR_CLONES void find_margins(const MovedFaces::Balls& balls,
                                                         const FloatPose& pose, const std::uint8_t* cells,
                                                         const LeastRadii& radii, Lanes& __restrict margin) {
  MovedBalls moved;
  for (std::size_t k = 0; k < kWidth; ++k) move_ball(balls, pose, k, moved);
  Lanes stored;
  Lanes least;
  for (std::size_t k = 0; k < kWidth; ++k) {
    stored[k] = cells[moved.cell[k]];
    const std::int32_t about = moved.level[k] < LeastRadii::kLevels ? moved.about[k] : 0;
    least[k] = radii.square[radii.first[static_cast<std::size_t>(moved.level[k])] +
                            static_cast<std::uint32_t>(about)];
  }
  for (std::size_t k = 0; k < kWidth; ++k) {
    const float square = stored[k] > 1.0F ? stored[k] - 1.0F : 0.0F;
    const float room = square + moved.outside[k] - moved.reach[k] * (1.0F + kSquareSlack);
    const float ranked = stored[k] > 0.0F || room > 0.0F ? room : room - kFirst;
    margin[k] = least[k] > moved.farthest[k] ? 1.0F : ranked;
  }
}

// Lists the lanes that are not clear; the first to be opened comes last.
std::size_t lanes_to_open(const Lanes& margin, std::array<std::size_t, kWidth>& lanes) {
  std::size_t count = 0;
  for (std::size_t k = 0; k < kWidth; ++k) {
    if (margin[k] > 0.0F) continue;
    std::size_t at = count++;
    for (; at > 0 && margin[lanes[at - 1]] < margin[k]; --at) lanes[at] = lanes[at - 1];
    lanes[at] = k;
  }
  return count;
}

}  // namespace

MovedFaces::MovedFaces(const TriangleMesh& mesh) : runs_(mesh), balls_(runs_.blocks) {
  for (Balls& balls : balls_) {
    balls = {};
    balls.radius.fill(-HUGE_VALF);
  }
  for_each_run(runs_, [&](std::size_t block, std::size_t lane, std::span<const Face> faces) {
    Vec3 low = Vec3::Constant(HUGE_VAL);
    Vec3 high = -low;
    double farthest = 0.0;
    const auto each_corner = [&](const auto& visit) {
      for (const Face& face : faces) {
        for (const VertexIndex v : face) visit(runs_.vertices[v]);
      }
    };
    each_corner([&](const Vec3& x) {
      low = low.cwiseMin(x);
      high = high.cwiseMax(x);
      farthest = std::max(farthest, x.squaredNorm());
    });
    const Vec3 middle = (0.5 * (low + high)).cast<float>().cast<double>();
    double square = 0.0;
    each_corner([&](const Vec3& x) { square = std::max(square, (x - middle).squaredNorm()); });
    Balls& balls = balls_[block];
    balls.x[lane] = static_cast<float>(middle.x());
    balls.y[lane] = static_cast<float>(middle.y());
    balls.z[lane] = static_cast<float>(middle.z());
    balls.radius[lane] = above(std::sqrt(square) + kFloatSlack * (middle.lpNorm<1>() + std::sqrt(square)));
    balls.square[lane] = above(farthest * (1.0 + kFloatSlack));
  });
}

FixedFaces::FixedFaces(const TriangleMesh& mesh) : runs_(mesh), boxes_(runs_.blocks) {
  for (Boxes& boxes : boxes_) {
    for (std::size_t k = 0; k < 3; ++k) {
      boxes.low[k].fill(HUGE_VALF);
      boxes.high[k].fill(-HUGE_VALF);
    }
  }
  for (std::size_t run = 0; run < runs_.faces.size(); ++run) {
    const FloatBox box = box_of(corners(runs_, runs_.faces[run]));
    for (std::size_t k = 0; k < 3; ++k) {
      boxes_[run / kWidth].low[k][run % kWidth] = box.low[k];
      boxes_[run / kWidth].high[k][run % kWidth] = box.high[k];
    }
  }
  for (std::size_t level = 1; level < runs_.first.size(); ++level) {
    for (std::size_t block = runs_.first[level - 1]; block < runs_.first[level]; ++block) {
      const std::size_t run = block - runs_.first[level - 1];
      Boxes& boxes = boxes_[runs_.first[level] + run / kWidth];
      for (std::size_t k = 0; k < 3; ++k) {
        boxes.low[k][run % kWidth] = std::ranges::min(boxes_[block].low[k]);
        boxes.high[k][run % kWidth] = std::ranges::max(boxes_[block].high[k]);
      }
    }
  }
  if (runs_.faces.empty()) return;
  cells_.emplace(runs_);
  radii_.emplace(runs_);
}

bool FixedFaces::meet(const Triangle& triangle) const {
  const FloatBox box = box_of(triangle);
  std::array<Pending, kMostPending> pending;
  std::size_t count = 0;
  if (!boxes_.empty()) pending[count++] = {runs_.first.size() - 1, 0};
  while (count > 0) {
    const auto [level, block] = pending[--count];
    for (std::uint32_t lanes = overlapping(boxes_[runs_.first[level] + block], box); lanes != 0;
         lanes &= lanes - 1) {
      const std::size_t run = block * kWidth + static_cast<std::size_t>(std::countr_zero(lanes));
      if (level > 0)
        pending[count++] = {level - 1, run};
      else if (triangles_meet(triangle, corners(runs_, runs_.faces[run])))
        return true;
    }
  }
  return false;
}

bool surfaces_meet(const MovedFaces& moved, const FixedFaces& fixed, const Pose& pose,
                   std::size_t* looked_at) {
  const FaceRuns& runs = moved.runs();
  if (runs.faces.empty() || !fixed.cells() || !fixed.radii()) return false;
  const FloatPose floats = in_floats(pose, *fixed.cells());
  std::array<Pending, kMostPending> pending;
  std::size_t count = 0;
  pending[count++] = {runs.first.size() - 1, 0};
  while (count > 0) {
    const auto [level, block] = pending[--count];
    Lanes margin;
    find_margins(moved.balls()[runs.first[level] + block], floats, fixed.cells()->square.data(),
                 *fixed.radii(), margin);
    std::array<std::size_t, kWidth> lanes;
    for (std::size_t k = 0, open = lanes_to_open(margin, lanes); k < open; ++k) {
      const std::size_t run = block * kWidth + lanes[level > 0 ? k : open - 1 - k];
      if (level > 0) {
        pending[count++] = {level - 1, run};
        continue;
      }
      Triangle face = corners(runs, runs.faces[run]);
      for (Vec3& x : face) x = to_socket(pose, x);
      if (looked_at != nullptr) ++*looked_at;
      if (fixed.meet(face)) return true;
    }
  }
  return false;
}

}  // namespace impinge
