// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/volume.hpp"

#include "files/file_bytes.hpp"

namespace impinge {

Told write_volume(const SceneOptions& options, Session& session, std::ostream& log) {
  const VolumeOptions& asked = *options.volume;
  Told told = tell_volume(session, {asked.width, asked.gap_mm, asked.centre_within_mm},
                          {.out = options.out, .threads = 2, .log = &log});
  for (const AnswerFile& file : told.files) write_if_changed(options.out / file.name, file.bytes);
  return told;
}

}  // namespace impinge
