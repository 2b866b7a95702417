// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The scenes of the paper, solved.

#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "brachisto/io/problem_file.hpp"
#include "brachisto/study/solve.hpp"

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
  Solution fine;         ///< a hundred times as accurate; of a given path: the
                         ///< same

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
  /// \param interrupt  nonzero: stop
  /// \throws io::IoError, io::InputError  if a file cannot be read
  Cases(const std::filesystem::path& directory,
        const std::atomic<int>& interrupt, const Announce& announce);

  /// \throws NotVerified  if there is no file of that name, or its scene
  ///                             has no verified answer
  [[nodiscard]] const Case& operator[](const std::string& name) const;
  [[nodiscard]] const std::map<std::string, Case>& all() const {
    return cases_;
  }

 private:
  std::filesystem::path directory_;
  std::map<std::string, Case> cases_;
};

}  // namespace brachisto::reproduction
