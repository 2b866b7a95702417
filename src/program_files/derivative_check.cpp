// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "program_files/derivative_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <random>
#include <stdexcept>
#include <utility>

#include "brachisto/math/index.hpp"
#include "nlp/active_set.hpp"

namespace brachisto::program_files {

namespace {

using Vector = std::vector<double>;

/// Of a row that no step told anything of: more than all.
constexpr double kUnknown = std::numeric_limits<double>::infinity();

/// Moves the free variables only, each in proportion to its size, and by no
/// more than one, which angles are large against.
class Directions {
 public:
  Directions(const nlp::Problem& problem, const Vector& x) : size_(x.size()) {
    constexpr double kSmallest = 1e-4;
    double largest = 0.0;
    for (const double value : x) largest = std::max(largest, std::abs(value));
    for (std::size_t i = 0; i < x.size(); ++i) {
      if (problem.variable_range(static_cast<int>(i)).single())
        size_[i] = 0.0;
      else
        size_[i] = std::clamp(std::abs(x[i]), kSmallest * largest, 1.0);
    }
  }
  [[nodiscard]] Vector next() {
    Vector d(size_);
    for (double& value : d) value = engine_() % 2 == 0 ? value : -value;
    return d;
  }

 private:
  Vector size_;
  std::mt19937 engine_{1};
};

/// Sums, over the entries of a row, of D_ij d_j and of its absolute values.
struct RowSums {
  Vector value, absolute;

  explicit RowSums(int rows) : value(at(rows)), absolute(at(rows)) {}
  void add(int row, double term) {
    value[at(row)] += term;
    absolute[at(row)] += std::abs(term);
  }
};

class Checker {
 public:
  Checker(nlp::Problem& problem, const PrimalDual& point)
      : problem_(problem), point_(point), directions_(problem, point.x) {}

  /// \param entries     of the pattern of derivatives
  /// \param function    F at the point the problem is at
  /// \param derivative  D d there
  /// \param row_name    of F
  DerivativeCheck check(
      std::string name, std::size_t entries, int rows, int columns,
      const std::function<Vector()>& function,
      const std::function<RowSums(const Vector& d)>& derivative,
      const std::function<std::string(int)>& row_name) {
    DerivativeCheck out{.name = std::move(name),
                        .entries = entries,
                        .rows = rows,
                        .columns = columns};
    constexpr int kDirections = 8;
    // Next to rest places are so small that a great step leaves them behind.
    constexpr std::array kSteps = {1e-3, 1e-4, 1e-5, 1e-6, 1e-7};
    for (int k = 0; k < kDirections; ++k) {
      const Vector d = directions_.next();
      move_to(point_.x);
      const RowSums ours = derivative(d);
      if (ours.absolute.empty()) return out;
      // Of a row whose terms are all small rounding is that of the largest.
      constexpr double kOfLargest = 1e-3;
      const double most = std::ranges::max(ours.absolute);
      out.largest = std::max(out.largest, most);
      Vector least(ours.value.size(), kUnknown);
      for (const double h : kSteps) {
        const auto theirs = difference_along(d, h, function);
        if (!theirs) continue;
        for (std::size_t i = 0; i < least.size(); ++i) {
          const double size = std::max(ours.absolute[i], kOfLargest * most);
          if (size == 0.0) {
            least[i] = std::min(least[i], std::abs((*theirs)[i]));
            continue;
          }
          const double off = std::abs(ours.value[i] - (*theirs)[i]) / size;
          least[i] = std::min(least[i], off);
        }
      }
      for (std::size_t i = 0; i < least.size(); ++i) {
        if (least[i] <= out.difference) continue;
        out.difference = least[i];
        out.worst_row = row_name(static_cast<int>(i));
      }
    }
    return out;
  }

 private:
  void move_to(const Vector& x) {
    if (!problem_.set_point(x)) {
      throw std::domain_error("not evaluable next to the point: " +
                              problem_.refusal());
    }
  }
  /// Nothing where F is not defined at one of the places.
  [[nodiscard]] std::optional<Vector> difference_along(
      const Vector& d, double h, const std::function<Vector()>& function) {
    constexpr std::array kAt = {1.0, -1.0, 2.0, -2.0};
    constexpr std::array kWeights = {8.0, -8.0, -1.0, 1.0};
    Vector out;
    for (std::size_t k = 0; k < kAt.size(); ++k) {
      Vector x = point_.x;
      for (std::size_t i = 0; i < x.size(); ++i) x[i] += kAt[k] * h * d[i];
      if (!problem_.set_point(x)) return std::nullopt;
      const Vector F = function();
      out.resize(F.size());
      for (std::size_t i = 0; i < F.size(); ++i) {
        out[i] += kWeights[k] * F[i] / (12.0 * h);
      }
    }
    return out;
  }

