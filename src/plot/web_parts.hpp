// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Files that are part of the program, byte by byte: those of src/plot/web and
/// Debian's dygraphs. The build writes the source of this header
/// (src/cmake/EmbedFiles.cmake).

#pragma once

#include <string_view>

namespace brachisto::plot {

extern const std::string_view kDocumentStyle;  ///< web/document.css
extern const std::string_view kMotionScript;   ///< web/motion.js
extern const std::string_view kRaceScript;     ///< web/race.js
extern const std::string_view kRaceStyle;      ///< web/race.css
extern const std::string_view kSweepScript;    ///< web/sweep.js
extern const std::string_view kSweepStyle;     ///< web/sweep.css
extern const std::string_view kAnswerScript;   ///< web/answer.js
extern const std::string_view kAnswerStyle;    ///< web/answer.css
extern const std::string_view kChartScript;    ///< dygraph.min.js
extern const std::string_view kChartStyle;     ///< dygraph.min.css
extern const std::string_view kChartLicence;   ///< web/dygraphs.LICENCE

}  // namespace brachisto::plot
