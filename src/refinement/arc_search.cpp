// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "refinement/arc_search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace brachisto {

namespace {

/// Whether the same holds on the same stretches.
bool alike(const std::vector<Arc>& one, const std::vector<Arc>& other) {
  constexpr double kSame = 1e-6;
  return std::ranges::equal(one, other, [](const Arc& a, const Arc& b) {
    return a.held == b.held && std::abs(a.end - b.end) < kSame &&
           a.touch.has_value() == b.touch.has_value() &&
           (!a.touch || a.touch->limit == b.touch->limit);
  });
}
bool any_alike(const std::vector<std::vector<Arc>>& all,
               const std::vector<Arc>& arcs) {
  return std::ranges::any_of(
      all, [&](const std::vector<Arc>& other) { return alike(other, arcs); });
}

}  // namespace

ArcFit ArcSearch::fit(const LimitedCurve& nearby, PathSetting setting,
                      int degree) {
  ArcFit found = fit_arcs(nearby, std::move(setting), degree, options_);
  MeshRecord& record = protocol_.record;
  record.passes += found.passes;
  record.newton_steps += found.newton_steps;
  protocol_.work += found.work;
  record.degree = degree;
  if (found.path) {
    record.elements = found.path->curve.problem().mesh().num_elements();
  } else {
    protocol_.fail(Status::NotConverged, std::move(found.message));
  }
  return found;
}

void ArcSearch::note(const char* what, const PathSetting& setting) {
  protocol_.log +=
      fmt::format("{}: {}\n", what, in_words(setting.arcs, setting.limits));
}

FittedPath ArcSearch::without_slivers(FittedPath path, int degree,
                                      double exceeded) {
  // The inertia was seen to be off by one with arcs of 1e-6 to 2e-6. A greater
  // number costs fits, not accuracy: the path without has to keep all limits,
  // between the places of its elements too.
  constexpr double kSliver = 1e-5, kKept = 1e-10;
  for (std::size_t i = 0; i < path.arcs.size() && !protocol_.stopped();) {
    std::vector<Arc> arcs = path.arcs;
    const bool touches = arcs[i].touch || (i > 0 && arcs[i - 1].touch);
    if (length_of(arcs, i) > kSliver || touches) {
      ++i;
      continue;
    }
    leave_out(arcs, i);
    const double kept = std::max(kKept, path.curve.largest_excess().value);
    PathSetting setting{path.curve.problem().limits(), arcs, path.ends};
    note("tried without a sliver", setting);
    const Status status = protocol_.status;
    const std::string message = protocol_.message;
    const int elements = protocol_.record.elements;
    ArcFit less = fit(path.curve, std::move(setting), degree);
    if (less.path && !corrected(less.path->curve, less.path->arcs,
                                Takeover::LedBack, std::min(exceeded, kept))) {
      path = *std::move(less.path);
    } else {
      protocol_.fail(status, message);  // as it was
      protocol_.record.elements = elements;
      ++i;
    }
  }
  return path;
}

std::optional<FittedPath> ArcSearch::fit_corrected(LimitedCurve nearby,
                                                   PathSetting setting,
                                                   int degree, double exceeded,
                                                   bool graded) {
  constexpr int kMostCorrections = 12, kFewest = 12;
  Takeover takeover = Takeover::LedBack;
  std::vector<std::vector<Arc>> tried, found_before;
  std::optional<FittedPath> last;  // whose arcs were corrected
  for (int i = 0; i < kMostCorrections; ++i) {
    for (Arc& arc : setting.arcs) {
      if (graded) arc.cuts = graded_cuts(std::max(kFewest, arc.elements()));
    }
    note(i == 0 ? "arcs tried" : "corrected to", setting);
    ArcFit found = fit(nearby, setting, degree);
    if (protocol_.stop.met()) return std::nullopt;
    const bool fitted = found.path.has_value();
    if (fitted) {
      last = std::move(found.path);
      setting.arcs = last->arcs;
      note("fitted", setting);
    } else {
      protocol_.log += fmt::format("  not fitted: {}\n", protocol_.message);
    }
    std::optional<ArcsFromA> other;
    if (fitted) {
      other = corrected(last->curve, last->arcs, takeover, exceeded);
      if (!other) return without_slivers(*std::move(last), degree, exceeded);
    }
    if (protocol_.worked_enough()) {
      protocol_.fail(Status::NotConverged,
                     "the share of work for it was used up");
      return std::nullopt;
    }
    // What is read off one path on other elements is not quite the same.
    const bool again = other && (any_alike(tried, other->arcs) ||
                                 any_alike(found_before, last->arcs));
    if (!fitted || again) {
      if (!last || takeover == Takeover::ForGood) break;
      takeover = Takeover::ForGood;
      found_before.clear();
      other = corrected(last->curve, last->arcs, takeover, exceeded);
      if (!other || alike(other->arcs, tried.back())) break;
    }
    tried.push_back(other->arcs);
    found_before.push_back(last->arcs);
    nearby = last->curve;
    setting.arcs = std::move(other->arcs);
    setting.ends = last->ends;
    setting.ends.corner = other->corner;
  }
  if (last) {
    protocol_.fail(Status::NotConverged,
                   "no arcs were found that keep the limits everywhere");
  }
  return std::nullopt;
}

}  // namespace brachisto
