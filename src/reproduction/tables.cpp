// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "brachisto/report/result.hpp"
#include "report/csv.hpp"
#include "report/provenance.hpp"
#include "report/text_table.hpp"
#include "reproduction/page.hpp"

namespace brachisto::reproduction {

using report::csv_field;

std::string difference_text(const PrintedNumber& row) {
  return with_minus_signs(
      fmt::format("{:+.3g} ({:+.2f} %){}", row.difference(),
                  100.0 * row.difference() / std::abs(number_in(row.paper)),
                  row.agrees() ? ", within the digits printed" : ""));
}

std::string comparison_csv(const std::vector<PrintedNumber>& rows) {
  std::string out =
      "place,quantity,unit,paper,ours,error,difference,agrees,"
      "remark\n";
  for (const PrintedNumber& row : rows) {
    out += fmt::format("{},{},{},{},{:.15g},{:.1e},{:.6g},{},{}\n",
                       csv_field(row.place), csv_field(row.quantity),
                       csv_field(row.unit), csv_field(row.paper),
                       row.ours.value, row.ours.error, row.difference(),
                       row.agrees(), csv_field(row.remark));
  }
  return out;
}

std::string claims_csv(const std::vector<Claim>& claims) {
  std::string out = "place,statement,verdict,evidence\n";
  for (const Claim& claim : claims) {
    out += fmt::format("{},{},{},{}\n", csv_field(claim.place),
                       csv_field(claim.statement), name(claim.verdict),
                       csv_field(claim.evidence));
  }
  return out;
}

std::string cases_csv(const Cases& cases) {
  std::string out =
      "case,tau,error,centre_path_length,rail_length,start_angle,end_angle,"
      "R_n_min_after_rise,R_n_max,x_of_R_n_max,kappa_b_min_after_rise,kappa_b_"
      "max,fold_margin,"
      "share_above_0.3,share_above_0.5,share_above_1,feasible\n";
  for (const auto& [name, one] : cases.all()) {
    const Motion& motion = one.motion();
    const PathDiagnostics& d = *one.fine.diagnostics;
    const Measured tau = one.tau();
    out += fmt::format(
        "{},{:.15g},{:.1e},{:.12g},{:.12g},{:.12g},{:.12g},{:.9g},{:.9g},"
        "{:.9g},{:.9g},{:.9g},{:.9g},{:.6g},{:.6g},{:.6g},{}\n",
        csv_field(name), tau.value, tau.error, motion.centre_path_length(),
        motion.rail_length(), motion.start_angle(), motion.end_angle(),
        d.normal_force_after_rise.value, d.max_normal_force.value,
        d.max_normal_force.x, d.curvature_after_rise.value,
        d.max_curvature.value, d.min_fold_margin.value, d.friction_above_0_3,
        d.friction_above_0_5, d.friction_above_1, one.fine.feasible());
  }
  return out;
}

std::string orientations_csv(const std::vector<OrientationRow>& rows) {
  std::string out = "eta_m,theta_m,error,tau\n";
  for (const OrientationRow& row : rows) {
    out += fmt::format("{:.15g},{:.12g},{:.1e},{:.15g}\n", row.eta_m,
                       row.fastest.theta_m.value, row.fastest.theta_m.error,
                       row.fastest.tau);
  }
  return out;
}

std::string boundary_csv(const Results& found) {
  std::string out = "orientation,eta_m,k,theta_m,theta_m_error\n";
  const auto add = [&](const char* orientation,
                       const std::vector<BoundaryBody>& bodies) {
    for (const BoundaryBody& body : bodies) {
      out +=
          fmt::format("{},{:.10g},{:.10g},", orientation, body.eta_m, body.k);
      out += body.has_orientation()
                 ? fmt::format("{:.10g},{:.1e}\n", body.theta_m.value,
                               body.theta_m.error)
                 : ",\n";
    }
  };
  add("theta_m = -pi/6", found.boundary);
  add("fastest", found.best_boundary);
  return out;
}

std::string numbers_text(const Reproduction& made, report::TableForm form) {
  report::Rows rows{{"quantity", "paper", "here", "here − paper"}};
  for (const PrintedNumber& row : made.comparisons) {
    const std::string unit = row.unit.empty() ? "" : " [" + row.unit + "]";
    rows.push_back({row.quantity + unit, row.paper, with_error(row.ours),
                    difference_text(row)});
  }
  std::string out = report::table(rows, form) + "\n";
  if (form == report::TableForm::Markdown) {
    report::Rows claims{{"claim", "statement", "evidence"}};
    for (const Claim& claim : made.claims) {
      claims.push_back({name(claim.verdict), claim.statement, claim.evidence});
    }
    return out + report::markdown_table(claims);
  }
  for (const Claim& claim : made.claims) {
    out += fmt::format("{}: {}\n    {}\n", name(claim.verdict), claim.statement,
                       claim.evidence);
  }
  return out;
}

std::string to_json(const Results& found, const Reproduction& made) {
  using Json = nlohmann::ordered_json;
  Json comparisons = Json::array();
  for (const PrintedNumber& row : made.comparisons) {
    comparisons.push_back({{"place", row.place},
                           {"quantity", row.quantity},
                           {"unit", row.unit},
                           {"paper", row.paper},
                           {"ours", row.ours.value},
                           {"error", row.ours.error},
                           {"difference", row.difference()},
                           {"agrees", row.agrees()},
                           {"remark", row.remark}});
  }
  Json claims = Json::array();
  for (const Claim& claim : made.claims) {
    claims.push_back({{"place", claim.place},
                      {"statement", claim.statement},
                      {"verdict", name(claim.verdict)},
                      {"evidence", claim.evidence}});
  }
  Json orientations = Json::array();
  for (const OrientationRow& row : found.orientations) {
    orientations.push_back({{"eta_m", row.eta_m},
                            {"theta_m", row.fastest.theta_m.value},
                            {"error", row.fastest.theta_m.error},
                            {"tau", row.fastest.tau}});
  }
  const auto bodies = [](const std::vector<BoundaryBody>& boundary) {
    Json list = Json::array();
    for (const BoundaryBody& body : boundary) {
      const bool known = body.has_orientation();
      list.push_back(
          {{"eta_m", body.eta_m},
           {"k", body.k},
           {"theta_m", known ? Json(body.theta_m.value) : Json()},
           {"theta_m_error", known ? Json(body.theta_m.error) : Json()}});
    }
    return list;
  };
  const Json document = {
      {"schema_version", report::kSchemaVersion},
      {"verified", true},
      {"comparisons", comparisons},
      {"claims", claims},
      {"fastest_orientations", orientations},
      {"as_fast_as_the_bead",
       {{"theta_m_minus_pi_6", bodies(found.boundary)},
        {"fastest_theta_m", bodies(found.best_boundary)}}},
      {"provenance", Json::parse(report::provenance_json())}};
  return document.dump(2) + "\n";
}

}  // namespace brachisto::reproduction
