// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/answer_document.hpp"

#include <utility>

namespace impinge {

Json document_of(std::string_view question, Json joint, Json request, Json answer, Json times_ms) {
  return {{"program", "impinge"},
          {"version", kVersion},
          {"commit", commit()},
          {"command", question},
          {"schema", "impinge " + std::string(question) + " --schema"},
          {"joint", std::move(joint)},
          {"request", std::move(request)},
          {"answer", std::move(answer)},
          {"times_ms", std::move(times_ms)},
          {"files", Json::array()}};
}

}  // namespace impinge
