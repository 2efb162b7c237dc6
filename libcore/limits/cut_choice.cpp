// SPDX-License-Identifier: GPL-3.0-or-later
#include "limits/cut_choice.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include <Eigen/Geometry>

#include "sphere/infinity.hpp"

namespace impinge {
namespace {

constexpr auto kUnit = static_cast<double>(kCutUnit);
constexpr std::size_t kSample = 256;    // so many faces of a body choose the direction of a plane
constexpr double kNormalLength = 1024;  // length of a plane's normal in whole numbers
constexpr double kClosePairs = 64;      // up to so many pairs, the nearest one is found

// The range of each face along one direction.
struct CutRanges {
  std::vector<CutRange> ball;
  std::vector<CutRange> socket;
};

// A place for a cut, and how many pairs of faces it leaves.
struct CutScore {
  double pairs = kInfinity;
  double at = 0.0;
};

// Ends of ranges in rising order, and how many of them are at or below the present place.
struct PassedEnds {
  PassedEnds(const std::vector<CutRange>& ranges, double CutRange::*end) {
    for (const CutRange& range : ranges) ends.push_back(range.*end);
    std::ranges::sort(ends);
  }
  double next() const { return passed < ends.size() ? ends[passed] : kInfinity; }
  double part() const { return static_cast<double>(passed); }
  double rest() const { return static_cast<double>(ends.size() - passed); }
  std::vector<double> ends;
  std::size_t passed = 0;
};

// The best of the places midway between neighbouring ends of ranges.
CutScore best_place(const CutRanges& ranges) {
  std::array<PassedEnds, 4> ends{
      PassedEnds{ranges.ball, &CutRange::low}, PassedEnds{ranges.ball, &CutRange::high},
      PassedEnds{ranges.socket, &CutRange::low}, PassedEnds{ranges.socket, &CutRange::high}};
  CutScore best;
  const auto least = [&] {
    return std::min({ends[0].next(), ends[1].next(), ends[2].next(), ends[3].next()});
  };
  double at = least();
  while (at < kInfinity) {
    for (PassedEnds& of : ends) {
      while (of.next() <= at) ++of.passed;
    }
    const double next = least();
    const double pairs = ends[0].part() * ends[2].part() + ends[1].rest() * ends[3].rest();
    if (next < kInfinity && pairs < best.pairs) best = {pairs, 0.5 * (at + next)};
    at = next;
  }
  return best;
}

// At most kSample of the faces, evenly spaced.
std::vector<std::uint32_t> sample(const std::vector<std::uint32_t>& all) {
  if (all.size() <= kSample) return all;
  std::vector<std::uint32_t> some;
  for (std::size_t k = 0; k < kSample; ++k) some.push_back(all[k * all.size() / kSample]);
  return some;
}

std::vector<CutRange> ranges_along(const CutFaces& of, const std::vector<std::uint32_t>& faces,
                                   const Vec3& direction) {
  std::vector<CutRange> ranges;
  ranges.reserve(faces.size());
  const double off = of.off * direction.norm();
  for (const std::uint32_t k : faces) {
    const CutRange range = of.along(k, direction);
    ranges.push_back({range.low - off, range.high + off});
  }
  return ranges;
}

std::vector<CutRange> ranges_out(const CutFaces& of, const std::vector<std::uint32_t>& faces) {
  std::vector<CutRange> ranges;
  ranges.reserve(faces.size());
  for (const std::uint32_t k : faces)
    ranges.push_back({of.radius[k].low - of.off, of.radius[k].high + of.off});
  return ranges;
}

// Sorts the faces to the sides of a cut; a face that reaches both sides goes to both.
void divide(const std::vector<std::uint32_t>& faces, const std::vector<CutRange>& ranges, double at,
            std::vector<std::uint32_t>& first, std::vector<std::uint32_t>& second) {
  for (std::size_t k = 0; k < faces.size(); ++k) {
    if (ranges[k].low <= at) first.push_back(faces[k]);
    if (ranges[k].high >= at) second.push_back(faces[k]);
  }
}

CutChoice cut_at(const CutNode& node, const CutRanges& ranges, ClearCut cut, double rounded) {
  cut.at = static_cast<std::int64_t>(rounded);
  const double at = rounded / kUnit;
  CutChoice choice{cut, {}, {}};
  divide(node.ball, ranges.ball, at, choice.first.ball, choice.second.ball);
  divide(node.socket, ranges.socket, at, choice.first.socket, choice.second.socket);
  return choice;
}

Vec3 mean(const CutFaces& of, const std::vector<std::uint32_t>& faces) {
  Vec3 sum = Vec3::Zero();
  for (const std::uint32_t k : faces) {
    for (const Vec3& x : of.of(k)) sum += x;
  }
  return sum / static_cast<double>(faces.size() * of.each);
}

Vec3 mean_normal(const CutFaces& of, const std::vector<std::uint32_t>& faces) {
  const std::size_t step = of.each / 3;
  Vec3 sum = Vec3::Zero();
  for (const std::uint32_t k : faces) {
    const auto x = of.of(k).subspan(step - 1);
    sum += (x[step] - x[0]).cross(x[2 * step] - x[0]);
  }
  return sum;
}

std::array<Vec3, 3> last_images(const CutFaces& of, std::uint32_t k) {
  const std::size_t step = of.each / 3;
  const auto x = of.of(k);
  return {x[step - 1], x[2 * step - 1], x[3 * step - 1]};
}

// The direction across the gap between the two faces that are nearest to each other, if there are few pairs.
std::optional<Vec3> nearest_across(const CutFaces& ball, const CutFaces& socket, const CutNode& node) {
  if (node.pairs() > kClosePairs) return std::nullopt;
  CutGap least{Vec3::UnitX(), kInfinity};
  for (const std::uint32_t k : node.ball) {
    const auto face = last_images(ball, k);
    for (const std::uint32_t j : node.socket) {
      const CutGap gap = widest_gap(face, socket.of(j));
      if (gap.mm < least.mm) least = gap;
    }
  }
  return least.direction;
}

std::vector<Vec3> directions_for(const CutFaces& ball, const CutFaces& socket, const CutNode& some,
                                 const Vec3& axis) {
  std::vector<Vec3> directions{axis};
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) directions.emplace_back(x, y, 1);
    directions.emplace_back(x, 1, 0);
  }
  directions.emplace_back(1, 0, 0);
  const Vec3 middle = mean(socket, some.socket);
  directions.push_back(middle);
  directions.emplace_back(middle - mean(ball, some.ball));
  directions.push_back(mean_normal(ball, some.ball));
  directions.push_back(mean_normal(socket, some.socket));
  if (const auto across = nearest_across(ball, socket, some)) directions.push_back(*across);
  return directions;
}

