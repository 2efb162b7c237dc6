// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/delimited.hpp"

#include <algorithm>
#include <string>

#include "files/finite_number.hpp"

namespace impinge {
namespace {

std::string_view without_blanks(std::string_view word) {
  while (word.starts_with(' ')) word.remove_prefix(1);
  while (word.ends_with(' ')) word.remove_suffix(1);
  return word;
}

// The place of the quote that closes the one at the beginning, or the end of the line.
std::size_t closing_quote(std::string_view line) {
  std::size_t at = line.find('"', 1);
  while (at < line.size() && line.substr(at).starts_with("\"\"")) at = line.find('"', at + 2);
  return std::min(at, line.size());
}

}  // namespace

NumberedLines::NumberedLines(std::string_view bytes) : rest_(bytes) {
  if (rest_.starts_with("\xEF\xBB\xBF")) rest_.remove_prefix(3);  // byte order mark of UTF-8
}

bool NumberedLines::next() {
  while (!rest_.empty()) {
    line_ = rest_.substr(0, rest_.find('\n'));
    rest_.remove_prefix(std::min(line_.size() + 1, rest_.size()));
    if (line_.ends_with('\r')) line_.remove_suffix(1);
    ++number_;
    if (line_.find_first_not_of(" \t") != line_.npos) return true;
  }
  return false;
}

char separator_of(std::string_view head) {
  for (const char separator : {'\t', ';'})
    if (head.find(separator) != head.npos) return separator;
  return ',';
}

std::vector<std::string_view> delimited_words(std::string_view line, char separator) {
  std::vector<std::string_view> words;
  for (bool more = true; more;) {
    while (line.starts_with(' ')) line.remove_prefix(1);
    const std::size_t quote = line.starts_with('"') ? closing_quote(line) : 0;
    const std::size_t end = std::min(line.find(separator, quote), line.size());
    words.push_back(quote > 0 ? line.substr(1, quote - 1) : without_blanks(line.substr(0, end)));
    more = end < line.size();
    line.remove_prefix(std::min(end + 1, line.size()));
  }
  return words;
}

std::optional<double> delimited_number(std::string_view word, char separator) {
  const std::size_t comma = word.find(',');
  if (separator == ',' || comma == word.npos) return finite_number(word);
  std::string point(word);
  point[comma] = '.';
  return finite_number(point);
}

}  // namespace impinge
