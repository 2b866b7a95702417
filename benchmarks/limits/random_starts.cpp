// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Is there a faster track under the same limits than the one that is verified?
// The program of `contact: optimal` on one mesh, solved from random paths that
// owe nothing to it, and what they lead to made exact and certified.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>
#include <vector>

#include "brachisto/solvers/program_solvers.hpp"
#include "math/cpu_clock.hpp"
#include "model/inertia.hpp"
#include "refinement/arc_fit.hpp"
#include "refinement/random_path.hpp"
#include "study/pose.hpp"
#include "support/csv.hpp"
#include "support/limited_scenes.hpp"
#include "support/processes.hpp"
#include "support/table.hpp"
#include "support/text.hpp"
#include "trajectory/certify.hpp"

using namespace brachisto;
using namespace brachisto::benchmarks;

namespace {

/// What a start led to.
struct Record {
  enum class Fate { Unsolved, Loop, Solved, Fitted, Certified };
  Fate fate = Fate::Unsolved;
  double tau = 0.0;       ///< on the mesh; of what is fitted, exact
  double mesh_tau = 0.0;  ///< on the mesh
  double beta_0 = 0.0, phi = 0.0, start_tau = 0.0, seconds = 0.0;
  int iterations = 0, attempts = 0;
  FixedText<200> arcs, reason;
};
constexpr std::array kFates{"unsolved", "loop", "solved", "fitted",
                            "certified"};

/// "valley–free–valley".
std::string in_words(const FittedPath& path) {
  std::vector<std::string> words;
  for (const Arc& arc : path.arcs) {
    std::string word = "free";
    for (std::size_t i = 0; i < arc.held.size(); ++i) {
      if (arc.held[i] != nlp::Held::No) {
        word = name(path.curve.problem().limits()[i].kind);
      }
    }
    words.push_back(std::move(word));
  }
  return fmt::format("{}", fmt::join(words, "–"));
}

/// The arcs of a solution, corrected until all limits are kept.
std::optional<FittedPath> fitted(LimitedCurve curve, const MeshOptions& options,
                                 std::string& reason) {
  constexpr int kDegree = 7, kMostCorrections = 12;
  PathSetting setting{curve.problem().limits(), arcs_of(curve),
                      curve.problem().ends()};
  for (int i = 0; i < kMostCorrections; ++i) {
    ArcFit fit = fit_arcs(curve, setting, kDegree, options);
    if (!fit.path) {
      reason = fit.message;
      return std::nullopt;
    }
    auto other = corrected(fit.path->curve, fit.path->arcs);
    if (!other) return std::move(fit.path);
    setting.arcs = std::move(other->arcs);
    setting.ends = fit.path->ends;
    setting.ends.corner = other->corner;
    curve = fit.path->curve;
  }
  reason = "arcs keep changing";
  return std::nullopt;
}

struct Study {
  testing::LimitedReference reference;
  int elements = 60, degree = 4, iterations = 1000;
  double waviness = 0.5;  ///< of the starts, in H
};

Record run(const Study& study, std::uint64_t seed) {
  const PosedProblem posed = pose(study.reference.scene, {}, {});
  const Scene& scene = *posed.limited;
  const double tau_unit = std::sqrt(2.0 * scene.gravity / scene.H);
  Record record;
  SplitMix64 random(SplitMix64::scrambled(seed));
  const RandomPath path =
      some_random_path(scene, study.waviness, random, record.attempts);
  for (std::size_t i = 1; i < path.u.size(); ++i) {
    const TurningPoint<double>& at = path.at[i];
    record.start_tau +=
        tau_unit * (path.u[i] - path.u[i - 1]) *
        std::sqrt(inertia_factor(scene.body, at.theta, at.beta));
  }
  LimitedTime problem(scene, inequalities(scene.body, scene.limits),
                      uniform_mesh(study.degree, study.elements),
                      {.free_contacts = true});
  IpoptOptions ipopt;
  ipopt.tolerance = 1e-8;
  ipopt.complementarity = 1e-10;
  ipopt.max_iterations = study.iterations;
  const double begin = process_cpu_seconds();
  SolverResult found =
      solve_with_ipopt(problem, start_on(problem, path), ipopt);
  record.iterations = found.iterations;
  if (found.status != Status::Solved) {
    record.reason = FixedText<200>(found.message);
    record.seconds = process_cpu_seconds() - begin;
    return record;
  }
  const LimitedCurve curve(problem, std::move(found.point));
  const auto take = [&](const LimitedCurve& from, Record::Fate fate) {
    record.fate = fate;
    record.tau = from.transit_time() * tau_unit;
    record.beta_0 = from.at(0.0).state.beta;
    record.phi = from.at(1.0).state.beta;
  };
  take(curve, Record::Fate::Solved);
  record.mesh_tau = record.tau;
  for (int e = 0; e < study.elements; ++e) {
    if (std::abs(curve.at(e, 1.0).state.beta) > std::numbers::pi) {
      record.fate = Record::Fate::Loop;
    }
  }
  std::string reason;
  if (record.fate == Record::Fate::Solved) {
    if (const auto exact = fitted(curve, posed.mesh_options, reason)) {
      constexpr double kError = 1e-8;
      const Certificate certificate =
          certify(exact->curve, exact->mismatch.largest(), kError);
      take(exact->curve, certificate.verified() ? Record::Fate::Certified
                                                : Record::Fate::Fitted);
      reason = failed_checks(certificate);
      record.arcs = FixedText<200>(in_words(*exact));
    }
  }
  record.reason = FixedText<200>(reason);
  record.seconds = process_cpu_seconds() - begin;
  return record;
}

/// Starts that led to the same path.
struct Minimum {
  Record one;  ///< the best known of them
  int starts = 0;
};

/// By fate and τ, which solutions on the mesh share to a part in 10⁴ and exact
/// ones to one in 10⁸.
std::vector<Minimum> minima_of(std::vector<Record> records) {
  const auto same = [](const Record& a, const Record& b) {
    const double most = a.fate >= Record::Fate::Fitted ? 1e-8 : 1e-4;
    return a.fate == b.fate && std::abs(a.tau - b.tau) <= most * b.tau;
  };
  std::ranges::sort(records, {}, &Record::tau);
  std::vector<Minimum> minima;
  for (const Record& record : records) {
    if (record.fate == Record::Fate::Unsolved) continue;
    const auto known = std::ranges::find_if(
        minima, [&](const Minimum& m) { return same(m.one, record); });
    if (known == minima.end()) {
      minima.push_back({record, 1});
    } else {
      ++known->starts;
    }
  }
  return minima;
}

/// Whether nothing faster was certified than the reference, which was found.
bool told(const Study& study, const std::vector<Record>& records) {
  constexpr double kSame = 1e-9;
  const double tau = study.reference.tau;
  Rows rows{{"τ", "starts", "is", "arcs", "β₀", "φ", "why not certified"}};
  for (const Minimum& minimum : minima_of(records)) {
    const Record& one = minimum.one;
    const bool exact = one.fate >= Record::Fate::Fitted;
    rows.push_back({fmt::format("{:.{}f}", one.tau, exact ? 9 : 4),
                    std::to_string(minimum.starts),
                    kFates.at(static_cast<std::size_t>(one.fate)),
                    one.arcs.str(), fmt::format("{:.4f}", one.beta_0),
                    fmt::format("{:.4f}", one.phi), one.reason.str()});
  }
  const auto count = [&](Record::Fate fate) {
    return std::ranges::count(records, fate, &Record::fate);
  };
  double lowest = INFINITY, seconds = 0.0;
  double fastest = INFINITY, slowest = 0.0, off = 0.0;
  for (const Record& record : records) {
    seconds += record.seconds;
    fastest = std::min(fastest, record.start_tau);
    slowest = std::max(slowest, record.start_tau);
    if (record.fate != Record::Fate::Certified) continue;
    lowest = std::min(lowest, record.tau);
    off = std::max(off, std::abs(record.mesh_tau / record.tau - 1.0));
  }
  fmt::print(
      "{}, verified τ = {:.9f}; {} starts with τ from {:.2f} to {:.2f}\n"
      "{} unsolved, {} with a loop, {} solved on the mesh alone, {} "
      "fitted, {} certified; {:.0f} s\n"
      "lowest certified {:.9f}: {:+.1e}; before the fit off by up to "
      "{:.1e}\n\n{}\n",
      study.reference.name, tau, records.size(), fastest, slowest,
      count(Record::Fate::Unsolved), count(Record::Fate::Loop),
      count(Record::Fate::Solved), count(Record::Fate::Fitted),
      count(Record::Fate::Certified), seconds, lowest, lowest - tau, off,
      markdown_table(rows));
  return std::abs(lowest - tau) <= kSame * tau;
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<std::string> cases{"optimal_K2", "optimal_K4",
                                 "optimal_uniform_K2"};
  Study study;
  int starts = 100;
  std::uint64_t seed = 1;
  ProcessLimits limits{.jobs = 1, .seconds = 300};
  std::string out =
      BRACHISTO_SOURCE_DIR "/benchmarks/results/random_starts.csv";
  CLI::App app{"Minima under limits from random starts"};
  app.add_option("--cases", cases, "Of the limited reference values")
      ->capture_default_str();
  app.add_option("--starts", starts, "Of each case")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--seed", seed, "Of the starts")->capture_default_str();
  app.add_option("--waviness", study.waviness, "Of the starts, in H")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  app.add_option("--elements", study.elements, "Of the mesh")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--degree", study.degree, "Of its elements")
      ->check(CLI::Range(2, 8))
      ->capture_default_str();
  app.add_option("--iterations", study.iterations, "Of Ipopt, at most")
      ->capture_default_str();
  app.add_option("--jobs", limits.jobs, "Processes at a time")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--out", out, "CSV file")->capture_default_str();
  CLI11_PARSE(app, argc, argv);

  fmt::print("{}. {} elements of degree {}, seed {}.\n\n", machine(),
             study.elements, study.degree, seed);
  std::string csv =
      "case,start,fate,tau,start_tau,beta_0,phi,iterations,attempts,seconds,"
      "arcs,reason\n";
  bool passed = true;
  for (const std::string& name : cases) {
    study.reference = testing::limited_reference(name);
    std::vector<Record> records(static_cast<std::size_t>(starts));
    run_isolated<Record>(
        starts, limits,
        [&](int i) { return run(study, seed + static_cast<std::uint64_t>(i)); },
        [&](int i, const std::optional<Record>& record,
            const std::string& fate) {
          Record& one = records[static_cast<std::size_t>(i)];
          if (record) {
            one = *record;
          } else {
            one.reason = FixedText<200>(fate);
          }
        });
    for (std::size_t i = 0; i < records.size(); ++i) {
      const Record& one = records[i];
      csv += fmt::format(
          "{},{},{},{:.12g},{:.6g},{:.6g},{:.6g},{},{},{:.2f},{},{}\n", name,
          seed + i, kFates.at(static_cast<std::size_t>(one.fate)), one.tau,
          one.start_tau, one.beta_0, one.phi, one.iterations, one.attempts,
          one.seconds, csv_field(one.arcs.str()), csv_field(one.reason.str()));
    }
    passed = told(study, records) && passed;
  }
  write_file(out, csv);
  return passed ? 0 : 1;
}
