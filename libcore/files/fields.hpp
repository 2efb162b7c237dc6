// SPDX-License-Identifier: GPL-3.0-or-later
// Requests, answers and rows of tables, described once. From the description follow their JSON and its schema
// (joint/document.hpp), the options of a command, the columns of a CSV (files/rows.hpp) and the lists of the
// reference page. What is described is a plain struct with a static function:
//
//   struct Stop {
//     double angle = 0.0;
//     static constexpr auto fields() {
//       return std::tuple{Field{"angle_deg", "deg", "where it stops", &Stop::angle}};
//     }
//   };
#pragma once

#include <array>
#include <cmath>
#include <concepts>
#include <limits>
#include <string_view>
#include <tuple>
#include <type_traits>

namespace impinge {

/// Numbers that a member of a request may have.
struct Range {
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();
  bool above = false;  // `least` itself is not among them

  constexpr bool has(double x) const { return (above ? x > least : x >= least) && x <= most; }
};
inline constexpr Range kPositive{.least = 0.0, .above = true};
inline constexpr Range kNotNegative{.least = 0.0};

/// A member, and what a reader must know of it.
template <class Owner, class Value>
struct Field {
  std::string_view
      name;  // key of JSON, column of a CSV, keyword of Python; as an option, - takes the place of _
  std::string_view unit;  // such as "mm"; "1" of counts and ratios, "" of what is no number
  std::string_view text;  // what it is, one clause
  Value Owner::*member;
  Range range = {};  // of a request
};
template <class Owner, class Value>
Field(std::string_view, std::string_view, std::string_view, Value Owner::*) -> Field<Owner, Value>;
template <class Owner, class Value>
Field(std::string_view, std::string_view, std::string_view, Value Owner::*, Range) -> Field<Owner, Value>;

template <class T>
concept Described = requires {
  std::tuple_size<decltype(T::fields())>::value;
};

/// visit(field) for each field, in their order.
template <Described T, class Visit>
constexpr void for_each_field(Visit&& visit) {
  std::apply([&](const auto&... field) { (visit(field), ...); }, T::fields());
}

/// The words for the values of an enumeration, in their order: specialised beside each that documents have.
template <class E>
inline constexpr std::array<std::string_view, 0> words_of{};

template <class E>
concept InWords = std::is_enum_v<E> &&(words_of<E>.size() > 0);

template <InWords E>
constexpr std::string_view word_of(E value) {
  return words_of<E>[static_cast<std::size_t>(value)];
}

}  // namespace impinge
