// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The worker: solves what it is told to, and nothing else.

#pragma once

#include <iosfwd>

namespace brachisto::sweep {

/// Reads the job and then requests from `in`, one per line, until it ends;
/// writes one answer per scene to `out`. A solve that throws is an answer too.
void run_worker(std::istream& in, std::ostream& out);

}  // namespace brachisto::sweep
