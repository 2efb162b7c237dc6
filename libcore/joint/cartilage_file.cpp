// SPDX-License-Identifier: GPL-3.0-or-later
#include "joint/cartilage_file.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "files/delimited.hpp"
#include "files/file_bytes.hpp"
#include "files/file_error.hpp"
#include "files/finite_number.hpp"

namespace impinge {
namespace {

constexpr const char* kMapAdvice =
    "give a CSV with the header x,y,z,thickness_mm and four numbers a line, in mm";

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
  NumberedLines lines(bytes);
  CartilageMap map;
  const auto refuse = [&](const std::string& reason) {
    throw FileError(file, "line " + std::to_string(lines.number()) + " " + reason, kMapAdvice);
  };
  if (!lines.next() || lines.line() != "x,y,z,thickness_mm")
    refuse("is not the header of a map of cartilage");
  while (lines.next()) {
    const std::vector<std::string_view> words = delimited_words(lines.line(), ',');
    std::array<double, 4> point{};
    if (words.size() != point.size()) refuse("is not four numbers");
    for (std::size_t k = 0; k < point.size(); ++k)
      point[k] = finite_number(words[k]).value_or(std::numeric_limits<double>::quiet_NaN());
    try {
      add_cartilage(point, centre, map);
    } catch (const std::invalid_argument& error) {
      refuse(error.what());
    }
  }
  if (map.directions.empty()) throw FileError(file, "holds no point", kMapAdvice);
  return map;
}

}  // namespace impinge
