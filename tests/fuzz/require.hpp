// SPDX-License-Identifier: GPL-3.0-or-later
// What a fuzz target asserts.
#pragma once

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

namespace impinge::test {

// Ends the program where the contract is broken: libFuzzer keeps the input.
inline void require(bool holds, std::string_view contract, const std::string& found = "") {
  if (holds) return;
  std::fprintf(stderr, "broken contract: %s\n%s\n", std::string(contract).c_str(), found.c_str());
  std::abort();
}

inline void require_one_line(const std::string& message) {
  require(std::ranges::none_of(message, [](unsigned char c) { return c < 0x20 || c == 0x7f; }),
          "a message is one line", message);
}

// "WHAT: reason; advice" in one line.
inline void require_message(const std::string& message, std::string_view start) {
  require(message.starts_with(start), "a message names what it is about", message);
  require(message.find("; ") != std::string::npos, "a message says what to do", message);
  require_one_line(message);
}

}  // namespace impinge::test
