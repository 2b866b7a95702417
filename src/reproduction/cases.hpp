// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The scenes of the paper, solved.

#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <map>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "brachisto/io/problem_file.hpp"
#include "brachisto/study/solve.hpp"

namespace brachisto::reproduction {

/// Something has no verified answer; what() says what and why.
class NotVerified : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

inline constexpr double kDegrees = 180.0 / std::numbers::pi;  ///< in 1 rad

/// The flag that a signal sets.
using Interrupt = std::atomic<int>;

/// \throws Interrupted  if the flag is set
void check(const Interrupt& interrupt);

/// The answer to a scene, to a relative error of 1e-12 unless told.
/// \throws NotVerified  without a verified answer
/// \throws Interrupted
[[nodiscard]] Solution verified_solution(const Scene& scene,
                                         const Interrupt& interrupt,
                                         double tolerance = 1e-12);

/// Its τ.
[[nodiscard]] double verified_tau(const Scene& scene,
                                  const Interrupt& interrupt);

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
  /// A hundred times as accurate, cross-checked by the indirect
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
