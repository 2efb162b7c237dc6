// SPDX-License-Identifier: GPL-3.0-or-later
#include "joint/touch.hpp"

#include "command/question_command.hpp"

namespace impinge {
namespace {

Told told(Session& session, const TouchRequest& request, const Work& /*work*/) {
  const TouchAnswer found = answer(session, request);
  return {.words = describe(found.contact) + describe(found.nearest_part) + describe(found.smallest_gap),
          .document = json_of(found),
          .row_of_one = {{"contact", "/contact/state"},
                         {"by", "/contact/by"},
                         {"smallest_gap_mm", "/smallest_gap/gap_mm"},
                         {"surface", "/smallest_gap/surface"},
                         {"vertex", "/smallest_gap/vertex"},
                         {"clock", "/smallest_gap/clock"}}};
}

}  // namespace

QuestionCommand touch_question() {
  return question_of<TouchRequest, TouchAnswer>(
      "touch", "Do the bones touch in a pose, and where is the smallest gap?",
      "femur.ply pelvis.ply --side right --pose flexion=90,internal_rotation=20", &told);
}

}  // namespace impinge
