// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps numbers in fewer bytes than doubles take. They read back as doubles, and their largest error is
// known. NaN, which is "no surface", stays NaN.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <span>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace impinge {

/// How a number is kept: in 8, 4 or 2 bytes.
enum class Storage { double_precision, single_precision, sixteen_bits };

/// Four bytes a number, rounded to nearest: off by at most 2^-24 of the number. Throws std::invalid_argument
/// for a number that is too large for a float, or too small to keep its digits (below 2^-126, except 0).
class FloatValues {
 public:
  static constexpr std::string_view name = "float";  // in tables of results

  /// Rounds the values.
  explicit FloatValues(std::span<const double> values) : values_(values.size()) {
    std::ranges::transform(values, values_.begin(), [](double v) { return to_float(v); });
  }

  double operator[](std::size_t i) const { return static_cast<double>(values_[i]); }  // number i
  std::size_t size() const { return values_.size(); }                                 // of numbers
  std::size_t bytes() const { return values_.size() * sizeof(float); }                // of memory

 private:
  static float to_float(double value) {
    const auto rounded = static_cast<float>(value);
    if (std::isnan(value) || std::isnormal(rounded) || value == 0.0) return rounded;
    char text[160];
    std::snprintf(
        text, sizeof text,
        "a table in float keeps numbers from 1.2e-38 to 3.4e+38, not %.3g: keep it in double, or give "
        "lengths in millimetres",
        value);
    throw std::invalid_argument(text);
  }

  std::vector<float> values_;
};

/// Two bytes a number: steps of equal size from the smallest number to the largest, off by at most half a
/// step (and the rounding of smallest + step * code).
class Uint16Values {
 public:
  static constexpr std::string_view name = "uint16";  // in tables of results
  static constexpr std::uint16_t kNone = 65535;       // code of NaN

  /// Rounds the values to steps between the least and the largest.
  explicit Uint16Values(std::span<const double> values) : codes_(values.size(), kNone) {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const double v : values) {
      if (std::isnan(v)) continue;
      low = std::min(low, v);
      high = std::max(high, v);
    }
    if (low > high) return;  // none at all
    smallest_ = low;
    step_ = (high - low) / (kNone - 1);
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (std::isnan(values[i])) continue;
      codes_[i] = step_ > 0.0 ? static_cast<std::uint16_t>(std::lround((values[i] - low) / step_)) : 0;
    }
  }

  /// Number i.
  double operator[](std::size_t i) const {
    const std::uint16_t code = codes_[i];
    return code == kNone ? std::numeric_limits<double>::quiet_NaN() : smallest_ + step_ * code;
  }
  std::size_t size() const { return codes_.size(); }                           // of numbers
  std::size_t bytes() const { return codes_.size() * sizeof(std::uint16_t); }  // of memory
  /// Number i is smallest() + step() * code(i), in the unit of the numbers; code kNone is NaN.
  std::uint16_t code(std::size_t i) const { return codes_[i]; }
  double smallest() const { return smallest_; }  // of the numbers
  double step() const { return step_; }          // between two codes

 private:
  std::vector<std::uint16_t> codes_;
  double smallest_ = 0.0;
  double step_ = 0.0;
};

}  // namespace impinge
