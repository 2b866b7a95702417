// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// All of the library's interface; docs/library.md leads through it.

#pragma once

#include "brachisto/io/problem_file.hpp"
#include "brachisto/math/clock.hpp"
#include "brachisto/math/index.hpp"
#include "brachisto/math/jet.hpp"
#include "brachisto/math/polynomial_basis.hpp"
#include "brachisto/model/body.hpp"
#include "brachisto/model/kinematics.hpp"
#include "brachisto/model/scene.hpp"
#include "brachisto/model/world.hpp"
#include "brachisto/nlp/problem.hpp"
#include "brachisto/ocp.hpp"
#include "brachisto/ocp/collocation.hpp"
#include "brachisto/ocp/end_functions.hpp"
#include "brachisto/ocp/evaluated_points.hpp"
#include "brachisto/ocp/least_cost.hpp"
#include "brachisto/ocp/mesh.hpp"
#include "brachisto/ocp/point_function.hpp"
#include "brachisto/ocp/program.hpp"
#include "brachisto/posed/problem.hpp"
#include "brachisto/posed/statement.hpp"
#include "brachisto/report/result.hpp"
#include "brachisto/run/solve_options.hpp"
#include "brachisto/solvers/program_solvers.hpp"
#include "brachisto/solvers/status.hpp"
#include "brachisto/study/design.hpp"
#include "brachisto/study/solution.hpp"
#include "brachisto/study/solve.hpp"
#include "brachisto/trajectory/motion.hpp"
#include "brachisto/version.hpp"
