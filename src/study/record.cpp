// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "study/record.hpp"

#include <fmt/format.h>

#include <utility>

namespace brachisto {

namespace {

void add_work(const std::vector<MeshRecord>& meshes, Solution& out) {
  for (const MeshRecord& mesh : meshes) {
    out.effort += {mesh.iterations, mesh.passes, mesh.newton_steps, {}};
  }
}

}  // namespace

void record(Outcome outcome, Solution& out) {
  out.status = outcome.status;
  out.message = std::move(outcome.message);
}

void record(const Start& start, Solution& out) {
  out.effort.newton_steps += start.newton_steps;
  out.effort.continuation = start.steps;
  out.folds = start.folds;
  out.continued_from_L = start.continued_from_L;
  record(Outcome{start.status, start.message}, out);
}

void record(const OtherStart& other, Solution& out) {
  out.effort += other.work;
  out.cold_start = other.cold;
}

void record(const ExtremalSolution& extremal, Solution& out) {
  out.effort.newton_steps += extremal.newton_steps;
  if (extremal.usable()) out.folds = extremal.continuation.folds;
}

void record(const LimitedExtremal& extremal, Solution& out) {
  out.effort.newton_steps += extremal.newton_steps;
}

void record(const ContactSearch& search, Solution& out) {
  out.effort.newton_steps += search.newton_steps;
  out.search_remark = search.remark;
}

void record(const LimitedSearch& search, Solution& out) {
  out.effort += search.work;
  if (!out.search_remark.empty() && !search.remark.empty()) {
    out.search_remark += "; under limits ";
  }
  out.search_remark += search.remark;
}

void record_cut(double seconds, Solution& out) {
  if (!out.search_remark.empty()) out.search_remark += "; ";
  out.search_remark += fmt::format(
      "the limit of {:g} s ended the search before its end, and what was to "
      "follow",
      seconds);
}

void record(const JudgedBranches& judged, Solution& out) {
  add_work(judged.meshes, out);
  for (const JudgedBranch& one : judged.branches) {
    out.branches.push_back(one.branch);
  }
}

void record_work(const RefinementProtocol& refinement, Solution& out) {
  add_work(refinement.meshes, out);
}

void record(const RefinementProtocol& refinement, Solution& out) {
  record_work(refinement, out);
  record_way(refinement, out);
}

void record_way(const RefinementProtocol& refinement, Solution& out) {
  Effort& effort = out.effort;
  effort.meshes.insert(effort.meshes.end(), refinement.meshes.begin(),
                       refinement.meshes.end());
  effort.log += refinement.log;
  record(Outcome{refinement.status, refinement.message}, out);
}

void record(Answered answered, Solution& out) {
  out.answer = std::move(answered.answer);
  out.estimated_error = answered.estimated_error;
  out.diagnostics = std::move(answered.diagnostics);
  out.limits = std::move(answered.limits);
}

void record(Certified certified, Solution& out) {
  out.certificate = std::move(certified.certificate);
  out.extremal = std::move(certified.cross_check);
}

}  // namespace brachisto
