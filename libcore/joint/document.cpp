// SPDX-License-Identifier: GPL-3.0-or-later
#include "joint/document.hpp"

#include <algorithm>
#include <array>
#include <numeric>

#include "files/formatted.hpp"
#include "files/joined.hpp"

namespace impinge {
namespace {

// The least number of letters to change, add or leave out (Levenshtein 1966).
std::size_t edits(std::string_view from, std::string_view to) {
  std::vector<std::size_t> row(to.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < from.size(); ++i) {
    std::size_t diagonal = row[0]++;
    for (std::size_t k = 0; k < to.size(); ++k) {
      const std::size_t changed = diagonal + (from[i] == to[k] ? 0 : 1);
      diagonal = row[k + 1];
      row[k + 1] = std::min({changed, row[k] + 1, row[k + 1] + 1});
    }
  }
  return row.back();
}

[[noreturn]] void refuse(std::string_view name, const std::string& what) {
  throw std::invalid_argument(std::string(name) + ": " + what);
}

}  // namespace

std::string describe(const Range& range) {
  const bool low = std::isfinite(range.least);
  const bool high = std::isfinite(range.most);
  if (!low) return high ? formatted("up to %g", range.most) : "finite";
  const std::string from =
      range.above ? formatted("above %g", range.least) : formatted("from %g", range.least);
  if (high)
    return from + (range.above ? formatted(", up to %g", range.most) : formatted(" to %g", range.most));
  return range.above ? from : formatted("%g or more", range.least);
}

std::string text_of(const Json& document) {
  return document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Json or_null(Json schema) {
  if (schema.contains("enum")) {
    schema["enum"].push_back(nullptr);
  } else if (schema.contains("type") && schema["type"].is_string()) {
    schema["type"] = Json::array({schema["type"], "null"});
  }
  return schema;
}

Json object_schema(Json properties) {
  Json required = Json::array();
  for (const auto& [name, property] : properties.items()) required.push_back(name);
  return {{"type", "object"},
          {"properties", std::move(properties)},
          {"required", std::move(required)},
          {"additionalProperties", false}};
}

void read_json(const Json& given, std::string_view name, const Range& range, double& value) {
  if (!given.is_number()) refuse(name, given.dump() + " is no number; give one " + describe(range));
  value = given.get<double>();
  if (!std::isfinite(value) || !range.has(value))
    refuse(name, formatted("%g is out of range; give a number ", value) + describe(range));
}

void read_json(const Json& given, std::string_view name, const Range& /*range*/, bool& value) {
  if (!given.is_boolean()) refuse(name, given.dump() + " is neither true nor false; give one of these");
  value = given.get<bool>();
}

void read_json(const Json& given, std::string_view name, const Range& /*range*/, std::string& value) {
  if (!given.is_string()) refuse(name, given.dump() + " is no text; give one");
  value = given.get<std::string>();
}

void read_json(const Json& given, std::string_view name, const Range& range, Vec3& value) {
  std::vector<double> numbers;
  read_json(given, name, range, numbers);
  if (numbers.size() != 3) refuse(name, "is not three numbers, x, y and z");
  value = {numbers[0], numbers[1], numbers[2]};
}

void read_json(const Json& given, std::string_view name, const Range& /*range*/, Motion& value) {
  in_field(name, [&] {
    if (given.is_string()) {
      value = parse_motion(given.get<std::string>());
      return;
    }
    std::array<double, 3> angles{};
    if (given.is_object()) {
      read_request(given, value);
      angles = {value.flexion, value.abduction, value.internal_rotation};
    } else {
      std::vector<double> numbers;
      read_json(given, name, {}, numbers);
      if (numbers.size() != angles.size())
        throw std::invalid_argument("is not three angles in degrees: flexion, abduction, internal rotation");
      std::copy(numbers.begin(), numbers.end(), angles.begin());
    }
    for (const double angle : angles)
      if (!(std::abs(angle) <= kLargestAngle))
        throw std::invalid_argument("an angle is not within 180 degrees of 0");
    value = {angles[0], angles[1], angles[2]};
  });
}

void read_json(const Json& given, std::string_view name, const Range& range, std::vector<Motion>& values) {
  const bool one = !given.is_array() || (!given.empty() && given.front().is_number());
  values.clear();
  for (const Json& item : one ? Json::array({given}) : given)
    read_json(item, name, range, values.emplace_back());
}

std::string_view near_word(std::string_view word, std::span<const std::string_view> words) {
  constexpr std::size_t kMost = 2;
  std::string_view near;
  std::size_t least = kMost + 1;
  for (const std::string_view one : words) {
    const std::size_t changed = edits(word, one);
    if (changed < least) {
      least = changed;
      near = one;
    }
  }
  return near;
}

std::size_t place_among(std::string_view word, std::span<const std::string_view> words,
                        std::string_view what) {
  const auto found = std::find(words.begin(), words.end(), word);
  if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
  const std::string_view near = near_word(word, words);
  refuse(what, "there is no '" + std::string(word) + "'" +
                   (near.empty() ? "; there are " : "; did you mean " + std::string(near) + "? There are ") +
                   (words.empty() ? "none" : joined(words)));
}

}  // namespace impinge
