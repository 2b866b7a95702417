// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "program_files/program_in_formulas.hpp"

#include <stdexcept>

#include "transcription/arc_length.hpp"
#include "transcription/limited_time.hpp"
#include "transcription/rolling_time.hpp"

namespace brachisto::program_files {

std::unique_ptr<ProgramInFormulas> in_formulas(const Transcription& problem) {
  if (const auto* rolling = dynamic_cast<const RollingTime*>(&problem)) {
    return in_formulas(*rolling);
  }
  if (const auto* limited = dynamic_cast<const LimitedTime*>(&problem)) {
    return in_formulas(*limited);
  }
  if (const auto* pieces = dynamic_cast<const ArcLength*>(&problem)) {
    return in_formulas(*pieces);
  }
  throw std::logic_error("a kind of transcription without formulas");
}

}  // namespace brachisto::program_files
