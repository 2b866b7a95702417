// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/cutting_drawing.hpp"

namespace brachisto::report::cutting {

void Shapes::add(const Shapes& others, Point by) {
  const auto moved = [&](Point p) { return Point{p.x + by.x, p.z + by.z}; };
  for (Polyline polyline : others.polylines) {
    for (Point& p : polyline.points) p = moved(p);
    polylines.push_back(std::move(polyline));
  }
  for (Circle circle : others.circles) {
    circle.centre = moved(circle.centre);
    circles.push_back(circle);
  }
  for (Label label : others.labels) {
    label.at = moved(label.at);
    labels.push_back(std::move(label));
  }
}

}  // namespace brachisto::report::cutting
