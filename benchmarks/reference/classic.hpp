// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// A classic of optimal control, stated, with what is known of it.

#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "brachisto/ocp.hpp"
#include "program_files/stated_formulas.hpp"
#include "reference/enclosures.hpp"

namespace brachisto::benchmarks {

struct Classic {
  std::string name;
  std::string formulas;  ///< in one line
  std::shared_ptr<const ocp::Posed> problem;
  std::function<std::unique_ptr<program_files::ProgramInFormulas>(const Mesh&)>
      in_formulas;
  /// What is reported is this times the cost, and this is added: −1 where
  /// something is maximised.
  double factor = 1.0, added = 0.0;
  /// By a closed form or a method that shares no code with collocation; each
  /// classic names one.
  struct Second {
    std::string by;
    double value;
  };
  Second second = {"", 0.0};
  bool closed_form = false;
  /// Of the closed form, where there is one; proven.
  std::optional<Enclosure> enclosure = {};
  struct Literature {
    std::string source;
    double value;
  };
  std::optional<Literature> literature = {};
  ocp::SolveBy by = {};

  [[nodiscard]] double reported(double cost) const {
    return factor * cost + added;
  }
};

template <class Formulas>
[[nodiscard]] Classic classic(std::string formulas_in_words, Formulas formulas,
                              ocp::Statement statement) {
  auto problem = std::make_shared<const ocp::Problem<Formulas>>(
      std::move(formulas), std::move(statement));
  return {.name = problem->statement().name,
          .formulas = std::move(formulas_in_words),
          .problem = problem,
          .in_formulas = [problem](const Mesh& mesh) {
            return program_files::in_formulas(*problem, mesh);
          }};
}

/// Carts, chains and beads.
[[nodiscard]] std::vector<Classic> mechanics();
/// An oscillator, reactors, a robot arm, a shuttle.
[[nodiscard]] std::vector<Classic> machines();

}  // namespace brachisto::benchmarks
