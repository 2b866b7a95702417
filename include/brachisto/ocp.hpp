// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Optimal-control problems of one's own, and nothing else of the library.

#pragma once

#include "brachisto/nlp/problem.hpp"
#include "brachisto/ocp/least_cost.hpp"
#include "brachisto/posed/problem.hpp"
#include "brachisto/posed/statement.hpp"
#include "brachisto/solvers/program_solvers.hpp"
