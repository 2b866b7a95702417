// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/cutting_drawing.hpp"

#include <cmath>

namespace brachisto::report::cutting {

Point turned(Point p, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * p.x - s * p.z, s * p.x + c * p.z};
}

Shapes Shapes::turned(double angle) const {
  Shapes out = *this;
  for (Polyline& polyline : out.polylines) {
    for (Point& p : polyline.points) p = cutting::turned(p, angle);
  }
  for (Circle& circle : out.circles) {
    circle.centre = cutting::turned(circle.centre, angle);
  }
  for (Label& label : out.labels) {
    label.at = cutting::turned(label.at, angle);
    label.angle += angle;
  }
  return out;
}

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
