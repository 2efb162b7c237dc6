// SPDX-License-Identifier: GPL-3.0-or-later
#include "change.hpp"

namespace impinge {
namespace {

val ends_value(const Ends& ends) { return val::array(std::vector<double>{ends.low, ends.high}); }

val bracket_value(const TurnLimit& limit) {
  return object(std::pair("state", text(name(limit.state))), std::pair("low_deg", limit.low_deg),
                std::pair("high_deg", limit.high_deg));
}

val neck_value(const std::optional<NeckBar>& neck) {
  if (!neck) return val::null();
  return object(std::pair("before_mm", neck->before), std::pair("after_mm", neck->after));
}

}  // namespace

val resection_reply(const SessionJoint& joint, const ResectionAnswer& found) {
  const Resection& cut = found.cut;
  std::vector<Vec3> places;
  places.reserve(cut.cut.vertices.size());
  for (const Vec3& x : cut.cut.vertices) places.emplace_back(joint.axes.transpose() * x);
  std::vector<std::uint32_t> corners;
  for (const Face& face : cut.cut.faces) corners.insert(corners.end(), face.begin(), face.end());
  const val legs = list(found.legs, [](const ReachedLeg& reached) {
    return object(
        std::pair("words", describe(reached.leg)), std::pair("required_deg", reached.leg.largest_deg),
        std::pair("before", bracket_value(reached.before)), std::pair("after", bracket_value(reached.after)));
  });
  return object(
      std::pair("positions", float_array(places)), std::pair("faces", typed_array(corners)),
      std::pair("depth", float_array(cut.depth)), std::pair("volume_mm3", ends_value(cut.volume_mm3)),
      std::pair("area_mm2", ends_value(cut.area_mm2)), std::pair("depth_mm", ends_value(cut.depth_mm)),
      std::pair("deepest", cut.empty() ? val::null() : point(found.deepest)),
      std::pair("neck", neck_value(found.neck)), std::pair("legs", legs));
}

val orientation_reply(const OrientationAnswer& found) {
  const OrientationQuestion& question = found.question;
  std::vector<double> squares;
  for (const OrientationCell& cell : found.cells)
    squares.insert(squares.end(),
                   {cell.middle.inclination_deg, cell.middle.anteversion_deg, cell.half_deg,
                    static_cast<double>(cell.state), cell.leg ? static_cast<double>(*cell.leg) : -1.0});
  const val as_scanned = object(std::pair("inclination_deg", question.at_rest.inclination_deg),
                                std::pair("anteversion_deg", question.at_rest.anteversion_deg),
                                std::pair("state", text(name(found.as_scanned))));
  const val map = object(std::pair("least_inclination_deg", question.least.inclination_deg),
                         std::pair("least_anteversion_deg", question.least.anteversion_deg),
                         std::pair("width_deg", question.width_deg));
  const val area = object(std::pair("free", found.free), std::pair("blocked", found.blocked),
                          std::pair("unknown", found.unknown), std::pair("open", found.open));
  const val legs = list(question.legs, [](const RequiredLeg& leg) { return text(describe(leg)); });
  return object(std::pair("squares", float_array(squares)), std::pair("legs", legs), std::pair("map", map),
                std::pair("as_scanned", as_scanned), std::pair("area_deg2", area));
}

}  // namespace impinge
