// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// One solve of a program by one of the peers, in the process that calls.

#pragma once

#include <filesystem>

#include "peers/ipopt_with_mumps.hpp"
#include "peers/program.hpp"
#include "peers/runs.hpp"

namespace brachisto::benchmarks {

/// Makes a program, or reads it from the file if the peer does, and solves it.
/// \throws std::runtime_error  if what is found is no point of the program
[[nodiscard]] Record measure(const ReferenceCase& reference, const Way& way,
                             int nodes, const std::filesystem::path& nl_file,
                             const MumpsOptions& mumps);

/// By how much the second derivatives that a file's reader finds at the start
/// differ from the program's own, relative: of both matrices times a vector.
[[nodiscard]] double difference_of_hessians(
    const ReferenceCase& reference, Formulation formulation, int nodes,
    const std::filesystem::path& nl_file);

}  // namespace brachisto::benchmarks
