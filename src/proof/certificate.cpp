// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "proof/certificate.hpp"

#include <flint/flint.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>
#include <utility>

#include "brachisto/version.hpp"
#include "proof/arc_theorems.hpp"

namespace brachisto::proof {

namespace {

constexpr int kDigits = 20;  // behind the point, of ends that are printed

/// Where a ball ends, rounded outward to so many digits behind the point.
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

/// What was shown, of one free arc or of a chain.
struct Shown {
  std::vector<std::string> names;  ///< of the unknowns
  Vector searched, found;
  int steps = 0;
  Enclosures enclosed;
  Json theorems;
  std::vector<Friction> friction;
  std::vector<Junction> junctions;
  Json arcs;  ///< null of one free arc of a plain scene
};

Json theorems_of(const Theorems& shown) {
  return {{"exists_once_in_box", {{"holds", true}}},
          {"legendre", theorem(shown.legendre)},
          {"no_conjugate_point", theorem(shown.no_conjugate_point)},
          {"strict_minimum", {{"holds", shown.strict_minimum()}}},
          {"other_slopes_cost_more", excess(shown.excess)},
          {"strong_minimum", {{"holds", shown.strong_minimum()}}},
          {"normal_force_positive", theorem(shown.presses)},
          {"no_fold", theorem(shown.no_fold)},
          {"no_loop", theorem(shown.no_loop)}};
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

Shown shown_of(const Scene& scene, const Root& root, const Accuracy& accuracy) {
  const Theorems found = prove_theorems(scene, as_free(scene, root), accuracy);
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

Shown shown_of(const ArcSystem& system, const ArcRoot& root,
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
    out.theorems = theorems_of(found);
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
  for (std::size_t i = 0; i < shown.names.size(); ++i) {
    unknowns[shown.names[i]] = {{"searched", shown.searched[i].exact()},
                                {"found", shown.found[i].exact()}};
  }
  const Enclosures& e = shown.enclosed;
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
              {"enclosures",
               {{"tau", stated(e.tau)},
                {"start_angle", stated(e.start_angle)},
                {"end_angle", stated(e.end_angle)},
                {"length_per_H", stated(e.length)},
                {"rotation", stated(e.rotation)}}},
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

/// Nothing may be said that was not shown, nor that is not shown again.
void compare(const Json& said, const Json& shown) {
  const Json& again = shown.at("theorems");
  const auto says = [](const Json& theorem, const char* what) {
    return theorem.contains(what) && theorem.at(what) != false;
  };
  for (const auto& [name, theorem] : said.at("theorems").items()) {
    for (const char* what : {"holds", "refuted"}) {
      if (says(theorem, what) &&
          !(again.contains(name) && says(again.at(name), what))) {
        throw Refused(
            fmt::format("it says of {} what is not shown again", name));
      }
    }
  }
  const char* slopes = "other_slopes_cost_more";
  if (!said.at("theorems").contains(slopes)) return;
  const auto edge = [&](const Json& of, const char* key) {
    return number(of.at("theorems").at(slopes), key);
  };
  if (edge(said, "slopes_from") < edge(shown, "slopes_from") ||
      edge(said, "slopes_to") > edge(shown, "slopes_to")) {
    throw Refused(fmt::format("it says of {} what is not shown again", slopes));
  }
}

/// An enclosure that was said holds one that was found, and its printed ends
/// are its own.
void compare(const Json& said, const Real& found, std::string_view name) {
  const Real claimed = ball(said.at("ball"));
  if (!found.within(claimed) ||
      said.at("lower") != decimal_end(claimed, false) ||
      said.at("upper") != decimal_end(claimed, true)) {
    throw Refused(fmt::format("its {} is not what is found again", name));
  }
}

void compare_friction(const Json& said, const std::vector<Friction>& found) {
  for (const Json& each : said) {
    const auto again =
        std::find_if(found.begin(), found.end(), [&](const Friction& one) {
          return each.at("share_of_time") == one.share && one.mu.finite();
        });
    if (again == found.end()) {
      throw Refused("its least friction is not found again");
    }
    compare(each.at("mu"), again->mu, "least friction");
    compare(each.at("x_per_H"), again->place, "place of least friction");
  }
}

void compare_junctions(const Json& certificate,
                       const std::vector<Junction>& found) {
  const Json said = certificate.value("junctions", Json::array());
  if (said.size() != found.size()) {
    throw Refused("its junctions are not found again");
  }
  for (std::size_t i = 0; i < found.size(); ++i) {
    compare(said[i].at("x_per_H"), found[i].place, "junction");
    compare(said[i].at("time"), found[i].time, "junction");
  }
}

}  // namespace

// FNV-1a.
std::string digest(Json certificate) {
  certificate.erase("digest");
  std::uint64_t hash = 14695981039346656037U;
  for (const char byte : certificate.dump()) {
    hash = (hash ^ static_cast<unsigned char>(byte)) * 1099511628211U;
  }
  return fmt::format("{:016x}", hash);
}

Accuracy accuracy_of(int bits) {
  constexpr Accuracy kUsual;
  return {.bits = bits,
          .terms = kUsual.terms * bits / kUsual.bits,
          .share = kUsual.share};
}

Json prove(const Scene& scene, const Accuracy& accuracy) {
  const std::string kind = not_of_this_kind(scene);
  if (!kind.empty()) throw NotProven("nothing is proven of " + kind + " yet");
  const Bits bits(accuracy.bits);
  try {
    if (is_plain(scene)) {
      const Root root = find_root(scene, approximation(scene), accuracy);
      return document(scene, accuracy, shown_of(scene, root, accuracy));
    }
    const NearChain near = approximate_chain(scene);
    const std::string why = not_of_this_kind(near.chain);
    if (!why.empty()) throw NotProven("nothing is proven where " + why);
    const ArcSystem system(near.chain);
    const ArcRoot root = find_arc_root(system, near.unknowns, accuracy);
    return document(scene, accuracy, shown_of(system, root, accuracy));
  } catch (const TooFewBits& error) {
    constexpr int kWord = 32;
    const int more = (accuracy.bits * 7 / 5 + kWord - 1) / kWord * kWord;
    throw TooFewBits(
        more > kMostBits
            ? fmt::format("{}, even at {} bits", error.what(), accuracy.bits)
            : fmt::format("{}; more bits may help: --bits {}", error.what(),
                          more));
  }
}

Scene scene_of(const Json& certificate) {
  if (!certificate.is_object() ||
      certificate.value("certificate", "") != "brachisto proof") {
    throw Refused("it is no certificate of `brachisto prove`");
  }
  if (certificate.at("version") != kCertificateVersion ||
      certificate.at("provenance").at("brachisto") != BRACHISTO_VERSION) {
    throw Refused("it is of another version");
  }
  if (certificate.at("digest") != digest(certificate)) {
    throw Refused("it was edited: its digest is not its own");
  }
  return scene_from(certificate.at("scene"));
}

bool is_of(const Json& certificate, const Scene& scene) {
  return not_of_this_kind(scene).empty() &&
         certificate.at("scene") == scene_json(scene);
}

Json check(const Json& certificate) {
  constexpr int kMoreBits = 40, kMoreTerms = 7;
  constexpr double kShorter = 0.85;
  const Scene scene = scene_of(certificate);
  const Json& made = certificate.at("accuracy");
  const int bits_said = made.at("bits").get<int>();
  if (bits_said < kLeastBits || bits_said > kMostBits) {
    throw Refused("its precision is none that is allowed");
  }
  const Accuracy usual = accuracy_of(bits_said);
  const Accuracy accuracy{.bits = usual.bits + kMoreBits,
                          .terms = usual.terms + kMoreTerms,
                          .share = usual.share * kShorter};
  const Bits bits(accuracy.bits);
  Vector searched, found;
  for (const auto& [name, said] : certificate.at("unknowns").items()) {
    searched.push_back(ball(said.at("searched")));
    found.push_back(ball(said.at("found")));
  }
  const Shown shown = [&] {
    if (is_plain(scene)) {
      if (searched.size() != kUnknowns) throw Refused("its box is another's");
      return shown_of(scene, verify_root(scene, searched, accuracy), accuracy);
    }
    const ArcSystem system(chain_from(scene, certificate.at("arcs")));
    if (searched.size() != system.chain().num_unknowns()) {
      throw Refused("its box is another's");
    }
    return shown_of(system, verify_arc_root(system, searched, accuracy),
                    accuracy);
  }();
  const std::array<std::pair<const char*, const Real*>, 5> enclosures{
      {{"tau", &shown.enclosed.tau},
       {"start_angle", &shown.enclosed.start_angle},
       {"end_angle", &shown.enclosed.end_angle},
       {"length_per_H", &shown.enclosed.length},
       {"rotation", &shown.enclosed.rotation}}};
  for (const auto& [name, value] : enclosures) {
    compare(certificate.at("enclosures").at(name), *value, name);
  }
  compare_friction(certificate.at("least_friction"), shown.friction);
  compare_junctions(certificate, shown.junctions);
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (arb_overlaps(shown.found[i].get(), found[i].get()) == 0) {
      throw Refused("its box is not where the root is");
    }
  }
  Json again = document(scene, accuracy, shown);
  compare(certificate, again);
  return again;
}

double distance_to_tau(const Json& certificate, double tau) {
  return (ball(certificate.at("enclosures").at("tau").at("ball")) - Real(tau))
      .abs()
      .upper();
}

}  // namespace brachisto::proof
