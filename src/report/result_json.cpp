// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/report/result_json.hpp"

#include <nlohmann/json.hpp>

#include "brachisto/report/provenance.hpp"
#include "report/fsolve_json.hpp"

namespace brachisto::report {

namespace {

using Json = nlohmann::ordered_json;

template <class Value>
Json or_null(const std::optional<Value>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json body_json(const Body& body) {
  Json json;
  json["shape"] = body.rolls() ? "cylinder" : "bead";
  if (body.rolls()) {
    json["radius"] = body.radius;
    json["eta_m"] = body.eta_m;
    json["theta_m"] = body.theta_m;
    json["k"] = body.k;
  }
  json["mass"] = or_null(body.mass);
  return json;
}

const char* shape_name(GivenPath::Shape shape) {
  switch (shape) {
    case GivenPath::Shape::Straight:
      return "straight";
    case GivenPath::Shape::Parabola:
      return "parabola";
    case GivenPath::Shape::CircularArc:
      return "circular_arc";
    case GivenPath::Shape::Cycloid:
      return "cycloid";
    case GivenPath::Shape::Points:
      return "points";
  }
  return "";
}

Json path_json(const GivenPath& path) {
  Json json = {
      {"curve", path.curve == GivenPath::Curve::Track ? "track" : "centre"},
      {"shape", shape_name(path.shape)},
      {"start_angle", path.has_start_angle()
                          ? Json(path.start_angle_or_vertical())
                          : Json(nullptr)}};
  if (path.shape == GivenPath::Shape::Points) {
    Json points = Json::array();
    for (const Point& point : path.points) {
      points.push_back({point.x, point.z});
    }
    json["points"] = std::move(points);
  }
  return json;
}

Json scene_json(const Scene& scene) {
  return {{"body", body_json(scene.body)},
          {"finish", {{"L", scene.L}, {"H", scene.H}}},
          {"gravity", scene.gravity},
          {"contact", scene.contact == Contact::Smooth ? "smooth" : "centre"},
          {"path", scene.path ? path_json(*scene.path) : Json(nullptr)}};
}

Json guess_json(const SolveOptions& options) {
  switch (options.guess) {
    case Guess::Cycloid:
      return "cycloid";
    case Guess::Straight:
      return "straight";
    case Guess::Random:
      return {{"random", {{"seed", options.seed}}}};
  }
  return nullptr;
}

const char* method_name(Method method) {
  switch (method) {
    case Method::Ipopt:
      return "ipopt";
    case Method::NewtonKkt:
      return "newton_kkt";
    case Method::Extremal:
      return "extremal";
    case Method::Fsolve:
      return "fsolve";
  }
  return "";
}

Json options_json(const SolveOptions& options) {
  const Discretisation& mesh = options.discretisation;
  return {{"discretisation",
           {{"formulation", mesh.formulation == Formulation::ArcLength
                                ? "arc_length"
                                : "rolling_time"},
            {"tolerance", or_null(mesh.tolerance)},
            {"degree", or_null(mesh.degree)},
            {"elements", or_null(mesh.elements)},
            {"nodes", or_null(mesh.nodes)}}},
          {"solver",
           {{"method", method_name(options.method)},
            {"linear_solver", name(options.linear_solver)},
            {"tolerance", options.tolerance},
            {"search",
             options.search == Search::Principal ? "principal" : "global"},
            {"polish", options.polish},
            {"certify", options.certify == Certify::None ? "none" : "extremal"},
            {"guess", guess_json(options)},
            {"limits",
             {{"iterations", options.limits.iterations},
              {"seconds", options.limits.seconds}}},
            {"fsolve", fsolve_options_json(options.fsolve)}}}};
}

Json provenance_json(const Solution& solution) {
  Json json = Json::parse(report::provenance_json());
  json["options"] = options_json(solution.options);
  const std::optional<LinearSolver> used =
      solution.effort.final_mesh().linear_solver;
  json["linear_solver"] = used ? Json(name(*used)) : Json(nullptr);
  return json;
}

Json phases_json(const PhaseSeconds& phases) {
  Json json;
  for (std::size_t i = 0; i < kNumPhases; ++i) {
    json[name(static_cast<Phase>(i))] = phases.seconds[i];
  }
  return json;
}

Json check_json(const Check& check) {
  Json json = {{"name", check.name},
               {"value", check.value},
               {"threshold", check.threshold},
               {"passed", check.passed}};
  if (!check.where.empty()) json["where"] = check.where;
  return json;
}

Json certificate_json(const Solution& solution) {
  const Certificate& certificate = solution.certificate;
  // Fixed keys first; null where this version has no such check.
  Json json = {{"kkt_residual", nullptr},
               {"reintegration_error", nullptr},
               {"energy_drift", nullptr},
               {"contact_error", nullptr},
               {"second_order", nullptr}};
  // Both times of a second opinion, for nobody to have to compute their
  // difference anew.
  const std::optional<CrossCheck>& opinion = solution.extremal;
  const bool both = opinion && opinion->solved && solution.motion() != nullptr;
  json["tau"] = both ? Json(solution.motion()->tau()) : Json(nullptr);
  json["extremal_tau"] = both ? Json(opinion->tau) : Json(nullptr);
  json["extremal_difference"] =
      both ? Json(opinion->difference) : Json(nullptr);
  Json checks = Json::array();
  for (const Check& check : certificate.checks) {
    json[check.name] = check.value;
    checks.push_back(check_json(check));
  }
  json["checks"] = std::move(checks);
  return json;
}

Json continuation_json(const std::vector<ContinuationStep>& steps) {
  Json json = Json::array();
  for (const ContinuationStep& step : steps) {
    json.push_back({{"eta_m", step.eta_m},
                    {"phi", step.phi},
                    {"newton_steps", step.newton_steps}});
  }
  return json;
}

Json meshes_json(const std::vector<MeshRecord>& meshes) {
  Json json = Json::array();
  for (const MeshRecord& mesh : meshes) {
    json.push_back({{"degree", mesh.degree},
                    {"elements", mesh.elements},
                    {"estimated_error", or_null(mesh.estimated_error)},
                    {"passes", mesh.passes},
                    {"iterations", mesh.iterations},
                    {"newton_steps", mesh.newton_steps}});
  }
  return json;
}

Json branches_json(const std::vector<Branch>& branches) {
  Json json = Json::array();
  for (const Branch& branch : branches) {
    json.push_back({{"tau", branch.verified ? Json(branch.tau) : Json()},
                    {"estimated_error", branch.estimated_error},
                    {"end_angle", branch.end_angle},
                    {"centre_path_length", branch.centre_path_length},
                    {"principal", branch.principal},
                    {"verified", branch.verified},
                    {"minimum", branch.minimum},
                    {"feasible", branch.feasible},
                    {"remarks", branch.remarks}});
  }
  return json;
}

Json cold_start_json(const std::optional<ColdStart>& cold) {
  if (!cold) return nullptr;
  return {{"status", name(cold->status)},
          {"tau_coarse", or_null(cold->tau)},
          {"principal", cold->principal}};
}

Json extremal_json(const std::optional<CrossCheck>& opinion) {
  if (!opinion) return nullptr;
  if (!opinion->solved) {
    return {{"solved", false}, {"message", opinion->message}};
  }
  return {{"solved", true},
          {"tau", opinion->tau},
          {"error_estimate", opinion->error_estimate},
          {"difference", opinion->difference}};
}

/// A range over u > 0. What is not finite is null in JSON: no bound.
Json range_json(const Extreme& min, const Extreme& max,
                const Extreme& after_rise) {
  return {{"min", min.value},
          {"max", max.value},
          {"min_at_start", min.at_start},
          {"max_at_start", max.at_start},
          {"min_after_rise", after_rise.value}};
}

/// Figures of the path; all null if `motion` is.
void add_path(Json& json, const Motion* motion, const PathDiagnostics* path,
              bool rolls) {
  const auto put = [&](const char* key, auto&& value) {
    json[key] = motion ? Json(value()) : Json(nullptr);
  };
  put("tau", [&] { return motion->tau(); });
  put("transit_time", [&] { return motion->transit_time(); });
  put("centre_path_length", [&] { return motion->centre_path_length(); });
  put("rail_length", [&] { return motion->rail_length(); });
  put("start_angle", [&] { return motion->start_angle(); });
  put("end_angle", [&] { return motion->end_angle(); });
  put("rotation", [&] { return or_null(motion->rotation()); });
  const auto diagnose = [&](const char* key, bool exists, auto&& value) {
    json[key] = path && exists ? Json(value()) : Json(nullptr);
  };
  diagnose("normal_force", true, [&] {
    Json force = range_json(path->min_normal_force, path->max_normal_force,
                            path->normal_force_after_rise);
    force["x_at_max"] = path->max_normal_force.x;
    return force;
  });
  diagnose("friction", rolls, [&] {
    return Json{{"share_above_0.3", path->friction_above_0_3},
                {"share_above_0.5", path->friction_above_0_5},
                {"share_above_1", path->friction_above_1}};
  });
  diagnose("curvature", true, [&] {
    return range_json(path->min_curvature, path->max_curvature,
                      path->curvature_after_rise);
  });
  diagnose("at_start", true, [&] {
    return Json{{"normal_force", path->at_start.normal_force},
                {"curvature", path->at_start.curvature}};
  });
  diagnose("fold_margin", rolls,
           [&] { return Json(path->min_fold_margin.value); });
}

}  // namespace

std::string result_json(const Solution& solution) {
  const bool verified = solution.verified();
  Json json;
  json["schema_version"] = kSchemaVersion;
  json["status"] = name(solution.status);
  json["message"] = solution.message;
  json["warnings"] = solution.warnings;
  json["verified"] = verified;
  const bool judged = solution.motion() != nullptr || solution.discrete();
  json["not_verified_because"] =
      judged ? Json(solution.not_verified_because()) : Json(nullptr);
  json["feasible"] = verified ? Json(solution.feasible()) : Json(nullptr);
  json["infeasible_because"] =
      verified ? Json(solution.infeasible_because()) : Json(nullptr);
  add_path(json, verified ? solution.motion() : nullptr,
           verified ? &*solution.diagnostics : nullptr,
           solution.scene.body.rolls());
  json["estimated_error"] = or_null(solution.estimated_error);

  const ProgramSize* program = solution.program();
  const auto size = [&](int ProgramSize::*count) {
    return program != nullptr ? Json(program->*count) : Json();
  };
  json["nodes"] = size(&ProgramSize::nodes);
  json["variables"] = size(&ProgramSize::variables);
  json["constraints"] = size(&ProgramSize::constraints);
  if (const Trajectory* found = solution.trajectory()) {
    const Mesh& mesh = found->curve().mesh();
    json["mesh"] = {{"degree", mesh.degree}, {"elements", mesh.num_elements()}};
  } else if (program != nullptr) {
    json["mesh"] = {{"degree", nullptr}, {"elements", program->nodes - 1}};
  } else {
    json["mesh"] = nullptr;
  }
  const Effort& effort = solution.effort;
  json["iterations"] = effort.iterations;
  json["first_iterations"] = effort.final_mesh().first_iterations;
  json["closure_passes"] = effort.final_mesh().passes;
  json["passes"] = effort.passes;
  json["newton_steps"] = effort.newton_steps;
  json["continuation"] = continuation_json(effort.continuation);
  json["refinement"] = meshes_json(effort.meshes);
  json["folds"] = solution.folds;
  json["cold_start"] = cold_start_json(solution.cold_start);
  json["branches"] = branches_json(solution.branches);
  json["search_remark"] = solution.search_remark.empty()
                              ? Json(nullptr)
                              : Json(solution.search_remark);
  json["extremal"] = extremal_json(solution.extremal);
  json["discrete_system"] = fsolve_json(solution);
  json["seconds"] = {{"total", effort.seconds},
                     {"solve", effort.seconds - effort.certificate_seconds},
                     {"certificate", effort.certificate_seconds},
                     {"cpu", effort.cpu_seconds},
                     {"phases", phases_json(effort.phases)}};
  json["certificate"] = certificate_json(solution);
  json["provenance"] = provenance_json(solution);
  json["scene"] = scene_json(solution.scene);
  return json.dump(2) + "\n";
}

std::string input_json(const Scene& scene, const SolveOptions& options) {
  Json json = {{"schema_version", kSchemaVersion},
               {"valid", true},
               {"scene", scene_json(scene)}};
  json.update(options_json(options));
  return json.dump(2) + "\n";
}

}  // namespace brachisto::report
