// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/ply_values.hpp"

#include <bit>
#include <cstdint>

#include "mesh/text_scan.hpp"

namespace impinge {
namespace {

class AsciiValues : public PlyValues {
 public:
  explicit AsciiValues(std::string_view body) : lines_(body) {}
  void next_record() override {
    words_ = &lines_.next_words();
    used_ = 0;
  }
  std::optional<double> next(PlyType) override {
    return used_ < words_->size() ? to_number((*words_)[used_++]) : std::nullopt;
  }

 private:
  LineScanner lines_;
  const std::vector<std::string_view>* words_ = nullptr;
  std::size_t used_ = 0;
};

class BinaryValues : public PlyValues {
 public:
  BinaryValues(std::string_view body, bool big_endian) : rest_(body), big_endian_(big_endian) {}
  void next_record() override {}
  std::optional<double> next(PlyType type) override {
    if (rest_.size() < type.size) return std::nullopt;
    std::uint64_t bits = 0;
    for (std::size_t k = 0; k < type.size; ++k) {
      const auto byte = static_cast<unsigned char>(rest_[big_endian_ ? k : type.size - 1 - k]);
      bits = bits << 8U | byte;
    }
    rest_.remove_prefix(type.size);
    return decode(bits, type);
  }

 private:
  static double decode(std::uint64_t bits, PlyType type) {
    if (type.size == 8) return std::bit_cast<double>(bits);
    if (type.floating) return static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)));
    const auto value = static_cast<double>(bits);
    const double range = static_cast<double>(std::uint64_t{1} << (8 * type.size));
    return type.is_signed && value >= range / 2 ? value - range : value;
  }

  std::string_view rest_;
  bool big_endian_;
};

}  // namespace

std::unique_ptr<PlyValues> ply_values(const PlyHeader& header) {
  if (header.format == PlyFormat::ascii) return std::make_unique<AsciiValues>(header.body);
  return std::make_unique<BinaryValues>(header.body, header.format == PlyFormat::big_endian);
}

}  // namespace impinge