  nlp::Problem& problem_;
  const PrimalDual& point_;
  Directions directions_;
};

Vector gradient_of(nlp::Problem& problem) {
  Vector out(at(problem.num_variables()));
  problem.eval_grad_f(out);
  return out;
}

void read_chain(const nlp::Problem& problem, ProgramCheck& out) {
  const nlp::ChainStructure chain = problem.chain_structure();
  out.links = chain.num_links;
  std::vector<int> inside(at(chain.num_links));
  for (const int block : chain.block) {
    if (block == nlp::ChainStructure::kBorder) ++out.border;
    if (block > 0 && block % 2 == 1) ++inside[at(block / 2)];
  }
  if (!inside.empty()) out.largest_link = *std::ranges::max_element(inside);
}

}  // namespace

ProgramCheck check_program(nlp::Problem& problem, const PrimalDual& point) {
  ProgramCheck out;
  const int n = problem.num_variables(), m = problem.num_constraints();
  out.variables = n;
  out.constraints = m;
  for (int i = 0; i < n; ++i) out.fixed += problem.variable_range(i).single();
  for (int i = 0; i < m; ++i) {
    out.inequalities += !problem.constraint_range(i).single();
  }
  Checker checker(problem, point);
  const auto variable = [&](int i) { return problem.variable_name(i); };
  const auto constraint = [&](int i) { return problem.constraint_name(i); };

  DerivativeCheck gradient = checker.check(
      "gradient", at(n), 1, n, [&] { return Vector{problem.eval_f()}; },
      [&](const Vector& d) {
        RowSums sums(1);
        const Vector values = gradient_of(problem);
        for (std::size_t i = 0; i < d.size(); ++i)
          sums.add(0, values[i] * d[i]);
        return sums;
      },
      [](int) { return std::string("the objective"); });

  const nlp::SparsityPattern& jacobian = problem.jac_g_pattern();
  Vector values(jacobian.num_entries());
  DerivativeCheck first = checker.check(
      "Jacobian", values.size(), m, n,
      [&] {
        Vector g(at(m));
        problem.eval_g(g);
        return g;
      },
      [&](const Vector& d) {
        RowSums sums(m);
        problem.eval_jac_g(values);
        jacobian.for_each([&](std::size_t entry, int i, int j) {
          sums.add(i, values[entry] * d[at(j)]);
        });
        return sums;
      },
      constraint);

  const nlp::SparsityPattern& hessian = problem.hess_lag_pattern();
  Vector curvatures(hessian.num_entries());
  DerivativeCheck second = checker.check(
      "Hessian", curvatures.size(), n, n,
      [&] {
        Vector out_of = gradient_of(problem);
        problem.eval_jac_g(values);
        jacobian.for_each([&](std::size_t entry, int i, int j) {
          out_of[at(j)] += values[entry] * point.lambda[at(i)];
        });
        return out_of;
      },
      [&](const Vector& d) {
        RowSums sums(n);
        problem.eval_hess_lag(1.0, point.lambda, curvatures);
        hessian.for_each([&](std::size_t entry, int i, int j) {
          sums.add(i, curvatures[entry] * d[at(j)]);
          if (i != j) sums.add(j, curvatures[entry] * d[at(i)]);
        });
        return sums;
      },
      variable);
  out.derivatives = {gradient, first, second};

  read_chain(problem, out);
  out.inertia = kkt_inertia(problem, point);
  const nlp::ActiveSet active = nlp::active_set(problem, point);
  out.wanted_positive = active.num_free();
  out.wanted_negative = active.num_equations();
  return out;
}

bool ProgramCheck::agrees() const {
  return std::ranges::all_of(derivatives, &DerivativeCheck::agrees);
}

bool ProgramCheck::minimum() const {
  return inertia.known && inertia.positive == wanted_positive &&
         inertia.negative == wanted_negative;
}

std::string ProgramCheck::in_words() const {
  std::string out = fmt::format(
      "{} variables, {} of them fixed; {} constraints, {} of them "
      "inequalities\n",
      variables, fixed, constraints, inequalities);
  for (const DerivativeCheck& one : derivatives) {
    out += fmt::format(
        "{:<9} {} x {}, {} entries; differs from differences by {:.1e}{}{}\n",
        one.name, one.rows, one.columns, one.entries, one.difference,
        one.worst_row.empty() ? "" : ", most at " + one.worst_row,
        one.agrees() ? "" : ": WRONG");
  }
  out += links > 0 ? fmt::format(
                         "chain     {} links, the largest with {} "
                         "unknowns; {} in the border\n",
                         links, largest_link, border)
                   : "chain     none\n";
  out += inertia.known ? fmt::format(
                             "inertia   ({}, {}, {}), of a strict minimum ({}, "
                             "{}, 0)\n",
                             inertia.positive, inertia.negative, inertia.zero,
                             wanted_positive, wanted_negative)
                       : "inertia   unknown\n";
  return out;
}

nlohmann::ordered_json ProgramCheck::to_json() const {
  nlohmann::ordered_json each = nlohmann::ordered_json::array();
  for (const DerivativeCheck& one : derivatives) {
    each.push_back({{"name", one.name},
                    {"rows", one.rows},
                    {"columns", one.columns},
                    {"entries", one.entries},
                    {"largest", one.largest},
                    {"difference", one.difference},
                    {"allowed", DerivativeCheck::kAllowed},
                    {"worst_row", one.worst_row},
                    {"agrees", one.agrees()}});
  }
  return {
      {"agrees", agrees()},
      {"variables", variables},
      {"fixed", fixed},
      {"constraints", constraints},
      {"inequalities", inequalities},
      {"derivatives", std::move(each)},
      {"chain",
       {{"links", links}, {"largest_link", largest_link}, {"border", border}}},
      {"inertia",
       {{"known", inertia.known},
        {"positive", inertia.positive},
        {"negative", inertia.negative},
        {"zero", inertia.zero},
        {"wanted_positive", wanted_positive},
        {"wanted_negative", wanted_negative},
        {"minimum", minimum()}}}};
}

}  // namespace brachisto::program_files
