// SPDX-License-Identifier: GPL-3.0-or-later
#include "harness/progress.hpp"

#include <algorithm>
#include <cmath>

namespace impinge::lab {
namespace {

constexpr std::chrono::seconds kPause{5};  // between two lines

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

std::string duration_text(double seconds) {
  const auto whole = static_cast<long>(std::ceil(std::max(0.0, seconds)));
  if (whole < 60) return std::to_string(whole) + " s";
  const std::string rest = std::to_string(whole % 60);
  return std::to_string(whole / 60) + " min " + (rest.size() < 2 ? "0" : "") + rest + " s";
}

void Progress::say(std::string_view text) {
  if (out_ != nullptr) *out_ << name_ << ": " << text << std::endl;
}

void Progress::begin(double expected_s) {
  expected_ = expected_s;
  done_ = 0.0;
  start_ = Clock::now();
}

void Progress::advance(double expected_s, std::string_view what) {
  done_ = std::min(done_ + expected_s, expected_);
  if (Clock::now() - printed_ < kPause) return;
  printed_ = Clock::now();
  const double share = expected_ > 0.0 ? 100.0 * done_ / expected_ : 100.0;
  say(std::to_string(std::lround(share)) + " %, about " + duration_text(seconds_left()) + " left (" +
      std::string(what) + ")");
}

double Progress::seconds_left() const {
  const double left = expected_ - done_;
  return done_ > 0.0 ? left * seconds_since(start_) / done_ : left;
}

}  // namespace impinge::lab
