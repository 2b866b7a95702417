// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "program_files/matrix_files.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "brachisto/math/index.hpp"

namespace brachisto::program_files {

namespace {

void put_head(const char* kind, int rows, int columns, std::size_t entries,
              TextStream& out) {
  out << "%%MatrixMarket matrix coordinate real " << kind << '\n'
      << rows << ' ' << columns << ' ' << entries << '\n';
}

}  // namespace

ProgramMatrices::ProgramMatrices(nlp::Problem& problem, const PrimalDual& point)
    : num_variables_(problem.num_variables()),
      num_constraints_(problem.num_constraints()),
      gradient_(at(num_variables_)),
      constraints_(at(num_constraints_)) {
  if (!problem.set_point(point.x)) {
    throw std::runtime_error("the program has no derivatives there: " +
                             problem.refusal());
  }
  problem.eval_grad_f(gradient_);
  problem.eval_g(constraints_);
  std::vector<double> values(problem.jac_g_pattern().num_entries());
  problem.eval_jac_g(values);
  jacobian_ = gathered(problem.jac_g_pattern(), values);
  values.resize(problem.hess_lag_pattern().num_entries());
  problem.eval_hess_lag(1.0, point.lambda, values);
  hessian_ = gathered(problem.hess_lag_pattern(), values);
}

ProgramMatrices::Entries ProgramMatrices::gathered(
    const nlp::SparsityPattern& pattern, const std::vector<double>& values) {
  Entries entries;
  entries.reserve(values.size());
  pattern.for_each([&](std::size_t entry, int row, int col) {
    entries.push_back({row, col, values[entry]});
  });
  // Column by column, as readers store them.
  std::ranges::stable_sort(entries, {}, [](const Entry& entry) {
    return std::pair(entry.col, entry.row);
  });
  Entries sums;
  for (const Entry& entry : entries) {
    if (!sums.empty() && sums.back().row == entry.row &&
        sums.back().col == entry.col) {
      sums.back().value += entry.value;
    } else {
      sums.push_back(entry);
    }
  }
  return sums;
}

void ProgramMatrices::put_entries(const Entries& entries, int down,
                                  TextStream& out) {
  for (const auto& [row, col, value] : entries) {
    out << row + down + 1 << ' ' << col + 1 << ' ' << value << '\n';
  }
}

void ProgramMatrices::put_jacobian(TextStream& out) const {
  put_head("general", num_constraints_, num_variables_, jacobian_.size(), out);
  put_entries(jacobian_, 0, out);
  out.flush();
}

void ProgramMatrices::put_hessian(TextStream& out) const {
  put_head("symmetric", num_variables_, num_variables_, hessian_.size(), out);
  put_entries(hessian_, 0, out);
  out.flush();
}

void ProgramMatrices::put_kkt(TextStream& out) const {
  const int size = num_variables_ + num_constraints_;
  put_head("symmetric", size, size, hessian_.size() + jacobian_.size(), out);
  put_entries(hessian_, 0, out);
  put_entries(jacobian_, num_variables_, out);
  out.flush();
}

void put_vector(std::span<const double> values, TextStream& out) {
  out << "%%MatrixMarket matrix array real general\n"
      << values.size() << " 1\n";
  for (const double value : values) out << value << '\n';
  out.flush();
}

}  // namespace brachisto::program_files
