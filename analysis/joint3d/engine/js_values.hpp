// SPDX-License-Identifier: GPL-3.0-or-later
// Values of JavaScript from values of the library, and back.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <emscripten/bind.h>

#include "joint/document.hpp"
#include "mesh/triangle_mesh.hpp"

namespace impinge {

using emscripten::val;

// An object from names and values.
template <class... Values>
val object(std::pair<const char*, Values>... members) {
  val made = val::object();
  (made.set(members.first, members.second), ...);
  return made;
}

// A typed array of its own: memory of the library moves when it grows.
template <class Number>
val typed_array(const std::vector<Number>& numbers) {
  return val(emscripten::typed_memory_view(numbers.size(), numbers.data())).call<val>("slice");
}

inline val float_array(std::span<const double> numbers) {
  return typed_array(std::vector<float>(numbers.begin(), numbers.end()));
}

inline val float_array(std::span<const Vec3> points) {
  std::vector<float> numbers;
  numbers.reserve(3 * points.size());
  for (const Vec3& x : points) {
    for (const double coordinate : {x.x(), x.y(), x.z()}) numbers.push_back(static_cast<float>(coordinate));
  }
  return typed_array(numbers);
}

inline val text(std::string_view words) { return val(std::string(words)); }

inline val point(const Vec3& x) { return val::array(std::vector<double>{x.x(), x.y(), x.z()}); }

template <class Value>
val or_null(const std::optional<Value>& value) {
  return value ? val(*value) : val::null();
}

inline val number_or_null(double value) { return std::isfinite(value) ? val(value) : val::null(); }

// Objects, lists, numbers and texts of JSON.
inline val val_of(const Json& document) { return val::global("JSON").call<val>("parse", text_of(document)); }

// Of a list, each made by `make`.
template <class Range, class Make>
val list(const Range& range, const Make& make) {
  val made = val::array();
  for (const auto& item : range) made.call<void>("push", make(item));
  return made;
}

// A number of a request, or `otherwise` where it is left out.
inline double number_of(const val& request, const char* name, double otherwise) {
  const val value = request[name];
  return value.isNumber() ? value.as<double>() : otherwise;
}

inline bool is_given(const val& value) { return !value.isUndefined() && !value.isNull(); }

}  // namespace impinge
