// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The scenes of the paper, solved, and which of them belong together.

#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <map>
#include <numbers>
#include <span>
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
/// The same by other options.
[[nodiscard]] Solution verified_solution(const Scene& scene,
                                         const Interrupt& interrupt,
                                         const SolveOptions& options);

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

// The families of tracks that the paper draws.

/// A case and its name in the key of a figure.
struct Member {
  const char* file;
  const char* name;
};

using Members = std::span<const Member>;

/// Fig. 8, by η_m.
inline constexpr Member kByOffset[] = {{"fig08_eta_m_0", "η_m = 0"},
                                       {"fig08_eta_m_1_6", "η_m = 1/6"},
                                       {"fig08_eta_m_1_3", "η_m = 1/3"},
                                       {"fig08_eta_m_1_2", "η_m = 1/2"},
                                       {"fig04_reference_case", "η_m = 2/3"},
                                       {"fig08_eta_m_1_sqrt2", "η_m = 1/√2"}};

/// Fig. 9, by θ_m.
inline constexpr Member kByOrientation[] = {
    {"fig09_theta_m_m90deg", "θ_m = −90°"},
    {"fig09_theta_m_m60deg", "θ_m = −60°"},
    {"fig09_theta_m_m30deg", "θ_m = −30°"},
    {"fig04_reference_case", "θ_m = 0"},
    {"fig09_theta_m_p30deg", "θ_m = 30°"},
    {"fig09_theta_m_p60deg", "θ_m = 60°"},
    {"fig09_theta_m_p90deg", "θ_m = 90°"}};

/// Fig. 10, by k.
inline constexpr Member kByInertia[] = {{"fig10_k_0.1", "k = 0.1"},
                                        {"fig10_k_0.3", "k = 0.3"},
                                        {"fig04_reference_case", "k = 0.5"},
                                        {"fig10_k_5_9", "k = 5/9"}};

/// Fig. 11, by r, with the offset 2/3 of its caption.
inline constexpr Member kByRadius[] = {{"fig11_r_0.2", "r = 0.2"},
                                       {"fig11_r_0.25", "r = 0.25"},
                                       {"fig04_reference_case", "r = 1/3"},
                                       {"fig11_r_0.4", "r = 0.4"},
                                       {"fig11_r_0.5", "r = 0.5"}};

/// Fig. 11, by r, with the offset 1/3 of its text.
inline constexpr Member kByRadiusOfTheText[] = {
    {"fig11_r_0.2_eta_m_1_3", "r = 0.2"},
    {"fig11_r_0.25_eta_m_1_3", "r = 0.25"},
    {"fig11_r_1_3_eta_m_1_3", "r = 1/3"},
    {"fig11_r_0.4_eta_m_1_3", "r = 0.4"},
    {"fig11_r_0.5_eta_m_1_3", "r = 0.5"}};

/// Fig. 12, by L.
inline constexpr Member kByLength[] = {{"fig12_L_2", "L = 2"},
                                       {"fig04_reference_case", "L = 3"},
                                       {"fig12_L_4", "L = 4"}};

}  // namespace brachisto::reproduction
