// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/vtp_arrays.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include <zlib.h>

#include "files/file_error.hpp"
#include "mesh/number_bytes.hpp"
#include "mesh/text_scan.hpp"

namespace impinge {
namespace {

constexpr std::string_view kVtpEnd = "</VTKFile>";
constexpr std::string_view kAppended = "<AppendedData";
constexpr std::string_view kXmlBlanks = " \t\r\n\v\f";
constexpr std::size_t kMostZlib = 1100;  // one byte never unpacks to more bytes

struct VtpType {
  std::string_view name;
  NumberType type;
};
constexpr std::array<VtpType, 11> kVtpTypes{{{"Int8", {1, false, true}},
                                             {"UInt8", {1, false, false}},
                                             {"Int16", {2, false, true}},
                                             {"UInt16", {2, false, false}},
                                             {"Int32", {4, false, true}},
                                             {"UInt32", {4, false, false}},
                                             {"Int64", {8, false, true}},
                                             {"UInt64", {8, false, false}},
                                             {"Float32", {4, true, true}},
                                             {"Float64", {8, true, true}},
                                             {"String", {1, false, false}}}};

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(kXmlBlanks);
  if (begin == text.npos) return {};
  return text.substr(begin, text.find_last_not_of(kXmlBlanks) + 1 - begin);
}

int sextet(char c) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const std::size_t at = kDigits.find(c);
  return at == kDigits.npos ? -1 : static_cast<int>(at);
}

// The first bytes that the text holds, at most `most`. Text that ends in = may go on, as a header is often
// encoded apart from its data.
std::string from_base64(std::string_view text, std::size_t most) {
  std::string bytes;
  unsigned bits = 0;
  int count = 0;  // of bits
  for (const char c : text) {
    if (bytes.size() == most) break;
    const int six = sextet(c);
    if (six < 0 && c != '=' && kXmlBlanks.find(c) == kXmlBlanks.npos) break;
    if (c == '=') count = 0;
    if (six < 0) continue;
    bits = bits << 6U | static_cast<unsigned>(six);
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes.push_back(static_cast<char>(bits >> count & 0xffU));
  }
  return bytes;
}

// Encoded data of unknown length; only what is asked for is decoded.
struct EncodedBytes {
  std::string_view rest;
  bool in_base64 = false;

  std::optional<std::string> first(std::size_t n) const {
    if (n > rest.size()) return std::nullopt;
    std::string bytes = in_base64 ? from_base64(rest, n) : std::string(rest.substr(0, n));
    return bytes.size() == n ? std::optional(std::move(bytes)) : std::nullopt;
  }
};

// The numbers before data, which are sizes.
class SizeHeader {
 public:
  SizeHeader(const EncodedBytes& from, std::size_t size, bool big_endian)
      : from_(from), type_{size, false, false}, big_endian_(big_endian) {}

  // The first n sizes; std::nullopt if they are missing, or one is larger than any file that is read.
  std::optional<std::vector<std::size_t>> sizes(std::size_t n) const {
    if (n > from_.rest.size()) return std::nullopt;
    const std::optional<std::string> bytes = from_.first(n * type_.size);
    if (!bytes) return std::nullopt;
    std::vector<std::size_t> found;
    for (std::size_t k = 0; k < n; ++k) {
      const double x = number_at(std::string_view(*bytes).substr(k * type_.size), type_, big_endian_);
      if (x > 1e12) return std::nullopt;
      found.push_back(static_cast<std::size_t>(x));
    }
    return found;
  }

 private:
  const EncodedBytes& from_;
  NumberType type_;
  bool big_endian_;
};

bool inflate(std::string_view packed, std::size_t size, std::string& bytes) {
  if (size > kMostZlib * packed.size()) return false;
  const std::size_t begin = bytes.size();
  bytes.resize(begin + size);
  auto length = static_cast<uLongf>(size);
  return uncompress(reinterpret_cast<Bytef*>(bytes.data() + begin), &length,
                    reinterpret_cast<const Bytef*>(packed.data()),
                    static_cast<uLong>(packed.size())) == Z_OK &&
         length == size;
}

