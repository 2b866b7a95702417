// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "search/limited_search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <utility>

#include "refinement/detour.hpp"
#include "refinement/open_conditions.hpp"
#include "refinement/tightening.hpp"

namespace brachisto {

namespace {

class LimitedPaths {
 public:
  LimitedPaths(const Scene& scene, const std::vector<ContactCandidate>& free,
               const MeshOptions& options)
      : scene_(scene),
        free_(free),
        options_(options),
        limits_(inequalities(scene.body, scene.limits)) {
    options_.ipopt.max_iterations =
        std::min(options.ipopt.max_iterations, kIterationsOfAStart);
  }

  LimitedSearch run() {
    from(0, [](Tightening& t) { return t.tighten(); });
    const std::size_t extremals = std::min(free_.size(), kMostFreeStarts);
    for (std::size_t i = 1; i < extremals; ++i) {
      from(i, [](Tightening& t) { return t.tighten(); });
    }
    const ExtremalCurve& first = free_.front().curve;
    constexpr int kWaves = 4;
    for (const auto& rough : {ways_past_discs(scene_, first, limits_),
                              waves(scene_, first, kWaves)}) {
      for (const RoughPath& path : rough) {
        from(0, [&](Tightening& t) { return t.tighten_from(path); });
      }
    }
    for (const auto& looser : one_at_a_time()) {
      from(0, [&](Tightening& t) { return t.tighten_after(looser); });
    }
    if (end_is_sought(scene_)) along_the_slope();
    std::ranges::stable_sort(out_.paths, {}, &LimitedCurve::transit_time);
    tell_bounds();
    if (out_.paths.size() > kMostLimitedPaths) {
      leave("of {} paths that it found the {} slowest were not solved for",
            out_.paths.size(), out_.paths.size() - kMostLimitedPaths);
      out_.paths.erase(out_.paths.begin() + kMostLimitedPaths,
                       out_.paths.end());
    }
    return std::move(out_);
  }

 private:
  void tell_bounds() {
    if (free_.size() > kMostFreeStarts) {
      leave(
          "of {} extremals without limits the {} slowest were not started "
          "from",
          free_.size(), free_.size() - kMostFreeStarts);
    }
    const std::size_t discs = discs_near(free_.front().curve, limits_);
    if (discs > kMostDiscs) {
      leave("of {} discs near the first of them both sides were tried of {}",
            discs, kMostDiscs);
    }
    if (ended_ > 0) {
      leave(
          "{} of its {} starts, or scans of the slope at B, ended at their {} "
          "iterations",
          ended_, out_.starts, options_.ipopt.max_iterations);
    }
  }

  [[nodiscard]] bool stopped() const { return options_.ipopt.stop.met(); }

  template <class... Args>
  void leave(fmt::format_string<Args...> text, Args&&... args) {
    out_.remark +=
        (out_.remark.empty() ? "the work of the search is bounded: " : "; ") +
        fmt::format(text, std::forward<Args>(args)...);
  }

  /// Unless it is known.
  void take(const LimitedCurve& path) {
    if (std::ranges::none_of(out_.paths, [&](const LimitedCurve& known) {
          return alike(known, path);
        })) {
      out_.paths.push_back(path);
    }
  }

  /// Tightens from a start beside a free extremal.
  void from(std::size_t extremal,
            const std::function<bool(Tightening&)>& tighten,
            const std::function<void(Tightening&)>& then = {}) {
    if (stopped()) return;
    if (options_.progress) {
      options_.progress(
          "search", fmt::format("start {}, {} paths so far", out_.starts + 1,
                                out_.paths.size()));
    }
    ++out_.starts;
    MeshOptions quiet = options_;
    quiet.progress = {};
    PassProtocol protocol(quiet);
    const ContactCandidate& beside = free_[extremal];
    Tightening tightening(scene_, beside.curve, beside.phi, options_.ipopt,
                          protocol);
    if (tighten(tightening)) {
      const LimitedCurve tight = tightening.last();
      take(tightening.close_contact() ? tightening.last() : tight);
      if (then) then(tightening);
    }
    const RefinementProtocol done = std::move(protocol).finished();
    const int before = out_.work.iterations;
    for (const MeshRecord& mesh : done.meshes) {
      out_.work += {mesh.iterations, mesh.passes, mesh.newton_steps, {}};
    }
    out_.work.log += done.log;
    if (out_.work.iterations - before >= options_.ipopt.max_iterations) {
      ++ended_;
    }
  }

  /// The limits with one of them as it is and the others as loose as the free
  /// extremal keeps them; nothing to order where there is but one.
  [[nodiscard]] std::vector<std::vector<PathInequality>> one_at_a_time() const {
    const LimitRelaxation relaxation(scene_, free_.front().curve);
    const std::vector<PathInequality> loose = relaxation.at(0.0);
    std::vector<std::vector<PathInequality>> out;
    for (std::size_t i = 0; i < loose.size(); ++i) {
      // Friction is two inequalities, which belong together.
      if (limits_[i].kind == PathInequality::Kind::FrictionBackward) continue;
      std::vector<PathInequality> mixed = loose;
      mixed[i] = limits_[i];
      if (limits_[i].kind == PathInequality::Kind::FrictionForward) {
        mixed[i + 1] = limits_[i + 1];
      }
      out.push_back(std::move(mixed));
    }
    if (out.size() < 2) out.clear();
    return out;
  }

  void along_the_slope() {
    const std::vector<LimitedCurve> known = out_.paths;
    if (known.empty()) return;
    const auto fastest =
        std::ranges::min_element(known, {}, &LimitedCurve::transit_time);
    const auto scan = [&](const LimitedCurve& path) {
      from(
          0, [&](Tightening& t) { return t.tighten_from(path); },
          [&](Tightening& t) {
            for (const LimitedCurve& contact : t.contacts_along()) {
              take(contact);
            }
          });
    };
    scan(known.front());
    if (fastest != known.begin()) scan(*fastest);
  }

  const Scene& scene_;
  const std::vector<ContactCandidate>& free_;
  MeshOptions options_;
  std::vector<PathInequality> limits_;
  LimitedSearch out_;
  int ended_ = 0;  ///< starts whose iterations were used up
};

}  // namespace

LimitedSearch find_limited_paths(const Scene& scene,
                                 const std::vector<ContactCandidate>& free,
                                 const MeshOptions& options) {
  return LimitedPaths(scene, free, options).run();
}

}  // namespace brachisto
