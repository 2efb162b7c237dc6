// SPDX-License-Identifier: GPL-3.0-or-later
#include "measures.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "session/measures.hpp"

namespace impinge {

val measures_reply(const SessionJoint& joint) {
  val measures = val::array();
  std::vector<std::string> reasons;  // why some are refused, each once
  for (const Measure& one : answer_measures(joint)) {
    if (one.value) {
      measures.call<void>("push", object(std::pair("measure", one.name), std::pair("value", *one.value),
                                         std::pair("uncertainty", one.uncertainty.value_or(0.0)),
                                         std::pair("unit", one.unit)));
      continue;
    }
    const std::string reason = one.state.substr(std::string("refused: ").size());
    if (std::ranges::find(reasons, reason) == reasons.end()) reasons.push_back(reason);
  }
  val left_out = val::array();
  for (const std::string& reason : reasons) left_out.call<void>("push", reason);
  return object(std::pair("measures", measures), std::pair("left_out", left_out));
}

}  // namespace impinge
