// SPDX-License-Identifier: GPL-3.0-or-later
// Describes the members of requests, answers and rows of tables. From this one description the library makes
// their JSON and its schema (joint/document.hpp), the options of a command, the columns of a CSV
// (files/rows.hpp) and the lists of the reference page. A struct is described by a static member:
//
//   struct Stop {
//     double angle = 0.0;
//     static constexpr std::tuple fields{Field{"angle_deg", "deg", "where it stops", &Stop::angle}};
//   };
#pragma once

#include <array>
#include <cmath>
#include <concepts>
#include <functional>
#include <limits>
#include <optional>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>

namespace impinge {

/// The numbers that a member of a request may have: those from `least` to `most`.
struct Range {
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();
  bool above = false;  // true where `least` itself is not allowed

  constexpr bool has(double x) const { return (above ? x > least : x >= least) && x <= most; }
};
inline constexpr Range kPositive{.least = 0.0, .above = true};
inline constexpr Range kNotNegative{.least = 0.0};

/// One value that a struct, its owner, has: how to get it, and what a reader must know of it.
template <class Get>
struct Field {
  std::string_view
      name;  // key of JSON, column of a CSV, keyword of Python; as an option, - takes the place of _
  std::string_view unit;  // such as "mm"; "1" for counts and ratios, "" for what is not a number
  std::string_view text;  // what it is, one clause
  Get get;                // a pointer to a member of the owner, or a function that takes the owner
  Range range = {};       // the numbers allowed in a request

  template <class Owner>
  constexpr decltype(auto) of(Owner& owner) const {
    return std::invoke(get, owner);
  }
};
template <class Get>
Field(std::string_view, std::string_view, std::string_view, Get) -> Field<Get>;
template <class Get>
Field(std::string_view, std::string_view, std::string_view, Get, Range) -> Field<Get>;

/// The type of the value of a field.
template <class Owner, class Get>
using ValueOf = std::remove_cvref_t<std::invoke_result_t<Get, const Owner&>>;

template <class Owner, class First, class... Rest>
constexpr auto value_via(const Owner& owner, First first, Rest... rest) {
  const auto& value = std::invoke(first, owner);
  if constexpr (sizeof...(Rest) == 0) {
    return value;
  } else if constexpr (requires { value.has_value(); }) {
    using Found = decltype(value_via(*value, rest...));
    if constexpr (requires(Found found) { found.has_value(); })
      return value ? value_via(*value, rest...) : Found();
    else
      return value ? std::optional(value_via(*value, rest...)) : std::nullopt;
  } else {
    return value_via(value, rest...);
  }
}
/// For a Field: gets a member of a member, and so on. Where an optional member on the way is empty, so is the
/// value.
template <class... Steps>
constexpr auto via(Steps... steps) {
  return [steps...](const auto& owner) { return value_via(owner, steps...); };
}

/// The fields of T: T::fields, or a specialisation beside the documents, for a struct whose own folder does
/// not use this header.
template <class T>
inline constexpr bool fields_of = false;
template <class T>
requires requires { T::fields; }
inline constexpr const auto& fields_of<T> = T::fields;

template <class T>
concept Described = !std::is_same_v<decltype(fields_of<T>), const bool>;

/// Calls visit(field) for each field, in their order.
template <Described T, class Visit>
constexpr void for_each_field(Visit&& visit) {
  std::apply([&](const auto&... field) { (visit(field), ...); }, fields_of<T>);
}

/// The words for the values of an enumeration, in their order. Each enumeration that documents use
/// specialises this.
template <class E>
inline constexpr std::array<std::string_view, 0> words_of{};

template <class E>
concept InWords = std::is_enum_v<E> &&(words_of<E>.size() > 0);

template <InWords E>
constexpr std::string_view word_of(E value) {
  return words_of<E>[static_cast<std::size_t>(value)];
}

}  // namespace impinge
