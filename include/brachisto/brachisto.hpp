// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// All of the library's interface; docs/library.md leads through it.

#pragma once

#include "brachisto/io/diagnostics.hpp"
#include "brachisto/io/problem_file.hpp"
#include "brachisto/io/sweep_file.hpp"
#include "brachisto/math/phase_clock.hpp"
#include "brachisto/math/stop_condition.hpp"
#include "brachisto/model/body.hpp"
#include "brachisto/model/kinematics.hpp"
#include "brachisto/model/mass_distribution.hpp"
#include "brachisto/model/path_limits.hpp"
#include "brachisto/model/point.hpp"
#include "brachisto/model/scene.hpp"
#include "brachisto/model/world.hpp"
#include "brachisto/nlp/kkt_residual.hpp"
#include "brachisto/nlp/problem.hpp"
#include "brachisto/nlp/sparsity_pattern.hpp"
#include "brachisto/paper/discrete_reading.hpp"
#include "brachisto/report/output_files.hpp"
#include "brachisto/report/result.hpp"
#include "brachisto/run/effort.hpp"
#include "brachisto/run/progress.hpp"
#include "brachisto/run/solve_options.hpp"
#include "brachisto/solvers/ipopt.hpp"
#include "brachisto/solvers/linear_solver.hpp"
#include "brachisto/solvers/newton_kkt.hpp"
#include "brachisto/solvers/status.hpp"
#include "brachisto/study/design_answer.hpp"
#include "brachisto/study/design_plan.hpp"
#include "brachisto/study/discrete_answer.hpp"
#include "brachisto/study/forecast.hpp"
#include "brachisto/study/limit_on_path.hpp"
#include "brachisto/study/sensitivities.hpp"
#include "brachisto/study/solution.hpp"
#include "brachisto/study/solve.hpp"
#include "brachisto/trajectory/certificate.hpp"
#include "brachisto/trajectory/motion.hpp"
#include "brachisto/version.hpp"
