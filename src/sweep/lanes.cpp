// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "sweep/lanes.hpp"

#include <algorithm>
#include <exception>
#include <utility>

#include "study/in_lanes.hpp"

namespace brachisto::sweep {

bool asks_for_lanes(const io::SweepFile& file) {
  const bool swept = std::ranges::any_of(
      file.keys(),
      [](const io::SweepKey& key) { return key.path == "solver.method"; });
  return swept || (file.num_scenes() > 0 &&
                   file.problem(0).options.or_default<Collocation>().in_lanes);
}

std::optional<Solution> Lanes::next() {
  if (!asked_) return std::nullopt;
  if (place_ == found_.size()) look_ahead();
  return std::move(found_[place_++]);
}

void Lanes::look_ahead() {
  const std::size_t end = std::min(last_, next_ + kAtOnce);
  std::vector<SceneToSolve> posed;
  for (; next_ < end; ++next_) {
    try {
      const io::ProblemFile problem = file_.problem(next_);
      posed.push_back({problem.scene, problem.options});
    } catch (const std::exception&) {
      posed.emplace_back();  // its own solve says why
    }
  }
  place_ = 0;
  try {
    found_ = solve_in_lanes(posed);
  } catch (const std::exception&) {
    found_.assign(posed.size(), std::nullopt);
  }
}

}  // namespace brachisto::sweep