// Unpacks data. Before them are the number of blocks, the size of a block, the size of the last one (0: as
// the others), and the packed sizes.
std::optional<std::string> unpacked(const EncodedBytes& data, const SizeHeader& header, std::size_t size) {
  const auto blocks = header.sizes(1);
  if (!blocks) return std::nullopt;
  if (blocks->front() == 0) return "";
  const auto sizes = header.sizes(3 + std::min(blocks->front(), data.rest.size()));
  if (!sizes) return std::nullopt;
  std::size_t begin = sizes->size() * size;
  std::string bytes;
  for (std::size_t k = 3; k < sizes->size(); ++k) {
    if ((*sizes)[k] > data.rest.size()) return std::nullopt;
    begin += (*sizes)[k];
  }
  const std::optional<std::string> all = data.first(begin);
  if (!all) return std::nullopt;
  begin = sizes->size() * size;
  for (std::size_t k = 3; k < sizes->size(); ++k) {
    const bool shorter = k + 1 == sizes->size() && (*sizes)[2] > 0;
    if (!inflate(std::string_view(*all).substr(begin, (*sizes)[k]), (*sizes)[shorter ? 2 : 1], bytes))
      return std::nullopt;
    begin += (*sizes)[k];
  }
  return bytes;
}

}  // namespace

VtpFile::VtpFile(const std::filesystem::path& file, std::string_view bytes) : file_(file) {
  const std::string_view text = trimmed(bytes);
  if (!text.ends_with(kVtpEnd))
    throw FileError(file, "is no VTP file, or cut short: its end is not </VTKFile>",
                    "export or copy it again");
  // Appended data need not be text, so XML is parsed without them.
  const std::size_t tag = std::min(text.find(kAppended), text.size());
  const std::size_t tag_end = text.find('>', tag);
  std::string xml(text.substr(0, std::min(tag_end, text.size())));
  if (tag < text.size()) {
    xml.append("/>").append(kVtpEnd);
    appended_ = text.substr(std::min(text.find('_', tag_end), text.size() - 1) + 1);
  }
  const pugi::xml_parse_result parsed = document_.load_buffer(xml.data(), xml.size());
  if (!parsed) throw_damaged(std::string("is no XML, ") + parsed.description());
  if (!poly_data()) {
    throw FileError(file, "holds no PolyData of VTK",
                    "extract the surface, in ParaView with Extract Surface, and save it as .vtp");
  }
  const std::string_view packer = root().attribute("compressor").value();
  if (!packer.empty() && packer != "vtkZLibDataCompressor")
    throw FileError(file, "is compressed by " + std::string(packer), "save it with ZLib, or uncompressed");
  big_endian_ = root().attribute("byte_order").value() == std::string_view("BigEndian");
  if (root().attribute("header_type").value() == std::string_view("UInt64")) header_size_ = 8;
}

std::vector<double> VtpFile::numbers(pugi::xml_node array) const {
  const std::string name = std::string("its array ") + array.attribute("Name").value();
  std::vector<double> numbers;
  if (array.attribute("format").value() == std::string_view("ascii")) {
    LineScanner lines(array.child_value());
    for (const auto* words = &lines.next_words(); !words->empty(); words = &lines.next_words()) {
      for (const std::string_view word : *words) {
        const std::optional<double> x = to_number(word);
        if (!x) throw_damaged(name + " has a word that is no number");
        numbers.push_back(*x);
      }
    }
    return numbers;
  }
  const std::string_view type = array.attribute("type").value();
  const auto* const known = std::ranges::find(kVtpTypes, type, &VtpType::name);
  if (known == kVtpTypes.end()) throw_damaged(name + " is not there, or of no known type");
  const std::string data = data_of(array);
  const std::size_t size = known->type.size;
  for (std::size_t i = 0; i + size <= data.size(); i += size)
    numbers.push_back(number_at(std::string_view(data).substr(i), known->type, big_endian_));
  return numbers;
}

std::string VtpFile::data_of(pugi::xml_node array) const {
  EncodedBytes data{array.child_value(), true};
  if (array.attribute("format").value() == std::string_view("appended")) {
    const auto offset = array.attribute("offset").as_ullong();
    data.rest = appended_.substr(std::min<unsigned long long>(offset, appended_.size()));
    data.in_base64 = root().child("AppendedData").attribute("encoding").value() != std::string_view("raw");
  }
  const SizeHeader header(data, header_size_, big_endian_);
  std::optional<std::string> bytes;
  if (root().attribute("compressor")) {
    bytes = unpacked(data, header, header_size_);
  } else if (const auto size = header.sizes(1)) {
    bytes = data.first(header_size_ + size->front());
    if (bytes) bytes->erase(0, header_size_);
  }
  if (!bytes) throw_damaged(std::string("its array ") + array.attribute("Name").value() + " is not whole");
  return *bytes;
}

void VtpFile::throw_damaged(const std::string& what) const {
  throw FileError(file_, what + ", it is cut short or damaged", "export or copy it again");
}

}  // namespace impinge
