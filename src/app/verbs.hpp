// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// The verbs of the command, one source file each.

#pragma once

#include <string>
#include <vector>

#include "app/command_line.hpp"

namespace brachisto::app {

/// Flags that every verb with a problem file shares.
struct CommonFlags {
  std::string file;
  std::vector<std::string> overrides;  ///< --set KEY=VALUE
  bool json = false;
  bool quiet = false;

  /// Their descriptions, before those of one verb.
  [[nodiscard]] std::vector<Flag> with(
      std::vector<Flag> own,
      const char* text_of_file = "Problem file (YAML); - is standard input");
};

[[nodiscard]] Verb solve_verb();
[[nodiscard]] Verb design_verb();
[[nodiscard]] Verb fit_verb();
[[nodiscard]] Verb validate_verb();
[[nodiscard]] Verb schema_verb();
[[nodiscard]] Verb sweep_verb();
[[nodiscard]] Verb export_verb();
[[nodiscard]] Verb merge_verb();
[[nodiscard]] Verb report_verb();
[[nodiscard]] Verb show_verb();
[[nodiscard]] Verb race_verb();
[[nodiscard]] Verb paper_verb();
[[nodiscard]] Verb body_verb();
[[nodiscard]] Verb table_verb();
[[nodiscard]] Verb compare_verb();
[[nodiscard]] Verb work_precision_verb();
[[nodiscard]] Verb nlp_verb();
[[nodiscard]] Verb derivatives_verb();
[[nodiscard]] Verb prove_verb();
[[nodiscard]] Verb check_proof_verb();
[[nodiscard]] Verb new_verb();
/// \param whole  the command line that it speaks of
[[nodiscard]] Verb complete_verb(CommandLine (*whole)());  ///< for shells
[[nodiscard]] Verb worker_verb();   ///< for sweeps, not for people
[[nodiscard]] Verb measure_verb();  ///< for comparisons, not for people

}  // namespace brachisto::app
