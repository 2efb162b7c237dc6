// SPDX-License-Identifier: GPL-3.0-or-later
// Where a scan of a plan has its radii from.
#pragma once

#include <functional>
#include <memory>

#include "planning/scene_plan.hpp"

namespace impinge {

/// Fills the whole table of a surface, for a plan that does not leave any of it out.
using FillFull = std::function<std::unique_ptr<RadiusSource>(const TriangleMesh&, Layer)>;

/// The whole table, the part of it that the plan keeps, or with an accuracy a table where it keeps that and
/// the faces elsewhere. Joint, plan and scan must outlive it.
std::unique_ptr<RadiusSource> make_scan_source(const BallSocketPair& joint, const ScenePlan& plan,
                                               const ScanPlan& scan, const FillFull& fill_full);

}  // namespace impinge
