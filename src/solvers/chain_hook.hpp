// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// The chain factorisation as a linear solver of Ipopt, which is not made for
// further ones: it takes the place of HSL's MA97.

#pragma once

#include <exception>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "brachisto/nlp/problem.hpp"
#include "brachisto/solvers/ipopt.hpp"

namespace brachisto {

/// Puts the chain factorisation of one problem in the place of MA97 as long as
/// it lives; Ipopt uses it if its option linear_solver says ma97.
///
/// Ipopt's HSLLoader lets a program set the functions of MA97 but hands no
/// pointer of ours to them, so the hook in force is a variable of the process:
/// it lives within a OneAtATime, as MUMPS has to.
class ChainHook {
 public:
  /// The release of Ipopt whose structs are known here, and whose KKT matrix.
  static constexpr std::string_view kRelease = "3.11.9";
  /// Whether the Ipopt this was compiled against is that release.
  [[nodiscard]] static bool available();

  /// \param release  the one to insist on, kRelease but in tests
  /// \pre available(), the problem states a chain structure, and no other hook
  ///      lives
  ChainHook(const nlp::Problem& problem, std::string_view release);
  ~ChainHook();
  ChainHook(const ChainHook&) = delete;
  ChainHook& operator=(const ChainHook&) = delete;

  /// Why the matrix Ipopt came with is not the chain it should be; empty if it
  /// is. Ipopt itself then ends with an internal error.
  [[nodiscard]] const std::string& refusal() const { return refusal_; }

  /// The release of the Ipopt that runs, by its own words; empty until then.
  [[nodiscard]] const std::string& release() const { return release_; }
  void set_release(std::string release) { release_ = std::move(release); }
  [[nodiscard]] bool right_release() const { return release_ == wanted_; }
  [[nodiscard]] std::string_view wanted_release() const { return wanted_; }

  /// In Ipopt's numbering of the KKT matrix: free variables, slacks of
  /// inequalities, multipliers of equations, multipliers of inequalities.
  [[nodiscard]] const nlp::ChainStructure& structure() const {
    return structure_;
  }
  /// Of these the ones with bounds, whose diagonal entries grow without limit.
  [[nodiscard]] const std::vector<int>& bounded() const { return bounded_; }
  void refuse(const std::string& why) { refusal_ = why; }
  /// What the factorisation threw, if it did.
  [[nodiscard]] std::exception_ptr exception() const { return exception_; }
  void keep(std::exception_ptr exception) { exception_ = std::move(exception); }

 private:
  nlp::ChainStructure structure_;
  std::vector<int> bounded_;
  std::string_view wanted_;
  std::string release_;
  std::string refusal_;
  std::exception_ptr exception_;
};

/// The same as without a release, for the chain to insist on another one.
[[nodiscard]] SolverResult solve_with_ipopt(nlp::Problem& problem,
                                            const PrimalDual& start,
                                            const IpoptOptions& options,
                                            std::string_view release);

}  // namespace brachisto