// Tries directions and keeps the best one, with how many pairs it leaves.
struct BestDirection {
  const CutFaces& ball;
  const CutFaces& socket;
  const CutNode& some;
  Vec3 direction = Vec3::UnitX();
  double pairs = kInfinity;

  void offer(const Vec3& wanted) {
    if (!(wanted.squaredNorm() > 1e-200)) return;
    const Vec3 unit = wanted.normalized();
    const CutScore score =
        best_place({ranges_along(ball, some.ball, unit), ranges_along(socket, some.socket, unit)});
    if (score.pairs >= pairs) return;
    pairs = score.pairs;
    direction = unit;
  }
  // Tries the best direction turned a little towards each of two others, and away from it.
  void improve() {
    for (double by = 0.25; by > 0.01 && pairs > 0.0; by *= 0.5) {
      const Vec3 u = direction.unitOrthogonal();
      const Vec3 v = direction.cross(u);
      const Vec3 from = direction;
      for (const Vec3& way : {u, v, Vec3(-u), Vec3(-v)}) offer(from + by * way);
    }
  }
};

std::array<std::int64_t, 3> whole(const Vec3& direction) {
  std::array<std::int64_t, 3> n{};
  for (std::size_t k = 0; k < 3; ++k)
    n[k] = std::llround(kNormalLength * direction[static_cast<Eigen::Index>(k)]);
  const std::int64_t common = std::gcd(n[0], std::gcd(n[1], n[2]));
  for (std::int64_t& x : n) x /= common;
  return n;
}

// A plane across the direction, at the best place for these ranges.
CutChoice cut_across(const CutFaces& ball, const CutFaces& socket, const CutNode& node,
                     const CutNode& best_for, const Vec3& direction) {
  const auto normal = whole(direction);
  const Vec3 n(static_cast<double>(normal[0]), static_cast<double>(normal[1]),
               static_cast<double>(normal[2]));
  const auto along = [&](const CutNode& of) {
    return CutRanges{ranges_along(ball, of.ball, n), ranges_along(socket, of.socket, n)};
  };
  const double at = best_place(along(best_for)).at;
  return cut_at(node, along(node), {ClearCut::Kind::plane, normal, 0}, std::round(kUnit * at));
}

}  // namespace

CutChoice choose_cut(const CutFaces& ball, const CutFaces& socket, const CutNode& node, const Vec3& axis) {
  const CutNode some{sample(node.ball), sample(node.socket)};
  BestDirection best{ball, socket, some};
  for (const Vec3& direction : directions_for(ball, socket, some, axis)) best.offer(direction);
  best.improve();
  CutChoice flat = cut_across(ball, socket, node, node, best.direction);
  if (ball.radius.empty()) return flat;
  const CutRanges out{ranges_out(ball, node.ball), ranges_out(socket, node.socket)};
  const CutScore score = best_place(out);
  if (!(score.pairs < flat.pairs()) || !(score.at > 1.0 / kUnit)) return flat;
  CutChoice round = cut_at(node, out, {ClearCut::Kind::sphere, {}, 0}, std::round(kUnit * score.at));
  return round.pairs() < flat.pairs() ? round : flat;
}

CutChoice cut_between_first(const CutFaces& ball, const CutFaces& socket, const CutNode& node) {
  const CutNode first{{node.ball.front()}, {node.socket.front()}};
  const CutGap gap = widest_gap(last_images(ball, first.ball.front()), socket.of(first.socket.front()));
  return cut_across(ball, socket, node, first, gap.direction);
}

}  // namespace impinge
