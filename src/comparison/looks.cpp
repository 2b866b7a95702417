// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "comparison/looks.hpp"

#include <algorithm>
#include <array>

#include "comparison/finding.hpp"
#include "comparison/methods.hpp"
#include "math/enum_table.hpp"

namespace brachisto::comparison {

using report::Mark;
using report::Stroke;
using Kind = ComparedMethod::Kind;

Look look_of(const ComparedMethod& method, std::size_t degrees,
             std::size_t index) {
  constexpr std::array kMarks{Mark::Disc, Mark::Circle, Mark::Square,
                              Mark::Diamond, Mark::Triangle};
  const auto arms =
      table_by<DiscreteArm>(Look{"#a50026", Stroke::DashDotted, Mark::Triangle},
                            Look{"#d95f02", Stroke::DashDotted, Mark::Circle},
                            Look{"#8c510a", Stroke::Dotted, Mark::Diamond},
                            Look{"#666666", Stroke::Dashed, Mark::Disc});
  switch (method.kind) {
    case Kind::RollingTime:
      return {report::family_colours(degrees)[index], Stroke::Solid,
              kMarks[index % kMarks.size()]};
    case Kind::Adaptive:
      return {"#000000", Stroke::Dotted, Mark::Diamond};
    case Kind::ArcLength:
      return {"#000000", Stroke::Dashed, Mark::Square};
    case Kind::Extremal:
      return {"#000000", Stroke::Solid, Mark::Triangle};
    case Kind::DiscreteSystem:
      return arms[method.arm];
  }
  return {};
}

std::string words(const ComparedMethod& method) {
  std::string text = label(method);
  std::ranges::replace(text, '_', ' ');
  return text;
}

report::Curve line_of_spoken_error(double low, double high) {
  report::Curve line;
  line.name = "error of " + error_words(kSpokenError);
  line.points = {{kSpokenError, low}, {kSpokenError, high}};
  line.stroke = Stroke::Dashed;
  line.colour = "#1f5fa8";
  line.width = 1.2;
  line.id = "spoken_error";
  return line;
}

}  // namespace brachisto::comparison
