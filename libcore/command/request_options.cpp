// SPDX-License-Identifier: GPL-3.0-or-later
#include "command/request_options.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "files/finite_number.hpp"

namespace impinge {

std::string option_name(std::string_view field) {
  for (const std::string_view unit : {"_mm", "_deg"})
    if (field.ends_with(unit)) field.remove_suffix(unit.size());
  std::string name = "--" + std::string(field);
  std::replace(name.begin(), name.end(), '_', '-');
  return name;
}

std::string type_name(std::string_view unit) {
  if (unit.empty() || unit == "1") return "NUMBER";
  std::string name(unit);
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return name;
}

CLI::Validator in_range(const Range& range, bool whole) {
  return CLI::Validator(
      [range, whole](const std::string& text) -> std::string {
        const std::optional<double> value = finite_number(text);
        const bool part = whole && value && *value != std::floor(*value);
        if (value && !part && range.has(*value)) return "";
        return "'" + text + "' is " +
               (part    ? "no whole number"
                : value ? "out of range"
                        : "no number") +
               "; give one that is " + describe(range);
      },
      "");
}

Vec3 place_option(const std::string& option, const std::string& text) {
  Vec3 place;
  std::string_view rest = text;
  for (Eigen::Index k = 0; k < 3; ++k) {
    const std::size_t comma = rest.find(',');
    const std::optional<double> value = finite_number(rest.substr(0, comma));
    if ((comma == rest.npos) != (k == 2) || !value)
      throw CLI::ValidationError(option, "'" + text + "' is no place; give three numbers in mm as X,Y,Z");
    place[k] = *value;
    rest.remove_prefix(comma == rest.npos ? rest.size() : comma + 1);
  }
  return place;
}

}  // namespace impinge
