// SPDX-License-Identifier: GPL-3.0-or-later
#include "measures.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "hip/published_measures.hpp"
#include "session/measures.hpp"

namespace impinge {
namespace {

val published_value(const PublishedMeasure& published) {
  if (published.source.empty()) return val::null();
  return object(std::pair("mean", or_null(published.mean)), std::pair("sd", or_null(published.sd)),
                std::pair("median", or_null(published.median)),
                std::pair("lower_quartile", or_null(published.lower_quartile)),
                std::pair("upper_quartile", or_null(published.upper_quartile)),
                std::pair("of", text(published.of)), std::pair("source", text(published.source)));
}

}  // namespace

val measures_reply(const SessionJoint& joint) {
  val measures = val::array();
  std::vector<std::string> reasons;  // why some are refused, each once
  for (const Measure& one : answer_measures(joint)) {
    if (one.value) {
      measures.call<void>(
          "push", object(std::pair("measure", one.name), std::pair("value", *one.value),
                         std::pair("uncertainty", one.uncertainty.value_or(0.0)), std::pair("unit", one.unit),
                         std::pair("published", published_value(published_measure(one.name)))));
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
