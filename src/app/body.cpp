// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// brachisto body PART…: the numbers of a body that is made of parts.

#include <fmt/format.h>
#include <memory>

#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "app/exit_code.hpp"
#include "app/terminal.hpp"
#include "app/verbs.hpp"
#include "brachisto/model/body.hpp"
#include "brachisto/report/result.hpp"
#include "io/body_parts.hpp"
#include "io/expression.hpp"
#include "io/visible_text.hpp"
#include "math/angle.hpp"

namespace brachisto::app {

namespace {

struct BodyFlags {
  std::vector<std::string> parts;
  std::string radius;  ///< expression [m]; empty: r is the unit of length
  bool json = false;
};

/// The shortest text of about the same number: without the last three digits
/// if only rounding put them there.
std::string tidy(double value) {
  constexpr double kSame = 4.0 * std::numeric_limits<double>::epsilon();
  const std::string text = fmt::format("{:.12g}", value);
  return std::abs(std::stod(text) - value) <= kSame * std::abs(value)
             ? text
             : fmt::format("{}", value);
}

/// "-30 deg".
std::string angle(double radians) {
  return tidy(math::in_degrees(radians)) + " deg";
}

UsageError refused(const std::string& what) {
  return {"brachisto body", io::visible(what)};
}

double radius_of(const BodyFlags& flags) {
  if (flags.radius.empty()) return 1.0;
  try {
    const double radius = io::evaluate(flags.radius);
    if (radius > 0.0) return radius;
    throw io::ExpressionError("a radius is > 0");
  } catch (const io::ExpressionError& error) {
    throw refused("--radius " + flags.radius + ": " + error.what());
  }
}

MassProperties properties_of(const BodyFlags& flags, double radius) {
  std::vector<MassPart> parts;
  for (const std::string& text : flags.parts) {
    try {
      parts.push_back(io::read_mass_part(text, radius));
    } catch (const std::invalid_argument& error) {
      throw refused(text + ": " + error.what());
    }
  }
  try {
    return mass_properties(parts, radius);
  } catch (const std::invalid_argument& error) {
    throw refused(error.what());
  }
}

/// The line of a scene. Without a radius in metres it says 1 and what to do.
std::string yaml(const BodyFlags& flags, double radius,
                 const MassProperties& found) {
  std::string line =
      fmt::format("body: {{shape: cylinder, radius: {}", tidy(radius));
  if (found.eta_m > 0.0) {
    line += fmt::format(", eta_m: {}, theta_m: {}", tidy(found.eta_m),
                        angle(found.theta_m));
  }
  line += fmt::format(", k: {}", tidy(found.k));
  if (flags.radius.empty()) return line + "}  # radius: yours, in m";
  return line + fmt::format(", mass: {}}}", tidy(found.mass));
}

void print_document(const BodyFlags& flags, double radius,
                    const MassProperties& found) {
  nlohmann::ordered_json body = {
      {"shape", "cylinder"},      {"radius", radius}, {"eta_m", found.eta_m},
      {"theta_m", found.theta_m}, {"k", found.k},     {"mass", found.mass}};
  print_json({{"schema_version", report::kSchemaVersion},
              {"unit_of_length", flags.radius.empty() ? "radius" : "m"},
              {"body", body},
              {"r_m", found.r_m},
              {"largest_k", found.largest_k()},
              {"yaml", yaml(flags, radius, found)}});
}

void print_table(const BodyFlags& flags, double radius,
                 const MassProperties& found) {
  const bool metres = !flags.radius.empty();
  const bool off = found.eta_m > 0.0;
  print(fmt::format(
      "m    {:.10g}{}\nη_m  {:.10g}{}\nθ_m  {}\n"
      "k    {:.10g}  (at most 1 − η_m² = {:.10g}, with all mass on the rim)\n\n"
      "{}\n",
      found.mass, metres ? " kg" : "", found.eta_m,
      metres && off ? fmt::format("  (r_m = {:.6g} m)", found.r_m) : "",
      off ? fmt::format("{:.10g}°", math::in_degrees(found.theta_m))
          : "any: the centre of mass lies on the axis",
      found.k, found.largest_k(), yaml(flags, radius, found)));
  if (found.eta_m == 1.0) {
    tell(
        "brachisto: η_m = 1 is refused in a scene: all mass in one point of "
        "the rim, which rests whenever it touches the track\n");
  }
}

int run(const BodyFlags& flags) {
  const double radius = radius_of(flags);
  const MassProperties found = properties_of(flags, radius);
  if (flags.json) {
    print_document(flags, radius, found);
  } else {
    print_table(flags, radius, found);
  }
  return kSuccess;
}

}  // namespace

Verb body_verb() {
  const auto flags = std::make_shared<BodyFlags>();
  return {
      .name = "body",
      .text = "Compute eta_m, theta_m and k of a body from its parts",
      .flags = {{.name = "PART",
                 .value = &flags->parts,
                 .text = "Part of the body, KIND:NAME=VALUE,… (see below)",
                 .placeholder = "",
                 .required = true},
                {.name = "--radius",
                 .value = &flags->radius,
                 .text = "Radius of the cylinder in m; lengths of parts are in "
                         "m then and masses in kg, else lengths are in radii",
                 .placeholder = "LENGTH",
                 .check = not_empty()},
                json_flag(flags->json)},
      .footer = "Parts:\n" + io::mass_part_grammar() +
                "Numbers may be expressions as in problem files.\n"
                "Examples:\n"
                "  brachisto body ring:m=2 point:m=1,at=1@-30deg\n"
                "  brachisto body disc:m=3,hole=0.8 rod:from=1@0,to=1@180deg\n"
                "  brachisto body --radius 0.077 disc:m=0.4 "
                "point:m=0.1,x=0.05,z=-0.02",
      .run = [flags] { return run(*flags); }};
}

}  // namespace brachisto::app
