// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "program_files/nl_file.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "brachisto/math/clock.hpp"
#include "brachisto/math/index.hpp"

namespace brachisto::program_files {

namespace {

using Kind = Formula::Token::Kind;

constexpr const char* kObjectiveName = "T";

std::size_t longest(int count, const std::function<std::string(int)>& name) {
  std::size_t length = 1;
  for (int i = 0; i < count; ++i) length = std::max(length, name(i).size());
  return length;
}

/// Writes the segments of one file, in the order in which they stand there.
class NlText {
 public:
  NlText(const nlp::Problem& problem, const ProgramInFormulas& formulas,
         const NlNumbering& numbering, TextStream& out)
      : problem_(problem), formulas_(formulas), order_(numbering), out_(out) {}

  void put(const PrimalDual& start) {
    put_header();
    put_quantities();
    put_constraints();
    put_objective();
    put_start(start);
    put_bounds();
    put_jacobian();
    put_gradient();
    out_.flush();
  }

 private:
  [[nodiscard]] int place(int variable) const {
    return order_.place_of_variable[at(variable)];
  }
  [[nodiscard]] int place_of_quantity(int quantity) const {
    return problem_.num_variables() + order_.place_of_quantity[at(quantity)];
  }

  void put_header() {
    int ranges = 0, equations = 0;
    for (int i = 0; i < problem_.num_constraints(); ++i) {
      const nlp::Range range = problem_.constraint_range(i);
      if (range.single()) {
        ++equations;
      } else if (std::isfinite(range.lower) && std::isfinite(range.upper)) {
        ++ranges;
      }
    }
    const std::size_t row_name =
        longest(problem_.num_constraints(),
                [&](int i) { return problem_.constraint_name(i); });
    const std::size_t col_name = longest(problem_.num_variables(), [&](int i) {
      return problem_.variable_name(i);
    });
    out_ << "g3 1 1 0\t# brachisto, natural units\n";
    out_ << ' ' << problem_.num_variables() << ' ' << problem_.num_constraints()
         << " 1 " << ranges << ' ' << equations
         << "\t# vars, constraints, objectives, ranges, eqns\n";
    out_ << ' ' << order_.nonlinear_constraints << ' '
         << (order_.nonlinear_objective ? 1 : 0)
         << "\t# nonlinear constraints, objectives\n";
    out_ << " 0 0\t# network constraints: nonlinear, linear\n";
    out_ << ' ' << order_.nonlinear_in_constraints << ' '
         << order_.nonlinear_in_objective << ' ' << order_.nonlinear_in_both
         << "\t# nonlinear vars in constraints, objectives, both\n";
    out_ << " 0 0 0 1\t# linear network variables; functions; arith, flags\n";
    out_ << " 0 0 0 0 0\t# discrete variables: binary, integer, nonlinear "
            "(b,c,o)\n";
    out_ << ' ' << order_.jacobian_entries << ' ' << order_.gradient_entries
         << "\t# nonzeros in Jacobian, gradients\n";
    out_ << ' ' << row_name << ' ' << col_name
         << "\t# max name lengths: constraints, variables\n";
    out_ << ' ' << order_.used_by_both << ' ' << order_.used_by_constraints
         << ' ' << order_.used_by_objective
         << " 0 0\t# common exprs: b,c,o,c1,o1\n";
  }

  void put_tree(const Formula& formula) {
    for (const Formula::Token& token : formula.tree()) {
      switch (token.kind) {
        case Kind::Operation:
          out_ << 'o' << token.number << '\n';
          break;
        case Kind::Constant:
          out_ << 'n' << token.value << '\n';
          break;
        case Kind::Unknown:
          out_ << 'v' << place(token.number) << '\n';
          break;
        case Kind::Quantity:
          out_ << 'v' << place_of_quantity(token.number) << '\n';
          break;
      }
    }
  }

  /// The tree with the constant added to it.
  void put_nonlinear(const Formula& formula) {
    const bool both = formula.constant() != 0.0 && !formula.tree().empty();
    if (both) out_ << "o0\n";
    put_tree(formula);
    if (both || formula.tree().empty()) {
      out_ << 'n' << formula.constant() << '\n';
    }
  }

  void put_terms(const std::vector<Formula::Term>& terms) {
    for (const auto& [unknown, coefficient] : terms) {
      out_ << place(unknown) << ' ' << coefficient << '\n';
    }
  }

  void put_quantities() {
    for (const int quantity : order_.quantities) {
      check_stop(quantity);
      const Formula formula = formulas_.quantity(quantity);
      out_ << 'V' << place_of_quantity(quantity) << ' '
           << formula.terms().size() << " 0\n";
      put_terms(formula.terms());
      put_nonlinear(formula);
    }
  }

  void put_constraints() {
    int row = 0;
    for (const int constraint : order_.constraints) {
      check_stop(constraint);
      const bool linear = row >= order_.nonlinear_constraints;
      out_ << 'C' << row++ << '\n';
      if (linear) {
        out_ << "n0\n";
      } else {
        put_nonlinear(formulas_.constraint(constraint));
      }
    }
  }

