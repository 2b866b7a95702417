// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "chain_library/separable_program.hpp"

#include <IpStdCInterface.h>

#include <algorithm>
#include <cstddef>
#include <ctime>
#include <memory>
#include <type_traits>

namespace brachisto::benchmarks {

namespace {

using Number = SeparableProgram::Number;
using Element = SeparableProgram::Element;

double evaluating = 0.0;  ///< processor time of all evaluations [s]

double processor_time() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// Calls visit(element, its first row, cost, rows) with all derivatives at x.
template <class Visit>
void for_elements(const SeparableProgram& program, const double* x,
                  Visit&& visit) {
  const double begin = processor_time();
  int row = 0;
  std::array<Number, SeparableProgram::kWidth> values;
  std::array<Number, SeparableProgram::kRows> rows;
  for (const Element& element : program.elements) {
    for (int i = 0; i < element.count; ++i) {
      const auto k = static_cast<std::size_t>(i);
      values[k] = Number::variable(x[element.variables[k]], i);
    }
    Number cost(0.0);
    program.formulas(element, program.step, values.data(), cost, rows.data());
    visit(element, row, cost, rows);
    row += element.rows;
  }
  evaluating += processor_time() - begin;
}

int num_rows(const SeparableProgram& program) {
  int rows = 0;
  for (const Element& element : program.elements) rows += element.rows;
  return rows;
}

const SeparableProgram& of(UserDataPtr data) {
  return *static_cast<const SeparableProgram*>(data);
}

Bool eval_f(Index, double* x, Bool, double* f, UserDataPtr data) {
  *f = 0.0;
  for_elements(of(data), x,
               [&](const Element&, int, const Number& cost, const auto&) {
                 *f += cost.value;
               });
  return TRUE;
}

Bool eval_grad_f(Index n, double* x, Bool, double* gradient, UserDataPtr data) {
  std::fill(gradient, gradient + n, 0.0);
  for_elements(of(data), x,
               [&](const Element& e, int, const Number& cost, const auto&) {
                 for (int i = 0; i < e.count; ++i) {
                   const auto k = static_cast<std::size_t>(i);
                   gradient[e.variables[k]] += cost.gradient[k];
                 }
               });
  return TRUE;
}

Bool eval_g(Index, double* x, Bool, Index, double* g, UserDataPtr data) {
  for_elements(of(data), x,
               [&](const Element& e, int row, const Number&, const auto& rows) {
                 for (int r = 0; r < e.rows; ++r) {
                   g[row + r] = rows[static_cast<std::size_t>(r)].value;
                 }
               });
  return TRUE;
}

/// Calls put(row, column, value) for each entry; values only if x is there.
template <class Put>
void jacobian(const SeparableProgram& program, const double* x, Put&& put) {
  const auto entries = [&](const Element& e, int row, const auto* rows) {
    for (int r = 0; r < e.rows; ++r) {
      for (int i = 0; i < e.count; ++i) {
        const auto k = static_cast<std::size_t>(i);
        put(row + r, e.variables[k],
            rows == nullptr ? 0.0
                            : (*rows)[static_cast<std::size_t>(r)].gradient[k]);
      }
    }
  };
  if (x != nullptr) {
    for_elements(program, x,
                 [&](const Element& e, int row, const Number&,
                     const auto& rows) { entries(e, row, &rows); });
    return;
  }
  int row = 0;
  const std::array<Number, SeparableProgram::kRows>* none = nullptr;
  for (const Element& e : program.elements) {
    entries(e, row, none);
    row += e.rows;
  }
}

Bool eval_jac_g(Index, double* x, Bool, Index, Index, Index* i, Index* j,
                double* values, UserDataPtr data) {
  std::size_t entry = 0;
  jacobian(of(data), values == nullptr ? nullptr : x,
           [&](int row, int column, double value) {
             if (values != nullptr) {
               values[entry++] = value;
             } else {
               i[entry] = row;
               j[entry++] = column;
             }
           });
  return TRUE;
}

Bool eval_h(Index, double* x, Bool, double factor, Index, double* lambda, Bool,
            Index, Index* i, Index* j, double* values, UserDataPtr data) {
  const SeparableProgram& program = of(data);
  std::size_t entry = 0;
  if (values == nullptr) {
    for (const Element& e : program.elements) {
      for (int a = 0; a < e.count; ++a) {
        for (int b = 0; b <= a; ++b) {
          const int one = e.variables[static_cast<std::size_t>(a)];
          const int other = e.variables[static_cast<std::size_t>(b)];
          i[entry] = std::max(one, other);
          j[entry++] = std::min(one, other);
        }
      }
    }
    return TRUE;
  }
  for_elements(
      program, x,
      [&](const Element& e, int row, const Number& cost, const auto& rows) {
        for (int a = 0; a < e.count; ++a) {
          for (int b = 0; b <= a; ++b) {
            double value = factor * cost.hessian[Number::pair(a, b)];
            for (int r = 0; r < e.rows; ++r) {
              value +=
                  lambda[row + r] *
                  rows[static_cast<std::size_t>(r)].hessian[Number::pair(a, b)];
            }
            values[entry++] = value;
          }
        }
      });
  return TRUE;
}

int iterations_done = 0;

Bool count(Index, Index iteration, double, double, double, double, double,
           double, double, double, Index, UserDataPtr) {
  iterations_done = iteration;
  return TRUE;
}

}  // namespace

int SeparableProgram::add_variable(double at, double least, double most) {
  start.push_back(at);
  lower.push_back(least);
  upper.push_back(most);
  return size() - 1;
}

ProgramRun solve(const SeparableProgram& program, const std::string& solver) {
  SeparableProgram copy = program;
  std::size_t jac_entries = 0, hess_entries = 0;
  for (const Element& e : copy.elements) {
    const auto width = static_cast<std::size_t>(e.count);
    jac_entries += width * static_cast<std::size_t>(e.rows);
    hess_entries += width * (width + 1) / 2;
  }
  const int m = num_rows(copy);
  std::vector<double> zero(static_cast<std::size_t>(m));
  const std::unique_ptr<std::remove_pointer_t<IpoptProblem>,
                        decltype(&FreeIpoptProblem)>
      problem(CreateIpoptProblem(copy.size(), copy.lower.data(),
                                 copy.upper.data(), m, zero.data(), zero.data(),
                                 static_cast<Index>(jac_entries),
                                 static_cast<Index>(hess_entries), 0, eval_f,
                                 eval_g, eval_grad_f, eval_jac_g, eval_h),
              &FreeIpoptProblem);
  const auto set = [&](const char* key, std::string value) {
    std::string name = key;
    AddIpoptStrOption(problem.get(), name.data(), value.data());
  };
  const auto set_number = [&](const char* key, double value) {
    std::string name = key;
    AddIpoptNumOption(problem.get(), name.data(), value);
  };
  std::string silent = "print_level";
  AddIpoptIntOption(problem.get(), silent.data(), 0);
  set("sb", "yes");
  set("linear_solver", solver);
  set("linear_system_scaling", "none");
  set_number("tol", 1e-9);
  SetIntermediateCallback(problem.get(), count);
  ProgramRun out;
  evaluating = 0.0;
  const double begin = processor_time();
  out.status = IpoptSolve(problem.get(), copy.start.data(), nullptr, &out.cost,
                          nullptr, nullptr, nullptr, &copy);
  out.cpu = processor_time() - begin - evaluating;
  out.iterations = iterations_done;
  return out;
}

}  // namespace brachisto::benchmarks
