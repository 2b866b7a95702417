// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Of what the stages of a solve return, what the solution keeps.

#pragma once

#include <vector>

#include "extremal/arc_shooting.hpp"
#include "extremal/shooting.hpp"
#include "refinement/refinement.hpp"
#include "search/limited_search.hpp"
#include "study/answer.hpp"
#include "study/branches.hpp"
#include "study/start.hpp"

namespace brachisto {

void record(Outcome outcome, Solution& out);
void record(const Start& start, Solution& out);
void record(const OtherStart& other, Solution& out);
void record(const ExtremalSolution& extremal, Solution& out);
void record(const LimitedExtremal& extremal, Solution& out);
void record(const ContactSearch& search, Solution& out);
void record(const LimitedSearch& search, Solution& out);
/// That time ended a search.
void record_cut(double seconds, Solution& out);
void record(const JudgedBranches& judged, Solution& out);
/// The work on meshes, and how the answer was refined.
void record(const RefinementProtocol& refinement, Solution& out);
/// The work alone: what was found before stands.
void record_work(const RefinementProtocol& refinement, Solution& out);
/// Only the latter, of work that is recorded already.
void record_way(const RefinementProtocol& refinement, Solution& out);
void record(Answered answered, Solution& out);
void record(Certified certified, Solution& out);

}  // namespace brachisto
