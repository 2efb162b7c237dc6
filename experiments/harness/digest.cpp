// SPDX-License-Identifier: GPL-3.0-or-later
#include "harness/digest.hpp"

#include <array>
#include <stdexcept>

#include <openssl/evp.h>

#include "files/file_bytes.hpp"

namespace impinge::lab {

std::string sha256_hex(std::string_view bytes) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned int length = 0;
  if (EVP_Digest(bytes.data(), bytes.size(), digest.data(), &length, EVP_sha256(), nullptr) != 1) {
    throw std::runtime_error("SHA-256 is not available in this build of OpenSSL");
  }
  constexpr std::string_view kHex = "0123456789abcdef";
  std::string text;
  for (unsigned int i = 0; i < length; ++i) {
    text += kHex[digest[i] >> 4U];
    text += kHex[digest[i] & 15U];
  }
  return text;
}

std::string sha256_of_file(const std::filesystem::path& path) { return sha256_hex(read_bytes(path)); }

}  // namespace impinge::lab
