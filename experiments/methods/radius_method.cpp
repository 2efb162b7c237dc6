// SPDX-License-Identifier: GPL-3.0-or-later
#include "methods/radius_method.hpp"

namespace impinge::lab {

std::string_view name_of(Measure measure) {
  switch (measure) {
    case Measure::radial:
      return "radial";
    case Measure::euclidean:
      return "euclidean";
    case Measure::pose:
      return "pose";
  }
  return "";
}

}  // namespace impinge::lab
