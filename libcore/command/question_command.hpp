// SPDX-License-Identifier: GPL-3.0-or-later
// A question about a joint as a command: options fill the request; the answer becomes words and files.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include "command/request_options.hpp"
#include "files/csv.hpp"
#include "files/fields.hpp"
#include "files/stopwatch.hpp"
#include "files/temporary_file.hpp"
#include "joint/document.hpp"
#include "joint/session.hpp"
#include "joint/touch.hpp"
#include "mesh/mesh_format.hpp"
#include "report/answer_document.hpp"

namespace impinge {

/// What a question may use while it works.
struct Work {
  std::optional<std::filesystem::path> out{};  // an existing folder; none: nothing is written
  std::size_t threads = 1;
  std::ostream* log = nullptr;                  // for warnings and progress
  bool quiet = false;                           // no progress
  std::vector<std::filesystem::path> inputs{};  // outputs never replace them
  MeshFormat mesh_format = MeshFormat::ply;     // format of written meshes

  /// Prints a line of progress.
  void say(const std::string& line) const;
  /// Prints a line about what looks wrong.
  void warn(const std::string& line) const;
  /// The path of a file in `out`. Throws std::runtime_error if it is an input.
  std::filesystem::path output(const std::string& name) const;
  /// The file name of a mesh.
  std::string mesh_file(const std::string& stem) const;
};

/// An answer in all its forms. A question fills what it has.
struct Told {
  std::string words{};                                  // lines for a terminal
  Json document{};                                      // of the answer
  std::vector<AnswerFile> files{};                      // beside summary.json; written together
  std::vector<std::shared_ptr<TemporaryFile>> wrote{};  // during the work; put in place with `files`
  std::vector<std::filesystem::path> spent{};  // of an interrupted run; removed once the answer is in place
  std::string table_name{};                    // such as "limits.csv"; empty: it has none
  Table table{};                               // rows of that file, without the column `joint`
  /// The joint's row of joints.csv (--joints), if there is no table: columns, and the places of their values
  /// in the document (JSON pointers).
  std::vector<std::pair<std::string, std::string>> row_of_one{};
};

/// The folder of an answer. It is made if missing, and removed again if it stays empty.
class AnswerFolder {
 public:
  /// Throws FileError if no file can be written there.
  explicit AnswerFolder(std::filesystem::path folder);
  AnswerFolder(const AnswerFolder&) = delete;
  AnswerFolder& operator=(const AnswerFolder&) = delete;
  ~AnswerFolder();

  /// Writes the files and the document as summary.json, which lists them; either all are written or none.
  /// Returns the files of an earlier answer that are still there. Throws std::runtime_error if a file would
  /// replace an input.
  std::vector<std::string> write(Told& told, const Work& work);

  const std::filesystem::path& path() const { return folder_; }

 private:
  std::filesystem::path folder_;
  std::filesystem::path there_;  // the nearest folder that existed before
};

/// A command that asks one question of a joint.
struct QuestionCommand {
  std::string name;                              // name of the command
  std::string text;                              // its help, one sentence
  std::string example;                           // what follows "impinge NAME"
  std::function<void(CLI::App&)> add_options{};  // adds those of the request
  std::vector<const char*> without{};            // options of the joint that it does not take
  bool takes_map = false;                        // does it take a map of the cartilage?
  bool writes_meshes = false;                    // does it write meshes in a format that can be chosen?
  std::function<void(std::optional<double> cartilage_mm)>
      use_cartilage{};  // of none the request's own; left out by questions about bones alone
  std::function<bool()> uses_cartilage{};              // does what is asked depend on it?
  std::function<ScanContactOptions()> scan_contact{};  // which contact as scanned deserves a warning
  std::function<void()> check{};    // throws std::invalid_argument if options exclude each other
  std::function<Json()> request{};  // the request as JSON
  std::function<std::vector<std::filesystem::path>()> files{};  // files that the request names
  std::function<Told(Session&, const Work&)> ask{};  // throws std::exception, one line, without an answer
  Json request_schema = Json::object();
  Json answer_schema = Json::object();
};

/// If a request has a gap that counts as contact, this has its size and the option that gave it.
template <class Request>
ScanContactOptions scan_contact_of(const Request& request) {
  ScanContactOptions told{.overlap = "--ignore-rest-contact"};
  if constexpr (requires { request.threshold_mm(); }) {
    told.threshold_mm = request.threshold_mm();
    told.threshold = Request::kThresholdOption;
  }
  if constexpr (requires { request.rim; }) told.rim = request.rim;
  return told;
}

/// The files that a request names.
template <Described Request>
std::vector<std::filesystem::path> files_of(const Request& request) {
  std::vector<std::filesystem::path> files;
  for_each_field<Request>([&]<class Get>(const Field<Get>& field) {
    if constexpr (std::same_as<ValueOf<Request, Get>, std::optional<std::filesystem::path>>)
      if (field.of(request)) files.push_back(*field.of(request));
  });
  return files;
}

/// The question of a `Request`. `told(session, request, work)` gives all forms of the `Answer`.
template <Described Request, Described Answer>
QuestionCommand question_of(std::string name, std::string text, std::string example,
                            Told (*told)(Session&, const Request&, const Work&)) {
  const auto request = std::make_shared<Request>();
  QuestionCommand made{.name = std::move(name), .text = std::move(text), .example = std::move(example)};
  made.add_options = [request](CLI::App& command) { add_request(command, *request); };
  if constexpr (requires { request->cartilage_mm; })
    made.use_cartilage = [request](std::optional<double> cartilage_mm) {
      request->cartilage_mm = Request().cartilage_mm;
      if (cartilage_mm) request->cartilage_mm = *cartilage_mm;
    };
  else
    made.without.push_back("--cartilage");
  made.uses_cartilage = [request] {
    if constexpr (requires { request->uses_cartilage(); }) return request->uses_cartilage();
    return requires { request->cartilage_mm; };
  };
  made.scan_contact = [request] { return scan_contact_of(*request); };
  made.check = [request] {
    if constexpr (requires { request->check(); }) request->check();
  };
  made.request = [request] { return json_of(*request); };
  made.files = [request] { return files_of(*request); };
  made.ask = [request, told](Session& session, const Work& work) { return told(session, *request, work); };
  made.request_schema = schema_of<Request>();
  made.answer_schema = schema_of<Answer>();
  return made;
}

/// The description of a question's command in the XML of the execution model of 3D Slicer: a panel for each
/// group of options and a parameter for each option that a window can set. CTK's schema wants _ for - in
/// flags.
std::string slicer_module(const CLI::App& command);

/// All questions, each in a file of its own.
QuestionCommand gaps_question();
QuestionCommand poses_question();
QuestionCommand touch_question();
QuestionCommand limits_question();
struct LimitsAnswer;
/// A line for a terminal: where the centre is, and of a fitted one the sphere.
std::string describe_centre(const Joint& joint);
/// Lines for a terminal: for one motion each limit and what it depends on, for several a table.
std::string describe(const LimitsAnswer& found);
QuestionCommand certify_question();
QuestionCommand measure_question();
QuestionCommand volume_question();
QuestionCommand orient_question();
QuestionCommand resect_question();
QuestionCommand report_question();

}  // namespace impinge
