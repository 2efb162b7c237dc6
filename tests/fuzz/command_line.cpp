// SPDX-License-Identifier: GPL-3.0-or-later
// Contract: for any command line, parse_program() returns what will be done, prints a text, or throws
// CommandError with one line that says what to do, or an error of the file that --config names. Words are
// parted by NUL.
#include <cstdint>
#include <sstream>
#include <vector>

#include "command/program.hpp"
#include "fuzz/require.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace impinge;
  using test::require;
  const std::string text(data, data + size);  // ends with a NUL of its own
  std::vector<const char*> words{"impinge"};
  for (std::size_t i = 0; i < text.size();
       i = text.find('\0', i) == text.npos ? text.size() : text.find('\0', i) + 1)
    words.push_back(text.data() + i);
  std::ostringstream out;
  std::ostringstream log;
  try {
    const bool printed = !parse_program(static_cast<int>(words.size()), words.data(), {out, log});
    require(!printed || out.str().find("impinge") != std::string::npos, "a text names the program",
            out.str());
    require(log.str().empty(), "nothing is wrong", log.str());
  } catch (const CommandError& error) {
    test::require_one_line(error.what());
    require(std::string(error.what()).find("; ") != std::string::npos, "what to do is said", error.what());
    require(out.str().empty(), "nothing is printed", out.str());
  } catch (const std::runtime_error& error) {
    test::require_one_line(error.what());
  }
  return 0;
}
