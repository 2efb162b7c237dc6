// SPDX-License-Identifier: GPL-3.0-or-later
// What stands behind the interface of fast_methods.hpp.
#pragma once

#include <concepts>
#include <memory>
#include <utility>

#include "13_fast/fast_methods.hpp"
#include "gap/gap_scan.hpp"
#include "methods/floor_scan.hpp"
#include "methods/radius_method.hpp"
#include "methods/table_method.hpp"

namespace impinge::lab {

// A kernel on its table.
template <class Table>
class KernelScan final : public GapMethod {
 public:
  // table: that of the other surface; scanned: whose vertices ask.
  KernelScan(Table table, Surface scanned) : table_(std::move(table)), scanned_(scanned) {}

  void scan(const AskedPoints& asked, const Pose& pose, Scratch& scratch) override {
    if constexpr (kFloats) {
      scratch.floats.resize(asked.points.size());
      scan_gaps(table_, asked.floats, pose, scanned_, scratch.floats);
    } else {
      scratch.doubles.resize(asked.points.size());
      scan_gaps(table_, asked.doubles, pose, scanned_, scratch.doubles);
    }
  }
  double gap(const Scratch& scratch, std::size_t i) const override {
    return kFloats ? static_cast<double>(scratch.floats[i]) : scratch.doubles[i];
  }
  double bytes() const override { return static_cast<double>(table_.bytes()); }

 private:
  static constexpr bool kFloats = std::same_as<typename Table::Real, float>;
  Table table_;
  Surface scanned_;
};

// On which side of a gap of 0 each vertex is, for sure.
class CertifiedScan final : public GapMethod {
 public:
  // Table: of the other surface; scanned: whose vertices ask.
  CertifiedScan(CertifiedTable table, Surface scanned) : table_(std::move(table)), scanned_(scanned) {}

  void scan(const AskedPoints& asked, const Pose& pose, Scratch& scratch) override {
    scan_gaps(table_, asked.floats, pose, scanned_, scratch.certified);
  }
  double gap(const Scratch& scratch, std::size_t i) const override {
    return static_cast<double>(scratch.certified.gap[i]);
  }
  std::size_t undecided(const Scratch& scratch) const override { return scratch.certified.undecided.size(); }
  double bytes() const override { return static_cast<double>(table_.bytes()); }

 private:
  CertifiedTable table_;
  Surface scanned_;
};

// The library's scan in double, one vertex at a time.
template <SamplingScheme S>
class ScalarScan final : public GapMethod {
 public:
  // table: that of the other surface; scanned: whose vertices ask.
  ScalarScan(RadialTable<S> table, Surface scanned) : table_(std::move(table)), scanned_(scanned) {}

  void scan(const AskedPoints& asked, const Pose& pose, Scratch& scratch) override {
    scratch.doubles.resize(asked.points.size());
    scan_gaps(table_, asked.points, pose, scanned_, scratch.doubles);
  }
  double gap(const Scratch& scratch, std::size_t i) const override { return scratch.doubles[i]; }
  double bytes() const override { return static_cast<double>(table_.bytes()); }

 private:
  RadialTable<S> table_;
  Surface scanned_;
};

// A pose, and whose vertices ask in it.
struct PosedScan {
  const Pose& pose;  // of the ball against the socket
  Surface scanned;   // whose vertices ask
};

// Moves the points to the frame of the surface that is asked, and has the method answer for them there.
inline void answer_moved(RadiusMethod& method, const AskedPoints& asked, const PosedScan& posed,
                         GapMethod::Scratch& scratch) {
  const std::size_t count = asked.points.size();
  scratch.moved.resize(count);
  scratch.doubles.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3& v = asked.points[i];
    scratch.moved[i] = to_other(posed.scanned, posed.pose, v);
  }
  method.answer(scratch.moved, scratch.doubles);
}

// Rays in the frame of the surface; the points are moved there first.
class RayScan final : public GapMethod {
 public:
  // rays: that meet the other surface; scanned: whose vertices ask.
  RayScan(std::unique_ptr<RadiusMethod> rays, Surface scanned) : rays_(std::move(rays)), scanned_(scanned) {}

  void scan(const AskedPoints& asked, const Pose& pose, Scratch& scratch) override {
    answer_moved(*rays_, asked, {pose, scanned_}, scratch);
    for (std::size_t i = 0; i < scratch.doubles.size(); ++i)
      scratch.doubles[i] = signed_gap(scanned_, scratch.doubles[i], scratch.moved[i].norm());
  }
  double gap(const Scratch& scratch, std::size_t i) const override { return scratch.doubles[i]; }
  double bytes() const override { return rays_->bytes(); }

 private:
  std::unique_ptr<RadiusMethod> rays_;
  Surface scanned_;
};

// Distances of points from the surface: Euclidean, and without a sign.
class ClosestScan final : public GapMethod {
 public:
  // distances: from the surface that is asked; scanned: whose vertices ask.
  ClosestScan(std::unique_ptr<RadiusMethod> distances, Surface scanned)
      : distances_(std::move(distances)), scanned_(scanned) {}

  void scan(const AskedPoints& asked, const Pose& pose, Scratch& scratch) override {
    answer_moved(*distances_, asked, {pose, scanned_}, scratch);
  }
  double gap(const Scratch& scratch, std::size_t i) const override { return scratch.doubles[i]; }
  double bytes() const override { return distances_->bytes(); }
  Measure measure() const override { return Measure::euclidean; }

 private:
  std::unique_ptr<RadiusMethod> distances_;
  Surface scanned_;
};

// The least that a look-up does.
class FloorScan final : public GapMethod {
 public:
  explicit FloorScan(std::size_t bytes) : table_(bytes, kReach) {}  // of a table of so many bytes

  void scan(const AskedPoints& asked, const Pose& pose, Scratch& scratch) override {
    scratch.floats.resize(asked.points.size());
    floor_scan(table_, asked.floats, pose, Surface::ball, scratch.floats);
  }
  double gap(const Scratch& /*scratch*/, std::size_t /*i*/) const override { return kNoSurface; }
  double bytes() const override { return static_cast<double>(sizeof(float) * table_.values.size()); }
  bool answers() const override { return false; }

 private:
  static constexpr double kReach = 64.0;  // mm, beyond every vertex of the pair
  FloorTable table_;
};

}  // namespace impinge::lab
