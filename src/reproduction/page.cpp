// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "reproduction/page.hpp"

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

#include "design/design_search.hpp"
#include "plot/web_parts.hpp"
#include "report/csv.hpp"
#include "report/page.hpp"
#include "report/provenance.hpp"
#include "report/rich_text.hpp"

namespace brachisto::reproduction {

namespace {

using Json = nlohmann::ordered_json;
using report::html_words;

constexpr const char* kTitle = "Brachistochrones of off-centred cylinders";

/// The heads being words with markup.
std::string words_table(std::vector<std::string> heads,
                        const report::HtmlRows& rows) {
  for (std::string& head : heads) head = html_words(head);
  return report::html_table(heads, rows);
}

/// Ours − paper with its sign and in percent, or that it agrees.
std::string difference_text(const PrintedNumber& row) {
  return with_minus_signs(
      fmt::format("{:+.3g} ({:+.2f} %){}", row.difference(),
                  100.0 * row.difference() / std::abs(number_in(row.paper)),
                  row.agrees() ? ", within the digits printed" : ""));
}

/// A column of a table and a key of its rows in a document; words without
/// markup.
template <class Row>
struct Column {
  const char* name;
  std::function<Json(const Row&)> of;  ///< null: there is none
  const char* digits = "{}";           ///< in the table
};
template <class Row>
using Columns = std::vector<Column<Row>>;

/// Cells of a row, or the names of the columns.
template <class Row>
std::string csv_row(const Columns<Row>& columns, const Row* row) {
  return report::csv_row(columns, [&](const Column<Row>& column) {
    const Json cell = row == nullptr ? Json(column.name) : column.of(*row);
    if (cell.is_string()) return report::csv_field(cell.get<std::string>());
    if (cell.is_number()) {
      return fmt::format(fmt::runtime(column.digits), cell.get<double>());
    }
    return cell.is_null() ? "" : cell.dump();
  });
}

template <class Row>
std::string csv(const Columns<Row>& columns, const std::vector<Row>& rows) {
  std::string out = csv_row<Row>(columns, nullptr);
  for (const Row& row : rows) out += csv_row(columns, &row);
  return out;
}

template <class Row>
Json json(const Columns<Row>& columns, const std::vector<Row>& rows) {
  Json list = Json::array();
  for (const Row& row : rows) {
    Json& one = list.emplace_back();
    for (const auto& [name, of, digits] : columns) one[name] = of(row);
  }
  return list;
}

const Columns<PrintedNumber>& comparison_columns() {
  using P = PrintedNumber;
  static const Columns<P> kAll{
      {"place", &P::place},
      {"quantity", &P::quantity},
      {"unit", &P::unit},
      {"paper", &P::paper},
      {"ours", [](const P& p) { return p.ours.value; }, "{:.15g}"},
      {"error", [](const P& p) { return p.ours.error; }, "{:.1e}"},
      {"difference", &P::difference, "{:.6g}"},
      {"agrees", &P::agrees},
      {"remark", &P::remark}};
  return kAll;
}

const Columns<Claim>& claim_columns() {
  static const Columns<Claim> kAll{
      {"place", &Claim::place},
      {"statement", &Claim::statement},
      {"verdict", [](const Claim& claim) { return name(claim.verdict); }},
      {"evidence", &Claim::evidence}};
  return kAll;
}

const Columns<OrientationRow>& orientation_columns() {
  using R = OrientationRow;
  static const Columns<R> kAll{
      {"eta_m", &R::eta_m, "{:.15g}"},
      {"theta_m", [](const R& r) { return r.fastest.theta_m.value; },
       "{:.12g}"},
      {"error", [](const R& r) { return r.fastest.theta_m.error; }, "{:.1e}"},
      {"tau", [](const R& r) { return r.fastest.tau; }, "{:.15g}"}};
  return kAll;
}

const Columns<BoundaryBody>& boundary_columns() {
  using B = BoundaryBody;
  const auto known = [](double Measured::*part) {
    return [=](const B& body) {
      return body.has_orientation() ? Json(body.theta_m.*part) : Json();
    };
  };
  static const Columns<B> kAll{
      {"eta_m", &B::eta_m, "{:.10g}"},
      {"k", &B::k, "{:.10g}"},
      {"theta_m", known(&Measured::value), "{:.10g}"},
      {"theta_m_error", known(&Measured::error), "{:.1e}"}};
  return kAll;
}

std::string boundary_csv(const Results& found) {
  const Columns<BoundaryBody>& columns = boundary_columns();
  std::string out = "orientation," + csv_row<BoundaryBody>(columns, nullptr);
  for (const auto& [orientation, bodies] :
       {std::pair{"theta_m = -pi/6", &found.boundary},
        {"fastest", &found.best_boundary}}) {
    for (const BoundaryBody& body : *bodies) {
      out += fmt::format("{},{}", orientation, csv_row(columns, &body));
    }
  }
  return out;
}

std::string cases_csv(const Cases& cases) {
  using D = PathDiagnostics;
  const auto path = [](double (Motion::*of)() const) {
    return [=](const Case& one) { return (one.motion().*of)(); };
  };
  const auto extreme = [](Extreme D::*of, double Extreme::*part) {
    return [=](const Case& one) { return (*one.fine.diagnostics).*of.*part; };
  };
  const auto share = [](double D::*of) {
    return [=](const Case& one) { return (*one.fine.diagnostics).*of; };
  };
  const Columns<Case> columns{
      {"case", &Case::name},
      {"tau", [](const Case& one) { return one.tau().value; }, "{:.15g}"},
      {"error", [](const Case& one) { return one.tau().error; }, "{:.1e}"},
      {"centre_path_length", path(&Motion::centre_path_length), "{:.12g}"},
      {"rail_length", path(&Motion::rail_length), "{:.12g}"},
      {"start_angle", path(&Motion::start_angle), "{:.12g}"},
      {"end_angle", path(&Motion::end_angle), "{:.12g}"},
      {"R_n_min_after_rise",
       extreme(&D::normal_force_after_rise, &Extreme::value), "{:.9g}"},
      {"R_n_max", extreme(&D::max_normal_force, &Extreme::value), "{:.9g}"},
      {"x_of_R_n_max", extreme(&D::max_normal_force, &Extreme::x), "{:.9g}"},
      {"kappa_b_min_after_rise",
       extreme(&D::curvature_after_rise, &Extreme::value), "{:.9g}"},
      {"kappa_b_max", extreme(&D::max_curvature, &Extreme::value), "{:.9g}"},
      {"fold_margin", extreme(&D::min_fold_margin, &Extreme::value), "{:.9g}"},
      {"share_above_0.3", share(&D::friction_above_0_3), "{:.6g}"},
      {"share_above_0.5", share(&D::friction_above_0_5), "{:.6g}"},
      {"share_above_1", share(&D::friction_above_1), "{:.6g}"},
      {"feasible", [](const Case& one) { return one.fine.feasible(); }}};
  std::string out = csv_row<Case>(columns, nullptr);
  for (const auto& [name, one] : cases.all()) out += csv_row(columns, &one);
  return out;
}

std::string comparison_table(const std::vector<PrintedNumber>& numbers) {
  report::HtmlRows rows;
  for (const PrintedNumber& row : numbers) {
    const std::string unit = row.unit.empty() ? "" : html_words(" " + row.unit);
    rows.push_back(
        {{fmt::format("{}<br/><small>{}</small>", html_words(row.quantity),
                      html_words(row.place)),
          "brief"},
         {html_words(row.paper) + unit},
         {with_error(row.ours) + unit},
         {difference_text(row), "brief"},
         {html_words(row.remark), "words"}});
  }
  return words_table({"quantity", "paper", "here", "here − paper", "remark"},
                     rows);
}

std::string claims_table(const std::vector<Claim>& claims) {
  report::HtmlRows rows;
  for (const Claim& claim : claims) {
    rows.push_back(
        {{fmt::format("{} <small>{}</small>", html_words(claim.statement),
                      html_words(claim.place)),
          "words"},
         {name(claim.verdict)},
         {html_words(claim.evidence), "words"}});
  }
  return words_table({"statement of the paper", "verdict", "evidence"}, rows);
}

std::string span(const Extreme& low, const Extreme& high) {
  return with_minus_signs(
      fmt::format("{:.3f} … {:.3f}", low.value, high.value));
}

std::string cases_table(const Cases& cases) {
  report::HtmlRows rows;
  for (const auto& [name, one] : cases.all()) {
    const PathDiagnostics& d = *one.fine.diagnostics;
    const bool rolls = one.scene().body.rolls();
    rows.push_back(
        {{fmt::format("<code>{}</code>", name)},
         {with_error(one.tau())},
         {fmt::format("{:.6f}", one.motion().rail_length())},
         {span(d.normal_force_after_rise, d.max_normal_force)},
         {span(d.curvature_after_rise, d.max_curvature) +
          (bends_less_than_body(one) ? "" : " (&gt; 1/r)")},
         {rolls ? fmt::format("{:.3f}", d.min_fold_margin.value) : "–"},
         {rolls ? fmt::format("{:.0f} %, {:.0f} %, {:.0f} %",
                              100.0 * d.friction_above_0_3,
                              100.0 * d.friction_above_0_5,
                              100.0 * d.friction_above_1)
                : "–"},
         {one.fine.feasible() ? "yes" : "no"}});
  }
  return words_table(
      {"case", "τ", "track", "R_n [m g]: least minimum … largest",
       "κ_b [1/H]: the same", "least 1 − r κ_c",
       "time with |R_t|/R_n > 0.3, 0.5, 1", "feasible"},
      rows);
}

std::string orientation_table(const std::vector<OrientationRow>& fastest) {
  report::HtmlRows rows;
  for (const OrientationRow& row : fastest) {
    rows.push_back({{fmt::format("{:.12f}", row.eta_m)},
                    {with_error(row.fastest.theta_m)},
                    {with_minus_signs(fmt::format(
                        "{:.5f}", row.fastest.theta_m.value * kDegrees))},
                    {fmt::format("{:.9f}", row.fastest.tau)}});
  }
  return words_table({"η_m", "θ_m of the smallest τ [rad]", "[°]", "τ there"},
                     rows);
}

std::string_view kind(const DesignMinimum& found) {
  return !found.stationary          ? "passed at a fold"
         : at_edge_of_branch(found) ? "edge of its branch"
                                    : "minimum";
}

/// "What is the quickest brachistochrone ever achievable by any object?"
std::string open_question(const std::vector<QuickestBody>& bodies) {
  report::HtmlRows rows;
  for (const QuickestBody& row : bodies) {
    auto& cells = rows.emplace_back();
    const auto add = [&]<class... Args>(fmt::format_string<Args...> format,
                                        Args&&... args) {
      cells.push_back(
          {with_minus_signs(fmt::format(format, std::forward<Args>(args)...))});
    };
    add("{:g}", row.L);
    cells.push_back({html_words(row.any_k ? "any" : "1/2")});
    if (!row.found) {
      cells.resize(cells.size() + 5, {"–"});
      cells.push_back({"0"});
      continue;
    }
    const Body& body = row.found->body;
    add("{:.9f}", row.found->tau);
    add("{:.5f}", body.eta_m);
    add("{:.5f}", body.theta_m);
    add("{:.5f}", body.k);
    add("{}", kind(*row.found));
    add("{}", row.found->found_from);
  }
  const std::string words = fmt::format(
      "<p>The paper ends with the question what the quickest brachistochrone "
      "ever achievable by any object between two given points is. For the "
      "radius of the reference case these are the quickest bodies that were "
      "found, each on its own extremal, able to run on it, and most of them a "
      "local minimum of the first and second order along the bounds that hold. "
      "Next to folds of branches τ jumps: there the least τ lies at the edge "
      "of a branch, or is that of the quickest body passed. That no other "
      "body is quicker is not proven, nor that {} is always best. With the "
      "radius free there is none: τ falls to zero as the body grows to "
      "(L² + H²)/(2L). Where there is no row none of {} searches came to such "
      "a body on the principal branch. docs/validation.md has more.</p>\n",
      html_words("k = 0"), kDesignStarts);
  return words + words_table({"L", "k", "τ", "η_m", "θ_m [rad]", "k found",
                              "what it is", "searches that led there"},
                             rows);
}

std::string introduction(const Results& found) {
  const Case& reference = found.cases["fig04_reference_case"];
  return fmt::format(
      "<p class=\"about\">Every figure with a result and every number of K. "
      "Sambath and V. "
      "Nagarajan, <i>Brachistochrone of off-centered cylinders</i> (2022), "
      "computed again by brachisto {} and set beside what is printed.</p>\n"
      "<h2>The scene</h2>\n<p>A cylinder of radius <i>r</i> rolls without slip "
      "from A = (0, 0) to B = (<i>L</i>, <i>H</i>), <i>H</i> = 1, on the "
      "paper's "
      "brachistochrone: the smooth-contact extremal, which is not the fastest "
      "track of all (docs/theory.md, section 3, third trap). Its centre of "
      "mass lies at the "
      "distance {} from its axis, at first in the direction {} below the "
      "horizontal; its moment of inertia about the centre of mass is "
      "<i>k m r</i><sup>2</sup>. Times are <i>τ</i> = <i>T</i> "
      "√(2<i>g</i>/<i>H</i>). The reference case has <i>L</i> = 3, <i>r</i> = "
      "1/3, {}, <i>k</i> = 1/2: <i>τ</i> = {}.</p>\n"
      "<p>All numbers are of solutions that passed every check of their "
      "certificate. The error bar of times is the estimated error, in the grid "
      "study the true one; that of other numbers is the change between a "
      "solution and one a hundred times as accurate. Least values of forces "
      "and curvatures leave out the rise from the start, where {}.</p>\n",
      report::provenance().brachisto, html_words("η_m r"), html_words("θ_m"),
      html_words("η_m = 2/3, θ_m = 0"), with_error(reference.tau()),
      html_words("R_n = 0 and κ_b = −1/r"));
}

/// \param figures  in HTML
std::string page(const Results& found, const Reproduction& made,
                 const std::string& figures) {
  std::string out =
      report::document_head(kTitle, {plot::kDocumentStyle}) +
      fmt::format("<h1>{}: the paper and brachisto</h1>\n", kTitle);
  out += introduction(found);
  out += "<h2>Numbers</h2>\n" + comparison_table(made.comparisons);
  out += "<h2>Statements</h2>\n" + claims_table(made.claims);
  out += "<h2>Figures</h2>\n";
  out += figures;
  out += "<h2>The initial orientation of the smallest τ</h2>\n" +
         orientation_table(found.orientations);
  out += "<h2>The quickest body</h2>\n" + open_question(found.quickest);
  out += "<h2>All cases</h2>\n" + cases_table(found.cases);
  const report::Provenance with = report::provenance();
  return out + fmt::format(
                   "<footer>Written by brachisto {}, Ipopt {}, MUMPS {}, "
                   "SuiteSparse {}, {}.</footer>\n</body>\n</html>\n",
                   with.brachisto, with.ipopt, with.mumps, with.suitesparse,
                   report::xml_escaped(with.compiler));
}

}  // namespace

Reproduction reproduce(const Results& found) {
  return {printed_numbers(found), judge(found), all_figures(found)};
}

report::DrawnFiles files(const Results& found, const Reproduction& made,
                         const std::atomic<int>* interrupt) {
  report::GrowingPage figures(interrupt);
  for (const Figure& figure : made.figures) {
    figures += fmt::format("<h3>{}</h3>\n", html_words(figure.heading));
    figures.add(figure.drawing, html_words(figure.caption));
  }
  figures.add_file("comparison.csv",
                   csv(comparison_columns(), made.comparisons));
  figures.add_file("claims.csv", csv(claim_columns(), made.claims));
  figures.add_file("cases.csv", cases_csv(found.cases));
  figures.add_file("orientations.csv",
                   csv(orientation_columns(), found.orientations));
  figures.add_file("boundary.csv", boundary_csv(found));
  // Last, so that whoever sees the page sees what it refers to.
  figures.add_file("index.html", page(found, made, figures.html()));
  return figures.files();
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
  const Json document = {
      {"schema_version", report::kSchemaVersion},
      {"verified", true},
      {"comparisons", json(comparison_columns(), made.comparisons)},
      {"claims", json(claim_columns(), made.claims)},
      {"fastest_orientations", json(orientation_columns(), found.orientations)},
      {"as_fast_as_the_bead",
       {{"theta_m_minus_pi_6", json(boundary_columns(), found.boundary)},
        {"fastest_theta_m", json(boundary_columns(), found.best_boundary)}}},
      {"provenance", Json::parse(report::provenance_json())}};
  return document.dump(2) + "\n";
}

}  // namespace brachisto::reproduction
