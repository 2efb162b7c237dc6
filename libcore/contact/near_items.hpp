// SPDX-License-Identifier: GPL-3.0-or-later
// All items of a scan that may be as near to the other surface as it matters, and no cap of items that is
// not.
#pragma once

#include <cstdint>

#include "contact/touch_search.hpp"

namespace impinge {

/// Who is shown the items: a function object that is borrowed.
class ItemVisitor {
 public:
  /// visit(item) returns the gap in mm that matters from then on; -infinity ends the search.
  template <class Visit>
  explicit ItemVisitor(Visit& visit)
      : visit_(&visit),
        call_([](void* self, std::uint32_t item) { return (*static_cast<Visit*>(self))(item); }) {}

  /// What it returns.
  double operator()(std::uint32_t item) const { return call_(visit_, item); }

 private:
  void* visit_;
  double (*call_)(void*, std::uint32_t);
};

/// Shows every item of the tree whose gap may be `gap` mm or less, in any order, each once. An item that is
/// not shown has a larger gap than that, and than all that the visitor returned, or none; see
/// contact/touch_search.hpp for whose gaps that holds.
void visit_near(const PosedTree& posed, double gap, const ItemVisitor& visit);

}  // namespace impinge
