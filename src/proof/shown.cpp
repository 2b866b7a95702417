// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "proof/shown.hpp"

#include <flint/flint.h>

#include <cmath>
#include <optional>

#include "brachisto/version.hpp"
#include "proof/certificate.hpp"

namespace brachisto::proof {

namespace {

constexpr int kDigits = 20;  // behind the point, of ends that are printed

/// Statements are made of what is a little wider than what was found, so that a
/// check whose roundings differ lies within.
Json stated(const Real& found, double times = 1.0) {
  const Real spare = Real(times) * found.radius() + Real(0x1p-66);
  const Real wide = found.widened(spare);
  return {{"lower", decimal_end(wide, false)},
          {"upper", decimal_end(wide, true)},
          {"ball", wide.exact()}};
}

Json theorem(const Theorem& shown) {
  Json out = {{"holds", shown.holds}};
  if (!shown.holds) out["why_not"] = shown.why_not;
  if (shown.refuted) out["refuted"] = true;
  return out;
}

Json excess(const Excess& shown) {
  Json out = theorem(shown.positive);
  out["slopes_from"] = hex(shown.least);
  out["slopes_to"] = hex(shown.most);
  return out;
}

/// What is not enclosed is not told.
Json friction(const std::vector<Friction>& shown) {
  // Maxima that are found again with other steps lie within five times the
  // radius: both enclose the true one.
  constexpr double kTimes = 4.0;
  Json out = Json::array();
  for (const Friction& each : shown) {
    if (!each.mu.finite()) continue;
    out.push_back({{"share_of_time", each.share},
                   {"mu", stated(each.mu, kTimes)},
                   {"x_per_H", stated(each.place, kTimes)}});
  }
  return out;
}

/// \param keeps  of a scene with limits, without which no path is a minimum
Json theorems_of(const Theorems& shown,
                 const std::optional<Theorem>& keeps = {}) {
  const bool kept = !keeps || keeps->holds;
  Json out = {{"exists_once_in_box", {{"holds", true}}},
              {"legendre", theorem(shown.legendre)},
              {"no_conjugate_point", theorem(shown.no_conjugate_point)},
              {"strict_minimum", {{"holds", kept && shown.strict_minimum()}}},
              {"other_slopes_cost_more", excess(shown.excess)},
              {"strong_minimum", {{"holds", kept && shown.strong_minimum()}}},
              {"normal_force_positive", theorem(shown.presses)},
              {"no_fold", theorem(shown.no_fold)},
              {"no_loop", theorem(shown.no_loop)}};
  if (keeps) out["keeps_limits"] = theorem(*keeps);
  return out;
}

Json theorems_of(const ArcTheorems& shown) {
  return {{"exists_once_in_box", {{"holds", true}}},
          {"legendre", theorem(shown.legendre)},
          {"keeps_limits", theorem(shown.keeps)},
          {"multipliers", theorem(shown.multipliers)},
          {"normal_force_positive", theorem(shown.presses)},
          {"no_fold", theorem(shown.no_fold)},
          {"no_loop", theorem(shown.no_loop)}};
}

}  // namespace

std::string decimal_end(const Real& ball, bool upper) {
  arf_t end, scaled;
  fmpz_t whole;
  arf_init(end);
  arf_init(scaled);
  fmpz_init(whole);
  if (upper) {
    arb_get_ubound_arf(end, ball.get(), working_bits);
  } else {
    arb_get_lbound_arf(end, ball.get(), working_bits);
  }
  fmpz_ui_pow_ui(whole, 10, kDigits);
  arf_mul_fmpz(scaled, end, whole, ARF_PREC_EXACT, ARF_RND_NEAR);
  if (upper) {
    arf_ceil(scaled, scaled);
  } else {
    arf_floor(scaled, scaled);
  }
  arf_get_fmpz(whole, scaled, ARF_RND_NEAR);
  const bool negative = fmpz_sgn(whole) < 0;
  fmpz_abs(whole, whole);
  char* text = fmpz_get_str(nullptr, 10, whole);
  std::string digits = text;
  flint_free(text);
  fmpz_clear(whole);
  arf_clear(end);
  arf_clear(scaled);
  if (digits.size() <= kDigits) {
    digits.insert(0, kDigits + 1 - digits.size(), '0');
  }
  digits.insert(digits.size() - kDigits, ".");
  return (negative ? "-" : "") + digits;
}

Shown shown_of(const PlainSystem& system, const Root& root,
               const Accuracy& accuracy) {
  const Theorems found =
      prove_theorems(system.scene(), as_free(system, root), accuracy);
  return {{"p_x", "p_z", "p_theta_0", "U"},
          root.searched,
          root.found,
          root.steps,
          found.enclosed,
          theorems_of(found),
          found.friction,
          {},
          {}};
}

Shown shown_of(const ArcSystem& system, const Root& root,
               const Accuracy& accuracy) {
  const ArcChain& chain = system.chain();
  Shown out;
  out.names = chain.names();
  out.searched = root.searched;
  out.found = root.found;
  out.steps = root.steps;
  out.arcs = arcs_json(chain);
  stays_on_its_side(system, root, accuracy);
  if (chain.one_free_arc()) {
    const Theorems found =
        prove_theorems(chain.scene, as_free(chain, root), accuracy);
    out.enclosed = found.enclosed;
    std::optional<Theorem> keeps;
    if (chain.scene.limits.any()) keeps = prove_limits(system, root, accuracy);
    out.theorems = theorems_of(found, keeps);
    out.friction = found.friction;
  } else {
    const ArcTheorems found = prove_arc_theorems(system, root, accuracy);
    out.enclosed = found.enclosed;
    out.theorems = theorems_of(found);
    out.junctions = found.junctions;
  }
  return out;
}

Json document(const Scene& scene, const Accuracy& accuracy,
              const Shown& shown) {
  Json unknowns;
  // What vanishes is found to any number of digits, but not by a check.
  constexpr int kSpareBits = 20;
  const Real rounding(std::ldexp(1.0, kSpareBits - accuracy.bits));
  for (std::size_t i = 0; i < shown.names.size(); ++i) {
    unknowns[shown.names[i]] = {
        {"searched", shown.searched[i].exact()},
        {"found", shown.found[i].widened(rounding).exact()}};
  }
  Json enclosures;
  for (const auto& [name, number] : kEnclosures) {
    enclosures[name] = stated(shown.enclosed.*number);
  }
  Json out = {{"certificate", "brachisto proof"},
              {"version", kCertificateVersion},
              {"provenance",
               {{"brachisto", BRACHISTO_VERSION},
                {"flint", std::string(flint_version)}}},
              {"scene", scene_json(scene)},
              {"accuracy",
               {{"bits", accuracy.bits},
                {"terms", accuracy.terms},
                {"share", hex(accuracy.share)},
                {"steps", shown.steps}}},
              {"unknowns", unknowns},
              {"enclosures", enclosures},
              {"theorems", shown.theorems},
              {"least_friction", friction(shown.friction)}};
  if (!shown.arcs.is_null()) {
    out["arcs"] = shown.arcs;
    Json& junctions = out["junctions"] = Json::array();
    for (const Junction& each : shown.junctions) {
      junctions.push_back(
          {{"x_per_H", stated(each.place)}, {"time", stated(each.time)}});
    }
  }
  out["digest"] = digest(out);
  return out;
}

}  // namespace brachisto::proof
