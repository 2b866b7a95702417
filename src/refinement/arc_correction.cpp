// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Other arcs where a solution with given ones breaks a limit or a sign.

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "brachisto/math/index.hpp"
#include "refinement/sightings.hpp"
#include "transcription/held_control.hpp"

namespace brachisto {

namespace {

using nlp::Held;

/// Whether the limit that holds the control of an arc keeps it from what
/// another one, which is exceeded there, asks for.
bool gives_no_way(const LimitedTime& problem, const Arc& arc,
                  std::size_t exceeded, Held where,
                  const TurningPoint<double>& place) {
  const int held = held_of_control(arc.held, problem.limits());
  if (held < 0) return false;
  return !problem.limits()[exceeded].bounds_control() ||
         holds_from_above(problem, held, arc.held[at(held)], place) !=
             holds_from_above(problem, static_cast<int>(exceeded), where,
                              place);
}

/// An arc that is missing is longer than the stretch where its limit is
/// exceeded without it: β has to be back on the free arc behind it, so that the
/// excess of q over the one that the limit allows has no integral. Of a
/// parabola the part above zero is 1/√3 of that.
void widen_new(const std::vector<std::vector<Held>>& before,
               std::vector<Sighting>& seen) {
  const std::size_t n = seen.size();
  std::vector<Sighting> wider = seen;
  for (std::size_t first = 0; first < n;) {
    std::size_t end = first + 1;
    while (end < n && seen[end].held == seen[first].held) ++end;
    if (is_free(before[first]) && !is_free(seen[first].held)) {
      const auto more = static_cast<std::size_t>(
          std::ceil(0.37 * static_cast<double>(end - first)));
      for (std::size_t k = 1; k <= more; ++k) {
        if (first >= k && is_free(seen[first - k].held)) {
          wider[first - k].held = seen[first].held;
        }
        if (end + k <= n && is_free(seen[end + k - 1].held)) {
          wider[end + k - 1].held = seen[first].held;
        }
      }
    }
    first = end;
  }
  seen = std::move(wider);
}

/// The limit of the place that holds; −1 if none does.
int held_of_place(const std::vector<Held>& held,
                  const std::vector<PathInequality>& limits) {
  for (std::size_t i = 0; i < held.size(); ++i) {
    if (held[i] != Held::No && !limits[i].bounds_control()) {
      return static_cast<int>(i);
    }
  }
  return -1;
}

/// Where a limit of the control is exceeded along one of the place, it does not
/// take over from it: it bounds the control from the side of the place before
/// it is reached, so that the path leaves the place in good time, is led back
/// and touches it where both hold.
void part_from_place(const LimitedTime& problem,
                     const std::vector<std::vector<Held>>& before,
                     std::vector<Sighting>& seen) {
  const auto taken = [&](std::size_t i) {
    return held_of_place(before[i], problem.limits()) >= 0 &&
           held_of_control(seen[i].held, problem.limits()) >= 0;
  };
  for (std::size_t first = 0; first < seen.size(); ++first) {
    if (!taken(first)) continue;
    const int place = held_of_place(before[first], problem.limits());
    std::size_t end = first;
    while (end < seen.size() && before[end] == before[first] &&
           seen[end].held == seen[first].held) {
      ++end;
    }
    const auto still = [&](std::size_t i) {
      return i < seen.size() && before[i] == before[first] &&
             seen[i].held == before[first];
    };
    const std::size_t more = (end - first + 1) / 2;
    const bool behind = still(end), ahead = first > 0 && still(first - 1);
    const Touch touch{at(place), before[first][at(place)]};
    const std::vector<Held> control = seen[first].held;
    std::size_t at_touch = (first + end - 1) / 2;
    if (ahead && !behind) {
      at_touch = first;
      std::size_t k = first;
      for (; k > 0 && first - k < more && still(k - 1); --k) {
        seen[k - 1].held = control;
      }
      if (k > 0 && still(k - 1)) {
        std::ranges::fill(seen[k - 1].held, Held::No);
      }
    } else if (behind && !ahead) {
      at_touch = end - 1;
      std::size_t k = end;
      for (; k - end < more && still(k); ++k) seen[k].held = control;
      if (still(k)) std::ranges::fill(seen[k].held, Held::No);
      end = k;
    }
    seen[at_touch].touch = touch;
    first = end - 1;
  }
}

/// Where a limit of the place lets go of an arc its multiplier oscillates, as
/// polynomials do that cannot follow what they stand for. Where the arc is let
/// go of more than once, stretches that are left of it beside those, and are
/// not much longer, are no arcs of their own.
void let_go_at_once(const LimitedTime& problem,
                    const std::vector<std::vector<Held>>& before,
                    std::vector<Sighting>& seen) {
  constexpr double kBetween = 3.0, kAtEnd = 2.0;
  enum class Now { Held, Free, Other };
  struct Stretch {
    std::size_t first, end;
    Now now;
    [[nodiscard]] double places() const {
      return now == Now::Free ? static_cast<double>(end - first) : 0.0;
    }
  };
  const auto now = [&](std::size_t i) {
    return is_free(seen[i].held)       ? Now::Free
           : seen[i].held == before[i] ? Now::Held
                                       : Now::Other;
  };
  for (std::size_t begin = 0, end = 0; begin < seen.size(); begin = end) {
    std::vector<Stretch> arc;
    for (; end < seen.size() && before[end] == before[begin]; ++end) {
      if (arc.empty() || arc.back().now != now(end)) {
        arc.push_back({end, end, now(end)});
      }
      arc.back().end = end + 1;
    }
    const auto times_free = std::ranges::count(arc, Now::Free, &Stretch::now);
    if (held_of_place(before[begin], problem.limits()) < 0 || times_free < 2) {
      continue;
    }
    for (std::size_t k = 0; k < arc.size(); ++k) {
      if (arc[k].now != Now::Held) continue;
      const double ahead = k > 0 ? arc[k - 1].places() : 0.0;
      const double behind = k + 1 < arc.size() ? arc[k + 1].places() : 0.0;
      const double most = ahead > 0.0 && behind > 0.0 ? kBetween : kAtEnd;
      const auto places = static_cast<double>(arc[k].end - arc[k].first);
      if (places > most * std::max(ahead, behind)) continue;
      for (std::size_t i = arc[k].first; i < arc[k].end; ++i) {
        std::ranges::fill(seen[i].held, Held::No);
      }
    }
  }
}

/// Held by a limit of curvature: then q vanishes at rest, and what its
/// polynomial leaves there is nothing to judge others by.
bool turns(const Arc& arc, const std::vector<PathInequality>& limits) {
  const int held = held_of_control(arc.held, limits);
  return held >= 0 && !limits[at(held)].bounds_force();
}

/// What holds at the places of a solution, as its inequalities would have it.
class Correction {
 public:
  /// \param curve, arcs  must outlive this
  Correction(const LimitedCurve& curve, const std::vector<Arc>& arcs,
             Takeover takeover, double exceeded)
      : curve_(curve), arcs_(arcs), takeover_(takeover), exceeded_(exceeded) {}

