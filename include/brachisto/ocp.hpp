// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// An optimal-control problem of one's own: ControlProblem says what it is,
/// LeastCost makes the nonlinear program of it. The other headers are what
/// these are made of.

#pragma once

#include "brachisto/ocp/collocation.hpp"
#include "brachisto/ocp/element_chain.hpp"
#include "brachisto/ocp/entries.hpp"
#include "brachisto/ocp/evaluated_points.hpp"
#include "brachisto/ocp/layout.hpp"
#include "brachisto/ocp/least_cost.hpp"
#include "brachisto/ocp/local_structure.hpp"
#include "brachisto/ocp/mesh.hpp"
#include "brachisto/ocp/point_function.hpp"
#include "brachisto/ocp/program.hpp"
#include "brachisto/ocp/scheme.hpp"
