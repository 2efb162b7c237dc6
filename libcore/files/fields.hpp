// SPDX-License-Identifier: GPL-3.0-or-later
// Requests, answers and rows of tables, described once. From the description follow their JSON and its schema
// (joint/document.hpp), the options of a command, the columns of a CSV (files/rows.hpp) and the lists of the
// reference page. What is described is a plain struct with a static member:
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

/// Numbers that a member of a request may have.
struct Range {
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();
  bool above = false;  // `least` itself is not among them

  constexpr bool has(double x) const { return (above ? x > least : x >= least) && x <= most; }
};
inline constexpr Range kPositive{.least = 0.0, .above = true};
inline constexpr Range kNotNegative{.least = 0.0};

/// A member, or what a function says of its owner, and what a reader must know of it.
template <class Get>
struct Field {
  std::string_view
      name;  // key of JSON, column of a CSV, keyword of Python; as an option, - takes the place of _
  std::string_view unit;  // such as "mm"; "1" of counts and ratios, "" of what is no number
  std::string_view text;  // what it is, one clause
  Get get;                // pointer to a member of the owner, or function of it
  Range range = {};       // of a request

  template <class Owner>
  constexpr decltype(auto) of(Owner& owner) const {
    return std::invoke(get, owner);
  }
};
template <class Get>
Field(std::string_view, std::string_view, std::string_view, Get) -> Field<Get>;
template <class Get>
Field(std::string_view, std::string_view, std::string_view, Get, Range) -> Field<Get>;

/// What the field is of such an owner.
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
/// For a Field: the member of a member, and so on; none where one on the way is.
template <class... Steps>
constexpr auto via(Steps... steps) {
  return [steps...](const auto& owner) { return value_via(owner, steps...); };
}

/// The fields of T. Specialised beside the documents of a struct whose own folder knows of none.
template <class T>
inline constexpr bool fields_of = false;
template <class T>
requires requires { T::fields; }
inline constexpr const auto& fields_of<T> = T::fields;

template <class T>
concept Described = !std::is_same_v<decltype(fields_of<T>), const bool>;

/// visit(field) for each field, in their order.
template <Described T, class Visit>
constexpr void for_each_field(Visit&& visit) {
  std::apply([&](const auto&... field) { (visit(field), ...); }, fields_of<T>);
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
