// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "model/cycloid.hpp"
#include "reproduction/claims.hpp"
#include "reproduction/members.hpp"
#include "reproduction/peaks.hpp"

namespace brachisto::reproduction {

namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;

std::vector<PeaksAndValleys> tracks_of(const Results& found,
                                       const Members& family) {
  std::vector<PeaksAndValleys> out;
  for (const Member& member : family) {
    out.push_back(peaks_and_valleys(found.cases[member.file].motion()));
  }
  return out;
}

std::vector<double> turns_of(const std::vector<PeaksAndValleys>& tracks) {
  std::vector<double> out;
  for (const PeaksAndValleys& track : tracks) out.push_back(track.turn());
  return out;
}

std::vector<std::size_t> numbers_of(
    const std::vector<PeaksAndValleys>& tracks) {
  std::vector<std::size_t> out;
  for (const PeaksAndValleys& track : tracks) {
    out.push_back(track.peaks.size());
  }
  return out;
}

/// Where the first peaks are, of the tracks that have any.
std::vector<double> places_of(const std::vector<PeaksAndValleys>& tracks) {
  std::vector<double> out;
  for (const PeaksAndValleys& track : tracks) {
    if (!track.peaks.empty()) out.push_back(track.peaks.front().top.x);
  }
  return out;
}

double spread(const std::vector<double>& values) {
  const auto [least, most] = std::ranges::minmax(values);
  return most - least;
}

/// "0.0°, 10.8°".
std::string in_degrees(const std::vector<double>& radians) {
  std::vector<std::string> out;
  for (const double angle : radians) {
    out.push_back(fmt::format("{:.1f}°", angle * kDegrees));
  }
  return fmt::format("{}", fmt::join(out, ", "));
}

std::string names_of(const Members& family) {
  std::vector<std::string> out;
  for (const Member& member : family) out.push_back(member.name);
  return fmt::format("{}", fmt::join(out, ", "));
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
    largest = std::max(
        largest, std::hypot(at.centre.x - there.x, at.centre.z - there.z));
  }
  return largest;
}

}  // namespace

Claim about_dependence_on_inertia(const Results& found) {
  const auto& [axisymmetric, off_centred] = found.shift_by_inertia;
  constexpr double kNone = 1e-6;
  const bool holds = axisymmetric < kNone && off_centred > kNone;
  return {"Sec. II.A",
          "The track depends on k too; that of an axisymmetric body does not.",
          holds ? Verdict::Holds : Verdict::Fails,
          fmt::format("Between k = 0.1 and k = 5/9 a point of the track at the "
                      "same share of the rolling time moves by up to {:.3f} "
                      "for η_m = 2/3 and by {:.0e} for η_m = 0.",
                      off_centred, axisymmetric)};
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
          std::max(bead, uniform) < kSame ? Verdict::Holds : Verdict::Fails,
          fmt::format("The solutions keep within {:.0e} and {:.0e} of the "
                      "closed forms.",
                      bead, uniform)};
}

Claim about_pull(const Results& found) {
  std::size_t scenes = 0;
  std::size_t peaks = 0;
  std::size_t valleys = 0;
  std::size_t elsewhere = 0;
  for (const auto& [name, one] : found.cases.all()) {
    if (one.scene().path || !one.scene().body.off_centred()) continue;
    ++scenes;
    const PeaksAndValleys track = peaks_and_valleys(one.motion());
    peaks += track.peaks.size();
    valleys += track.valleys.size();
    for (const Peak& peak : track.peaks) {
      elsewhere += std::sin(peak.top.theta) > 0.0 ? 0 : 1;
    }
    for (const Bend& valley : track.valleys) {
      elsewhere += std::sin(valley.theta) < 0.0 ? 0 : 1;
    }
  }
  return {"Sec. III.B",
          "The track is pulled in where the centre of mass is at the bottom "
          "and pushed out where it is at the top.",
          elsewhere == 0 ? Verdict::Holds : Verdict::HoldsInPart,
          fmt::format("In the {} off-centred scenes there are {} peaks and {} "
                      "valleys between them. With the centre of mass below the "
                      "axis in a peak, above it in a valley: {} of {}.",
                      scenes, peaks, valleys, peaks + valleys - elsewhere,
                      peaks + valleys)};
}

