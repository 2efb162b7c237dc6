// SPDX-License-Identifier: GPL-3.0-or-later
// Writes and reads as JSON what files/fields.hpp describes, and makes its JSON Schema (draft 2020-12). Keys
// are the names of the fields, in their order; NaN and infinities become null, points [x, y, z].
#pragma once

#include <cmath>
#include <concepts>
#include <filesystem>
#include <optional>
#include <ranges>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "files/fields.hpp"
#include "hip/motion.hpp"
#include "sphere/direction.hpp"

namespace impinge {

using Json = nlohmann::ordered_json;

template <class T>
inline constexpr bool is_optional = false;
template <class T>
inline constexpr bool is_optional<std::optional<T>> = true;

template <class T>
concept TextLike = std::convertible_to<const T&, std::string_view>;

template <class T>
Json json_of(const T& value) {
  if constexpr (Described<T>) {
    Json object = Json::object();
    for_each_field<T>([&](const auto& field) { object[std::string(field.name)] = json_of(field.of(value)); });
    return object;
  } else if constexpr (is_optional<T>) {
    return value ? json_of(*value) : Json(nullptr);
  } else if constexpr (InWords<T>) {
    return word_of(value);
  } else if constexpr (std::floating_point<T>) {
    return std::isfinite(value) ? Json(value) : Json(nullptr);
  } else if constexpr (std::same_as<T, std::filesystem::path>) {
    return value.string();
  } else if constexpr (TextLike<T>) {
    return std::string_view(value);
  } else if constexpr (std::ranges::range<T>) {
    Json array = Json::array();
    for (const auto& item : value) array.push_back(json_of(item));
    return array;
  } else {
    return value;
  }
}

/// "above 0", "from -90 to 90", "0 or more", "finite".
std::string describe(const Range& range);

/// The text of a document, indented. Bytes that are not UTF-8, as file names may have, become U+FFFD.
std::string text_of(const Json& document);

/// The schema of a value that may also be null.
Json or_null(Json schema);
/// An object with exactly these properties.
Json object_schema(Json properties);

template <class T>
Json schema_of() {
  if constexpr (Described<T>) {
    Json properties = Json::object();
    for_each_field<T>([&]<class Get>(const Field<Get>& field) {
      Json& property = properties[std::string(field.name)] = schema_of<ValueOf<T, Get>>();
      property["description"] = field.text;
      if (!field.unit.empty()) property["unit"] = field.unit;
    });
    return object_schema(std::move(properties));
  } else if constexpr (is_optional<T>) {
    return or_null(schema_of<typename T::value_type>());
  } else if constexpr (InWords<T>) {
    return {{"enum", words_of<T>}};
  } else if constexpr (std::same_as<T, bool>) {
    return {{"type", "boolean"}};
  } else if constexpr (std::integral<T>) {
    return {{"type", "integer"}};
  } else if constexpr (std::floating_point<T>) {
    return {{"type", "number"}};
  } else if constexpr (std::same_as<T, std::filesystem::path> || TextLike<T>) {
    return {{"type", "string"}};
  } else {
    return {{"type", "array"}, {"items", schema_of<std::ranges::range_value_t<T>>()}};
  }
}

/// Sets a value of a request from JSON; null stands for no value. Throws std::invalid_argument, one line that
/// begins with `name`, for a value of another kind or out of range.
void read_json(const Json& given, std::string_view name, const Range& range, double& value);
void read_json(const Json& given, std::string_view name, const Range& range, bool& value);
void read_json(const Json& given, std::string_view name, const Range& range, std::string& value);
inline void read_json(const Json& given, std::string_view name, const Range& range,
                      std::filesystem::path& value) {
  std::string text;
  read_json(given, name, range, text);
  value = text;
}

template <class T>
void read_json(const Json& given, std::string_view name, const Range& range, std::optional<T>& value) {
  if (given.is_null())
    value.reset();
  else
    read_json(given, name, range, value.emplace());
}

/// The word that differs by two letters at most; empty if none does.
std::string_view near_word(std::string_view word, std::span<const std::string_view> words);

/// The index of `word` in `words`. Throws std::invalid_argument, with a similar word if there is one.
std::size_t place_among(std::string_view word, std::span<const std::string_view> words,
                        std::string_view what);

/// Reads a place or a shift: three numbers.
void read_json(const Json& given, std::string_view name, const Range& range, Vec3& value);

/// Reads a text such as "flexion=90,internal_rotation=10", three numbers (flexion, abduction, internal
/// rotation) or an object with these keys; degrees.
void read_json(const Json& given, std::string_view name, const Range& range, Motion& value);
/// Reads a list of motions; three numbers are one motion.
void read_json(const Json& given, std::string_view name, const Range& range, std::vector<Motion>& values);

template <InWords E>
void read_json(const Json& given, std::string_view name, const Range& range, E& value) {
  std::string word;
  read_json(given, name, range, word);
  value = static_cast<E>(place_among(word, words_of<E>, name));
}

/// Reads a list, or its only item without brackets.
template <class T>
void read_json(const Json& given, std::string_view name, const Range& range, std::vector<T>& values) {
  values.clear();
  for (const Json& item : given.is_array() ? given : Json::array({given}))
    read_json(item, name, range, values.emplace_back());
}

/// Calls `use` and puts the field's name before the message of a std::invalid_argument.
template <class Do>
void in_field(std::string_view name, const Do& use) {
  try {
    use();
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(std::string(name) + ": " + error.what());
  }
}

/// The names of the fields, in their order.
template <Described T>
std::vector<std::string_view> names_of_fields() {
  std::vector<std::string_view> names;
  for_each_field<T>([&](const auto& field) { names.push_back(field.name); });
  return names;
}

/// Sets the field of that name; false if there is none.
template <Described Request>
bool read_field(std::string_view name, const Json& given, Request& request) {
  bool found = false;
  for_each_field<Request>([&](const auto& field) {
    if (field.name != name) return;
    read_json(given, field.name, field.range, field.of(request));
    found = true;
  });
  return found;
}

/// Sets the values of a request that a JSON object gives; the others stay as they are.
template <Described Request>
void read_request(const Json& given, Request& request) {
  if (!given.is_object())
    throw std::invalid_argument("a request is a JSON object with a key for each value that is given");
  for (const auto& item : given.items())
    if (!read_field(item.key(), item.value(), request))
      place_among(item.key(), names_of_fields<Request>(), "request");  // says what there is
}

}  // namespace impinge
