// SPDX-License-Identifier: GPL-3.0-or-later
// Makes options of a command from the fields of a request (files/fields.hpp): clearance_mm becomes
// --clearance MM, with its text, range and default.
#pragma once

#include <concepts>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>

#include "files/fields.hpp"
#include "files/formatted.hpp"
#include "files/joined.hpp"
#include "hip/motion.hpp"
#include "joint/document.hpp"

namespace impinge {

/// Turns "clearance_mm" into "--clearance".
std::string option_name(std::string_view field);
/// Turns "mm" into "MM"; "NUMBER" without a unit.
std::string type_name(std::string_view unit);
/// Accepts numbers in a range; with `whole` only whole numbers.
CLI::Validator in_range(const Range& range, bool whole = false);
/// Reads three numbers X,Y,Z. Throws CLI::ValidationError.
Vec3 place_option(const std::string& option, const std::string& text);

/// The type shown in the help: "left|right", or "MOTION".
template <class T>
requires(InWords<T> || std::same_as<T, Motion> || std::same_as<T, std::optional<Motion>>) std::string
    words_or_motion(const char* between) {
  if constexpr (InWords<T>) return joined(words_of<T>, between);
  return "MOTION";
}

/// Adds an option with the words that name `value`; `value` holds the default.
template <InWords Value>
CLI::Option* add_word(CLI::App& command, const std::string& name, Value& value, const std::string& text) {
  return command
      .add_option_function<std::string>(
          name, [&value, name](const std::string& word) { read_json(word, name, {}, value); },
          text + " [" + std::string(word_of(value)) + "]")
      ->type_name(words_or_motion<Value>("|"));
}

template <class Request, class Get>
void add_field(CLI::App& command, const Field<Get>& field, Request& request) {
  using Value = ValueOf<Request, Get>;
  const std::string name = option_name(field.name);
  std::string text(field.text);
  Value& value = field.of(request);
  CLI::Option* option = nullptr;
  if constexpr (std::same_as<Value, bool>) {
    option = command.add_flag(name, value, text);
  } else if constexpr (InWords<Value>) {
    option = add_word(command, name, value, text);
  } else if constexpr (std::same_as<Value, Motion> || std::same_as<Value, std::optional<Motion>>) {
    option = command.add_option_function<std::string>(
        name, [&value, name](const std::string& given) { read_json(given, name, {}, value); }, text);
    option->type_name(words_or_motion<Value>("|"));
  } else if constexpr (std::same_as<Value, std::optional<Vec3>>) {
    option = command.add_option_function<std::string>(
        name, [&value, name](const std::string& given) { value = place_option(name, given); }, text);
    option->type_name("X,Y,Z");
  } else if constexpr (requires { words_or_motion<typename Value::value_type>(","); }) {
    option = command.add_option_function<std::vector<std::string>>(
        name, [&value, name](const std::vector<std::string>& given) { read_json(given, name, {}, value); },
        text);
    option->allow_extra_args(false)->type_name(words_or_motion<typename Value::value_type>(","));
    if constexpr (InWords<typename Value::value_type>) option->delimiter(',');
  } else if constexpr (std::same_as<Value, std::vector<std::string>>) {
    option =
        command.add_option(name, value, text)->delimiter(',')->allow_extra_args(false)->type_name("NAME,...");
  } else if constexpr (std::same_as<Value, double> || std::same_as<Value, std::optional<double>>) {
    if constexpr (std::same_as<Value, double>) text += formatted(" [%g]", value);
    option =
        command.add_option(name, value, text)->check(in_range(field.range))->type_name(type_name(field.unit));
  } else {
    option = command.add_option(name, value, text);
  }
  option->group("The question");
}

/// Adds an option for each field but cartilage_mm, which is the joint's --cartilage.
template <Described Request>
void add_request(CLI::App& command, Request& request) {
  for_each_field<Request>([&](const auto& field) {
    if (field.name != "cartilage_mm") add_field(command, field, request);
  });
}

}  // namespace impinge
