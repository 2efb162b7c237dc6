// SPDX-License-Identifier: GPL-3.0-or-later
#include "19_slices_to_surface/slices_study.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "19_slices_to_surface/isosurface.hpp"
#include "hip/sphere_fit.hpp"
#include "reference/exact_radius.hpp"
#include "sphere/schemes/fibonacci.hpp"
#include "sphere/schemes/rsid.hpp"
#include "table/exact_raster.hpp"

namespace impinge::lab {
namespace {

constexpr double kMostGap = 8.0;               // mm
constexpr double kAround = 3.0;                // degrees
constexpr std::uint64_t kSocketSeed = 0x5eed;  // so that the two bones have different noise

using Gaps = std::vector<double>;

Gaps exact_gaps(const TriangleMesh& ball, const TriangleMesh& socket, const std::vector<Vec3>& directions) {
  const std::vector<double> inner = exact_radii(ball, {directions, Layer::farthest});
  Gaps gaps = exact_radii(socket, {directions, Layer::nearest});
  for (std::size_t i = 0; i < gaps.size(); ++i) gaps[i] -= inner[i];
  return gaps;
}

// A direction and eight round it.
void add_with_neighbours(const Vec3& u, std::vector<Vec3>& directions) {
  const Vec3 east = u.unitOrthogonal();
  const Vec3 north = u.cross(east);
  directions.push_back(u);
  for (int k = 0; k < 8; ++k) {
    const double at = 0.25 * kPi * k;
    directions.push_back(
        (u + std::tan(kAround * kDegree) * (std::cos(at) * east + std::sin(at) * north)).normalized());
  }
}

TriangleMesh scan(const TriangleMesh& body, const SlicesOptions& options, double noise, std::uint64_t seed) {
  ScanLevels levels = options.levels;
  levels.noise = noise;
  levels.seed = seed;
  return isosurface(hounsfield(bone_shares(body, options.grid), levels), levels.threshold());
}

BallSocketPair scan_both(const Hip& hip, const SlicesOptions& options, double noise) {
  return {scan(hip.ball, options, noise, options.levels.seed),
          scan(hip.socket, options, noise, options.levels.seed + kSocketSeed)};
}

Gaps table_gaps(const BallSocketPair& pair, const std::vector<Vec3>& directions, double precision_deg) {
  const Rsid scheme = Rsid::with_precision(precision_deg);
  const RadialTable<Rsid> ball = fill_exact(pair.ball, scheme, Layer::farthest);
  const RadialTable<Rsid> socket = fill_exact(pair.socket, scheme, Layer::nearest);
  Gaps gaps;
  gaps.reserve(directions.size());
  for (const Vec3& u : directions) gaps.push_back(socket.radius_at(u) - ball.radius_at(u));
  return gaps;
}

// Collects the stages and compares each with the truth and with the stage before.
class Stages {
 public:
  explicit Stages(const FacingGaps& truth) : truth_(truth), before_(truth.gap) {}

  void add(const char* name, const BallSocketPair& pair, Gaps gaps) {
    StageError error{name, pair.ball.faces.size(), pair.socket.faces.size()};
    error.directions = gaps.size();
    std::size_t counted = 0;
    for (std::size_t i = 0; i < gaps.size(); ++i) {
      if (std::isnan(gaps[i]) || std::isnan(before_[i])) {
        ++error.missed;
        continue;
      }
      const double off = gaps[i] - truth_.gap[i];
      ++counted;
      error.mean_mm += off;
      error.rms_mm += off * off;
      error.largest_mm = std::max(error.largest_mm, std::abs(off));
      error.added_rms_mm += (gaps[i] - before_[i]) * (gaps[i] - before_[i]);
    }
    const auto n = static_cast<double>(counted);
    error.mean_mm /= n;
    error.rms_mm = std::sqrt(error.rms_mm / n);
    error.added_rms_mm = std::sqrt(error.added_rms_mm / n);
    all_.push_back(error);
    before_ = std::move(gaps);
  }
  const std::vector<StageError>& all() const { return all_; }

 private:
  const FacingGaps& truth_;
  Gaps before_;
  std::vector<StageError> all_;
};

}  // namespace

FacingGaps facing_gaps(const Hip& hip, std::size_t count) {
  std::vector<Vec3> directions;
  const Fibonacci even = Fibonacci::with_precision(360.0 / std::sqrt(static_cast<double>(count) * kPi));
  for (std::size_t i = 0; i < even.size(); ++i) add_with_neighbours(even.direction(i), directions);
  const Gaps gaps = exact_gaps(hip.ball, hip.socket, directions);
  FacingGaps facing;
  for (std::size_t i = 0; i < gaps.size(); i += 9) {
    const auto first = gaps.begin() + static_cast<std::ptrdiff_t>(i);
    if (!std::all_of(first, first + 9, [](double gap) { return gap < kMostGap; })) continue;  // no NaN is
    facing.directions.push_back(directions[i]);
    facing.gap.push_back(gaps[i]);
  }
  return facing;
}

SlicesResult slices_to_surface(const Hip& hip, const FacingGaps& truth, const SlicesOptions& options) {
  Stages stages(truth);
  const auto exact = [&truth](const BallSocketPair& pair) {
    return exact_gaps(pair.ball, pair.socket, truth.directions);
  };
  const BallSocketPair clean = scan_both(hip, options, 0.0);
  stages.add("slices", clean, exact(clean));
  const BallSocketPair noisy = scan_both(hip, options, options.levels.noise);
  stages.add("noise", noisy, exact(noisy));
  const BallSocketPair fewer{decimate(noisy.ball, options.faces), decimate(noisy.socket, options.faces)};
  stages.add("decimation", fewer, exact(fewer));
  const Vec3 centre = fit_ball(fewer.ball).centre;
  const BallSocketPair centred{relative_to(fewer.ball, centre), relative_to(fewer.socket, centre)};
  stages.add("centre", centred, exact(centred));
  stages.add("table", centred, table_gaps(centred, truth.directions, options.precision_deg));
  return {stages.all(), fewer.ball, fewer.socket, centre};
}

}  // namespace impinge::lab
