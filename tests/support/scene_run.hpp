// SPDX-License-Identifier: GPL-3.0-or-later
// A whole scene, as the program runs it.
#pragma once

#include "files/file_bytes.hpp"
#include "scene/report.hpp"

namespace impinge::test {

// Measures what the options ask for, writes all files and returns the summary.
inline nlohmann::json run_scene(const SceneOptions& options) {
  Session session = load_joint(options);
  const Measurement measurement = measure(session, options);
  nlohmann::json report = summary(options, *session.joint, measurement);
  require_writable_folder(options.out);
  write_scene(options, *session.joint, measurement, report);
  return report;
}

}  // namespace impinge::test
