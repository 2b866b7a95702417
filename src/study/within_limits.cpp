// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "study/within_limits.hpp"

#include <fmt/format.h>

#include <new>
#include <stdexcept>
#include <string>

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

}  // namespace

void within_limits(Solution& out, const StopCondition& stop,
                   const std::function<void()>& work) {
  const StopScope scope(stop);
  bool stopped = false;
  try {
    work();
    // An iteration limit is the one that was reached first.
    stopped = stop.met() && out.status != Status::IterationLimit;
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
                         : fmt::format("the limit of {:g} s was reached",
                                       out.options.limits.seconds));
}

}  // namespace brachisto
