// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// The flags of solve that ask for a track to be built.

#pragma once

#include <string>
#include <vector>

#include "app/command_line.hpp"
#include "brachisto/model/body.hpp"
#include "brachisto/study/solution.hpp"
#include "report/cutting_build.hpp"
#include "report/cutting_drawing.hpp"

namespace brachisto::app {

/// --track-svg, --track-dxf, and how the track is built.
class BuildFlags {
 public:
  [[nodiscard]] std::vector<Flag> flags();

  /// What can be refused before the scene is solved.
  /// \throws UsageError, report::OutputError
  void check(const Scene& scene, bool force) const;
  /// The sheets of a solution, which are to be written once its results are; of
  /// one that is not verified or not feasible none.
  /// \throws UsageError, report::OutputError
  [[nodiscard]] std::vector<report::cutting::Drawing> drawings(
      const Solution& solution, const std::vector<MassPart>& made_of,
      bool force) const;
  /// Into one directory all or none of them; sheets of an earlier track that
  /// had more of them go. \throws report::OutputError
  void write(const std::vector<report::cutting::Drawing>& drawings,
             bool force) const;

 private:
  [[nodiscard]] bool any() const { return !svg_.empty() || !dxf_.empty(); }
  [[nodiscard]] report::cutting::Build build() const;

  std::string svg_, dxf_;
  std::string sheet_ = "600x400", scale_ = "1:1";
  double strip_ = 40.0, thickness_ = 3.0, hole_ = 6.0;
  double gauge_ = 0.0;  ///< 0: one strip
};

}  // namespace brachisto::app
