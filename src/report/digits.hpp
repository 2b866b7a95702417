// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Numbers for people: no digit beyond the error.

#pragma once

#include <string>

namespace brachisto::report {

/// A value with its digits up to the error and the error in units of the last
/// one, rounded up: "5.09344446660(5)" is 5.0934444666 ± 5e-11. With an error
/// that is not known, or none, 12 digits and nothing behind them.
/// \param error  absolute, of the value
[[nodiscard]] std::string with_error(double value, double error);

/// The digits of a value that its error leaves, without the error: "5.0934".
[[nodiscard]] std::string within_error(double value, double error);

}  // namespace brachisto::report
