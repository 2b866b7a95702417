// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// What a certificate says, on the terminal and as a page.

#include <fmt/format.h>

#include <array>
#include <functional>
#include <utility>

#include "proof/certificate.hpp"

namespace brachisto::proof {

namespace {

constexpr std::array<std::pair<const char*, const char*>, 7> kStatements{
    {{"keeps_limits", "the path keeps all limits, strictly where none holds"},
     {"multipliers", "multipliers have the sign of Pontryagin's principle"},
     {"strict_minimum",
      "T is a strict weak local minimum between its fixed ends"},
     {"strong_minimum", "the same among paths of any slopes that stay near"},
     {"normal_force_positive", "R_n > 0 after the start"},
     {"no_fold", "the track does not fold"},
     {"no_loop", "the path has no loop: |β| < π"}}};

const char* verdict(const Json& theorem) {
  if (theorem.at("holds").get<bool>()) return "proven";
  return theorem.contains("refuted") ? "disproven" : "not proven";
}

/// A ball with as many decimals as it has.
std::string decimals(const Json& exact) {
  constexpr slong kMostDigits = 60;
  Real ball;
  if (!Real::read(exact.get<std::string>(), ball)) return "?";
  char* text = arb_get_str(ball.get(), kMostDigits, 0);
  std::string out = text;
  flint_free(text);
  return out;
}

/// "free, floor, free"; empty of a single arc.
std::string arcs_of(const Json& certificate) {
  std::string out;
  for (const Json& arc : certificate.value("arcs", Json::array())) {
    out += (out.empty() ? "" : ", ") + arc.value("holds", "free");
  }
  return out.find(',') == std::string::npos ? "" : out;
}

std::string ends_of(const Json& enclosure) {
  return fmt::format("[{}, {}]", enclosure.at("lower").get<std::string>(),
                     enclosure.at("upper").get<std::string>());
}

/// Rows of a table: all numbers of a map in it, under their keys.
std::string of_world_and_limits(const Json& scene) {
  std::string out;
  const std::function<void(const std::string&, const Json&)> add =
      [&](const std::string& key, const Json& value) {
        if (value.is_structured()) {
          for (const auto& [name, each] : value.items()) {
            add(key.empty() ? name : key + "." + name, each);
          }
        } else {
          const std::string text = value.get<std::string>();
          const bool number = text.find("0x") != std::string::npos;
          out += fmt::format("| {} | {} | {} |\n", key, text,
                             number ? fmt::format("{}", std::stod(text)) : "");
        }
      };
  add("", scene.at("world"));
  add("limits", scene.at("limits"));
  if (scene.contains("end_slope")) add("end_slope", scene.at("end_slope"));
  return out;
}

}  // namespace

std::string in_words(const Json& certificate) {
  const Json& e = certificate.at("enclosures");
  const Json& t = certificate.at("theorems");
  const auto between = [&](const char* name, const char* symbol) {
    return fmt::format("  {} in {}\n", symbol, ends_of(e.at(name)));
  };
  const std::string arcs = arcs_of(certificate);
  std::string out = fmt::format(
      "Theorem. Of the scene, its numbers of 64 bits taken as exact, exactly "
      "one\n{} lies in the box of the certificate, and of it\n",
      arcs.empty() ? "extremal" : "chain of these arcs");
  out += between("tau", "τ");
  out += between("end_angle", "φ");
  out += between("length_per_H", "S/H");
  if (!arcs.empty()) out += fmt::format("  arcs: {}\n", arcs);
  for (const Json& each : certificate.value("junctions", Json::array())) {
    out +=
        fmt::format("  a junction at x/H in {}\n", ends_of(each.at("x_per_H")));
  }
  for (const auto& [name, words] : kStatements) {
    if (!t.contains(name)) continue;
    out += fmt::format("  {}: {}\n", verdict(t.at(name)), words);
  }
  for (const Json& each : certificate.at("least_friction")) {
    out += fmt::format("  least friction after {:g} % of T in {}\n",
                       100.0 * each.at("share_of_time").get<double>(),
                       ends_of(each.at("mu")));
  }
  for (const auto& [name, said] : t.items()) {
    if (said.contains("why_not")) {
      out += fmt::format("  {}: {}\n", name,
                         said.at("why_not").get<std::string>());
    }
  }
  return out;
}

std::string page(const Json& certificate) {
  const Json& scene = certificate.at("scene");
  const Json& accuracy = certificate.at("accuracy");
  const Json& made_by = certificate.at("provenance");
  const auto number = [&](const char* key) {
    const std::string exact = scene.at(key).get<std::string>();
    return fmt::format("| {} | {} | {} |\n", key, exact, std::stod(exact));
  };
  const bool bead = scene.at("shape") == "bead";
  const bool plain = !scene.contains("world");
  std::string out = fmt::format(
      "# Theorem\n\nA {} goes {}to B, L to the side and H below, {}; "
      "`contact: {}`. Its numbers are these, exactly:\n\n"
      "| | exact | about |\n| --- | --- | --- |\n",
      bead ? "bead" : "cylinder", plain ? "from rest at A " : "from A ",
      plain ? "in a uniform field, without losses" : "in SI units",
      scene.at("contact").get<std::string>());
  for (const char* key : {"radius", "eta_m", "theta_m", "k"}) {
    if (!bead) out += number(key);
  }
  out += number("L") + number("H");
  if (!plain) out += number("gravity") + of_world_and_limits(scene);
  const std::string arcs = arcs_of(certificate);
  out += plain
             ? "\nIn units of r (of a bead: of metres) and with 2 g = 1, let "
               "θ(0) = θ_m, w(0) = 0, β(0) = β₀ the start angle and p_w(0) as "
               "𝓗 = 0 asks. Of all (p_x, p_z, p_θ(0), U) in the box (exactly "
               "in proof.json)\n\n"
             : fmt::format(
                   "\n{}Of all states and costates at the starts of the arcs "
                   "and lengths U of the arcs in the box (exactly in "
                   "proof.json)\n\n",
                   arcs.empty() ? "" : fmt::format("The arcs are: {}. ", arcs));
  for (const auto& [name, box] : certificate.at("unknowns").items()) {
    out += fmt::format("    {} = {}\n", name, decimals(box.at("searched")));
  }
  out += plain
             ? "\nexactly one solution of Hamilton's equations ends in B with "
               "p_θ = p_w = 0. Of it\n\n"
             : fmt::format(
                   "\nexactly one {} satisfies the conditions at A, at B and "
                   "where arcs meet (docs/proofs.md lists them). Of it\n\n",
                   arcs.empty() ? "extremal" : "chain of these arcs");
  for (const auto& [name, enclosure] : certificate.at("enclosures").items()) {
    out += fmt::format("    {} in {}\n", name, ends_of(enclosure));
  }
  for (const Json& each : certificate.at("least_friction")) {
    out += fmt::format(
        "    max |R_t|/R_n from {:g} % of T on in {}, at x/H in {}\n",
        100.0 * each.at("share_of_time").get<double>(), ends_of(each.at("mu")),
        ends_of(each.at("x_per_H")));
  }
  for (const Json& each : certificate.value("junctions", Json::array())) {
    out += fmt::format("    a junction at x/H in {}, t √(2 g/H) in {}\n",
                       ends_of(each.at("x_per_H")), ends_of(each.at("time")));
  }
  out += "\nand each of these by itself:\n\n";
  for (const auto& [name, said] : certificate.at("theorems").items()) {
    out += fmt::format("- `{}`: {}{}\n", name, verdict(said),
                       said.contains("why_not")
                           ? " (" + said.at("why_not").get<std::string>() + ")"
                           : "");
  }
  out += fmt::format(
      "\n# What the machine did\n\nIt integrated with balls of {} bits and "
      "Taylor series of {} terms in {} steps, and found that Krawczyk's "
      "operator "
      "maps the box into its interior. What series leave out is bounded by "
      "their "
      "own terms. Signs along the path are those of enclosures over pieces "
      "that "
      "cover it.\n",
      accuracy.at("bits").get<int>(), accuracy.at("terms").get<int>(),
      accuracy.at("steps").get<int>());
  out += fmt::format(
      "\n# What is trusted\n\nThe compiler; FLINT {} and its Arb; brachisto "
      "{}: "
      "its formulas of 𝓗 and of the forces, and src/proof. docs/proofs.md "
      "tells "
      "the theory. Nothing is said of extremals elsewhere.\n\n    brachisto "
      "check-proof proof.json\n\nshows all of it again with more bits, more "
      "terms and shorter steps.\n",
      made_by.at("flint").get<std::string>(),
      made_by.at("brachisto").get<std::string>());
  return out;
}

}  // namespace brachisto::proof
