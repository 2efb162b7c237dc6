// SPDX-License-Identifier: GPL-3.0-or-later
// Reads lines, words and numbers from a text in memory.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace impinge {

/// Hands out the lines of a text, without line feeds and carriage returns.
class LineScanner {
 public:
  explicit LineScanner(std::string_view text) : rest_(text) {}  // the text must outlive the scanner
  std::optional<std::string_view> next();                       // the next line; std::nullopt at the end
  /// The next line that has a word, cut into its words; empty at the end. Valid until the next call.
  const std::vector<std::string_view>& next_words();
  std::string_view rest() const { return rest_; }  // the text that has not been handed out

 private:
  std::string_view rest_;
  std::vector<std::string_view> words_;
};

/// Replaces the contents of `words` by the parts of `line` between blanks.
void split_words(std::string_view line, std::vector<std::string_view>& words);

/// The whole word as a number, "nan" and "inf" included; std::nullopt for any other word. A magnitude beyond
/// a double counts as infinite or zero.
std::optional<double> to_number(std::string_view word);

/// The whole word as an integer; std::nullopt if it is anything else or beyond 64 bits.
std::optional<std::int64_t> to_integer(std::string_view word);

}  // namespace impinge
