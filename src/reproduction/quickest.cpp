// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "reproduction/quickest.hpp"

#include <utility>

#include "brachisto/math/stop_condition.hpp"
#include "design/gather_designs.hpp"

namespace brachisto::reproduction {

std::vector<QuickestBody> quickest_bodies(Scene reference,
                                          const Interrupt& interrupt) {
  std::vector<QuickestBody> rows;
  for (const double L : {2.0, 3.0, 4.0}) {
    reference.L = L * reference.H;
    for (const bool any_k : {true, false}) {
      DesignPlan plan;
      plan.free = {BodyKey::EtaM, BodyKey::ThetaM};
      if (any_k) plan.free.push_back(BodyKey::K);
      plan.starts = kDesignStarts;
      std::vector<DesignSearch> searches;
      for (int start = 1; start <= plan.starts; ++start) {
        try {
          searches.push_back(
              search_design(reference, {}, plan, start, &interrupt));
        } catch (const Stopped&) {
          check(interrupt);
          throw;
        }
        check(interrupt);
      }
      std::optional<DesignMinimum> best =
          gather_designs(plan, std::move(searches)).best;
      if (best && !(best->verified && best->feasible)) best.reset();
      rows.push_back({L, any_k, std::move(best)});
    }
  }
  return rows;
}

}  // namespace brachisto::reproduction
