// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "proof/certificate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>

#include "brachisto/version.hpp"
#include "proof/shown.hpp"

namespace brachisto::proof {

namespace {

std::vector<std::string> keys(const Json& object) {
  std::vector<std::string> out;
  for (const auto& [key, value] : object.get_ref<const Json::object_t&>()) {
    out.push_back(key);
  }
  return out;
}

void compare_keys(const Json& said, const std::vector<std::string>& asked,
                  std::string_view where) {
  const std::vector<std::string> found = keys(said);
  if (found == asked) return;
  const auto other = std::ranges::find_if(found, [&](const std::string& key) {
    return std::ranges::find(asked, key) == asked.end();
  });
  throw Refused(fmt::format("its {} are not those that are shown again{}",
                            where, other == found.end() ? "" : ": " + *other));
}

/// What a reason says without the place, which depends on the steps.
std::string_view without_place(std::string_view reason) {
  return reason.substr(0, reason.find(" near u = "));
}

/// Whether a theorem says no more than the one that is shown again. Where less
/// was shown, why is a remark of the prover.
bool no_more(const Json& said, const Json& again) {
  const auto always = [](Json theorem) {
    for (const char* key : {"refuted", "why_not"}) theorem.erase(key);
    return keys(theorem);
  };
  if (always(said) != always(again)) return false;
  const auto says = [](const Json& theorem, const char* what) {
    return theorem.contains(what) && theorem.at(what).get<bool>();
  };
  if ((says(said, "holds") && !says(again, "holds")) ||
      (says(said, "refuted") && !says(again, "refuted")) ||
      (says(said, "holds") && said.contains("why_not"))) {
    return false;
  }
  if (says(said, "refuted") && without_place(said.value("why_not", "")) !=
                                   without_place(again.value("why_not", ""))) {
    return false;
  }
  const auto edge = [](const Json& of, const char* key) {
    return of.contains(key) ? number(of, key) : 0.0;
  };
  return edge(said, "slopes_from") >= edge(again, "slopes_from") &&
         edge(said, "slopes_to") <= edge(again, "slopes_to");
}

/// Nothing may be said that was not shown, nor that is not shown again.
void compare(const Json& said, const Json& again) {
  compare_keys(said, keys(again), "parts");
  for (const char* each :
       {"provenance", "accuracy", "unknowns", "enclosures", "theorems"}) {
    compare_keys(said.at(each), keys(again.at(each)), each);
  }
  for (const auto& [name, box] : said.at("unknowns").items()) {
    compare_keys(box, {"searched", "found"}, "balls");
  }
  for (const auto& [name, theorem] : said.at("theorems").items()) {
    if (!no_more(theorem, again.at("theorems").at(name))) {
      throw Refused(fmt::format("it says of {} what is not shown again", name));
    }
  }
}

/// An enclosure that was said holds one that was found, and its printed ends
/// are its own.
void compare(const Json& said, const Real& found, std::string_view name) {
  compare_keys(said, {"lower", "upper", "ball"}, "ends");
  const Real claimed = ball(said.at("ball"));
  if (!found.within(claimed) ||
      said.at("lower") != decimal_end(claimed, false) ||
      said.at("upper") != decimal_end(claimed, true)) {
    throw Refused(fmt::format("its {} is not what is found again", name));
  }
}

bool within(const Vector& found, const Vector& said) {
  return std::ranges::equal(
      found, said, [](const Real& a, const Real& b) { return a.within(b); });
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
    compare_keys(each, {"share_of_time", "mu", "x_per_H"},
                 "numbers of friction");
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
    compare_keys(said[i], {"x_per_H", "time"}, "numbers of a junction");
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
      const PlainSystem system(scene);
      const Root root = find_root(system, approximation(scene), accuracy);
      return document(scene, accuracy, shown_of(system, root, accuracy));
    }
    const NearChain near = approximate_chain(scene);
    const std::string why = not_of_this_kind(near.chain);
    if (!why.empty()) throw NotProven("nothing is proven where " + why);
    const ArcSystem system(near.chain);
    const Root root = find_root(system, near.unknowns, accuracy);
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
  if (made.at("terms") != usual.terms || made.at("share") != hex(usual.share) ||
      !made.at("steps").is_number_integer() ||
      !certificate.at("provenance").at("flint").is_string()) {
    throw Refused("its accuracy is none that it could have been made with");
  }
  const Accuracy accuracy{.bits = usual.bits + kMoreBits,
                          .terms = usual.terms + kMoreTerms,
                          .share = usual.share * kShorter};
  const Bits bits(accuracy.bits);
  Vector searched, found;
  for (const auto& [name, said] : certificate.at("unknowns").items()) {
    searched.push_back(ball(said.at("searched")));
    found.push_back(ball(said.at("found")));
  }
  std::optional<PlainSystem> plain;
  std::optional<ArcSystem> chain;
  if (is_plain(scene)) {
    plain.emplace(scene);
  } else {
    chain.emplace(chain_from(scene, certificate.at("arcs")));
  }
  const ShootingSystem& system =
      plain ? static_cast<const ShootingSystem&>(*plain) : *chain;
  if (searched.size() != system.units().size()) {
    throw Refused("its box is another's");
  }
  const Root root = verify_root(system, searched, accuracy);
  const Shown shown = plain ? shown_of(*plain, root, accuracy)
                            : shown_of(*chain, root, accuracy);
  Json again = document(scene, accuracy, shown);
  compare(certificate, again);
  for (const auto& [name, number] : kEnclosures) {
    compare(certificate.at("enclosures").at(name), shown.enclosed.*number,
            name);
  }
  compare_friction(certificate.at("least_friction"), shown.friction);
  compare_junctions(certificate, shown.junctions);
  if (!within(shown.found, found)) {
    // The part that is found depends on C; a second step leaves less of it.
    const Vector narrower = narrowed(system, shown.found, accuracy);
    if (!within(narrower, found)) {
      throw Refused("its box is not where the root is");
    }
  }
  return again;
}

double distance_to_tau(const Json& certificate, double tau) {
  return (ball(certificate.at("enclosures").at("tau").at("ball")) - Real(tau))
      .abs()
      .upper();
}

}  // namespace brachisto::proof
