// SPDX-License-Identifier: GPL-3.0-or-later
// Values of JavaScript from values of the library, and back.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <emscripten/bind.h>

#include "joint/document.hpp"
#include "mesh/triangle_mesh.hpp"

namespace impinge {

using emscripten::val;

// A typed array of its own: memory of the library moves when it grows.
template <class Number>
val typed_array(std::span<const Number> numbers) {
  return val(emscripten::typed_memory_view(numbers.size(), numbers.data())).call<val>("slice");
}

inline val float_array(std::span<const double> numbers) {
  const std::vector<float> floats(numbers.begin(), numbers.end());
  return typed_array<float>(floats);
}

inline val float_array(std::span<const Vec3> points) {
  static_assert(sizeof(Vec3) == 3 * sizeof(double));
  return float_array(std::span(reinterpret_cast<const double*>(points.data()), 3 * points.size()));
}

inline val index_array(std::span<const Face> faces) {
  static_assert(sizeof(Face) == 3 * sizeof(std::uint32_t));
  return typed_array(std::span(reinterpret_cast<const std::uint32_t*>(faces.data()), 3 * faces.size()));
}

inline val val_of(const Json& document) { return val::global("JSON").call<val>("parse", text_of(document)); }

inline Json json_from(const val& value) {
  return Json::parse(val::global("JSON").call<std::string>("stringify", value));
}

inline bool is_given(const val& value) { return !value.isUndefined() && !value.isNull(); }

}  // namespace impinge
