// SPDX-License-Identifier: GPL-3.0-or-later
// Reads tables as spreadsheets write them: their lines, the words of a line, and numbers.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace impinge {

/// Goes through the lines of a text. Blank lines are skipped but counted. A line is given without its end,
/// the first one without a byte order mark.
class NumberedLines {
 public:
  explicit NumberedLines(std::string_view bytes);

  /// Goes to the next line; false after the last one. To be called before the first line too.
  bool next();
  std::string_view line() const { return line_; }
  std::size_t number() const { return number_; }  // of the line in the text, from 1

 private:
  std::string_view rest_;
  std::string_view line_;
  std::size_t number_ = 0;
};

/// The separator of a table whose header line is `head`: a tab if it has one, else a semicolon if it has one,
/// else a comma.
char separator_of(std::string_view head);

/// The words between the separators of a line, without the blanks and quotes around them. A separator within
/// quotes does not count; a doubled quote within quotes stays doubled.
std::vector<std::string_view> delimited_words(std::string_view line, char separator);

/// The word as a finite number, else std::nullopt. Where the separator is not a comma, the decimal sign may
/// be one.
std::optional<double> delimited_number(std::string_view word, char separator);

}  // namespace impinge
