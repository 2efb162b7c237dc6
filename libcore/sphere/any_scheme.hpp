// SPDX-License-Identifier: GPL-3.0-or-later
// Holds any sampling scheme behind one type, chosen while the program runs, so that code that uses it is
// compiled once, not once for each scheme. It gives exactly the numbers of the scheme that it holds.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sphere/scheme.hpp"

namespace impinge {

class AnyScheme {
 public:
  using VisitStencil = std::function<void(const Stencil&)>;   // takes each stencil of for_each_cell_across()
  using VisitRun = std::function<void(const DirectionRun&)>;  // takes each run of visit_near()

  /// The functions of a scheme, see sphere/scheme.hpp.
  class Model {
   public:
    Model() = default;
    Model(const Model&) = delete;
    Model& operator=(const Model&) = delete;
    virtual ~Model() = default;
    virtual std::string_view name() const = 0;
    virtual double precision_deg() const = 0;
    virtual std::size_t size() const = 0;
    virtual std::size_t cells() const = 0;
    virtual bool has_known_borders() const = 0;  // see AnyScheme::has_known_borders()
    virtual bool meets_cells_once(const Vec3& a, const Vec3& b) const = 0;
    virtual double covering_radius() const = 0;
    virtual double stencil_radius() const = 0;
    virtual Vec3 direction(std::size_t entry) const = 0;
    virtual Stencil stencil(const Vec3& x) const = 0;
    virtual void for_each_cell_across(const Stencil& at, const VisitStencil& visit) const = 0;
    /// As visit_near() of the scheme's walker.
    virtual void visit_near(const TriangleCone& cone, double margin, const VisitRun& visit) const = 0;
  };

  /// Finds entries in or near triangles. Keeps the scheme alive.
  class Walker {
   public:
    /// A walker of the scheme that `model` holds.
    explicit Walker(std::shared_ptr<const Model> model) : model_(std::move(model)) {}
    void visit_near(const TriangleCone& cone, double margin, const VisitRun& visit) const {
      model_->visit_near(cone, margin, visit);
    }

   private:
    std::shared_ptr<const Model> model_;
  };

  /// The scheme of this name whose entries are `precision_deg` degrees apart at the equator. Throws
  /// std::invalid_argument if there is no such name or precision.
  AnyScheme(std::string_view name, double precision_deg);

  std::string_view name() const { return model_->name(); }
  double precision_deg() const { return model_->precision_deg(); }
  std::size_t size() const { return model_->size(); }
  std::size_t cells() const { return model_->cells(); }
  /// Does the scheme satisfy HasKnownBorders? Only then may meets_cells_once() be called.
  bool has_known_borders() const { return model_->has_known_borders(); }
  bool meets_cells_once(const Vec3& a, const Vec3& b) const { return model_->meets_cells_once(a, b); }
  double covering_radius() const { return covering_radius_; }
  double stencil_radius() const { return stencil_radius_; }
  Vec3 direction(std::size_t entry) const { return model_->direction(entry); }
  Stencil stencil(const Vec3& x) const { return model_->stencil(x); }
  void for_each_cell_across(const Stencil& at, const VisitStencil& visit) const {
    model_->for_each_cell_across(at, visit);
  }
  Walker walker() const { return Walker(model_); }

 private:
  std::shared_ptr<const Model> model_;
  double covering_radius_;  // asked for often, and not cheap in every scheme
  double stencil_radius_;
};

/// The names of all schemes, in alphabetical order.
std::vector<std::string> all_scheme_names();

}  // namespace impinge
