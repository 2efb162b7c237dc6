// SPDX-License-Identifier: GPL-3.0-or-later
// The same sources at other levels of optimisation and with other vector instructions: programs of their own,
// built by ../compilers/CMakeLists.txt, that print digests of the same tables.
#include <array>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <vector>

#include "stress/compilers/programs.hpp"
#include "stress/family.hpp"

namespace impinge::lab {
namespace {

// Lines that a program prints.
std::vector<std::string> output_of(const std::string& program) {
  std::FILE* pipe = ::popen(("'" + program + "'").c_str(), "r");
  if (pipe == nullptr) throw std::runtime_error("cannot run " + program);
  std::vector<std::string> lines;
  std::array<char, 256> line{};
  while (std::fgets(line.data(), static_cast<int>(line.size()), pipe) != nullptr)
    lines.emplace_back(line.data());
  if (::pclose(pipe) != 0 || lines.empty()) throw std::runtime_error(program + " failed");
  return lines;
}

std::vector<StabilityCase> run_simd_and_compiler(const StabilityRun& /*options*/) {
  const std::vector<std::string> expected = output_of(std::string(kDigestPrograms.front().path));
  std::vector<StabilityCase> rows;
  for (const DigestProgram& program : kDigestPrograms) {
    const std::vector<std::string> lines = output_of(std::string(program.path));
    for (std::size_t k = 0; k < expected.size(); ++k) {
      StabilityCase row;
      row.magnitude = program.level;
      row.method = expected[k].substr(0, expected[k].find(' '));
      row.kind = "ours";
      row.threshold = 0.0;
      row.questions = 1;
      row.condition = 1.0;
      row.wrong = lines.size() == expected.size() && lines[k] == expected[k] ? 0 : 1;
      row.error_over_condition_u = static_cast<double>(row.wrong);
      rows.push_back(row);
    }
  }
  return rows;
}

}  // namespace

StabilityFamily simd_and_compiler_family() {
  StabilityFamily family;
  family.name = "simd_and_compiler";
  family.parameter = "-O0, -O1, -O2, -O3 as 0 to 3; 4 is -O3 with all vector instructions of this processor";
  family.unit = "-O";
  family.expected =
      "tables, look-ups and exact decisions are the same bit for bit: nothing is contracted to fused "
      "multiply-add and "
      "nothing reassociated";
  family.threshold = 0.0;
  family.derivation = "IEEE 754 rounds each operation in one way";
  family.run = run_simd_and_compiler;
  return family;
}

}  // namespace impinge::lab
