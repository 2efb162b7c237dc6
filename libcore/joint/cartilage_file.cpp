// SPDX-License-Identifier: GPL-3.0-or-later
#include "joint/cartilage_file.hpp"

#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "files/file_bytes.hpp"
#include "files/file_error.hpp"
#include "files/finite_number.hpp"

namespace impinge {
namespace {

constexpr std::string_view kHeader = "x,y,z,thickness_mm";
constexpr const char* kMapAdvice =
    "give a CSV with the header x,y,z,thickness_mm and four numbers a line, in mm";

using Row = std::array<double, 4>;

// The four finite numbers of a line; none if it has others.
std::optional<Row> parse_row(std::string_view line) {
  Row row{};
  for (std::size_t k = 0; k < row.size(); ++k) {
    const std::size_t comma = line.find(',');
    const std::string_view word = line.substr(0, comma);
    const std::optional<double> number = finite_number(word);
    if (!number) return std::nullopt;
    row[k] = *number;
    if ((comma == line.npos) != (k + 1 == row.size())) return std::nullopt;
    line.remove_prefix(comma == line.npos ? line.size() : comma + 1);
  }
  return row;
}

}  // namespace

void add_cartilage(const std::array<double, 4>& point, const Vec3& centre, CartilageMap& map) {
  const auto [x, y, z, thickness] = point;
  const Vec3 arm = Vec3(x, y, z) - centre;
  if (!arm.allFinite() || !std::isfinite(thickness)) throw std::invalid_argument("is not four numbers");
  if (thickness < 0.0) throw std::invalid_argument("has a negative thickness");
  if (!(arm.norm() > 0.0))
    throw std::invalid_argument("is a point at the centre of rotation, which has no direction");
  map.directions.push_back(arm.normalized());
  map.thickness.push_back(thickness);
}

CartilageMap read_cartilage(const std::filesystem::path& file, const Vec3& centre) {
  const std::string bytes = read_bytes(file);
  CartilageMap map;
  std::string_view rest = bytes;
  for (std::size_t number = 1; !rest.empty(); ++number) {
    std::string_view line = rest.substr(0, rest.find('\n'));
    rest.remove_prefix(std::min(line.size() + 1, rest.size()));
    if (line.ends_with('\r')) line.remove_suffix(1);
    const auto refuse = [&](const std::string& reason) {
      throw FileError(file, "line " + std::to_string(number) + " " + reason, kMapAdvice);
    };
    if (number == 1) {
      if (line != kHeader) refuse("is not the header of a map of cartilage");
      continue;
    }
    const std::optional<Row> row = parse_row(line);
    if (!row) refuse("is not four numbers");
    try {
      add_cartilage(*row, centre, map);
    } catch (const std::invalid_argument& error) {
      refuse(error.what());
    }
  }
  if (map.directions.empty()) throw FileError(file, "holds no point", kMapAdvice);
  return map;
}

}  // namespace impinge
