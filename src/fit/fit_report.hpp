// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What a fit says: for a person, for programs, and as a picture.

#pragma once

#include <string>
#include <vector>

#include "fit/fit_times.hpp"
#include "report/figure.hpp"

namespace brachisto::fit {

/// What was fitted to what.
struct Subject {
  std::string file;          ///< problem file
  std::string measurements;  ///< file of times
};

/// A dozen lines and the table of residuals.
[[nodiscard]] std::string summary(const Fit& fit);

/// The document fit.json; docs/fit.md has its keys.
[[nodiscard]] std::string to_json(const Fit& fit, const Subject& subject);

/// Residuals over the place, with the error that each time is said to have.
[[nodiscard]] report::Figure residual_figure(const Fit& fit);

/// What does not speak for the fit: values that no scene may have, χ² that the
/// stated errors do not explain. One sentence each.
[[nodiscard]] std::vector<std::string> doubts(const Fit& fit);

/// The values that a problem file may have, KEY=VALUE each: those found, or
/// where no scene may have them the nearest that one may.
[[nodiscard]] std::vector<std::string> overrides_of(const Fit& fit);

/// Lines of a comment that say where the values of a file come from.
[[nodiscard]] std::string comment(const Fit& fit, const Subject& subject);

}  // namespace brachisto::fit
