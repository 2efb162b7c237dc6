// SPDX-License-Identifier: GPL-3.0-or-later
#include "measures.hpp"

#include <string>

#include "hip/published_measures.hpp"
#include "joint/measures.hpp"

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
  for (const Measure& one : answer_measures(joint)) {
    const val refused = one.value ? val::null() : text(one.state.substr(std::string("refused: ").size()));
    measures.call<void>("push", object(std::pair("measure", one.name), std::pair("value", or_null(one.value)),
                                       std::pair("uncertainty", or_null(one.uncertainty)),
                                       std::pair("unit", one.unit), std::pair("refused", refused),
                                       std::pair("published", published_value(published_measure(one.name)))));
  }
  return object(std::pair("measures", measures));
}

}  // namespace impinge
