// SPDX-License-Identifier: GPL-3.0-or-later
#include "sphere/any_scheme.hpp"

#include <mutex>
#include <optional>
#include <type_traits>
#include <utility>

#include "sphere/scheme_choice.hpp"
#include "sphere/walker.hpp"

namespace impinge {
namespace {

template <SamplingScheme S>
class ModelOf final : public AnyScheme::Model {
 public:
  explicit ModelOf(const S& scheme) : scheme_(scheme) {}

  std::string_view name() const override { return S::name; }
  double precision_deg() const override { return scheme_.precision_deg(); }
  std::size_t size() const override { return scheme_.size(); }
  std::size_t cells() const override { return scheme_.cells(); }
  bool has_known_borders() const override { return HasKnownBorders<S>; }
  bool meets_cells_once(const Vec3& a, const Vec3& b) const override {
    if constexpr (HasKnownBorders<S>) return impinge::meets_cells_once(scheme_, a, b);
    return false;
  }
  double covering_radius() const override { return scheme_.covering_radius(); }
  double stencil_radius() const override { return scheme_.stencil_radius(); }
  Vec3 direction(std::size_t entry) const override { return scheme_.direction(entry); }
  Stencil stencil(const Vec3& x) const override { return scheme_.stencil(x); }

  void for_each_cell_across(const Stencil& at, const AnyScheme::VisitStencil& visit) const override {
    if constexpr (requires { scheme_.for_each_cell_across(at, visit); })
      scheme_.for_each_cell_across(at, visit);
  }

  void visit_near(const TriangleCone& cone, double margin, const AnyScheme::VisitRun& visit) const override {
    std::call_once(walker_made_, [this] { walker_.emplace(walker_of(scheme_)); });
    walker_->visit_near(cone, margin, visit);
  }

 private:
  using Walker = std::remove_cvref_t<decltype(walker_of(std::declval<const S&>()))>;

  S scheme_;
  mutable std::once_flag walker_made_;  // it may hold a sine for every grid line, and most never walk
  mutable std::optional<Walker> walker_;
};

std::shared_ptr<const AnyScheme::Model> model_of(std::string_view name, double precision_deg) {
  std::shared_ptr<const AnyScheme::Model> model;
  with_scheme(name,
              [&]<class S>() { model = std::make_shared<ModelOf<S>>(S::with_precision(precision_deg)); });
  return model;
}

}  // namespace

AnyScheme::AnyScheme(std::string_view name, double precision_deg)
    : model_(model_of(name, precision_deg)),
      covering_radius_(model_->covering_radius()),
      stencil_radius_(model_->stencil_radius()) {}

std::vector<std::string> all_scheme_names() {
  std::vector<std::string> names;
  for_each_scheme([&names]<class S>() { names.emplace_back(S::name); });
  return names;
}

}  // namespace impinge
