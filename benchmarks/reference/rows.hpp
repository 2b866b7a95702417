// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The rows of the reference set, measured.

#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "reference/classic.hpp"

namespace brachisto::benchmarks {

/// One tolerance, and what came of it.
struct WorkPoint {
  double tolerance, error, estimate, seconds;
  bool verified;
};

struct ClassicRow {
  const Classic* classic;
  double value, estimate, seconds;
  bool verified;
  std::string why_not;
  int elements, variables, constraints;
  std::vector<double> junctions;
  std::vector<WorkPoint> work;
  /// Ipopt with MUMPS on the .nl file of the last mesh, from the guess.
  std::string peer_status;
  double peer_value, peer_seconds;
  std::string nl_file;
};

/// Writes the .nl file into a folder.
[[nodiscard]] ClassicRow measured(const Classic& classic,
                                  const std::filesystem::path& folder);

/// A track of a rolling body, by the program and by what shares no code.
struct RollingRow {
  std::string name, second;
  bool limited;
  double tau, second_tau, seconds;
  bool verified;
};

[[nodiscard]] std::vector<RollingRow> rolling_rows();

struct ReferenceSet {
  std::vector<ClassicRow> classics;
  std::vector<RollingRow> rolling;
  std::string stamp;  ///< when and where it was measured
};

/// "1.5e-12", "–" for NaN.
[[nodiscard]] std::string brief(double value);
[[nodiscard]] std::string page_of(const ReferenceSet& set);
[[nodiscard]] nlohmann::ordered_json json_of(const ReferenceSet& set);

}  // namespace brachisto::benchmarks
