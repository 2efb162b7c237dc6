// SPDX-License-Identifier: GPL-3.0-or-later
// The one function that JavaScript calls: ask(kind, request). The reply has `ok`, and `error` where it is
// false; the joint and the tables are then as before. README.md beside has the kinds.
#include <exception>
#include <functional>
#include <map>
#include <new>
#include <string>

#include "files/one_line.hpp"
#include "hip/named_motion.hpp"
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

val ask_joint(const val& request) {
  const bool preset = request["source"].as<std::string>() == "preset";
  if (preset) {
    use_hip(session(), hip_request(request));
  } else {
    use_meshes(session(), meshes_request(request), landmarks_request(request));
  }
  val reply = joint_reply(*session().joint);
  if (!preset) reply.set("axes_from", axes_request(request).from);
  reply.set("tables", val_of(tables_reply(session().tables)));
  return reply;
}

val ask_tables(const val& request) {
  fill_tables(session(), described<TableSettings>(request));
  measure_tables(session());
  return val_of(tables_reply(session().tables));
}

val ask_bound(const val& /*request*/) {
  bound_tables(session());
  return val_of({{"bound_mm", json_of(whole_bound(session().tables))}});
}

val ask_verdicts(const val& request) {
  return val_of(verdicts_reply(answer_verdicts(session(), described<PoseRequest>(request))));
}

val ask_pose(const val& request) {
  return pose_reply(*session().joint, answer_pose(session(), described<PoseRequest>(request)));
}

val ask_sweep(const val& request) {
  const auto asked = described<SweepRequest>(request);
  const NamedMotion& motion = named_motion(asked.motions.empty() ? std::string() : asked.motions.front());
  const LimitRequest one{.start = asked.pose.value_or(motion.start),
                         .growing = std::string(motion.growing),
                         .motion = motion.name,
                         .largest_deg = asked.largest_deg,
                         .translation = asked.translation.value_or(Vec3::Zero()),
                         .cartilage_mm = asked.cartilage_mm};
  const Sweep found = sweep(session(), one, asked.step_deg);
  val reply = val_of({{"limits", json_of(answer_limits(session(), one))}});
  reply.set("angles", float_array(found.angles));
  reply.set("smallest", float_array(found.smallest));
  return reply;
}

// The document of the answer, with arrays where it has some.
template <class Answer>
val reply_of(const Answer& found) {
  val reply = val_of(json_of(found));
  if constexpr (requires { add_arrays(*session().joint, found, reply); })
    add_arrays(*session().joint, found, reply);
  return reply;
}

template <class Request>
val ask_question(const val& request) {
  return reply_of(answer(session(), described<Request>(request)));
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
  return reply_of(answer(session(), described<VolumeRequest>(request), volume_settings()));
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
  val reply = val::object();
  reply.set("html", report_page(parts));
  return reply;
}

val ask_export(const val& request) {
  const GapsAnswer found = answer_pose(session(), described<PoseRequest>(request["pose"]));
  const SessionJoint& joint = *session().joint;
  const auto asked = [&request](const char* name) { return request[name].as<std::string>(); };
  const Surface of = asked("surface") == "ball" ? Surface::ball : Surface::socket;
  const std::string bytes =
      asked("format") == "csv" ? gaps_csv(joint, found) : surface_file(joint, found, of, ply_bytes);
  val reply = val::object();
  reply.set("bytes", typed_array<std::uint8_t>(std::vector<std::uint8_t>(bytes.begin(), bytes.end())));
  return reply;
}

val refusal(const std::string& why) { return val_of({{"ok", false}, {"error", one_line(why)}}); }

val ask(const std::string& kind, const val& request) {
  static const std::map<std::string, std::function<val(const val&)>> kKinds{
      {"presets", [](const val&) { return val_of(catalogue()); }},
      {"joint", ask_joint},
      {"tables", ask_tables},
      {"bound", ask_bound},
      {"points", [](const val&) { return points_reply(session()); }},
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
    if (!session().joint && kind != "presets" && kind != "joint")
      return refusal("there is no joint yet; choose one first");
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