  [[nodiscard]] std::optional<ArcsFromA> run() {
    std::optional<StartCorner> corner = curve_.problem().ends().corner;
    // Arcs that are worth less may be too short to be found: the estimated
    // error has it.
    constexpr double kCost = 5e-13, kWithSmoothContacts = 5e-11;
    const bool smooth = curve_.problem().scene().contact == Contact::Smooth;
    const auto [until, cost] = curve_.misled_from_rest();
    const bool misled = !(cost <= (smooth ? kWithSmoothContacts : kCost));
    bool begins = false;  // the corner
    if (corner && !(curve_.corner_multiplier() >= 0.0)) {
      corner.reset();
      changed_ = true;
    } else if (misled) {
      changed_ = true;
    } else if (!corner) {
      corner = curve_.corner_at_rest(exceeded_);
      begins = changed_ = corner.has_value();
    }
    int first = 0;
    double begin = 0.0;
    for (const Arc& arc : arcs_) {
      look_along(arc, first, begin);
      first += arc.elements();
      begin = arc.end;
    }
    if (!changed_) return std::nullopt;
    if (begins) let_go_behind(corner->limit);
    const LimitedTime& problem = curve_.problem();
    let_go_at_once(problem, before_, seen_);
    touch_once(seen_, problem.limits());
    if (takeover_ == Takeover::LedBack) {
      part_from_place(problem, before_, seen_);
    }
    widen_new(before_, seen_);
    leave_end(problem, seen_);
    std::vector<Arc> arcs =
        arcs_from(seen_, problem.mesh().num_elements(), problem.limits());
    if (corner && misled && until < arcs.front().end) {
      Arc along{.held = std::vector(arcs.front().held.size(), Held::No),
                .end = until,
                .cuts = equal_cuts(2)};
      along.held[corner->limit] = corner->at;
      arcs.insert(arcs.begin(), std::move(along));
    }
    return with_corner(problem, std::move(arcs), corner);
  }

