// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>
#include <utility>
#include <vector>

#include "command/question_command.hpp"
#include "files/delimited.hpp"
#include "files/finite_number.hpp"
#include "report/answer_document.hpp"
#include "report/svg.hpp"

namespace impinge {
namespace {

std::string element(const char* indent, const char* tag, std::string_view text) {
  return std::string(indent) + "<" + tag + ">" + escaped(text) + "</" + tag + ">\n";
}

// Turns "--keep" into "Keep", "--ball-part" into "Ball part"; "BALL" stays.
std::string label_of(const CLI::Option& option) {
  std::string label = option.get_positional() ? option.get_name() : option.get_lnames().front();
  std::replace(label.begin(), label.end(), '-', ' ');
  label[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(label[0])));
  return label;
}

// What stands in [] at the end of a text, if it is a value and no sentence.
std::string default_of(const std::string& text) {
  if (text.empty() || text.back() != ']') return "";
  const std::size_t begin = text.rfind('[') + 1;
  const std::string value = text.substr(begin, text.size() - 1 - begin);
  return value.find(' ') == value.npos ? value : "";
}

// The tag with its attributes, what the value is, and the words of an enumeration.
struct Kind {
  std::string tag;
  std::string attributes{};
  std::string value{};
  bool input_file = false;
  std::vector<std::string> words{};
};

// Only a number with a default gets a field for numbers, since Slicer always passes such a field.
Kind kind_of(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  const std::string value = default_of(option.get_description());
  const bool bone =
      option.get_positional() || option.check_lname("ball-part") || option.check_lname("socket-part");
  if (option.get_items_expected_max() == 0) return {.tag = "boolean", .value = "false"};
  if (option.check_lname("landmarks"))
    return {.tag = "pointfile",
            .attributes = " fileExtensions=\".mrk.json,.fcsv\" coordinateSystem=\"lps\"",
            .input_file = true};
  if (bone) return {.tag = "geometry", .attributes = " fileExtensions=\".ply\"", .input_file = true};
  if (type == "FILE" || option.check_lname("poses")) return {.tag = "file", .input_file = true};
  if (type == "DIR") return {.tag = "directory"};
  const std::vector<std::string_view> words = delimited_words(type, '|');
  const bool lower =
      std::none_of(type.begin(), type.end(), [](unsigned char c) { return std::isupper(c) != 0; });
  if (words.size() > 1 && lower) {
    std::vector<std::string> choices(words.begin(), words.end());
    if (std::find(words.begin(), words.end(), value) == words.end()) choices.insert(choices.begin(), "");
    return {.tag = "string-enumeration", .value = value, .words = std::move(choices)};
  }
  if (finite_number(value) && type.find('|') == type.npos) return {.tag = "double", .value = value};
  return {.tag = "string", .value = value == "all" || value == "none" ? "" : value};
}

std::string parameter_of(const CLI::Option& option, std::size_t& index) {
  constexpr const char* kIndent = "      ";
  const Kind kind = kind_of(option);
  std::string name = option.get_positional() ? option.get_name() : option.get_lnames().front();
  std::replace(name.begin(), name.end(), '-', '_');
  std::string xml = "    <" + kind.tag + kind.attributes + ">\n" + element(kIndent, "name", name);
  xml += option.get_positional() ? element(kIndent, "index", std::to_string(index++))
                                 : element(kIndent, "longflag", name);
  xml +=
      element(kIndent, "description", option.get_description()) + element(kIndent, "label", label_of(option));
  if (!kind.value.empty() || !kind.words.empty()) xml += element(kIndent, "default", kind.value);
  if (kind.input_file) xml += element(kIndent, "channel", "input");
  for (const std::string& word : kind.words) xml += element(kIndent, "element", word);
  return xml + "    </" + kind.tag + ">\n";
}

// False for options that print and end, take many joints, or are set by the script.
bool is_for_windows(const CLI::Option& option) {
  constexpr std::array<const char*, 7> kNot{"help",  "json",   "schema",     "xml",
                                            "quiet", "joints", "mesh-format"};
  return std::none_of(kNot.begin(), kNot.end(), [&](const char* name) { return option.check_lname(name); });
}

}  // namespace

std::string slicer_module(const CLI::App& command) {
  std::string title = command.get_name();
  title[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(title[0])));
  std::string xml = "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<executable>\n";
  xml += element("  ", "category", "Impingement") + element("  ", "title", "Impinge " + title);
  xml += element("  ", "description", command.get_description()) + element("  ", "version", kVersion);
  xml += element("  ", "documentation-url", "") + element("  ", "license", "GPL-3.0-or-later");
  xml += element("  ", "contributor", "impinge");
  std::size_t index = 0;
  for (const auto& [group, label] :
       {std::pair{"Positionals", "The bones"}, std::pair{"The question", "The question"},
        std::pair{"The joint", "The joint"}, std::pair{"The answer", "The answer"}}) {
    std::string parameters;
    for (const CLI::Option* option : command.get_options()) {
      const std::string of = option->get_positional() ? "Positionals" : option->get_group();
      if (of == group && is_for_windows(*option)) parameters += parameter_of(*option, index);
    }
    if (parameters.empty()) continue;
    xml += "  <parameters>\n" + element("    ", "label", label) + element("    ", "description", label) +
           parameters + "  </parameters>\n";
  }
  return xml + "</executable>\n";
}

}  // namespace impinge
