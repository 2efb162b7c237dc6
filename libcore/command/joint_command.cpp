// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <memory>
#include <new>
#include <thread>
#include <utility>

#include "command/joint_options.hpp"
#include "command/program.hpp"
#include "command/question_command.hpp"
#include "files/file_error.hpp"
#include "files/joined.hpp"
#include "files/one_line.hpp"
#include "joint/rest_contact.hpp"

namespace impinge {
namespace {

namespace fs = std::filesystem;

// What every question takes besides its own options.
struct JointCommand {
  QuestionCommand question;
  JointOptions joint;
  fs::path joints;  // a folder of joints, instead of a single one
  fs::path out;
  bool json = false;
  bool schema = false;
  bool xml = false;
  const CLI::App* app = nullptr;
  Work work{.threads = std::max(1U, std::thread::hardware_concurrency())};
};

Json document_schema(const QuestionCommand& question) {
  Json schema{{"$schema", "https://json-schema.org/draft/2020-12/schema"},
              {"title", "impinge " + question.name},
              {"description", question.text}};
  Json properties{{"program", {{"const", "impinge"}}},
                  {"version", {{"type", "string"}}},
                  {"commit", {{"type", "string"}}},
                  {"command", {{"const", question.name}}},
                  {"schema", {{"type", "string"}}},
                  {"joint", schema_of<JointDocument>()},
                  {"request", question.request_schema},
                  {"answer", question.answer_schema},
                  {"times_ms", {{"type", "object"}, {"additionalProperties", {{"type", "number"}}}}},
                  {"files", {{"type", "array"}, {"items", {{"type", "string"}}}}}};
  schema.update(object_schema(std::move(properties)));
  return schema;
}

// Reads a joint and asks the question. The document of what is told is that of summary.json.
Told ask(const JointCommand& command, const JointOptions& options, const Work& work, const Screen& screen) {
  Stopwatch watch;
  const QuestionCommand& question = command.question;
  // As if no joint had been before it; the scan's own thickness is found once the joint is there.
  if (question.use_cartilage) question.use_cartilage(options.cartilage_of_scan ? 0.0 : options.cartilage_mm);
  Session session = load_joint(options, question.scan_contact());
  if ((options.cartilage_mm || options.cartilage_of_scan) && !question.uses_cartilage())
    session.joint->joint.warnings.emplace_back(
        "the thickness of cartilage is left out: this answer is about bones alone; gaps, limits, report and "
        "the areas of poses use it");
  std::string said = describe_joint(options, session.joint->joint);
  if (options.cartilage_of_scan) {
    const double thickness = cartilage_of_scan(*session.joint, "--cartilage scan");
    question.use_cartilage(thickness);
    said += formatted("cartilage           %g mm, the smallest gap as scanned\n", thickness);
  }
  const double read_ms = watch.lap_ms();
  if (!command.json) screen.out << said << std::flush;
  for (const std::string& warning : session.joint->joint.warnings) work.warn(warning);
  Told told = question.ask(session, work);
  told.document =
      document_of(question.name, json_of(describe(*session.joint, names_of(options))), question.request(),
                  std::move(told.document), {{"read", read_ms}, {"answer", watch.lap_ms()}});
  return told;
}

void add_rows(const std::string& joint, const Table& rows, Table& table) {
  if (table.columns.empty()) {
    table.columns = rows.columns;
    table.columns.insert(table.columns.begin(), {"joint", "", "its folder, or empty"});
  }
  for (std::vector<Cell> row : rows.rows) {
    row.insert(row.begin(), Cell(joint));
    table.add_row(std::move(row));
  }
}

Cell cell_at(const Json& document, const std::string& pointer) {
  const Json::json_pointer at(pointer);
  if (!document.contains(at)) return {};
  const Json& value = document[at];
  if (value.is_boolean()) return value.get<bool>();
  if (value.is_number_integer()) return value.get<std::int64_t>();
  if (value.is_number()) return value.get<double>();
  return value.is_string() ? Cell(value.get<std::string>()) : Cell();
}

Table row_of_one(const Told& told) {
  Table table;
  std::vector<Cell> row;
  for (const auto& [column, at] : told.row_of_one) {
    table.columns.push_back({column, "", ""});
    row.push_back(cell_at(told.document["answer"], at));
  }
  table.add_row(std::move(row));
  return table;
}

std::string listed(const std::vector<std::string>& names) {
  return names.size() > 1 ? "{" + joined(names, ",") + "}" : names.front();
}

void add_table(Told& told) {
  if (told.table_name.empty()) return;
  Table table;
  add_rows("", told.table, table);
  told.files.push_back({told.table_name, to_csv(table)});
}

// `older` are files of an earlier answer.
void tell_written(const Told& told, const std::vector<std::string>& older, const JointCommand& command,
                  const Screen& screen) {
  const std::string folder = command.out.string() + "/";
  if (!command.json)
    screen.out << "wrote               " << folder << listed(told.document["files"]) << std::endl;
  if (!older.empty())
    command.work.warn(folder + listed(older) +
                      " is left from an earlier command: it says nothing about this one");
}

std::vector<fs::path> inputs_of(const JointCommand& command, const JointOptions& options) {
  std::vector<fs::path> files = files_of(options);
  for (fs::path& file : command.question.files()) files.push_back(std::move(file));
  return files;
}

void run_one(const JointCommand& command, const Screen& screen) {
  Work work = command.work;
  std::unique_ptr<AnswerFolder> folder;
  if (!command.out.empty()) {
    folder = std::make_unique<AnswerFolder>(command.out);
    work.out = command.out;
  }
  work.inputs = inputs_of(command, command.joint);
  Told told = ask(command, command.joint, work, screen);
  add_table(told);
  std::vector<std::string> older;
  if (folder) older = folder->write(told, work);
  screen.out << (command.json ? text_of(told.document) : told.words);
  if (folder) tell_written(told, older, command, screen);
}

// What is given for all joints takes precedence over a joint's own description.
JointOptions options_of(const JointCommand& command, const JointFolder& at) {
  JointOptions options = command.joint;
  options.ball = at.ball;
  options.socket = at.socket;
  use_description(*command.app, at, options);
  return options;
}

// A later command would take the answers in there for joints.
void require_elsewhere(const fs::path& out, const fs::path& joints) {
  const fs::path inner = fs::weakly_canonical(out);
  const fs::path outer = fs::canonical(joints);
  if (std::mismatch(outer.begin(), outer.end(), inner.begin(), inner.end()).first == outer.end())
    throw FileError(out, "lies in the folder of the joints, as if its meshes were joints",
                    "choose another folder with --out");
}

// Asks each joint in a folder of its own, and writes a table of them all.
void run_all(const JointCommand& command, const Screen& screen) {
  const JointFolders folders = find_joints(command.joints);
  require_elsewhere(command.out, command.joints);
  Work work = command.work;
  Table table;
  Json documents = Json::array();
  std::vector<std::string> left_out = folders.left_out;
  std::string table_name = "joints.csv";
  for (const JointFolder& at : folders.joints) {
    work.say("joint " + std::to_string(&at - folders.joints.data() + 1) + " of " +
             std::to_string(folders.joints.size()) + ", " + at.subject);
    try {
      AnswerFolder folder(command.out / at.subject);
      work.out = folder.path();
      const JointOptions options = options_of(command, at);
      work.inputs = inputs_of(command, options);
      Told told = ask(command, options, work, screen);
      if (!told.table_name.empty()) table_name = told.table_name;
      add_rows(at.subject, told.table_name.empty() ? row_of_one(told) : told.table, table);
      add_table(told);
      folder.write(told, work);
      documents.push_back(std::move(told.document));
    } catch (const std::exception& error) {
      const bool memory = dynamic_cast<const std::bad_alloc*>(&error) != nullptr;
      std::string what = memory ? kNoMemory : one_line(error.what());
      const std::string where = at.ball.parent_path().string();
      if (what.find(where) == what.npos) what.insert(0, where + ": ");
      left_out.push_back(std::move(what));
    }
  }
  for (const std::string& reason : left_out) work.warn("left out: " + reason);
  if (documents.empty())
    throw std::runtime_error(command.joints.string() +
                             ": none of its joints could be used; see the lines above");
  AnswerFolder folder(command.out);
  work.out = command.out;
  Told all{.document = {{"program", "impinge"},
                        {"version", kVersion},
                        {"commit", commit()},
                        {"command", command.question.name},
                        {"joints", command.joints.string()},
                        {"left_out", left_out},
                        {"documents", documents}},
           .files = {{table_name, to_csv(table)}}};
  folder.write(all, work);
  if (command.json)
    screen.out << text_of(all.document);
  else
    screen.out << "joints              " << documents.size() << ", in " << table.rows.size() << " rows of "
               << (command.out / table_name).string() << "; the files of each in a folder of its name"
               << std::endl;
}

// Throws if options exclude each other.
void require_consistent(const JointCommand& command) {
  if (command.schema || command.xml) return;
  command.question.check();
  if (command.joint.cartilage_map && !command.question.takes_map)
    throw std::invalid_argument("cartilage: is one thickness here, and no map; give a number of mm");
  if (command.joints.empty() && (command.joint.ball.empty() || command.joint.socket.empty()))
    throw std::invalid_argument("two meshes are needed, BALL and SOCKET");
}

void run(const JointCommand& command, const Screen& screen) {
  if (command.schema)
    screen.out << text_of(document_schema(command.question));
  else if (command.xml)
    screen.out << slicer_module(*command.app);
  else if (command.joints.empty())
    run_one(command, screen);
  else
    run_all(command, screen);
}

void add_command(CLI::App& program, QuestionCommand question, const Screen& screen,
                 std::function<void()>& work) {
  const auto command = std::make_shared<JointCommand>();
  command->question = std::move(question);
  command->work.log = &screen.log;
  CLI::App& app = *program.add_subcommand(command->question.name, command->question.text);
  app.footer("Example: impinge " + command->question.name + " " + command->question.example);
  CLI::Option* const ball =
      app.add_option("BALL", command->joint.ball, "mesh with the ball: PLY, STL, OBJ, OFF, VTP or VTK, in mm")
          ->type_name("FILE");
  app.add_option("SOCKET", command->joint.socket, "mesh with the socket, in the same frame")
      ->type_name("FILE");
  command->question.add_options(app);
  const std::function<void()> use_config = add_joint_options(app, command->joint);
  const std::string group = "The answer";
  CLI::Option* const out = app.add_option("-o,--out", command->out,
                                          "folder for files; without it the answer is on the screen alone")
                               ->type_name("DIR")
                               ->group(group);
  if (command->question.writes_meshes)
    add_word(app, "--mesh-format", command->work.mesh_format, "of the meshes that are written")
        ->group("The question");
  app.add_flag("--json", command->json, "print the document that summary.json holds, in place of words")
      ->group(group);
  CLI::Option* const joints =
      app.add_option("--joints", command->joints,
                     "a folder with a folder for each joint, in place of BALL and SOCKET")
          ->type_name("DIR")
          ->group(group);
  joints->needs(out)->excludes(ball);
  for (const char* of_one : {"--centre", "--landmarks", "--ball-part", "--socket-part", "--config"})
    joints->excludes(app.get_option(of_one));
  for (const char* other : command->question.without) app.remove_option(app.get_option(other));
  app.add_option("--threads", command->work.threads, "[all cores]")
      ->type_name("N")
      ->check(in_range({1, 1024}, true))
      ->group(group);
  app.add_flag("--quiet", command->work.quiet, "no progress")->group(group);
  app.add_flag("--schema", command->schema, "print the JSON Schema of the document, and do nothing else")
      ->group(group);
  app.add_flag("--xml", command->xml, "print what 3D Slicer makes a window of, and do nothing else")
      ->group(group);
  command->app = &app;
  app.callback([command, use_config, &screen, &work] {  // runs once nothing is left over
    use_config();
    require_consistent(*command);
    work = [command, &screen] { run(*command, screen); };
  });
}

}  // namespace

void Work::say(const std::string& line) const {
  if (log != nullptr && !quiet) *log << "impinge: " << one_line(line) << std::endl;
}

void Work::warn(const std::string& line) const {
  if (log != nullptr) *log << "impinge: warning: " << one_line(line) << std::endl;
}

void add_joint_commands(CLI::App& program, const Screen& screen, std::function<void()>& work) {
  for (QuestionCommand& question : std::vector<QuestionCommand>{
           gaps_question(), touch_question(), poses_question(), limits_question(), volume_question(),
           resect_question(), orient_question(), measure_question(), certify_question(), report_question()})
    add_command(program, std::move(question), screen, work);
}

}  // namespace impinge
