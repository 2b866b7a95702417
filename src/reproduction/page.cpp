// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "reproduction/page.hpp"

#include <fmt/format.h>

#include <iterator>
#include <string_view>
#include <utility>
#include <vector>

#include "design/design_search.hpp"
#include "report/page.hpp"
#include "report/provenance.hpp"
#include "report/rich_text.hpp"

namespace brachisto::reproduction {

namespace {

using report::html_words;

constexpr const char* kTitle = "Brachistochrones of off-centred cylinders";

/// A table from the rows of its body, which are markup. Each cell is told its
/// column, by whose name it is known where there is no room for columns.
std::string html_table(const std::vector<std::string>& heads,
                       const std::string& rows) {
  constexpr std::string_view kRow = "<tr>", kCell = "<td";
  std::string out = "<div class=\"wide\"><table class=\"stacked\"><thead><tr>";
  for (const std::string& head : heads) {
    out += fmt::format("<th>{}</th>", html_words(head));
  }
  out += "</tr></thead><tbody>\n";
  std::size_t column = 0;
  for (std::string_view rest = rows; !rest.empty();) {
    if (rest.starts_with(kRow)) column = 0;
    if (!rest.starts_with(kCell)) {
      out += rest.front();
      rest.remove_prefix(1);
      continue;
    }
    out += fmt::format(
        "{} data-label=\"{}\"", kCell,
        report::xml_escaped(report::plain_words(heads.at(column++))));
    rest.remove_prefix(kCell.size());
  }
  return out + "</tbody></table></div>\n";
}

std::string comparison_table(const std::vector<PrintedNumber>& numbers) {
  std::string rows;
  for (const PrintedNumber& row : numbers) {
    const std::string unit = row.unit.empty() ? "" : " " + row.unit;
    rows += fmt::format(
        "<tr><td class=\"brief\">{}<br/><small>{}</small></td><td>{}{}</td>"
        "<td>{}{}</td><td class=\"brief\">{}</td>"
        "<td class=\"words\">{}</td></tr>\n",
        html_words(row.quantity), html_words(row.place), html_words(row.paper),
        html_words(unit), with_error(row.ours), html_words(unit),
        difference_text(row), html_words(row.remark));
  }
  return html_table({"quantity", "paper", "here", "here − paper", "remark"},
                    rows);
}

std::string claims_table(const std::vector<Claim>& claims) {
  std::string rows;
  for (const Claim& claim : claims) {
    rows += fmt::format(
        "<tr><td class=\"words\">{} <small>{}</small></td><td>{}</td>"
        "<td class=\"words\">{}</td></tr>\n",
        html_words(claim.statement), html_words(claim.place),
        name(claim.verdict), html_words(claim.evidence));
  }
  return html_table({"statement of the paper", "verdict", "evidence"}, rows);
}

std::string span(const Extreme& low, const Extreme& high) {
  return with_minus_signs(
      fmt::format("{:.3f} … {:.3f}", low.value, high.value));
}

std::string cases_table(const Cases& cases) {
  std::string rows;
  for (const auto& [name, one] : cases.all()) {
    const PathDiagnostics& d = *one.fine.diagnostics;
    const bool rolls = one.scene().body.rolls();
    rows += fmt::format(
        "<tr><td><code>{}</code></td><td>{}</td><td>{:.6f}</td>"
        "<td>{}</td><td>{}{}</td><td>{}</td>"
        "<td>{}</td><td>{}</td></tr>\n",
        name, with_error(one.tau()), one.motion().rail_length(),
        span(d.normal_force_after_rise, d.max_normal_force),
        span(d.curvature_after_rise, d.max_curvature),
        bends_less_than_body(one) ? "" : " (&gt; 1/r)",
        rolls ? fmt::format("{:.3f}", d.min_fold_margin.value) : "–",
        rolls
            ? fmt::format(
                  "{:.0f} %, {:.0f} %, {:.0f} %", 100.0 * d.friction_above_0_3,
                  100.0 * d.friction_above_0_5, 100.0 * d.friction_above_1)
            : "–",
        one.fine.feasible() ? "yes" : "no");
  }
  return html_table({"case", "τ", "track", "R_n [m g]: least minimum … largest",
                     "κ_b [1/H]: the same", "least 1 − r κ_c",
                     "time with |R_t|/R_n > 0.3, 0.5, 1", "feasible"},
                    rows);
}

std::string orientation_table(const std::vector<OrientationRow>& fastest) {
  std::string rows;
  for (const OrientationRow& row : fastest) {
    rows += fmt::format(
        "<tr><td>{:.12f}</td><td>{}</td><td>{}</td><td>{:.9f}</td></tr>\n",
        row.eta_m, with_error(row.fastest.theta_m),
        with_minus_signs(
            fmt::format("{:.5f}", row.fastest.theta_m.value * kDegrees)),
        row.fastest.tau);
  }
  return html_table({"η_m", "θ_m of the smallest τ [rad]", "[°]", "τ there"},
                    rows);
}

std::string_view kind(const DesignMinimum& found) {
  return !found.stationary          ? "passed at a fold"
         : at_edge_of_branch(found) ? "edge of its branch"
                                    : "minimum";
}

/// "What is the quickest brachistochrone ever achievable by any object?"
std::string open_question(const std::vector<QuickestBody>& bodies) {
  std::string rows;
  for (const QuickestBody& row : bodies) {
    rows += fmt::format("<tr><td>{:g}</td><td>{}</td>", row.L,
                        html_words(row.any_k ? "any" : "1/2"));
    if (!row.found) {
      rows +=
          "<td>–</td><td>–</td><td>–</td><td>–</td><td>–</td><td>0</td></tr>\n";
      continue;
    }
    const Body& body = row.found->body;
    rows += with_minus_signs(fmt::format(
        "<td>{:.9f}</td><td>{:.5f}</td><td>{:.5f}</td><td>{:.5f}</td>"
        "<td>{}</td><td>{}</td></tr>\n",
        row.found->tau, body.eta_m, body.theta_m, body.k, kind(*row.found),
        row.found->found_from));
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
  return words + html_table({"L", "k", "τ", "η_m", "θ_m [rad]", "k found",
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
  std::string out = report::page_head(kTitle, ": the paper and brachisto");
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

PaperFiles files(const Results& found, const Reproduction& made,
                 const std::atomic<int>* interrupt) {
  PaperFiles written;
  std::vector<report::OutputFile>& out = written.files;
  std::string figures;
  std::size_t room = report::kMostOfPictures;
  for (const Figure& figure : made.figures) {
    report::DrawnFigure drawn =
        report::draw(figure.drawing, report::Format::Svg, interrupt);
    figures += fmt::format("<h3>{}</h3>\n", html_words(figure.heading)) +
               report::figure_html(drawn, figure.drawing.name,
                                   html_words(figure.caption), room);
    if (!drawn.missing.empty()) written.missing = drawn.missing;
    std::move(drawn.files.begin(), drawn.files.end(), std::back_inserter(out));
  }
  out.push_back({"comparison.csv", comparison_csv(made.comparisons)});
  out.push_back({"claims.csv", claims_csv(made.claims)});
  out.push_back({"cases.csv", cases_csv(found.cases)});
  out.push_back({"orientations.csv", orientations_csv(found.orientations)});
  out.push_back({"boundary.csv", boundary_csv(found)});
  // Last, so that whoever sees the page sees what it refers to.
  out.push_back({"index.html", page(found, made, figures)});
  return written;
}

}  // namespace brachisto::reproduction