 private:
  static constexpr int kPlaces = 16;  // of an element

  void look_along(const Arc& arc, int first, double begin) {
    constexpr double kShort = 1e-4;
    const int end = first + arc.elements();
    largest_ = curve_.largest_multiplier(first, end);
    // Junctions of a short arc would stay where its neighbours begin.
    const bool given_up =
        arc.end - begin < kShort && pulls_wrong_anywhere(arc, first, end);
    for (int e = first; e < end; ++e) {
      // What is touched has its multiplier at a point, and the polynomial of
      // the other one tells nothing there.
      const bool before_touch = arc.touch && e + 1 == end;
      for (const double t : places(e)) {
        // Junctions belong to two arcs. At rest multipliers say nothing, but
        // limits may be exceeded for the first moment alone.
        const bool at_rest =
            e == 0 && t == 0.0 && !turns(arc, curve_.problem().limits());
        if ((t == 0.0 && !at_rest) || t == 1.0) continue;
        look_at(arc, e, t, given_up, !before_touch && !at_rest);
      }
      // Or for the last.
      constexpr double kJustBefore = 1.0 - 1e-9;
      if (e + 1 == curve_.problem().mesh().num_elements()) {
        look_at(arc, e, kJustBefore, given_up, !before_touch);
      }
    }
    if (arc.touch) keep_touch(arc, end);
  }

  /// What is exceeded from A on by no more than the corner lets it.
  void let_go_behind(std::size_t limit) {
    for (std::size_t i = 0; i < seen_.size(); ++i) {
      const bool touched = seen_[i].touch && seen_[i].touch->limit == limit;
      if (!touched && seen_[i].held[limit] == Held::No) return;
      seen_[i].touch.reset();
      seen_[i].held = before_[i];
    }
  }

  /// Of those that are exceeded by little the worst as well, which may lie
  /// between others.
  [[nodiscard]] std::vector<double> places(int element) const {
    std::vector<double> places = curve_.places(element, kPlaces);
    if (exceeded_ < kExceeded) {
      const ExcessAt worst = curve_.excess_on(element);
      if (worst.value > exceeded_) {
        places.insert(std::ranges::upper_bound(places, worst.t), worst.t);
      }
    }
    return places;
  }

  [[nodiscard]] bool pulls_wrong(const Arc& arc, const LimitedPoint& place,
                                 std::size_t limit) const {
    // Of the arc's largest, or what is rounding of costates, which are some 1:
    // multipliers of arcs of 1e-4 are less.
    constexpr double kWrongSign = 1e-3, kRounding = 1e-12;
    const Held held = arc.held[limit];
    const double multiplier = place.multipliers[limit];
    return held != Held::No &&
           (held == Held::AtLower ? multiplier : -multiplier) >
               std::max(kRounding, kWrongSign * largest_);
  }
  [[nodiscard]] bool pulls_wrong_anywhere(const Arc& arc, int first,
                                          int end) const {
    for (int e = first; e < end; ++e) {
      for (const double t : curve_.places(e, kPlaces)) {
        const LimitedPoint place = curve_.at(e, t);
        for (std::size_t i = 0; i < arc.held.size(); ++i) {
          if (pulls_wrong(arc, place, i)) return true;
        }
      }
    }
    return false;
  }

