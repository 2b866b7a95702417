// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "study/wider_search.hpp"

namespace brachisto {

std::string wider_search(Contact contact, const SolveOptions& options) {
  if (options.search == Search::Global || contact == Contact::Centre) return {};
  const std::string search = "search: global";
  if (options.method == Method::Extremal) return search + " with method: ipopt";
  return options.discretisation.formulation == Formulation::ArcLength
             ? search + " with formulation: rolling_time"
             : search;
}

}  // namespace brachisto
