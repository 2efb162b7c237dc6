// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/number_bytes.hpp"

#include <bit>
#include <cstdint>

namespace impinge {

double number_at(std::string_view bytes, NumberType type, bool big_endian) {
  std::uint64_t bits = 0;
  for (std::size_t k = 0; k < type.size; ++k)
    bits = bits << 8U | static_cast<unsigned char>(bytes[big_endian ? k : type.size - 1 - k]);
  if (type.floating && type.size == 8) return std::bit_cast<double>(bits);
  if (type.floating) return static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)));
  const std::size_t above = 64 - 8 * type.size;  // shifted there and back, the sign fills it
  if (type.is_signed) return static_cast<double>(static_cast<std::int64_t>(bits << above) >> above);
  return static_cast<double>(bits);
}

}  // namespace impinge
