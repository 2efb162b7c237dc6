// SPDX-License-Identifier: GPL-3.0-or-later
#include "cohort/draw.hpp"

#include <stdexcept>

#include <gsl/gsl_cdf.h>

#include "harness/digest.hpp"
#include "hip/hip_checks.hpp"
#include "hip/hip_surface.hpp"

namespace impinge::lab {
namespace {

constexpr std::size_t kAttempts = 100;

HipParameters drawn(const Study& study, std::size_t j, std::size_t attempt) {
  const std::size_t count = study.spreads.size();
  Eigen::VectorXd scores(static_cast<Eigen::Index>(count));
  for (std::size_t k = 0; k < count; ++k) {
    const double u = uniform_draw(study.seed, std::string(study.spreads[k].parameter->name), j, attempt);
    scores[static_cast<Eigen::Index>(k)] = gsl_cdf_ugaussian_Pinv(u);
  }
  scores = study.mixing * scores;
  HipParameters parameters = study.start;
  for (std::size_t k = 0; k < count; ++k)
    parameters.*study.spreads[k].parameter->value =
        value_at(study.spreads[k], scores[static_cast<Eigen::Index>(k)]);
  return parameters;
}

}  // namespace

double uniform_draw(std::uint64_t seed, const std::string& tag, std::size_t hip, std::size_t attempt) {
  const std::string text =
      std::to_string(seed) + "/" + tag + "/" + std::to_string(hip) + "/" + std::to_string(attempt);
  const std::uint64_t digits = std::stoull(sha256_hex(text).substr(0, 13), nullptr, 16);
  return (static_cast<double>(digits) + 0.5) * 0x1p-52;
}

DrawnHip draw_hip(const Study& study, std::size_t j) {
  std::string why;
  for (std::size_t attempt = 0; attempt < kAttempts; ++attempt) {
    const HipParameters parameters = drawn(study, j, attempt);
    try {
      HipParameters right = parameters;
      right.side = Side::right;
      require_free_at_rest(hip_surface(right));
      return {parameters, attempt};
    } catch (const std::invalid_argument& error) {
      why = error.what();
    }
  }
  throw std::runtime_error("hip " + std::to_string(j) + ": " + std::to_string(kAttempts) +
                           " draws make no hip, the last one because " + why +
                           "; narrow the distributions of the study");
}

}  // namespace impinge::lab
