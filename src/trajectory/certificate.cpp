// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/trajectory/certificate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "brachisto/model/contact.hpp"
#include "brachisto/model/start_angle.hpp"
#include "brachisto/nlp/kkt_residual.hpp"

namespace brachisto {

bool Certificate::verified() const {
  return !checks.empty() &&
         std::all_of(checks.begin(), checks.end(),
                     [](const Check& check) { return check.passed; });
}

const Check* Certificate::find(const std::string& name) const {
  const auto found =
      std::find_if(checks.begin(), checks.end(),
                   [&](const Check& check) { return check.name == name; });
  return found == checks.end() ? nullptr : &*found;
}

void Certificate::add(std::string name, double value, double threshold,
                      std::string where) {
  checks.push_back({std::move(name), value, threshold, std::move(where),
                    value <= threshold});
}

namespace {

double distance(Point a, Point b) {
  return std::hypot(a.x - b.x, a.z - b.z);
}

/// How far the ends of the track are from A and B, or with Contact::Centre how
/// far the ends of the centre's path are.
double contact_error(const ExtremalCurve& curve) {
  const Scene& scene = curve.scene();
  const ExtremalPoint start = curve.at(0.0);
  const ExtremalPoint end = curve.at(1.0);
  const Point A{0.0, 0.0};
  const Point B{scene.L, scene.H};
  if (scene.contact == Contact::Centre) {
    return std::max(distance(start.centre, A), distance(end.centre, B));
  }
  const double r = scene.body.radius;
  // At the start the slope is β₀ in closed form, not the curve's own.
  return std::max(
      distance(track_below(start.centre, r, start_angle(scene.body)), A),
      distance(track_below(end.centre, r, end.beta), B));
}

void check_slope(const ExtremalCurve& curve, Certificate& certificate) {
  const std::vector<double>& slopes = curve.continuous_slope();
  std::size_t worst = 0;
  for (std::size_t c = 0; c < slopes.size(); ++c) {
    // Written so that a NaN is the worst of all.
    if (!(std::abs(slopes[c]) <= std::abs(slopes[worst]))) worst = c;
  }
  certificate.add(
      "slope_angle", std::abs(slopes[worst]), std::numbers::pi,
      fmt::format("collocation point {} of {}", worst, slopes.size()));
}

void check_speed(const ExtremalCurve& curve, Certificate& certificate) {
  std::vector<double> w = curve.w_at_points();
  w.push_back(curve.at(1.0).w);
  std::size_t at_rest = 0;
  std::string where;
  for (std::size_t c = 0; c < w.size(); ++c) {
    if (w[c] > 0.0) continue;  // written so that a NaN counts
    if (at_rest++ == 0) {
      where = fmt::format("w = {:.3g} at collocation point {} of {}", w[c], c,
                          w.size() - 1);
    }
  }
  certificate.add("speed",
                  static_cast<double>(at_rest) / static_cast<double>(w.size()),
                  0.0, where);
}

}  // namespace

Certificate certify(RollingTime& problem, const PrimalDual& point, double phi,
                    const CertificateThresholds& thresholds) {
  Certificate certificate;
  problem.set_end_angle(phi);
  const nlp::KktResidual kkt =
      nlp::kkt_residual(problem, point.x, point.lambda);
  certificate.add("kkt_residual", kkt.stationarity, thresholds.kkt_residual,
                  kkt.worst_variable);
  certificate.add("defects", kkt.infeasibility, thresholds.defects,
                  kkt.worst_constraint);

  const ExtremalCurve curve(problem, point);
  certificate.add("contact_error", contact_error(curve),
                  thresholds.contact_error);
  if (problem.scene().contact == Contact::Smooth) {
    certificate.add("closure", std::abs(curve.at(1.0).beta - phi),
                    thresholds.closure);
  }
  check_slope(curve, certificate);
  check_speed(curve, certificate);
  return certificate;
}

}  // namespace brachisto
