// SPDX-License-Identifier: GPL-3.0-or-later
#include "planning/plan_draft.hpp"

namespace impinge {

void index_faces(const BallSocketPair& joint, double margin, ScanPlan& scan) {
  if (scan.faces && scan.faces->margin() >= margin) return;
  scan.faces = std::make_unique<NearFaces>(mesh_of(joint, other(scan.scanned)), margin);
}

}  // namespace impinge
