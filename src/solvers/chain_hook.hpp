// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// The chain factorisation as a linear solver of Ipopt, which is not made for
// further ones: it takes the place of HSL's MA97.

#pragma once

#include <exception>
#include <string>
#include <utility>

#include "brachisto/nlp/problem.hpp"

namespace brachisto {

/// Puts the chain factorisation of one problem in the place of MA97 as long as
/// it lives; Ipopt uses it if its option linear_solver says ma97.
///
/// Ipopt's HSLLoader lets a program set the functions of MA97 but hands no
/// pointer of ours to them, so the hook in force is a variable of the process:
/// it lives within a OneAtATime, as MUMPS has to.
class ChainHook {
 public:
  /// Whether the Ipopt this was compiled against has the hook, with structs
  /// known here: release 3.11.9.
  [[nodiscard]] static bool available();

  /// \pre available(), the problem states a chain structure, and no other hook
  ///      lives
  explicit ChainHook(const nlp::Problem& problem);
  ~ChainHook();
  ChainHook(const ChainHook&) = delete;
  ChainHook& operator=(const ChainHook&) = delete;

  /// Why the matrix Ipopt came with is not the chain it should be; empty if it
  /// is. Ipopt itself then ends with an internal error.
  [[nodiscard]] const std::string& refusal() const { return refusal_; }
  [[nodiscard]] int factorisations() const { return factorisations_; }

  /// In Ipopt's numbering of the KKT matrix: free variables, multipliers.
  [[nodiscard]] const nlp::ChainStructure& structure() const {
    return structure_;
  }
  void refuse(const std::string& why) { refusal_ = why; }
  /// What the factorisation threw, if it did.
  [[nodiscard]] std::exception_ptr exception() const { return exception_; }
  void keep(std::exception_ptr exception) { exception_ = std::move(exception); }
  void count_factorisation() { ++factorisations_; }

 private:
  nlp::ChainStructure structure_;
  std::string refusal_;
  std::exception_ptr exception_;
  int factorisations_ = 0;
};

}  // namespace brachisto
