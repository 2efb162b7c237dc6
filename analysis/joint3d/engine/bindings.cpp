// SPDX-License-Identifier: GPL-3.0-or-later
// The one function that JavaScript calls: ask(kind, request). The reply has `ok`, and `error` where it is
// false; the joint and the tables are then as before. README.md beside has the kinds.
#include <exception>
#include <functional>
#include <map>
#include <new>
#include <stdexcept>
#include <string>

#include "arrays.hpp"
#include "catalogue.hpp"
#include "files/one_line.hpp"
#include "joint/document.hpp"
#include "joint/joint_files.hpp"
#include "joint/limits.hpp"
#include "joint/measures.hpp"
#include "joint/proof.hpp"
#include "joint/volume.hpp"
#include "replies.hpp"
#include "report/page.hpp"
#include "requests.hpp"

namespace impinge {
namespace {

Session& session() {
  static Session only;
  return only;
}

void require_joint() {
  if (!session().joint) throw std::invalid_argument("there is no joint yet; choose one first");
}

val ask_joint(const val& request) {
  const bool preset = request["source"].as<std::string>() == "preset";
  if (preset) {
    use_hip(session(), hip_request(request));
  } else {
    use_meshes(session(), meshes_request(request), landmarks_request(request));
  }
  val reply = joint_reply(*session().joint);
  if (!preset) reply.set("axes_from", axes_request(request).from);
  reply.set("tables", tables_reply(session().tables));
  return reply;
}

val ask_tables(const val& request) {
  require_joint();
  fill_tables(session(), table_request(request));
  measure_tables(session());
  return tables_reply(session().tables);
}

val ask_bound(const val& /*request*/) {
  require_joint();
  bound_tables(session());
  return object(std::pair("bound_mm", number_or_null(whole_bound(session().tables))));
}

val ask_verdicts(const val& request) {
  require_joint();
  return verdicts_reply(answer_verdicts(session(), pose_request(request)));
}

val ask_points(const val& /*request*/) {
  require_joint();
  return points_reply(session());
}

val ask_pose(const val& request) {
  require_joint();
  const GapsAnswer found = answer_pose(session(), pose_request(request));
  return pose_reply(*session().joint, found);
}

val ask_sweep(const val& request) {
  require_joint();
  const LimitRequest limits = limit_request(request);
  const double step_deg = step_request(request);
  const Sweep found = sweep(session(), limits, step_deg);
  val reply = val_of(
      json_of(LimitsAnswer{.centre_within_mm = kErrorOfInput, .limits = answer_limits(session(), limits)}));
  reply.set("angles", float_array(found.angles));
  reply.set("smallest", float_array(found.smallest));
  return reply;
}

// A request that files/fields.hpp describes.
template <class Request>
Request described(const val& request) {
  require_joint();
  Request asked;
  if (is_given(request))
    read_request(Json::parse(val::global("JSON").call<std::string>("stringify", request)), asked);
  return asked;
}

// The document of the answer, with arrays where it has some.
template <class Request>
val ask_question(const val& request) {
  const auto found = answer(session(), described<Request>(request));
  val reply = val_of(json_of(found));
  if constexpr (requires { add_arrays(*session().joint, found, reply); })
    add_arrays(*session().joint, found, reply);
  return reply;
}

// One thread; a worker of the page is told how far it is.
VolumeSettings volume_settings(VolumeSettings how = {}) {
  how.threads = 1;
  const val reached = val::global("joint3dReached");
  if (reached.typeOf().as<std::string>() == "function")
    how.reached = [reached](std::span<const CellVerdict>, double open) { reached(open); };
  return how;
}

val ask_volume(const val& request) {
  const auto asked = described<VolumeRequest>(request);
  if (asked.width < 0.02)
    throw std::invalid_argument(
        "a page leaves 0.02 of all rotations open, or more; choose a width from 0.02 to 1");
  const VolumeAnswer found = answer(session(), asked, volume_settings());
  val reply = val_of(json_of(found));
  add_arrays(*session().joint, found, reply);
  return reply;
}

// The file that `impinge report` writes. `asked` is a ReportRequest; the page holds the viewer.
val ask_report(const val& request) {
  const auto asked = described<ReportRequest>(request["asked"]);
  const ReportAnswer found = answer(session(), asked, volume_settings({.most_cells = kMostVolumeCells}));
  const auto said = [&request](const char* name) { return request[name].as<std::string>(); };
  ReportParts parts =
      report_parts(*session().joint, {.ball = said("ball"), .socket = said("socket")}, asked, found);
  const std::string viewer = said("viewer");
  parts.program = said("program");
  parts.viewer = viewer;
  return object(std::pair("html", report_page(parts)));
}

val ask_export(const val& request) {
  require_joint();
  const GapsAnswer found = answer_pose(session(), pose_request(request["pose"]));
  const SessionJoint& joint = *session().joint;
  const bool csv = request["format"].as<std::string>() == "csv";
  const bool ball = csv || request["surface"].as<std::string>() == "ball";
  const std::string bytes =
      csv ? gaps_csv(joint, found)
          : surface_file(joint, found, ball ? Surface::ball : Surface::socket, ply_bytes);
  const char* name = csv ? "gaps.csv" : ball ? "ball.ply" : "socket.ply";
  return object(std::pair("name", name),
                std::pair("bytes", typed_array(std::vector<std::uint8_t>(bytes.begin(), bytes.end()))));
}

val refusal(const std::string& why) {
  return object(std::pair("ok", false), std::pair("error", one_line(why)));
}

val ask(const std::string& kind, const val& request) {
  static const std::map<std::string, std::function<val(const val&)>> kKinds{
      {"presets", [](const val&) { return catalogue(); }},
      {"joint", ask_joint},
      {"tables", ask_tables},
      {"bound", ask_bound},
      {"points", ask_points},
      {"pose", ask_pose},
      {"verdicts", ask_verdicts},
      {"sweep", ask_sweep},
      {"limits", ask_question<LimitsRequest>},
      {"measure", ask_question<MeasureRequest>},
      {"touch", ask_question<TouchRequest>},
      {"gaps", ask_question<GapsRequest>},
      {"certify", ask_question<CertifyRequest>},
      {"volume", ask_volume},
      {"resect", ask_question<ResectRequest>},
      {"orient", ask_question<OrientRequest>},
      {"report", ask_report},
      {"export", ask_export}};
  try {
    const auto found = kKinds.find(kind);
    if (found == kKinds.end()) return refusal("unknown question '" + kind + "'");
    val reply = found->second(request);
    reply.set("ok", true);
    return reply;
  } catch (const std::bad_alloc&) {
    return refusal("there is not enough memory; choose a coarser precision or smaller meshes");
  } catch (const std::exception& error) {
    return refusal(error.what());
  }
}

}  // namespace
}  // namespace impinge

EMSCRIPTEN_BINDINGS(joint3d) { emscripten::function("ask", &impinge::ask); }
