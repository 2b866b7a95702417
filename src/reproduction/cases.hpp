// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The scenes of the paper, solved.

#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "brachisto/io/problem_file.hpp"
#include "brachisto/study/solve.hpp"
#include "reproduction/transit.hpp"

namespace brachisto::reproduction {

/// A number and how far it may be off, both in its own unit.
struct Measured {
  double value = 0.0;
  double error = 0.0;
};

/// A scene of the paper and what came out.
struct Case {
  std::string name;      ///< of its problem file, without ending
  io::ProblemFile file;  ///< with its wanted accuracy
  Solution rough;        ///< as the file wants it
  /// A hundred times as accurate, with a second opinion of the indirect
  /// method; of a given path: the same.
  Solution fine;

  [[nodiscard]] bool verified() const {
    return rough.verified() && fine.verified();
  }
  [[nodiscard]] const Scene& scene() const { return fine.scene; }
  /// \pre verified()
  [[nodiscard]] const Motion& motion() const { return *fine.motion(); }
  /// τ with its estimated error.
  [[nodiscard]] Measured tau() const;
  /// Any number that follows from a solution; its error is the change from
  /// rough to fine, which bounds that of the fine one from above by far.
  [[nodiscard]] Measured measure(
      const std::function<double(const Solution&)>& quantity) const;
};

/// Called with the name of what begins.
using Announce = std::function<void(const std::string&)>;

/// All scenes of a directory by name.
class Cases {
 public:
  /// Solves every problem file of `directory`.
  /// \param required  names that have to be there
  /// \throws io::IoError, io::InputError  if one is not, or cannot be read
  /// \throws NotVerified  if a scene has no verified answer
  /// \throws Interrupted
  Cases(const std::filesystem::path& directory,
        const std::vector<std::string>& required, const Interrupt& interrupt,
        const Announce& announce);

  /// \throws io::IoError  if there is no file of that name
  [[nodiscard]] const Case& operator[](const std::string& name) const;
  [[nodiscard]] const std::map<std::string, Case>& all() const {
    return cases_;
  }

 private:
  [[nodiscard]] io::IoError missing(const std::string& name) const;

  std::filesystem::path directory_;
  std::map<std::string, Case> cases_;
};

}  // namespace brachisto::reproduction
