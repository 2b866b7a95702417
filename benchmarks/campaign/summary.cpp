// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "campaign/summary.hpp"

#include <fmt/format.h>

#include <functional>

#include "support/table.hpp"

namespace brachisto::benchmarks {

namespace {

using Filter = std::function<bool(const Record&)>;

std::vector<double> values(const std::vector<Examined>& all,
                           const Filter& filter,
                           const std::function<double(const Record&)>& value) {
  std::vector<double> out;
  for (const Examined& one : all) {
    if (filter(one.record)) out.push_back(value(one.record));
  }
  return out;
}

std::string counts(const std::vector<Examined>& all) {
  Rows table{{"outcome", "scenes", "share of those with a cycloid"}};
  const double whole = count(all).with_cycloid;
  const auto line = [&](const std::string& what, const Filter& filter) {
    const auto n = values(all, filter, [](const Record&) { return 0.0; });
    table.push_back(
        {what, std::to_string(n.size()),
         fmt::format("{:.2f} %",
                     100.0 * static_cast<double>(n.size()) / whole)});
  };
  const auto is = [](Verdict verdict) {
    return [verdict](const Record& one) { return one.verdict == verdict; };
  };
  line("solved and verified", [](const Record& one) { return one.verified; });
  line("– and the witness agrees", is(Verdict::Agrees));
  line("– and the witness disagrees", is(Verdict::Disagrees));
  line("– and the witness found nothing", is(Verdict::NoWitness));
  line("– beyond a fold",
       [](const Record& one) { return one.verified && one.folds > 0; });
  line("– and feasible", [](const Record& one) { return one.feasible; });
  line("solved, not verified", is(Verdict::Unverified));
  line("not solved", is(Verdict::NotSolved));
  line("process lost", is(Verdict::Lost));
  line("no cycloid to continue from", is(Verdict::NoCycloid));
  return markdown_table(table);
}

std::string quantiles(const std::vector<Examined>& all) {
  Rows table{{"quantity", "median", "95 %", "99 %", "largest"}};
  const auto line = [&](const std::string& what, const char* format,
                        const Filter& filter, auto value) {
    const std::vector<double> all_of_them = values(all, filter, value);
    std::vector<std::string> row{what};
    for (const double q : {0.5, 0.95, 0.99, 1.0}) {
      row.push_back(
          fmt::format(fmt::runtime(format), percentile(all_of_them, q)));
    }
    table.push_back(std::move(row));
  };
  const Filter compared = [](const Record& one) {
    return one.verdict == Verdict::Agrees || one.verdict == Verdict::Disagrees;
  };
  const Filter verified = [](const Record& one) { return one.verified; };
  const Filter tried = [](const Record& one) {
    return one.verdict != Verdict::Lost && one.verdict != Verdict::NoCycloid;
  };
  line("difference of τ, relative", "{:.1e}", compared,
       [](const Record& one) { return one.difference.tau; });
  line("difference at element ends, / max(L, H)", "{:.1e}", compared,
       [](const Record& one) { return one.difference.nodes; });
  line("difference anywhere, / max(L, H)", "{:.1e}", compared,
       [](const Record& one) { return one.difference.path; });
  line("difference of the end angle, rad", "{:.1e}", compared,
       [](const Record& one) { return one.difference.angle; });
  line("estimated error of τ, relative", "{:.1e}", verified,
       [](const Record& one) { return one.estimated_error; });
  line("solve(), seconds", "{:.3f}", tried,
       [](const Record& one) { return one.seconds; });
  line("indirect method, seconds", "{:.3f}", tried,
       [](const Record& one) { return one.witness_seconds; });
  line("iterations of Ipopt", "{:.0f}", tried,
       [](const Record& one) { return static_cast<double>(one.iterations); });
  line("Newton steps", "{:.0f}", tried,
       [](const Record& one) { return static_cast<double>(one.newton_steps); });
  line("meshes", "{:.0f}", tried,
       [](const Record& one) { return static_cast<double>(one.meshes); });
  return markdown_table(table);
}

std::string in_words(const Record& record) {
  std::string text = record.reason.str();
  if (record.verdict == Verdict::Disagrees) {
    text = fmt::format(
        "τ {:.12g}, witness {:.12g}; τ differs by {:.1e}, the path by {:.1e}; "
        "{} folds, witness {}",
        record.tau, record.witness_tau, record.difference.tau,
        record.difference.path, record.folds, record.witness_folds);
  }
  const std::string witness = record.witness_reason.str();
  if (!witness.empty()) {
    text += (text.empty() ? "" : " — ") + ("witness: " + witness);
  }
  return text;
}

std::string exceptions(const std::vector<Examined>& all) {
  Rows table{{"scene", "verdict", "L", "r", "η", "θ_m", "k", "reason"}};
  for (const Examined& one : all) {
    const Verdict verdict = one.record.verdict;
    if (verdict == Verdict::Agrees || verdict == Verdict::NoCycloid) continue;
    const Body& body = one.scene.body;
    table.push_back(
        {std::to_string(one.index), std::string(word(verdict)),
         fmt::format("{:.5g}", one.scene.L), fmt::format("{:.5g}", body.radius),
         fmt::format("{:.5g}", body.eta_m), fmt::format("{:.5g}", body.theta_m),
         fmt::format("{:.5g}", body.k), in_words(one.record)});
  }
  return table.size() == 1 ? "Every scene is solved, verified and confirmed.\n"
                           : markdown_table(table);
}

}  // namespace

Verdicts count(const std::vector<Examined>& all) {
  Verdicts verdicts;
  for (const Examined& one : all) {
    if (one.record.verdict == Verdict::NoCycloid) continue;
    ++verdicts.with_cycloid;
    if (one.record.verified) ++verdicts.verified;
    if (one.record.verdict == Verdict::Disagrees) ++verdicts.disagreeing;
  }
  return verdicts;
}

std::string summary(const std::vector<Examined>& all) {
  return counts(all) + '\n' + quantiles(all) + '\n' + exceptions(all);
}

}  // namespace brachisto::benchmarks
