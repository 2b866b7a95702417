// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/posed/statement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "brachisto/math/index.hpp"
#include "posed/mesh_path.hpp"

namespace brachisto::ocp {

namespace {

MeshPath path_of(const Answer& answer) {
  const Statement& said = answer.made_of.statement;
  const int states =
      static_cast<int>(said.states.size() + said.parameters.size());
  const Layout layout(answer.made_of.mesh.num_points(), {}, states,
                      static_cast<int>(said.controls.size()),
                      states + static_cast<int>(said.limits.size()));
  return {answer.made_of.mesh, layout, answer.made_of.point};
}

Place place_of(const Answer& answer, const MeshPath& path, double sigma,
               PathValues here) {
  keep_in_bounds(answer.made_of.statement, answer.made_of.scales, here);
  Place out{.time = sigma * path.duration()};
  const std::size_t states = answer.made_of.statement.states.size();
  for (std::size_t s = 0; s < states; ++s) {
    out.states.push_back(here.states[s] * answer.made_of.scales[s]);
    out.costates.push_back(here.costates[s] / answer.made_of.scales[s]);
  }
  for (std::size_t k = 0; k < here.controls.size(); ++k) {
    out.controls.push_back(here.controls[k] *
                           answer.made_of.scales[here.states.size() + k]);
  }
  return out;
}

std::string with_unit(const std::string& name, const std::string& unit) {
  return unit.empty() ? name : name + " [" + unit + "]";
}

}  // namespace

bool Answer::verified() const {
  return status == Status::Solved &&
         std::ranges::all_of(certificate, &Check::passed);
}

std::string Answer::why_not() const {
  if (status != Status::Solved) return message;
  for (const Check& check : certificate) {
    if (check.passed()) continue;
    return fmt::format("{}: {:.2g}, allowed {:.2g}{}{}", check.name,
                       check.value, check.allowed,
                       check.where.empty() ? "" : ", ", check.where);
  }
  return {};
}

Place Answer::at(double time) const {
  const MeshPath path = path_of(*this);
  const double sigma = std::clamp(time / path.duration(), 0.0, 1.0);
  return place_of(*this, path, sigma, path.values(sigma));
}

std::vector<Place> Answer::nodes() const {
  const MeshPath path = path_of(*this);
  std::vector<Place> out{place_of(*this, path, 0.0, path.values(0, 0.0))};
  for (int e = 0; e < made_of.mesh.num_elements(); ++e) {
    for (const double t : radau_scheme(made_of.mesh.degree).rule.points) {
      out.push_back(
          place_of(*this, path, made_of.mesh.sigma(e, t), path.values(e, t)));
    }
  }
  return out;
}

std::string Answer::csv() const {
  std::string out = with_unit("t", made_of.statement.time_unit);
  for (const Variable& state : made_of.statement.states) {
    out += "," + with_unit(state.name, state.unit);
  }
  for (const Variable& control : made_of.statement.controls) {
    out += "," + with_unit(control.name, control.unit);
  }
  for (const Variable& state : made_of.statement.states)
    out += ",p_" + state.name;
  out += '\n';
  for (const Place& place : nodes()) {
    out += fmt::format("{:.17g}", place.time);
    for (const auto* values :
         {&place.states, &place.controls, &place.costates}) {
      for (const double value : *values) out += fmt::format(",{:.17g}", value);
    }
    out += '\n';
  }
  return out;
}

std::string Answer::svg() const {
  constexpr double kWidth = 640.0, kHeight = 120.0, kLeft = 70.0, kGap = 24.0;
  std::vector<Place> places;
  constexpr int kSteps = 400;
  for (int i = 0; i <= kSteps; ++i) places.push_back(at(duration * i / kSteps));
  const std::size_t states = made_of.statement.states.size();
  const std::size_t count = states + made_of.statement.controls.size();
  std::string out = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {} {}\" "
      "font-family=\"sans-serif\" font-size=\"12\">\n<title>{}</title>\n",
      kLeft + kWidth + kGap,
      kGap + static_cast<double>(count) * (kHeight + kGap) + kGap,
      made_of.statement.name);
  for (std::size_t i = 0; i < count; ++i) {
    const Variable& variable = i < states
                                   ? made_of.statement.states[i]
                                   : made_of.statement.controls[i - states];
    const auto value = [&](const Place& place) {
      return i < states ? place.states[i] : place.controls[i - states];
    };
    double low = kNoBound, high = -kNoBound;
    for (const Place& place : places) {
      low = std::min(low, value(place));
      high = std::max(high, value(place));
    }
    const double range = high > low ? high - low : 1.0;
    const double top = kGap + static_cast<double>(i) * (kHeight + kGap);
    out += fmt::format(
        "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"none\" "
        "stroke=\"#bbb\"/>\n<text x=\"{}\" y=\"{}\">{}</text>\n"
        "<text x=\"{}\" y=\"{}\" text-anchor=\"end\">{:.4g}</text>\n"
        "<text x=\"{}\" y=\"{}\" text-anchor=\"end\">{:.4g}</text>\n"
        "<polyline fill=\"none\" stroke=\"#06c\" stroke-width=\"1.5\" "
        "points=\"",
        kLeft, top, kWidth, kHeight, kLeft + 4.0, top - 4.0,
        with_unit(variable.name, variable.unit), kLeft - 4.0, top + 10.0, high,
        kLeft - 4.0, top + kHeight, low);
    for (const Place& place : places) {
      out +=
          fmt::format("{:.2f},{:.2f} ", kLeft + kWidth * place.time / duration,
                      top + kHeight * (1.0 - (value(place) - low) / range));
    }
    out += "\"/>\n";
  }
  return out + fmt::format(
                   "<text x=\"{}\" y=\"{}\" text-anchor=\"end\">t = "
                   "{:.6g}</text>\n</svg>\n",
                   kLeft + kWidth,
                   kGap + static_cast<double>(count) * (kHeight + kGap),
                   duration);
}

}  // namespace brachisto::ocp
