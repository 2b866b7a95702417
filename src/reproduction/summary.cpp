// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "brachisto/report/provenance.hpp"
#include "brachisto/report/result_json.hpp"
#include "report/letters.hpp"
#include "reproduction/page.hpp"
#include "reproduction/tables.hpp"

namespace brachisto::reproduction {

namespace {

/// To a width in letters, which fmt would count in bytes.
std::string padded(const std::string& text, std::size_t width) {
  const std::size_t count = report::letters(text);
  return text + std::string(count < width ? width - count : 1, ' ');
}

}  // namespace

std::string summary(const Reproduction& made) {
  std::string out = padded("quantity", 47) + padded("paper", 8) +
                    padded("here", 27) + "here − paper\n";
  for (const Comparison& row : made.comparisons) {
    const std::string unit = row.unit.empty() ? "" : " [" + row.unit + "]";
    out += padded(row.quantity + unit, 47) + padded(row.paper, 8) +
           padded(with_error(row.ours), 27) + difference_text(row) + "\n";
  }
  out += "\n";
  for (const Claim& claim : made.claims) {
    out += fmt::format("{}: {}\n    {}\n", name(claim.verdict), claim.statement,
                       claim.evidence);
  }
  return out;
}

std::string to_json(const Findings& found, const Reproduction& made) {
  using Json = nlohmann::ordered_json;
  Json comparisons = Json::array();
  for (const Comparison& row : made.comparisons) {
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
