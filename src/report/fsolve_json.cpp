// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/fsolve_json.hpp"

namespace brachisto::report {

using Json = nlohmann::ordered_json;

const char* name(DiscreteReading::Quadrature quadrature) {
  switch (quadrature) {
    case DiscreteReading::Quadrature::MeanSpeed:
      return "vmean";
    case DiscreteReading::Quadrature::Midpoint:
      return "midpoint";
    case DiscreteReading::Quadrature::Trapezoid:
      return "trapezoid";
  }
  return "";
}

const char* name(DiscreteReading::Datum datum) {
  switch (datum) {
    case DiscreteReading::Datum::Release:
      return "release";
    case DiscreteReading::Datum::Rest:
      return "rest";
    case DiscreteReading::Datum::Printed:
      return "printed";
  }
  return "";
}

const char* name(DiscreteReading::Slopes slopes) {
  return slopes == DiscreteReading::Slopes::Literal ? "literal" : "smooth";
}

const char* name(FsolveVariant variant) {
  switch (variant) {
    case FsolveVariant::Hybrid:
      return "hybrid";
    case FsolveVariant::Newton:
      return "newton";
    case FsolveVariant::Lifted:
      return "lifted";
  }
  return "";
}

Json fsolve_options_json(const FsolveOptions& options) {
  const DiscreteReading& reading = options.reading;
  return {{"quadrature", name(reading.quadrature)},
          {"datum", name(reading.datum)},
          {"slopes", name(reading.slopes)},
          {"epsilon", reading.epsilon},
          {"variant", name(options.variant)}};
}

Json fsolve_json(const Solution& solution) {
  if (!solution.discrete()) return nullptr;
  const FsolveAnswer& answer = *solution.discrete();
  Json json = {{"solved", answer.solved()},
               {"nodes", answer.nodes},
               {"unknowns", answer.unknowns},
               {"residual", answer.residual},
               {"iterations", answer.iterations},
               {"evaluations", answer.evaluations},
               {"jacobians", answer.jacobians},
               {"refused_points", answer.refused_points},
               {"cpu_seconds", answer.cpu_seconds},
               {"memory_bytes", answer.memory_bytes}};
  const auto put = [&](const char* key, double value) {
    json[key] = answer.solved() ? Json(value) : Json(nullptr);
  };
  put("tau", answer.tau);
  put("transit_time", answer.transit_time);
  put("centre_path_length", answer.centre_path_length);
  put("start_angle", answer.start_angle);
  put("end_angle", answer.end_angle);
  const bool compared = solution.extremal && solution.extremal->solved;
  json["error"] = answer.solved() && compared
                      ? Json(answer.tau / solution.extremal->tau - 1.0)
                      : Json(nullptr);
  return json;
}

}  // namespace brachisto::report
