// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "program_files/nl_numbering.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "brachisto/math/clock.hpp"
#include "brachisto/math/index.hpp"

namespace brachisto::program_files {

namespace {

using Kind = Formula::Token::Kind;

/// Who uses a variable nonlinearly, or a quantity.
enum Use : std::uint8_t { kNobody = 0, kConstraint = 1, kObjective = 2 };
constexpr std::uint8_t kBoth = kConstraint | kObjective;

class Survey {
 public:
  Survey(int num_variables, const ProgramInFormulas& formulas)
      : variables(at(num_variables)),
        quantities(at(formulas.num_quantities())) {}

  void note(const Formula& formula, std::uint8_t use) {
    for (const Formula::Token& token : formula.tree()) {
      if (token.kind == Kind::Unknown) variables[at(token.number)] |= use;
      if (token.kind == Kind::Quantity) quantities[at(token.number)] |= use;
    }
  }
  /// What is in a quantity is used as the quantity is.
  void note_within_quantities(const ProgramInFormulas& formulas) {
    for (int i = 0; i < formulas.num_quantities(); ++i) {
      check_stop(i);
      const std::uint8_t use = quantities[at(i)];
      if (use == kNobody) continue;
      const Formula formula = formulas.quantity(i);
      note(formula, use);
      for (const Formula::Term& term : formula.terms()) {
        variables[at(term.unknown)] |= use;
      }
    }
  }

  std::vector<std::uint8_t> variables, quantities;
};

/// Those of the given use, in their order, behind what is there.
/// \return how many
int append(const std::vector<std::uint8_t>& uses, std::uint8_t use,
           std::vector<int>& out) {
  const std::size_t before = out.size();
  for (std::size_t i = 0; i < uses.size(); ++i) {
    if (uses[i] == use) out.push_back(static_cast<int>(i));
  }
  return static_cast<int>(out.size() - before);
}

std::vector<int> inverse(const std::vector<int>& order, std::size_t size) {
  std::vector<int> out(size, -1);
  for (std::size_t i = 0; i < order.size(); ++i) {
    out[at(order[i])] = static_cast<int>(i);
  }
  return out;
}

}  // namespace

void find_unknowns(const Formula& formula, const ProgramInFormulas& formulas,
                   std::span<const int> place,
                   std::vector<Formula::Term>& out) {
  out = formula.terms();
  for (const Formula::Token& token : formula.tree()) {
    if (token.kind == Kind::Unknown) out.push_back({token.number, 0.0});
    if (token.kind != Kind::Quantity) continue;
    const Formula quantity = formulas.quantity(token.number);
    for (const Formula::Term& term : quantity.terms()) {
      out.push_back({term.unknown, 0.0});
    }
    for (const Formula::Token& inner : quantity.tree()) {
      if (inner.kind == Kind::Unknown) out.push_back({inner.number, 0.0});
    }
  }
  // Of equals that of the affine part comes first.
  const auto order = [&](const Formula::Term& term) {
    return std::pair(place.empty() ? term.unknown : place[at(term.unknown)],
                     term.coefficient == 0.0);
  };
  std::ranges::sort(out, {}, order);
  const auto repeated = std::ranges::unique(out, {}, &Formula::Term::unknown);
  out.erase(repeated.begin(), repeated.end());
}

NlNumbering::NlNumbering(const nlp::Problem& problem,
                         const ProgramInFormulas& formulas)
    : column_entries(at(problem.num_variables())) {
  Survey survey(problem.num_variables(), formulas);
  std::vector<Formula::Term> unknowns;
  std::vector<int> linear;
  for (int i = 0; i < problem.num_constraints(); ++i) {
    check_stop(i);
    const Formula formula = formulas.constraint(i);
    survey.note(formula, kConstraint);
    (formula.tree().empty() ? linear : constraints).push_back(i);
    find_unknowns(formula, formulas, {}, unknowns);
    jacobian_entries += unknowns.size();
    for (const Formula::Term& term : unknowns) {
      ++column_entries[at(term.unknown)];
    }
  }
  nonlinear_constraints = static_cast<int>(constraints.size());
  constraints.insert(constraints.end(), linear.begin(), linear.end());

  std::vector<bool> in_objective(column_entries.size());
  for (int i = 0; i < formulas.num_objective_parts(); ++i) {
    check_stop(i);
    const Formula formula = formulas.objective_part(i);
    survey.note(formula, kObjective);
    nonlinear_objective |= !formula.tree().empty();
    find_unknowns(formula, formulas, {}, unknowns);
    for (const Formula::Term& term : unknowns) {
      in_objective[at(term.unknown)] = true;
    }
  }
  gradient_entries = static_cast<int>(std::ranges::count(in_objective, true));
  survey.note_within_quantities(formulas);

  nonlinear_in_both = append(survey.variables, kBoth, variables);
  nonlinear_in_constraints =
      nonlinear_in_both + append(survey.variables, kConstraint, variables);
  const int alone = append(survey.variables, kObjective, variables);
  // With variables of the objective alone those of constraints count too.
  nonlinear_in_objective =
      alone > 0 ? nonlinear_in_constraints + alone : nonlinear_in_both;
  append(survey.variables, kNobody, variables);
  place_of_variable = inverse(variables, survey.variables.size());

  used_by_both = append(survey.quantities, kBoth, quantities);
  used_by_constraints = append(survey.quantities, kConstraint, quantities);
  used_by_objective = append(survey.quantities, kObjective, quantities);
  place_of_quantity = inverse(quantities, survey.quantities.size());
}

}  // namespace brachisto::program_files
