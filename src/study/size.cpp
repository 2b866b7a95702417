// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "study/size.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "refinement/turn_meshes.hpp"

namespace brachisto {

namespace {

// Measured on one core of an AMD EPYC: from 570 to 2800 turns of the base body
// 1.1e-4 down to 0.9e-4 s times the power 3/2 of their number, for the
// continuation needs more steps too, and 0.23 to 0.19 MB per turn; of fixed
// meshes 5e-6 s and 2.1 kB per node, 2e-6 s and 1.0 kB for arc_length. What is
// refused must be too large for certain, on a faster machine and by a shorter
// way too: a third of the first time, a tenth of the second, somewhat less
// memory.
constexpr double kSecondsOfTurns = 3e-5;
constexpr double kBytesPerTurn = 0.17e6;
constexpr double kSecondsPerNode = 5e-7;
constexpr double kBytesPerNode = 1.8e3;
constexpr double kBytesPerArcLengthNode = 0.8e3;

/// "21 GB".
std::string in_bytes(double bytes) {
  constexpr std::array kUnits{"B", "kB", "MB", "GB", "TB"};
  std::size_t unit = 0;
  while (bytes >= 1e3 && unit + 1 < kUnits.size()) {
    bytes *= 1e-3;
    ++unit;
  }
  return fmt::format("{:.3g} {}", bytes, kUnits.at(unit));
}

}  // namespace

SizeEstimate estimate_size(double turns, const SolveOptions& options) {
  SizeEstimate size{.turns = turns};
  if (const auto* program = options.of<Collocation>()) {
    const Discretisation& mesh = program->discretisation;
    if (mesh.nodes) {
      size.nodes = *mesh.nodes;
    } else if (mesh.elements) {
      size.nodes = 1.0 + 1.0 * *mesh.elements * mesh.degree_of_fixed();
    }
    size.bytes = size.nodes * (mesh.formulation == Formulation::ArcLength
                                   ? kBytesPerArcLengthNode
                                   : kBytesPerNode);
  } else if (const auto* system = options.of<DiscreteSystem>()) {
    size.nodes = system->nodes;
    // One dense matrix of the paper's 2n + 1 equations.
    if (system->solver != DiscreteSolver::Lifted) {
      size.bytes = sizeof(double) * std::pow(2.0 * size.nodes + 1.0, 2);
    }
  }
  size.bytes = std::max(kBytesPerTurn * turns, size.bytes);
  size.seconds = std::max(kSecondsOfTurns * std::pow(turns, 1.5),
                          kSecondsPerNode * size.nodes);
  return size;
}

std::optional<Outcome> too_large(const SizeEstimate& size,
                                 double available_bytes, double seconds) {
  const bool too_much = size.bytes > available_bytes;
  if (!too_much && !(size.seconds > seconds)) return std::nullopt;
  const bool by_turns = kBytesPerTurn * size.turns >= size.bytes;
  const std::string what =
      by_turns ? fmt::format("the body turns about {:.2g} times on its way",
                             size.turns)
               : fmt::format("the mesh has {:.3g} nodes", size.nodes);
  return Outcome{
      too_much ? Status::OutOfMemory : Status::TimeLimit,
      fmt::format("{}, which takes at least {} of memory and {:.2g} s; there "
                  "are {}, and limits.seconds is {:g}. Nothing was computed. "
                  "{}",
                  what, in_bytes(size.bytes), size.seconds,
                  std::isfinite(available_bytes) ? in_bytes(available_bytes)
                                                 : "no bounds on memory",
                  seconds,
                  by_turns ? "Try a larger radius, or a nearer point B"
                           : "Try fewer nodes")};
}

std::optional<Outcome> too_large(const PosedProblem& posed) {
  if (!posed.cycloid) return std::nullopt;
  const double number = turns(
      posed.natural.body, posed.cycloid->arc_length(posed.cycloid->psi_end));
  const SizeEstimate size = estimate_size(number, posed.options);
  const double seconds = posed.options.limits.seconds;
  // To ask the kernel takes a per cent or so of a small solve.
  constexpr double kLittle = 16e6;
  if (size.bytes <= kLittle && !(size.seconds > seconds)) return std::nullopt;
  return too_large(size, available_memory(), seconds);
}

}  // namespace brachisto
