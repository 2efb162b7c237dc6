// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <exception>
#include <stdexcept>
#include <system_error>

#include "command/question_command.hpp"
#include "files/file_bytes.hpp"
#include "files/file_set.hpp"

namespace impinge {
namespace {

namespace fs = std::filesystem;

constexpr const char* kSummary = "summary.json";

fs::path without_slash(const fs::path& folder) {
  const fs::path whole = fs::absolute(folder).lexically_normal();
  return whole.has_filename() ? whole : whole.parent_path();
}

// The nearest existing folder at or above this one.
fs::path existing(const fs::path& of) {
  std::error_code unreadable;
  fs::path folder = without_slash(of);
  while (!fs::exists(folder, unreadable)) folder = folder.parent_path();
  return folder;
}

// Removes empty folders, from this one up to one that existed before.
void remove_empty(const fs::path& of, const fs::path& there) {
  std::error_code kept;
  fs::path folder = without_slash(of);
  while (folder != there && fs::remove(folder, kept)) folder = folder.parent_path();
}

// The files that an earlier summary lists, and those that an interrupted question kept.
std::vector<std::string> files_of_earlier(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code unreadable;
  for (const fs::directory_entry& file : fs::directory_iterator(folder, unreadable))
    if (file.path().extension() == ".part") names.push_back(file.path().filename().string());
  if (!fs::is_regular_file(folder / kSummary, unreadable) || fs::is_empty(folder / kSummary, unreadable))
    return names;
  const Json said = Json::parse(read_bytes(folder / kSummary), nullptr, /*allow_exceptions=*/false);
  if (!said.is_object() || !said.contains("files") || !said["files"].is_array()) return names;
  for (const Json& name : said["files"])
    if (name.is_string()) names.push_back(name.get<std::string>());
  return names;
}

}  // namespace

fs::path Work::output(const std::string& name) const {
  fs::path file = out.value() / name;
  std::error_code not_there;
  for (const fs::path& input : inputs) {
    if (fs::equivalent(input, file, not_there))
      throw std::runtime_error(input.string() +
                               ": would be replaced by the output; choose another folder with --out");
  }
  return file;
}

std::string Work::mesh_file(const std::string& stem) const {
  return stem + '.' + std::string(word_of(mesh_format));
}

AnswerFolder::AnswerFolder(fs::path folder) : folder_(std::move(folder)), there_(existing(folder_)) {
  try {
    require_writable_folder(folder_);
  } catch (...) {
    remove_empty(folder_, there_);
    throw;
  }
}

AnswerFolder::~AnswerFolder() {
  try {
    remove_empty(folder_, there_);
  } catch (const std::exception&) {  // an empty folder stays
    return;
  }
}

std::vector<std::string> AnswerFolder::write(Told& told, const Work& work) {
  std::vector<std::string> names;
  for (const auto& file : told.wrote) names.push_back(file->target().filename().string());
  for (const AnswerFile& file : told.files) names.push_back(file.name);
  names.emplace_back(kSummary);
  for (const std::string& name : names) work.output(name);
  const std::vector<std::string> earlier = files_of_earlier(folder_);
  told.document["files"] = names;
  FileSet files;
  for (const auto& file : told.wrote) files.add(file);
  for (const AnswerFile& file : told.files) files.add(folder_ / file.name, file.bytes);
  files.add(folder_ / kSummary, text_of(told.document));
  files.commit();
  std::error_code unreadable;
  for (const fs::path& file : told.spent) fs::remove(file, unreadable);
  std::vector<std::string> older;
  for (const std::string& name : earlier) {
    if (std::find(names.begin(), names.end(), name) == names.end() && fs::exists(folder_ / name, unreadable))
      older.push_back(name);
  }
  return older;
}

}  // namespace impinge
