// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>

#include "model/cycloid.hpp"
#include "model/inertia.hpp"
#include "reproduction/claims.hpp"
#include "reproduction/peaks.hpp"

namespace brachisto::reproduction {

namespace {

using enum Verdict;

/// Peaks of the tracks of a family.
struct FamilyPeaks {
  std::vector<std::size_t> numbers;
  std::vector<double> turns;   ///< see PeaksAndValleys::turn()
  std::vector<double> places;  ///< of the first one, where there is any [m]
};

FamilyPeaks peaks_of(const Results& found, Members family) {
  FamilyPeaks out;
  for (const Member& member : family) {
    const PeaksAndValleys track =
        peaks_and_valleys(found.cases[member.file].motion());
    out.numbers.push_back(track.peaks.size());
    out.turns.push_back(track.turn());
    if (!track.peaks.empty()) out.places.push_back(track.peaks.front().top.x);
  }
  return out;
}

/// Texts of all of some things, "0.0°, 10.8°".
std::string list_of(const auto& things, const auto& text) {
  std::vector<std::string> texts;
  std::ranges::transform(things, std::back_inserter(texts), text);
  return fmt::format("{}", fmt::join(texts, ", "));
}

std::string in_degrees(const std::vector<double>& radians) {
  return list_of(radians, [](double angle) {
    return fmt::format("{:.1f}°", angle * kDegrees);
  });
}

std::string names_of(Members family) {
  return list_of(family, &Member::name);
}

double deepest_mass_centre(const Motion& motion) {
  constexpr int kSamples = 2000;
  double deepest = 0.0;
  for (const TrajectoryPoint& at : motion.fine_sample(kSamples)) {
    deepest = std::max(deepest, at.motion.mass_centre.z);
  }
  return deepest;
}

/// Largest distance of the centre's path from the cycloid in closed form. Both
/// run through it at the rate of the rolling time.
double distance_from_cycloid(const Motion& motion) {
  constexpr int kSamples = 200;
  const CycloidArc arc = axisymmetric_optimum(motion.scene()).value();
  double largest = 0.0;
  for (const TrajectoryPoint& at : motion.fine_sample(kSamples)) {
    const double U = arc.rolling_time(motion.scene().gravity);
    const Point there = arc.at(arc.psi_end * at.u / U);
    largest = std::max(largest, distance(at.centre, there));
  }
  return largest;
}

Claim about_cycloids(const Results& found) {
  // Between nodes the path has order p + 1 only.
  constexpr double kSame = 1e-6;
  const double bead = distance_from_cycloid(found.cases["fig06_bead"].motion());
  const double uniform =
      distance_from_cycloid(found.cases["fig06_uniform_cylinder"].motion());
  return {"Fig. 6",
          "The bead runs on a cycloid, and so does the centre of the uniform "
          "cylinder.",
          std::max(bead, uniform) < kSame ? Holds : Fails,
          fmt::format("The solutions keep within {:.0e} and {:.0e} of the "
                      "closed forms.",
                      bead, uniform)};
}

Claim about_pull(const Results& found) {
  std::size_t scenes = 0, peaks = 0, valleys = 0, as_claimed = 0;
  for (const auto& [name, one] : found.cases.all()) {
    if (one.scene().path || !one.scene().body.off_centred()) continue;
    ++scenes;
    const PeaksAndValleys track = peaks_and_valleys(one.motion());
    peaks += track.peaks.size();
    valleys += track.valleys.size();
    for (const Peak& peak : track.peaks) {
      as_claimed += std::sin(peak.top.theta) > 0.0 ? 1 : 0;
    }
    for (const Bend& valley : track.valleys) {
      as_claimed += std::sin(valley.theta) < 0.0 ? 1 : 0;
    }
  }
  return {"Sec. III.B",
          "The track is pulled in where the centre of mass is at the bottom "
          "and pushed out where it is at the top.",
          as_claimed == peaks + valleys ? Holds : HoldsInPart,
          fmt::format("In the {} off-centred scenes there are {} peaks and {} "
                      "valleys between them. With the centre of mass below the "
                      "axis in a peak, above it in a valley: {} of {}.",
                      scenes, peaks, valleys, as_claimed, peaks + valleys)};
}

Claim about_depth(const Results& found) {
  const double here =
      deepest_mass_centre(found.cases["fig04_reference_case"].motion());
  const double on_cycloid =
      deepest_mass_centre(found.cases["fig04_cycloid"].motion());
  return {"Sec. III.B",
          "So the centre of mass does not fall too deep, to have to come up "
          "again.",
          here < on_cycloid ? Holds : Fails,
          fmt::format("It comes down to z = {:.4f} H; on Cycloid*, which is "
                      "pulled nowhere, to {:.4f} H.",
                      here, on_cycloid)};
}

Claim about_shortest_track(double bead, double uniform, double off) {
  return {"Fig. 6", "The bead has the shortest track of the three.",
          bead < std::min(uniform, off) ? Holds : Fails,
          fmt::format("{:.4f}, {:.4f}, {:.4f}: bead, uniform, off-centred.",
                      bead, uniform, off)};
}

Claim about_lengths(double uniform, double off) {
  const double share = std::abs(uniform - off) / uniform;
  return {"Fig. 6",
          "The uniform and the off-centred cylinder have near equal path "
          "lengths.",
          share < 0.01 ? Holds : HoldsInPart,
          fmt::format("{:.4f} and {:.4f}, {:.1f} % apart.", uniform, off,
                      100.0 * share)};
}

Claim about_order(double bead, double uniform, double off) {
  return {"Fig. 6",
          "The bead is the quickest, the off-centred cylinder second, the "
          "uniform cylinder last.",
          bead < off && off < uniform ? Holds : Fails,
          fmt::format("{:.4f}, {:.4f}, {:.4f}. The off-centred cylinder is "
                      "faster than the uniform one by {:.1f} %; by the printed "
                      "times it would be {:.1f} %.",
                      bead, off, uniform, percent_less(uniform, off),
                      percent_less(number_in(printed::kUniform),
                                   number_in(printed::kOffCentred)))};
}

Claim about_incline(double off, double uniform) {
  return {"Sec. III.B",
          "On an inclined plane too the off-centred cylinder is quicker than "
          "the uniform one.",
          off < uniform ? Holds : Fails,
          fmt::format("On the straight line of Fig. 4 τ = {:.4f} against "
                      "{:.4f}.",
                      off, uniform)};
}

Claim about_angular_speed(const Motion& motion) {
  const Scene& scene = motion.scene();
  double least = std::numeric_limits<double>::infinity();
  double most = 0.0;
  constexpr int kSamples = 400;
  for (const TrajectoryPoint& at : motion.fine_sample(kSamples)) {
    if (at.motion.v_c <= 0.0) continue;
    const double energy = kinetic_energy(scene.body, scene.gravity, at.theta,
                                         at.beta, at.motion.v_c)
                              .total();
    const double ratio = at.motion.omega / std::sqrt(energy);
    least = std::min(least, ratio);
    most = std::max(most, ratio);
  }
  constexpr double kSame = 1.0 + 1e-9;
  return {"Sec. III.B", "Speeds follow the kinetic energy, ω ∝ √TKE.",
          most < kSame * least ? Holds : HoldsInPart,
          fmt::format("For axisymmetric bodies. In general TKE = m r^2 ω^2 A/2 "
                      "with A(θ, β): on the track of Fig. 4 ω/√TKE varies by "
                      "the factor {:.2f}.",
                      most / least)};
}

Claim about_effect_of_offset(const FamilyPeaks& by_eta) {
  const std::vector<double>& turns = by_eta.turns;
  const bool grows = std::ranges::is_sorted(turns) && turns.front() == 0.0 &&
                     turns.back() > 0.0;
  return {"Sec. III.C",
          "A growing η_m gradually induces peaks and valleys and makes them "
          "more pronounced.",
          grows ? Holds : Fails,
          fmt::format("The track turns downwards on {} peaks, by {} in all, "
                      "for {}.",
                      fmt::join(by_eta.numbers, ", "), in_degrees(turns),
                      names_of(kByOffset))};
}

Claim about_place_of_peaks(const FamilyPeaks& by_eta,
                           const FamilyPeaks& by_theta) {
  const std::vector<double>& places = by_theta.places;
  const double by_offset = spread(by_eta.places);
  const bool moves = spread(places) > by_offset;
  // As little as the other moves them.
  const bool moves_only = spread(by_theta.turns) / spread(by_eta.turns) <
                          by_offset / spread(places);
  return {"Sec. III.D",
          "While η_m dictates the extent of peaks and valleys, θ_m determines "
          "their location.",
          !moves       ? Fails
          : moves_only ? Holds
                       : HoldsInPart,
          fmt::format("From θ_m = −90° to 90° the first peak moves from x_b = "
                      "{:.2f} to {:.2f}; η_m moves it by {:.2f}. But the "
                      "extent depends on θ_m as well: the track turns "
                      "downwards by {}.",
                      places.front(), places.back(), by_offset,
                      in_degrees(by_theta.turns))};
}

Claim about_effect_of_inertia(const FamilyPeaks& by_eta,
                              const FamilyPeaks& by_k) {
  const double effect = by_k.turns.back() - by_k.turns.front();
  const double effect_of_eta = by_eta.turns.back() - by_eta.turns.front();
  const bool lesser = std::abs(effect) < std::abs(effect_of_eta);
  const bool same_way = effect * effect_of_eta > 0.0;
  return {"Sec. III.E", "k acts like η_m, but to a lesser degree.",
          !lesser    ? Fails
          : same_way ? Holds
                     : HoldsInPart,
          with_minus_signs(fmt::format(
              "The turning downwards is {} for {}: a change by {:+.1f}°{}. "
              "From η_m = 0 to 1/√2 it is {:+.1f}°.",
              in_degrees(by_k.turns), names_of(kByInertia), effect * kDegrees,
              same_way ? "" : ", the other way", effect_of_eta * kDegrees))};
}

Claim about_number_of_peaks(const std::vector<std::size_t>& caption,
                            const std::vector<std::size_t>& text) {
  const bool falls = std::ranges::is_sorted(caption, std::greater<>{}) &&
                     std::ranges::is_sorted(text, std::greater<>{});
  return {"Sec. III.F",
          "r influences the number of peaks and valleys; smaller cylinders "
          "have more.",
          falls && caption.front() > caption.back() ? Holds : Fails,
          fmt::format("{} peaks for {} with η_m = 2/3, {} with η_m = 1/3.",
                      fmt::join(caption, ", "), names_of(kByRadius),
                      fmt::join(text, ", "))};
}

/// "4.8706 (r = 0.5), …".
std::string by_radius(const std::vector<RadiusRow>& rows) {
  return list_of(rows, [](const RadiusRow& row) {
    return fmt::format("{:.4f} (r = {:.3g})", row.tau, row.radius);
  });
}

Claim about_radius(const Results& found) {
  constexpr double kNone = 0.005;  // half of the last digit that is printed
  std::vector<RadiusRow> off_centred;
  for (const Member& member : kByRadius) {
    off_centred.push_back(
        {found.cases[member.file].scene().body.radius, found.tau(member.file)});
  }
  const double k = found.cases["fig06_uniform_cylinder"].scene().body.k;
  const bool varies = spread(off_centred, &RadiusRow::tau) > kNone;
  const bool constant = spread(found.uniform, &RadiusRow::tau) < kNone;
  return {"Sec. III.F",
          "Transit times vary with r, unlike those of axisymmetric cylinders.",
          !varies    ? Fails
          : constant ? Holds
                     : HoldsInPart,
          fmt::format("Off-centred, η_m = 2/3: τ = {}. Axisymmetric times do "
                      "not depend on r between fixed ends of the centre's "
                      "path; between fixed points A and B of the track they "
                      "do: τ = {}, and for r → 0 that of the bead times "
                      "√(1 + k), {:.4f}.",
                      by_radius(off_centred), by_radius(found.uniform),
                      found.tau("fig06_bead") * std::sqrt(1.0 + k))};
}

Claim about_length_of_domain(const Results& found) {
  std::vector<double> times, lengths;
  for (const Member& member : kByLength) {
    times.push_back(found.tau(member.file));
    lengths.push_back(found.cases[member.file].motion().rail_length());
  }
  const bool longer =
      std::ranges::is_sorted(times) && std::ranges::is_sorted(lengths);
  return {"Sec. III.G", "Longer domains have longer tracks and take longer.",
          longer ? Holds : Fails,
          fmt::format("τ = {:.4f} and lengths {:.4f} for L = 2, 3, 4.",
                      fmt::join(times, ", "), fmt::join(lengths, ", "))};
}

}  // namespace

std::vector<Claim> claims_of_shapes(const Results& found) {
  const auto track = [&](const char* name) {
    return found.cases[name].motion().rail_length();
  };
  const double bead = track("fig06_bead");
  const double uniform = track("fig06_uniform_cylinder");
  const double off = track("fig04_reference_case");
  const FamilyPeaks by_eta = peaks_of(found, kByOffset);
  return {
      about_cycloids(found),
      about_pull(found),
      about_depth(found),
      about_shortest_track(bead, uniform, off),
      about_lengths(uniform, off),
      about_order(found.tau("fig06_bead"), found.tau("fig06_uniform_cylinder"),
                  found.tau("fig04_reference_case")),
      about_incline(found.tau("fig04_straight"), found.uniform_on_incline),
      about_angular_speed(found.cases["fig04_reference_case"].motion()),
      about_effect_of_offset(by_eta),
      about_place_of_peaks(by_eta, peaks_of(found, kByOrientation)),
      about_effect_of_inertia(by_eta, peaks_of(found, kByInertia)),
      about_number_of_peaks(peaks_of(found, kByRadius).numbers,
                            peaks_of(found, kByRadiusOfTheText).numbers),
      about_radius(found),
      about_length_of_domain(found)};
}

}  // namespace brachisto::reproduction
