// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "comparison/pages.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "brachisto/version.hpp"
#include "comparison/comparison_text.hpp"
#include "comparison/finding.hpp"
#include "comparison/methods.hpp"
#include "comparison/pictures.hpp"
#include "comparison/statistics.hpp"
#include "plot/web_parts.hpp"
#include "report/page.hpp"
#include "report/rich_text.hpp"
#include "report/scale.hpp"
#include "report/text_table.hpp"

namespace brachisto::comparison {

namespace {

using report::folded_html;
using report::html_table;
using report::xml_escaped;

constexpr const char* kPage = "index.html";
constexpr const char* kDocument = "work_precision.json";

std::string paragraph(const std::string& words) {
  return fmt::format("<p class=\"about\">{}</p>\n", xml_escaped(words));
}

/// What belongs to a name, at the end if it is new.
template <class Value>
Value& entry_of(std::vector<std::pair<std::string, Value>>& entries,
                const std::string& name) {
  const auto found =
      std::ranges::find(entries, name, &std::pair<std::string, Value>::first);
  return found != entries.end() ? found->second
                                : entries.emplace_back(name, Value()).second;
}

/// What has no result, and why, once for each reason.
class Failures {
 public:
  void add(const std::string& method, const std::string& mesh,
           const std::string& reason) {
    auto& methods = entry_of(entry_of(reasons_, reason), method);
    if (!mesh.empty()) methods.push_back(mesh);
  }
  [[nodiscard]] std::string html() const {
    if (reasons_.empty()) return {};
    std::string out = "<h2>Without a result</h2>\n<ul class=\"failures\">\n";
    for (const auto& [reason, methods] : reasons_) {
      std::string names;
      for (const auto& [method, meshes] : methods) {
        names += (names.empty() ? "" : ", ") + method;
        if (!meshes.empty()) names += " on " + listed(meshes);
      }
      out += fmt::format("<li>{}: {}</li>\n", xml_escaped(names),
                         xml_escaped(reason));
    }
    return out + "</ul>\n";
  }

 private:
  using Methods = std::vector<std::pair<std::string, std::vector<std::string>>>;

  static std::string listed(const std::vector<std::string>& meshes) {
    constexpr std::size_t kNamed = 6;
    if (meshes.size() > kNamed) {
      return fmt::format("{} meshes from {} to {}", meshes.size(),
                         meshes.front(), meshes.back());
    }
    return fmt::format("{}", fmt::join(meshes, ", "));
  }