  void look_at(const Arc& arc, int element, double t, bool given_up,
               bool signs_count) {
    const LimitedTime& problem = curve_.problem();
    const LimitedPoint place = curve_.at(element, t);
    Sighting seen{problem.mesh().sigma(element, t), arc.held};
    for (std::size_t i = 0; i < arc.held.size(); ++i) {
      if (arc.held[i] == Held::No) continue;
      if (given_up || (signs_count && pulls_wrong(arc, place, i))) {
        seen.held[i] = Held::No;
        changed_ = true;
      }
    }
    if (const auto [limit, where, excess] = exceeded(arc, place);
        where != Held::No) {
      changed_ = true;
      if (gives_no_way(problem, arc, limit, where, place.state)) {
        seen.touch = {limit, where};
        seen.excess = excess;
      } else {
        // Along a limit of the place the control is given: the path leaves it.
        std::ranges::fill(seen.held, Held::No);
        seen.held[limit] = where;
      }
    }
    before_.push_back(arc.held);
    seen_.push_back(std::move(seen));
  }

  /// Of the limits that do not hold the one that is exceeded most.
  struct Exceeded {
    std::size_t limit;
    Held where;  ///< No if none is
    double by;
  };
  [[nodiscard]] Exceeded exceeded(const Arc& arc,
                                  const LimitedPoint& place) const {
    const LimitedTime& problem = curve_.problem();
    Exceeded worst{0, Held::No, exceeded_};
    for (std::size_t i = 0; i < arc.held.size(); ++i) {
      if (arc.held[i] != Held::No) continue;
      const PathInequality& limit = problem.limits()[i];
      const double value = value_of(limit, problem.scene(), place.state);
      const double below = limit.lower - value;
      const double above = value - limit.upper;
      if (std::max(below, above) <= worst.by) continue;
      worst = {i, below > above ? Held::AtLower : Held::AtUpper,
               std::max(below, above)};
    }
    return worst;
  }

  /// If its multiplier has the right sign.
  void keep_touch(const Arc& arc, int end) {
    constexpr double kKept = std::numeric_limits<double>::infinity();
    const LimitedTime& problem = curve_.problem();
    const Touch& touch = *arc.touch;
    const double multiplier = curve_.point().lambda[at(problem.layout().limit(
        end * problem.mesh().degree - 1, static_cast<int>(touch.limit)))];
    if ((multiplier > 0.0) != (touch.at == Held::AtUpper)) {
      changed_ = true;
      return;
    }
    seen_.push_back({arc.end, seen_.back().held,
                     Touch{touch.limit, touch.at, multiplier}, kKept});
    before_.push_back(before_.back());
  }

  const LimitedCurve& curve_;
  const std::vector<Arc>& arcs_;
  Takeover takeover_;
  double exceeded_;
  double largest_ = 0.0;  ///< multiplier on the arc that is looked at
  std::vector<Sighting> seen_;
  std::vector<std::vector<Held>> before_;  ///< what was held there
  bool changed_ = false;
};

}  // namespace

ArcsFromA with_corner(const LimitedTime& problem, std::vector<Arc> arcs,
                      std::optional<StartCorner> corner) {
  const Arc& first = arcs.front();
  const bool at_A = problem.pushed() && !problem.free_contacts() &&
                    first.touch && arcs.size() > 1 &&
                    first.held == arcs[1].held &&
                    problem.limits()[first.touch->limit].bounds_control() &&
                    first.end < problem.mesh().boundaries[1];
  if (at_A) {
    corner = StartCorner{first.touch->limit, first.touch->at};
    arcs.erase(arcs.begin());
  } else if (corner && !problem.pushed()) {
    if (!turns(first, problem.limits())) corner.reset();
  }
  return {std::move(arcs), corner};
}

std::optional<ArcsFromA> corrected(const LimitedCurve& curve,
                                   const std::vector<Arc>& arcs,
                                   Takeover takeover, double exceeded) {
  return Correction(curve, arcs, takeover, exceeded).run();
}

}  // namespace brachisto