Claim about_depth(const Results& found) {
  const double here =
      deepest_mass_centre(found.cases["fig04_reference_case"].motion());
  const double on_cycloid =
      deepest_mass_centre(found.cases["fig04_cycloid"].motion());
  return {"Sec. III.B",
          "So the centre of mass does not fall too deep, to have to come up "
          "again.",
          here < on_cycloid ? Verdict::Holds : Verdict::Fails,
          fmt::format("It comes down to z = {:.4f} H; on Cycloid*, which is "
                      "pulled nowhere, to {:.4f} H.",
                      here, on_cycloid)};
}

Claim about_effect_of_offset(const Results& found) {
  const Members family = tracks_by_offset();
  const std::vector<PeaksAndValleys> tracks = tracks_of(found, family);
  const std::vector<double> turns = turns_of(tracks);
  const bool grows = std::ranges::is_sorted(turns) && turns.front() == 0.0 &&
                     turns.back() > 0.0;
  return {"Sec. III.C",
          "A growing η_m gradually induces peaks and valleys and makes them "
          "more pronounced.",
          grows ? Verdict::Holds : Verdict::Fails,
          fmt::format("The track turns downwards on {} peaks, by {} in all, "
                      "for {}.",
                      fmt::join(numbers_of(tracks), ", "), in_degrees(turns),
                      names_of(family))};
}

Claim about_place_of_peaks(const Results& found) {
  const std::vector<PeaksAndValleys> by_theta =
      tracks_of(found, tracks_by_orientation());
  const std::vector<PeaksAndValleys> by_eta =
      tracks_of(found, tracks_by_offset());
  const std::vector<double> places = places_of(by_theta);
  const std::vector<double> places_by_eta = places_of(by_eta);
  const std::vector<double> turns = turns_of(by_theta);
  const bool moves = spread(places) > spread(places_by_eta);
  // As little as the other moves them.
  const bool moves_only = spread(turns) / spread(turns_of(by_eta)) <
                          spread(places_by_eta) / spread(places);
  return {"Sec. III.D",
          "While η_m dictates the extent of peaks and valleys, θ_m determines "
          "their location.",
          !moves       ? Verdict::Fails
          : moves_only ? Verdict::Holds
                       : Verdict::HoldsInPart,
          fmt::format("From θ_m = −90° to 90° the first peak moves from x_b = "
                      "{:.2f} to {:.2f}; η_m moves it by {:.2f}. But the "
                      "extent depends on θ_m as well: the track turns "
                      "downwards by {}.",
                      places.front(), places.back(), spread(places_by_eta),
                      in_degrees(turns))};
}

Claim about_effect_of_inertia(const Results& found) {
  const Members family = tracks_by_inertia();
  const std::vector<double> turns = turns_of(tracks_of(found, family));
  const std::vector<double> by_eta =
      turns_of(tracks_of(found, tracks_by_offset()));
  const double effect = turns.back() - turns.front();
  const double effect_of_eta = by_eta.back() - by_eta.front();
  const bool lesser = std::abs(effect) < std::abs(effect_of_eta);
  const bool same_way = effect * effect_of_eta > 0.0;
  return {"Sec. III.E", "k acts like η_m, but to a lesser degree.",
          !lesser    ? Verdict::Fails
          : same_way ? Verdict::Holds
                     : Verdict::HoldsInPart,
          with_minus_signs(fmt::format(
              "The turning downwards is {} for {}: a change by {:+.1f}°{}. "
              "From η_m = 0 to 1/√2 it is {:+.1f}°.",
              in_degrees(turns), names_of(family), effect * kDegrees,
              same_way ? "" : ", the other way", effect_of_eta * kDegrees))};
}

Claim about_number_of_peaks(const Results& found) {
  const auto numbers = [&](const Members& family) {
    return numbers_of(tracks_of(found, family));
  };
  const std::vector<std::size_t> caption = numbers(tracks_by_radius());
  const std::vector<std::size_t> text = numbers(tracks_by_radius_of_the_text());
  const bool falls = std::ranges::is_sorted(caption, std::greater<>{}) &&
                     std::ranges::is_sorted(text, std::greater<>{});
  return {"Sec. III.F",
          "r influences the number of peaks and valleys; smaller cylinders "
          "have more.",
          falls && caption.front() > caption.back() ? Verdict::Holds
                                                    : Verdict::Fails,
          fmt::format("{} peaks for {} with η_m = 2/3, {} with η_m = 1/3.",
                      fmt::join(caption, ", "), names_of(tracks_by_radius()),
                      fmt::join(text, ", "))};
}

}  // namespace brachisto::reproduction