  std::vector<std::pair<std::string, Methods>> reasons_;
};

/// What each party needs for errors, and how.
std::string wanted_table(const std::vector<Party>& parties) {
  report::Rows rows{{"error", "method", "processor time", "by"}};
  for (const double error : {1e-3, 1e-6, 1e-9, 1e-12}) {
    for (const Party& party : parties) {
      if (party.trials.empty()) continue;
      const Trial* trial = party.quickest_to(error);
      rows.push_back({error_words(error), party.name,
                      trial != nullptr ? duration(trial->seconds) : "—",
                      trial != nullptr ? trial->how : ""});
    }
  }
  return html_table(rows);
}

/// How errors and times were taken, and where.
std::string how_measured(const std::optional<Reference>& reference,
                         const std::string& times) {
  const Machine machine = this_machine();
  std::string out;
  if (reference) {
    out += paragraph(fmt::format("Errors are relative, of τ, against {}.",
                                 reference_text(*reference)));
    if (!reference->instead_of.empty()) {
      out += paragraph(fmt::format(
          "No other method has an answer that the program could be judged by "
          "({}): its errors are against its own.",
          reference->instead_of));
    }
  }
  return out + paragraph(times) +
         paragraph(fmt::format("Measured on {} ({} cores, {}).", machine.cpu,
                               machine.cores, machine.kernel));
}

report::GrowingPage page_of(const std::string& sentence, const Subject& subject,
                            const std::atomic<int>* interrupt) {
  report::GrowingPage page(interrupt);
  const std::string title = xml_escaped(sentence);
  page += report::document_head(title, {plot::kDocumentStyle});
  page += fmt::format("<h1>{}</h1>\n", title);
  page += fmt::format("<p class=\"about\">{}.</p>\n",
                      report::html_words(in_words(subject)));
  return page;
}

void add_picture(report::GrowingPage& page, const Picture& picture) {
  page.add(picture.figure, page.next_number() + xml_escaped(picture.caption));
}

report::DrawnFiles finished(report::GrowingPage& page) {
  page += fmt::format("<footer>Written by brachisto {}.</footer>\n",
                      BRACHISTO_VERSION);
  page.add_file(kPage, page.html() + "</body>\n</html>\n");
  return page.files();
}

/// "1 solve", "5 solves".
std::string solves(int repetitions) {
  return report::counted(static_cast<std::size_t>(repetitions), "solve");
}

/// What names in the sentence and the picture mean.
std::string names_in_words() {
  return paragraph(
      "The program is collocation in the rolling time, by its degree p or on "
      "meshes of its own; arc_length is the program in the paper's variables, "
      "fsolve the paper's discrete system, the extremal method multiple "
      "shooting. The sentence above has the quickest run of each.");
}

/// Of the start of all runs on meshes.
std::string start_in_words(const WorkPrecision& found) {
  std::vector<double> starts;
  for (const PrecisionLine& line : found.lines) {
    if (party(line.method) != "the program") continue;
    for (const PrecisionPoint& point : line.points) {
      if (point.run.solved() && !point.run.start.empty()) {
        starts.push_back(spread_of(point.run.start).median);
      }
    }
  }
  if (starts.empty()) return {};
  return paragraph(fmt::format(
      "Of the program's times the start takes {}: the way from the cycloid to "
      "a coarse solution{}. It does not depend on the mesh.",
      duration(spread_of(starts).median),
      found.subject.limited() ? ", with the search for the arcs" : ""));
}

}  // namespace

std::vector<std::string> work_precision_file_names() {
  std::vector<std::string> names = work_precision_picture_files();
  names.insert(names.end(), {kDocument, kPage});
  return names;
}

std::vector<std::string> comparison_file_names() {
  return {"compare.txt", "compare.json", "compare.csv",
          "compare.gp",  "compare.svg",  kPage};
}

report::DrawnFiles files_of(const WorkPrecision& found,
                            const std::atomic<int>* interrupt) {
  const std::vector<Party> parties = parties_of(found);
  report::GrowingPage page =
      page_of(in_a_sentence(parties), found.subject, interrupt);
  page.add_file(kDocument, to_json(found));
  const std::vector<Picture> pictures = pictures_of(found);
  add_picture(page, pictures.front());
  Failures failures;
  for (const LeftOut& one : found.left_out) {
    failures.add(label(one.method), "", one.reason);
  }
  std::size_t runs = 0;
  for (const PrecisionLine& line : found.lines) {
    for (const PrecisionPoint& point : line.points) {
      ++runs;
      if (point.run.solved()) continue;
      failures.add(label(line.method), text(point.fineness), point.run.cause);
    }
  }
  page += names_in_words() + failures.html();
  page += "<h2>Numbers</h2>\n";
  page += folded_html("What errors cost", wanted_table(parties));
  page += folded_html(
      "Orders",
      paragraph("Fitted to the finest meshes whose errors follow one power of "
                "the number of elements, pieces or nodes, and are above " +
                report::printed(found.floor(), 2) + ".") +
          html_table(order_rows(found)));
  page += folded_html(fmt::format("All {} runs", runs),
                      html_table(point_rows(found)));
  page += folded_html(
      "How it was measured",
      how_measured(found.reference,
                   fmt::format("Each run is a process of its own, from the "
                               "cycloid; its time is the median of up to {}, "
                               "without certificates.",
                               solves(found.plan.repetitions))));
  if (pictures.size() > 1) page += "<h2>More pictures</h2>\n";
  page += start_in_words(found);
  for (std::size_t i = 1; i < pictures.size(); ++i)
    add_picture(page, pictures[i]);
  return finished(page);
}

report::DrawnFiles files_of(const MethodComparison& made,
                            const std::atomic<int>* interrupt) {
  const std::vector<Party> parties = parties_of(made);
  report::GrowingPage page =
      page_of(in_a_sentence(parties), made.subject, interrupt);
  page.add_file("compare.txt", summary(made));
  page.add_file("compare.json", to_json(made));
  for (const Picture& picture : pictures_of(made)) add_picture(page, picture);
  Failures failures;
  for (const ComparisonRow& row : made.rows) {
    if (!row.run.solved()) failures.add(row.label, "", row.run.cause);
  }
  page += names_in_words() + failures.html();
  page += "<h2>Numbers</h2>\n";
  page += folded_html(fmt::format("All {} methods", made.rows.size()),
                      html_table(method_rows(made)));
  page += folded_html(
      "How it was measured",
      how_measured(
          made.reference,
          fmt::format("Each method runs in a process of its own, from the "
                      "cycloid to residuals of {}; its time is the median of "
                      "up to {}, without certificates.",
                      report::printed(made.options.residual, 2),
                      solves(made.options.repetitions))));
  return finished(page);
}

}  // namespace brachisto::comparison
