// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/text_scan.hpp"

#include <charconv>
#include <limits>
#include <system_error>

namespace impinge {
namespace {

constexpr std::string_view kBlanks = " \t\r\v\f";

std::string_view without_plus(std::string_view word) {
  return word.size() > 1 && word[0] == '+' && word[1] != '-' ? word.substr(1) : word;
}

}  // namespace

std::optional<std::string_view> LineScanner::next() {
  if (rest_.empty()) return std::nullopt;
  const std::size_t end = rest_.find('\n');
  std::string_view line = rest_.substr(0, end);
  rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  return line;
}

const std::vector<std::string_view>& LineScanner::next_words() {
  words_.clear();
  while (words_.empty()) {
    const std::optional<std::string_view> line = next();
    if (!line) break;
    split_words(*line, words_);
  }
  return words_;
}

void split_words(std::string_view line, std::vector<std::string_view>& words) {
  words.clear();
  while (true) {
    const std::size_t begin = line.find_first_not_of(kBlanks);
    if (begin == std::string_view::npos) return;
    line.remove_prefix(begin);
    const std::size_t end = line.find_first_of(kBlanks);
    words.push_back(line.substr(0, end));
    line.remove_prefix(words.back().size());
  }
}

std::optional<double> to_number(std::string_view word) {
  word = without_plus(word);
  if (word.ends_with(')')) return std::nullopt;  // nan(...)
  double number = 0.0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  if (error == std::errc::invalid_argument || end != word.data() + word.size()) return std::nullopt;
  if (error == std::errc::result_out_of_range) {
    // from_chars does not say whether the number is too large or too small; a negative exponent means small.
    const bool tiny = word.find("e-") != std::string_view::npos || word.find("E-") != std::string_view::npos;
    return tiny ? 0.0 : std::numeric_limits<double>::infinity();
  }
  return number;
}

std::optional<std::int64_t> to_integer(std::string_view word) {
  word = without_plus(word);
  std::int64_t integer = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), integer);
  if (error != std::errc{} || end != word.data() + word.size()) return std::nullopt;
  return integer;
}

}  // namespace impinge
