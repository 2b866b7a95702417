// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "comparison/finding.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "comparison/comparison.hpp"
#include "comparison/methods.hpp"
#include "comparison/statistics.hpp"
#include "comparison/work_precision.hpp"
#include "report/scale.hpp"

namespace brachisto::comparison {

using report::printed;

namespace {

constexpr int kDigits = 2;

/// Parties by the names of their methods, the program first.
class Parties {
 public:
  void add_refused(const ComparedMethod& method) { (void)of(method); }

  /// A run that solved nothing leaves no trial; an error that cannot be told
  /// from that of the reference counts as much.
  void add(const ComparedMethod& method, const std::string& how,
           const Measurement& run, std::optional<double> error,
           const Reference& reference) {
    Party& party = of(method);
    if (run.outcome != Measurement::Outcome::Refused) party.refused = false;
    if (!run.solved() || !error || run.cpu.empty()) return;
    party.trials.push_back(
        {how, spread_of(run.cpu).median, std::max(*error, reference.error)});
  }

  [[nodiscard]] std::vector<Party> all() && {
    std::ranges::stable_partition(
        all_, [](const Party& party) { return party.name == "the program"; });
    return std::move(all_);
  }

 private:
  Party& of(const ComparedMethod& method) {
    const std::string name = party(method);
    const auto found = std::ranges::find(all_, name, &Party::name);
    if (found != all_.end()) return *found;
    return all_.emplace_back(Party{name, {}, true});
  }

  std::vector<Party> all_;
};

std::string with_sign(int power) {
  return power < 0 ? fmt::format("−{}", -power) : fmt::format("{}", power);
}

/// "rolling_time p = 3, mesh of 8", "adaptive, to 1e-06", "extremal".
std::string how(const ComparedMethod& method, const Fineness& fineness) {
  const std::string point = text(fineness);
  if (point.empty()) return label(method);
  return fmt::format("{}, {} {}", label(method),
                     fineness.mesh > 0 ? "mesh of" : "to", point);
}

/// "a", "a and b", "a, b and c".
std::string listed(const std::vector<std::string>& words) {
  std::string out;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) out += i + 1 == words.size() ? " and " : ", ";
    out += words[i];
  }
  return out;
}

/// "a does", "a and b do".
std::string of_all(const std::vector<std::string>& names,
                   const char* what_one_does, const char* what_many_do) {
  return fmt::format("{} {}", listed(names),
                     names.size() == 1 ? what_one_does : what_many_do);
}

}  // namespace

const Trial* Party::quickest_to(double error) const {
  const Trial* best = nullptr;
  for (const Trial& trial : trials) {
    if (trial.error > error) continue;
    if (best == nullptr || trial.seconds < best->seconds) best = &trial;
  }
  return best;
}

const Trial* Party::nearest() const {
  const auto least = std::ranges::min_element(trials, {}, &Trial::error);
  return least == trials.end() ? nullptr : &*least;
}

std::vector<Party> parties_of(const WorkPrecision& found) {
  Parties parties;
  for (const PrecisionLine& line : found.lines) {
    for (const PrecisionPoint& point : line.points) {
      parties.add(line.method, how(line.method, point.fineness), point.run,
                  point.error, found.reference);
    }
  }
  for (const LeftOut& one : found.left_out) {
    if (one.method != found.reference.method) parties.add_refused(one.method);
  }
  return std::move(parties).all();
}

std::vector<Party> parties_of(const MethodComparison& made) {
  Parties parties;
  for (const ComparisonRow& row : made.rows) {
    // Its time under limits is also that of the program, whose arcs it has.
    if (made.subject.limited() &&
        row.method.kind == ComparedMethod::Kind::Extremal) {
      continue;
    }
    parties.add(row.method, row.label, row.run, row.error,
                made.reference.value_or(Reference{}));
  }
  return std::move(parties).all();
}

std::string error_words(double error) {
  if (!(error > 0.0)) return printed(error);
  // As one with its power of ten, whatever its size.
  const int power = static_cast<int>(std::floor(std::log10(error)));
  const std::string digits = printed(error / std::pow(10.0, power), kDigits);
  if (digits == "10") return fmt::format("1e{}", with_sign(power + 1));
  return fmt::format("{}e{}", digits, with_sign(power));
}

std::string duration(double seconds) {
  constexpr double kMilli = 1e-3, kHundred = 100.0;
  const bool short_time = seconds < 1.0;
  const double number = short_time ? seconds / kMilli : seconds;
  return (number < kHundred ? printed(number, kDigits)
                            : fmt::format("{:.0f}", number)) +
         (short_time ? " ms" : " s");
}

std::string in_a_sentence(const std::vector<Party>& parties, double error) {
  std::vector<std::string> times, short_of, errors, without, refused;
  const Party* nearest = nullptr;
  for (const Party& party : parties) {
    if (const Trial* trial = party.quickest_to(error)) {
      times.push_back(fmt::format("{} {}{}", party.name,
                                  times.empty() ? "needs " : "",
                                  duration(trial->seconds)));
    } else if (const Trial* least = party.nearest()) {
      short_of.push_back(party.name);
      errors.push_back(error_words(least->error));
      if (nearest == nullptr || least->error < nearest->nearest()->error) {
        nearest = &party;
      }
    } else {
      (party.refused ? refused : without).push_back(party.name);
    }
  }
  std::vector<std::string> parts;
  const std::string to = fmt::format("an error of {}", error_words(error));
  if (!times.empty()) {
    parts.push_back(fmt::format("To {} {}", to, listed(times)));
    if (!short_of.empty()) {
      parts.push_back(
          fmt::format("{} (at best {})",
                      of_all(short_of, "does not reach it", "do not reach it"),
                      listed(errors)));
    }
  } else if (nearest != nullptr) {
    const Trial* least = nearest->nearest();
    parts.push_back(fmt::format(
        "No method reaches {}: {} comes nearest, to {} in {}", to,
        nearest->name, error_words(least->error), duration(least->seconds)));
  }
  if (!without.empty()) {
    parts.push_back(of_all(without, "finds no answer", "find no answer"));
  }
  if (!refused.empty()) {
    parts.push_back(of_all(refused, "does not take such a scene",
                           "do not take such a scene"));
  }
  if (parts.empty()) return "Nothing was measured.";
  std::string out = fmt::format("{}.", fmt::join(parts, "; "));
  // The name of a method stays as it is written: "fsolve finds no answer".
  if (out.starts_with("the ")) out[0] = 'T';
  return out;
}

}  // namespace brachisto::comparison
