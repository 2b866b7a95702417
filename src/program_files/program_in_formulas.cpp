// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "program_files/program_in_formulas.hpp"

#include <stdexcept>

#include "program_files/arc_length_formulas.hpp"
#include "program_files/limited_time_formulas.hpp"
#include "program_files/rolling_time_formulas.hpp"

namespace brachisto::program_files {

std::string no_formulas_because(const Scene& scene) {
  if (scene.world.sphere) {
    return "a sphere's field has another formula inside than outside: which "
           "one holds depends on the place";
  }
  return {};
}

std::unique_ptr<ProgramInFormulas> in_formulas(const Transcription& problem) {
  if (const auto* rolling = dynamic_cast<const RollingTime*>(&problem)) {
    return std::make_unique<RollingTimeFormulas>(*rolling);
  }
  if (const auto* pieces = dynamic_cast<const ArcLength*>(&problem)) {
    return std::make_unique<ArcLengthFormulas>(*pieces);
  }
  if (const auto* limited = dynamic_cast<const LimitedTime*>(&problem)) {
    return std::make_unique<LimitedTimeFormulas>(*limited);
  }
  throw std::logic_error("a kind of transcription without formulas");
}

}  // namespace brachisto::program_files
