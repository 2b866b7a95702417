// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "study/within_limits.hpp"

#include <fmt/format.h>

#include <new>
#include <stdexcept>
#include <string>
#include <utility>

#include "solvers/pivot_store.hpp"

namespace brachisto {

namespace {

void end(Solution& out, Status status, std::string message) {
  out.status = status;
  out.message = std::move(message);
  out.discard_answer();
}

void end_by_memory(Solution& out) {
  end(out, Status::OutOfMemory,
      "memory ran out before the end. Try a coarser mesh, or a larger radius");
}

void work_until(const StopCondition& stop, Solution& out,
                const std::function<void(Solution&)>& work) {
  const StopScope scope(stop);
  bool stopped = false;
  try {
    work(out);
    // An iteration limit is the one that was reached first.
    stopped = stop.met() && out.status != Status::IterationLimit;
  } catch (const AnswerStands&) {  // NOLINT(bugprone-empty-catch): no failure
  } catch (const Stopped&) {
    if (!stop.met()) throw;
    stopped = true;
  } catch (const std::bad_alloc&) {
    end_by_memory(out);
  } catch (const std::length_error&) {  // more than can be addressed
    end_by_memory(out);
  }
  if (!stopped) return;
  end(out, stopped_by(stop),
      stop.interrupted() ? "stopped by a signal before the end"
                         : time_limit_reached(out.options.limits.seconds));
}

}  // namespace

std::string time_limit_reached(double seconds) {
  return fmt::format("the limit of {:g} s was reached (solver.limits.seconds)",
                     seconds);
}

Solution within_limits(const PosedProblem& posed,
                       const std::function<void(Solution&)>& work) {
  const auto begin = StopCondition::Clock::now();
  const double cpu_begin = process_cpu_seconds();
  const PhaseSeconds phases_begin = phase_seconds();
  Solution out;
  out.scene = posed.asked;
  out.options = posed.options;
  out.warnings = posed.warnings;
  const ChainScope chains(posed.program.threads);
  work_until(posed.stop(), out, work);
  Effort& effort = out.effort;
  effort.seconds =
      std::chrono::duration<double>(StopCondition::Clock::now() - begin)
          .count();
  effort.cpu_seconds =
      process_cpu_seconds() - cpu_begin - effort.certificate_cpu_seconds;
  effort.phases = phase_seconds();
  effort.phases -= phases_begin;
  return out;
}

}  // namespace brachisto
