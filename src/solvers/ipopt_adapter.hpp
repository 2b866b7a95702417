// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// The adapter between our problem interface and Ipopt's. It contains no
// mathematics, and with ipopt.cpp it is the only code that sees Ipopt.

#pragma once

#include <IpTNLP.hpp>
#include <exception>

#include "brachisto/nlp/problem.hpp"
#include "brachisto/solvers/program_solvers.hpp"

namespace brachisto {

/// An nlp::Problem as a TNLP.
class IpoptAdapter final : public Ipopt::TNLP {
 public:
  /// All arguments must outlive the adapter.
  /// \param effort  what the run has taken so far, which options.most_effort
  ///                ends before the next iteration, in restoration too; null if
  ///                nobody counts it
  IpoptAdapter(nlp::Problem& problem, const PrimalDual& start,
               const IpoptOptions& options, const double* effort);

  /// The last iterate, empty if Ipopt did not hand one over.
  [[nodiscard]] const PrimalDual& final_point() const { return final_point_; }
  [[nodiscard]] int iterations() const { return iterations_; }
  [[nodiscard]] int refused_points() const { return refused_points_; }
  [[nodiscard]] const std::string& last_refusal() const {
    return last_refusal_;
  }
  /// Whether IpoptOptions::most_effort ended the run.
  [[nodiscard]] bool tired() const { return tired_; }
  /// What ended the run, if the problem or check_stop() threw.
  [[nodiscard]] std::exception_ptr exception() const { return exception_; }

  bool get_nlp_info(Ipopt::Index& n, Ipopt::Index& m, Ipopt::Index& nnz_jac_g,
                    Ipopt::Index& nnz_h_lag,
                    IndexStyleEnum& index_style) override;
  bool get_bounds_info(Ipopt::Index n, Ipopt::Number* x_l, Ipopt::Number* x_u,
                       Ipopt::Index m, Ipopt::Number* g_l,
                       Ipopt::Number* g_u) override;
  bool get_starting_point(Ipopt::Index n, bool init_x, Ipopt::Number* x,
                          bool init_z, Ipopt::Number* z_L, Ipopt::Number* z_U,
                          Ipopt::Index m, bool init_lambda,
                          Ipopt::Number* lambda) override;
  bool eval_f(Ipopt::Index n, const Ipopt::Number* x, bool new_x,
              Ipopt::Number& obj_value) override;
  bool eval_grad_f(Ipopt::Index n, const Ipopt::Number* x, bool new_x,
                   Ipopt::Number* grad_f) override;
  bool eval_g(Ipopt::Index n, const Ipopt::Number* x, bool new_x,
              Ipopt::Index m, Ipopt::Number* g) override;
  bool eval_jac_g(Ipopt::Index n, const Ipopt::Number* x, bool new_x,
                  Ipopt::Index m, Ipopt::Index nele_jac, Ipopt::Index* iRow,
                  Ipopt::Index* jCol, Ipopt::Number* values) override;
  bool eval_h(Ipopt::Index n, const Ipopt::Number* x, bool new_x,
              Ipopt::Number obj_factor, Ipopt::Index m,
              const Ipopt::Number* lambda, bool new_lambda,
              Ipopt::Index nele_hess, Ipopt::Index* iRow, Ipopt::Index* jCol,
              Ipopt::Number* values) override;
  bool intermediate_callback(Ipopt::AlgorithmMode mode, Ipopt::Index iter,
                             Ipopt::Number obj_value, Ipopt::Number inf_pr,
                             Ipopt::Number inf_du, Ipopt::Number mu,
                             Ipopt::Number d_norm,
                             Ipopt::Number regularization_size,
                             Ipopt::Number alpha_du, Ipopt::Number alpha_pr,
                             Ipopt::Index ls_trials,
                             const Ipopt::IpoptData* ip_data,
                             Ipopt::IpoptCalculatedQuantities* ip_cq) override;
  void finalize_solution(Ipopt::SolverReturn status, Ipopt::Index n,
                         const Ipopt::Number* x, const Ipopt::Number* z_L,
                         const Ipopt::Number* z_U, Ipopt::Index m,
                         const Ipopt::Number* g, const Ipopt::Number* lambda,
                         Ipopt::Number obj_value,
                         const Ipopt::IpoptData* ip_data,
                         Ipopt::IpoptCalculatedQuantities* ip_cq) override;

 private:
  /// Runs `evaluate` at x. False, which makes Ipopt shorten its step, if the
  /// problem refuses x; keeps an exception if one is thrown on.
  template <class Evaluate>
  bool guarded(const Ipopt::Number* x, bool new_x, Evaluate&& evaluate);
  /// The same, but what is thrown is false.
  template <class Evaluate>
  bool answered(const Ipopt::Number* x, bool new_x, Evaluate&& evaluate);

  nlp::Problem& problem_;
  const PrimalDual& start_;
  const IpoptOptions& options_;
  const double* effort_;
  bool tired_ = false;
  PrimalDual final_point_;
  int iterations_ = 0;
  int refused_points_ = 0;
  bool have_point_ = false;
  bool accepted_ = false;
  std::string last_refusal_;
  std::exception_ptr exception_;
};

}  // namespace brachisto
