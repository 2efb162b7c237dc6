// SPDX-License-Identifier: GPL-3.0-or-later
// What the standard library of emscripten 3.1.6 (libc++ 13) lacks of C++20 and libcore asks for, so that the
// library compiles as it is. Each stands on its C++17 counterpart; a projection is applied to what is
// compared. The compiler includes this file before every source of the WebAssembly build, and no other build
// does.
#pragma once

#include <version>

#if defined(_LIBCPP_VERSION) && _LIBCPP_VERSION < 15000

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <iterator>
#include <string>
#include <system_error>
#include <utility>

_LIBCPP_BEGIN_NAMESPACE_STD

template <class To, class From>
constexpr To bit_cast(const From& from) noexcept {
  return __builtin_bit_cast(To, from);
}

// The whole text or nothing: libcore refuses anything behind a number.
inline from_chars_result from_chars(const char* first, const char* last, double& value) {
  const string text(first, last);
  const bool begins =
      !text.empty() && (text[0] == '-' || text[0] == '.' || (text[0] >= '0' && text[0] <= '9'));
  const bool hexadecimal = text.find_first_of("xX") != string::npos;
  char* end = nullptr;
  const double read = strtod(text.c_str(), &end);
  if (!begins || hexadecimal || end == text.c_str()) return {first, errc::invalid_argument};
  const char* stop = first + (end - text.c_str());
  if (isinf(read)) return {stop, errc::result_out_of_range};
  value = read;
  return {stop, errc()};
}

// The shortest text that reads back as the same number, in fixed or scientific notation, whichever is
// shorter.
inline to_chars_result to_chars(char* first, char* last, double value) {
  char text[40];
  int digits = 0;
  do {
    snprintf(text, sizeof text, "%.*e", digits, value);
  } while (++digits < 17 && strtod(text, nullptr) != value);
  if (isfinite(value)) {
    const int exponent = atoi(strchr(text, 'e') + 1);
    char fixed[400];
    snprintf(fixed, sizeof fixed, "%.*f", max(digits - 1 - exponent, 0), value);
    if (strlen(fixed) <= strlen(text)) strcpy(text, fixed);
  } else {
    snprintf(text, sizeof text, "%g", value);
  }
  const size_t length = strlen(text);
  if (static_cast<size_t>(last - first) < length) return {last, errc::value_too_large};
  memcpy(first, text, length);
  return {first + length, errc()};
}

namespace ranges {

struct Itself {
  template <class Value>
  const Value& operator()(const Value& value) const {
    return value;
  }
};

template <class Less, class Projection>
auto projected(Less less, Projection projection) {
  return [less, projection](const auto& a, const auto& b) {
    return std::invoke(less, std::invoke(projection, a), std::invoke(projection, b));
  };
}

// An algorithm of a range is that of its two ends.
#define IMPINGE_OF_RANGE(algorithm)                                     \
  template <class Range, class... Rest>                                 \
  auto algorithm(Range&& range, Rest... rest) {                         \
    return std::algorithm(std::begin(range), std::end(range), rest...); \
  }
#define IMPINGE_OF_ORDERED_RANGE(algorithm)                                                  \
  template <class Range, class Less = std::less<>, class Projection = Itself>                \
  auto algorithm(Range&& range, Less order = {}, Projection projection = {}) {               \
    return std::algorithm(std::begin(range), std::end(range), projected(order, projection)); \
  }
IMPINGE_OF_RANGE(all_of)
IMPINGE_OF_RANGE(any_of)
IMPINGE_OF_RANGE(none_of)
IMPINGE_OF_RANGE(count)
IMPINGE_OF_RANGE(count_if)
IMPINGE_OF_RANGE(find)
IMPINGE_OF_RANGE(find_if)
IMPINGE_OF_RANGE(lower_bound)
IMPINGE_OF_RANGE(copy_if)
IMPINGE_OF_RANGE(transform)
IMPINGE_OF_RANGE(replace_if)
IMPINGE_OF_RANGE(fill)
IMPINGE_OF_RANGE(min_element)
IMPINGE_OF_ORDERED_RANGE(max_element)
IMPINGE_OF_ORDERED_RANGE(sort)
IMPINGE_OF_ORDERED_RANGE(stable_sort)
IMPINGE_OF_ORDERED_RANGE(make_heap)
IMPINGE_OF_ORDERED_RANGE(push_heap)
IMPINGE_OF_ORDERED_RANGE(pop_heap)
#undef IMPINGE_OF_RANGE
#undef IMPINGE_OF_ORDERED_RANGE

template <class Range>
auto min(Range&& range) {
  return *std::min_element(std::begin(range), std::end(range));
}
template <class Range>
auto max(Range&& range) {
  return *std::max_element(std::begin(range), std::end(range));
}

}  // namespace ranges

_LIBCPP_END_NAMESPACE_STD

#endif