  void put_objective() {
    out_ << "O0 0\n";
    const int parts = formulas_.num_objective_parts();
    double constant = 0.0;
    if (!order_.nonlinear_objective) {
      for (int i = 0; i < parts; ++i) {
        constant += formulas_.objective_part(i).constant();
      }
      out_ << 'n' << constant << '\n';
      return;
    }
    // A sum of three or more; all parts are nonlinear alike.
    constexpr int kFewestSummands = 3;
    const int padding = std::max(0, kFewestSummands - parts);
    out_ << "o54\n" << parts + padding << '\n';
    for (int i = 0; i < parts; ++i) {
      check_stop(i);
      put_nonlinear(formulas_.objective_part(i));
    }
    for (int i = 0; i < padding; ++i) out_ << "n0\n";
  }

  void put_start(const PrimalDual& start) {
    if (!start.lambda.empty()) {
      out_ << 'd' << problem_.num_constraints() << '\n';
      int row = 0;
      for (const int constraint : order_.constraints) {
        out_ << row++ << ' ' << 0.0 - start.lambda[at(constraint)] << '\n';
      }
    }
    out_ << 'x' << problem_.num_variables() << '\n';
    int col = 0;
    for (const int variable : order_.variables) {
      out_ << col++ << ' ' << start.x[at(variable)] << '\n';
    }
  }

  void put_range(const nlp::Range& range, double less) {
    const double lower = range.lower - less;
    const double upper = range.upper - less;
    const bool above = std::isfinite(lower), below = std::isfinite(upper);
    if (range.single()) {
      out_ << "4 " << lower;
    } else if (above && below) {
      out_ << "0 " << lower << ' ' << upper;
    } else if (above) {
      out_ << "2 " << lower;
    } else if (below) {
      out_ << "1 " << upper;
    } else {
      out_ << '3';
    }
    out_ << '\n';
  }

  void put_bounds() {
    out_ << "r\n";
    int row = 0;
    for (const int constraint : order_.constraints) {
      check_stop(constraint);
      const bool linear = row++ >= order_.nonlinear_constraints;
      put_range(problem_.constraint_range(constraint),
                linear ? formulas_.constraint(constraint).constant() : 0.0);
    }
    out_ << "b\n";
    for (const int variable : order_.variables) {
      put_range(problem_.variable_range(variable), 0.0);
    }
  }

  void put_jacobian() {
    out_ << 'k' << problem_.num_variables() - 1 << '\n';
    std::size_t entries = 0;
    for (int col = 0; col + 1 < problem_.num_variables(); ++col) {
      entries += at(order_.column_entries[at(order_.variables[at(col)])]);
      out_ << entries << '\n';
    }
    std::vector<Formula::Term> unknowns;
    int row = 0;
    for (const int constraint : order_.constraints) {
      check_stop(constraint);
      find_unknowns(formulas_.constraint(constraint), formulas_,
                    order_.place_of_variable, unknowns);
      out_ << 'J' << row++ << ' ' << unknowns.size() << '\n';
      put_terms(unknowns);
    }
  }

  void put_gradient() {
    std::vector<double> coefficients(at(problem_.num_variables()));
    std::vector<bool> there(coefficients.size());
    std::vector<Formula::Term> unknowns;
    for (int i = 0; i < formulas_.num_objective_parts(); ++i) {
      check_stop(i);
      find_unknowns(formulas_.objective_part(i), formulas_, {}, unknowns);
      for (const auto& [unknown, coefficient] : unknowns) {
        there[at(unknown)] = true;
        coefficients[at(unknown)] += coefficient;
      }
    }
    out_ << "G0 " << order_.gradient_entries << '\n';
    for (const int variable : order_.variables) {
      if (!there[at(variable)]) continue;
      out_ << place(variable) << ' ' << coefficients[at(variable)] << '\n';
    }
  }

  const nlp::Problem& problem_;
  const ProgramInFormulas& formulas_;
  const NlNumbering& order_;
  TextStream& out_;
};

}  // namespace

void put_nl(const nlp::Problem& problem, const ProgramInFormulas& formulas,
            const NlNumbering& numbering, const PrimalDual& start,
            TextStream& out) {
  NlText(problem, formulas, numbering, out).put(start);
}

void put_row_names(const nlp::Problem& problem, const NlNumbering& numbering,
                   TextStream& out) {
  for (const int constraint : numbering.constraints) {
    out << word_of(problem.constraint_name(constraint)) << '\n';
  }
  out << kObjectiveName << '\n';
  out.flush();
}

void put_col_names(const nlp::Problem& problem, const NlNumbering& numbering,
                   TextStream& out) {
  for (const int variable : numbering.variables) {
    out << word_of(problem.variable_name(variable)) << '\n';
  }
  out.flush();
}

std::string word_of(std::string name) {
  std::ranges::replace(name, ' ', '_');
  return name;
}

}  // namespace brachisto::program_files
