// SPDX-License-Identifier: GPL-3.0-or-later
// Lines and words of tables as spreadsheets write them.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace impinge {

/// Lines of a text with their numbers, without those that are blank, ends of lines and a byte order mark.
class NumberedLines {
 public:
  explicit NumberedLines(std::string_view bytes);

  /// Goes to the next line; false behind the last one.
  bool next();
  std::string_view line() const { return line_; }
  std::size_t number() const { return number_; }  // from 1

 private:
  std::string_view rest_;
  std::string_view line_;
  std::size_t number_ = 0;
};

/// What parts the words of a table with this head: a tab, else a semicolon, else a comma, which it has.
char separator_of(std::string_view head);

/// The words of a line, without blanks and quotes around them; within quotes a separator parts nothing, and a
/// quote that is doubled stays so. One more than there are separators.
std::vector<std::string_view> delimited_words(std::string_view line, char separator);

/// The word as a finite number, its decimal sign a point or, where no comma parts words, a comma;
/// std::nullopt for any other word.
std::optional<double> delimited_number(std::string_view word, char separator);

}  // namespace impinge
