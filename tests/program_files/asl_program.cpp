// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "program_files/asl_program.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

// It defines names such as n_var for members of a variable `asl`; last, since
// macros of it spoil other headers.
#include <asl_pfgh.h>

namespace brachisto::testing {

namespace {

std::size_t place(int i) {
  return static_cast<std::size_t>(i);
}

/// The library knows numbers from 1e30 on as infinite.
double bound(double value) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  constexpr double kLargest = 1e30;
  return value >= kLargest    ? kInfinity
         : value <= -kLargest ? -kInfinity
                              : value;
}

}  // namespace

struct AslProgram::Library {
  ASL* asl = ASL_alloc(ASL_read_pfgh);
  Library() = default;
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;
  ~Library() { ASL_free(&asl); }
};

AslProgram::AslProgram(const std::filesystem::path& nl_file)
    : library_(std::make_unique<Library>()) {
  ASL* asl = library_->asl;
  std::string stub = nl_file.string();
  FILE* file = jac0dim(stub.data(), static_cast<fint>(stub.size()));
  if (file == nullptr) throw std::runtime_error("cannot read " + stub);
  want_xpi0 = 3;
  if (pfgh_read(file, ASL_return_read_err) != 0) {
    throw std::runtime_error("not understood: " + stub);
  }
  for (int i = 0; i < n_var; ++i) {
    ranges_.push_back({bound(LUv[2 * i]), bound(LUv[2 * i + 1])});
    start_.x.push_back(X0[i]);
  }
  std::vector<nlp::SparsityPattern::Position> jacobian(place(nzc));
  for (int i = 0; i < n_con; ++i) {
    row_ranges_.push_back({bound(LUrhs[2 * i]), bound(LUrhs[2 * i + 1])});
    if (pi0 != nullptr) start_.lambda.push_back(-pi0[i]);
    for (const cgrad* entry = Cgrad[i]; entry != nullptr; entry = entry->next) {
      jacobian[place(entry->goff)] = {i, entry->varno};
    }
  }
  for (const auto& [row, col] : jacobian) jacobian_.add(row, col);
  // The upper triangle column by column is the lower one row by row.
  const int entries = static_cast<int>(sphsetup(-1, 1, 1, 1));
  hessian_.reserve(place(entries));
  for (int row = 0; row < n_var; ++row) {
    for (int k = sputinfo->hcolstarts[row]; k < sputinfo->hcolstarts[row + 1];
         ++k) {
      hessian_.add(row, sputinfo->hrownos[k]);
    }
  }
  g_.resize(place(n_con));
}

AslProgram::~AslProgram() = default;

void AslProgram::write_solution(const std::string& message,
                                PrimalDual answer) const {
  ASL* asl = library_->asl;
  std::string text = message;
  for (double& multiplier : answer.lambda) multiplier = -multiplier;
  solve_result_num = 0;
  write_sol(text.data(), answer.x.data(), answer.lambda.data(), nullptr);
}

int AslProgram::num_variables() const {
  const ASL* asl = library_->asl;
  return n_var;
}

int AslProgram::num_constraints() const {
  const ASL* asl = library_->asl;
  return n_con;
}

std::string AslProgram::variable_name(int index) const {
  ASL* asl = library_->asl;
  return var_name(index);
}

std::string AslProgram::constraint_name(int index) const {
  ASL* asl = library_->asl;
  return con_name(index);
}

bool AslProgram::do_set_point(std::span<const double> x) {
  ASL* asl = library_->asl;
  x_.assign(x.begin(), x.end());
  fint error = 0;
  f_ = objval(0, x_.data(), &error);
  if (error != 0) return false;
  conval(x_.data(), g_.data(), &error);
  return error == 0;
}

double AslProgram::do_eval_f() const {
  return f_;
}

void AslProgram::do_eval_g(std::span<double> g) const {
  std::ranges::copy(g_, g.begin());
}

void AslProgram::do_eval_grad_f(std::span<double> grad_f) const {
  ASL* asl = library_->asl;
  std::vector<double> x = x_;
  fint error = 0;
  objgrd(0, x.data(), grad_f.data(), &error);
}

void AslProgram::do_eval_jac_g(std::span<double> values) const {
  ASL* asl = library_->asl;
  std::vector<double> x = x_;
  fint error = 0;
  jacval(x.data(), values.data(), &error);
}

void AslProgram::do_eval_hess_lag(double objective_factor,
                                  std::span<const double> lambda,
                                  std::span<double> values) const {
  ASL* asl = library_->asl;
  std::vector<double> y(lambda.begin(), lambda.end());
  sphes(values.data(), -1, &objective_factor, y.data());
}

}  // namespace brachisto::testing
