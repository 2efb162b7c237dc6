// SPDX-License-Identifier: GPL-3.0-or-later
#include "harness/event_counts.hpp"

#include <cstdlib>
#include <map>
#include <sstream>
#include <stdexcept>

#include "files/file_bytes.hpp"
#include "harness/shell.hpp"

namespace impinge::lab {
namespace {

constexpr std::string_view kTrigger = "desc: Trigger: Client Request: ";
// Threads apart: idle workers of a library would be counted by chance.
constexpr const char* kOptions =
    "--tool=callgrind --separate-threads=yes --instr-atstart=no --cache-sim=yes --I1=32768,8,64 "
    "--D1=32768,8,64 --LL=1048576,16,64";

// What follows the word at the beginning of a line; nothing where no line begins so.
std::string line_after(std::string_view text, std::string_view word) {
  const std::size_t at = ("\n" + std::string(text)).find("\n" + std::string(word));
  if (at == std::string_view::npos) return {};
  const std::size_t from = at + word.size();
  return std::string(text.substr(from, text.find('\n', from) - from));
}

// A folder of its own, gone at the end.
class DumpFolder {
 public:
  explicit DumpFolder(const std::filesystem::path& parent) {
    std::string name = (parent / "callgrind-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr)
      throw std::runtime_error(parent.string() + ": no folder can be made in it: make it writable");
    path_ = name;
  }
  DumpFolder(const DumpFolder&) = delete;
  DumpFolder& operator=(const DumpFolder&) = delete;
  ~DumpFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace

EventCounts parse_event_counts(std::string_view dump) {
  EventCounts counts;
  counts.label = line_after(dump, kTrigger);
  std::istringstream names(line_after(dump, "events: "));
  std::istringstream numbers(line_after(dump, "summary: "));
  std::map<std::string, double> events;
  // Callgrind leaves out zeros at the end of a line.
  for (std::string name; names >> name;)
    if (double number = 0.0; numbers >> number || !events.empty()) events[name] = number;
  if (counts.label.empty() || !events.contains("Ir") || !events.contains("DLmw"))
    throw std::runtime_error(
        "this is no dump of callgrind's that a program asked for: run it by count_events()");
  counts.instructions = events["Ir"];
  counts.first_misses = events["D1mr"] + events["D1mw"];
  counts.second_misses = events["DLmr"] + events["DLmw"];
  return counts;
}

std::vector<EventCounts> count_events(const std::vector<std::string>& words,
                                      const std::filesystem::path& folder) {
  if (std::system("valgrind --version >/dev/null 2>&1") != 0)
    throw std::runtime_error("valgrind does not run: install the package valgrind");
  const DumpFolder dumps(folder);
  const std::filesystem::path dump = dumps.path() / "dump";
  std::string command = std::string("valgrind ") + kOptions +
                        " --log-file=" + shell_quoted((dumps.path() / "log").string()) +
                        " --callgrind-out-file=" + shell_quoted(dump.string());
  for (const std::string& word : words) command += " " + shell_quoted(word);
  if (std::system(command.c_str()) != 0)
    throw std::runtime_error(words.front() + " failed under valgrind: see its message above");
  std::vector<EventCounts> counts;
  const auto of_first_thread = [&dump](int k) { return dump.string() + "." + std::to_string(k) + "-01"; };
  for (int k = 1; std::filesystem::exists(of_first_thread(k)); ++k)
    counts.push_back(parse_event_counts(read_bytes(of_first_thread(k))));
  return counts;
}

}  // namespace impinge::lab
