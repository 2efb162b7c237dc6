// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/ply_values.hpp"

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
  std::optional<double> next(NumberType) override {
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
  std::optional<double> next(NumberType type) override {
    if (rest_.size() < type.size) return std::nullopt;
    const double x = number_at(rest_, type, big_endian_);
    rest_.remove_prefix(type.size);
    return x;
  }

 private:
  std::string_view rest_;
  bool big_endian_;
};

}  // namespace

std::unique_ptr<PlyValues> ply_values(const PlyHeader& header) {
  if (header.format == PlyFormat::ascii) return std::make_unique<AsciiValues>(header.body);
  return std::make_unique<BinaryValues>(header.body, header.format == PlyFormat::big_endian);
}

}  // namespace impinge
