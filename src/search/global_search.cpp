// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "search/global_search.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "extremal/contact_scan.hpp"
#include "solvers/newton_solver.hpp"
#include "transcription/contact_equation.hpp"
#include "transcription/prolongation.hpp"

namespace brachisto {

namespace {

/// True if the marks and T agree to `tolerance`.
bool agree(const ContactCandidate& a, double mark, double T, double tolerance) {
  return std::abs(mark_of(a) - mark) <= tolerance &&
         std::abs(a.curve.transit_time() / T - 1.0) <= tolerance;
}

PrimalDual sample(const ScannedContact& contact, const RollingTime& problem) {
  return sample_at_mesh(problem, contact.rolling_time, [&](double sigma) {
    const ExtremalState at = contact.path.at(sigma);
    ExtremalPoint point;
    point.centre = {at.x, at.z};
    point.theta = at.theta;
    point.w = at.w;
    point.beta = at.beta;
    point.p = {contact.p_x, contact.p_z, at.p_theta, at.p_w};
    return point;
  });
}

std::string remark(const ContactScan& scan, std::size_t left,
                   std::size_t lost) {
  std::vector<std::string> parts;
  if (!scan.whole_grid) {
    parts.emplace_back("not all terminal conditions at B were tried");
  } else if (!scan.complete()) {
    parts.push_back(
        fmt::format("of {} likely ways to arrive at B it looked at {}",
                    scan.starts, scan.tried));
  }
  if (left > 0) {
    parts.push_back(fmt::format(
        "of {} extremals that it found the {} slowest were not solved for",
        scan.contacts.size(), left));
  }
  std::string text;
  if (!parts.empty()) {
    text = fmt::format("the work of the search is bounded: {}",
                       fmt::join(parts, "; "));
  }
  if (lost > 0) {
    text +=
        fmt::format("{}of {} extremals that it found {} were lost on a mesh",
                    text.empty() ? "" : "; ", scan.contacts.size(), lost);
  }
  return text;
}

}  // namespace

double mark_of(const ContactCandidate& extremal) {
  return extremal.curve.scene().contact == Contact::Smooth
             ? extremal.phi
             : extremal.curve.arc_length();
}

ContactSearch find_contacts(const Scene& scene, double longest,
                            const std::function<Mesh(double length)>& mesh_for,
                            std::vector<ContactCandidate> known,
                            const StopCondition& stop,
                            const ProgressHook& progress) {
  // Two extremals are one and the same below the first; above the second,
  // Newton's method has left the one that it started from.
  constexpr double kSame = 1e-5;
  constexpr double kElsewhere = 1e-3;
  const std::size_t num_known = known.size();
  ContactSearch out{std::move(known), 0, {}};
  if (!scene.body.off_centred()) return out;
  const ContactScan scan = scan_contacts(scene, longest, [&] {
    if (progress) progress("search", "shooting backwards from B");
    return stop.met();
  });
  std::size_t left = scan.contacts.size(), lost = 0;
  for (const ScannedContact& scanned : scan.contacts) {
    if (stop.met() || out.contacts.size() >= num_known + kMostContacts) break;
    if (progress) {
      progress("search", fmt::format("{} extremals, {} left to solve for",
                                     scan.contacts.size(), left));
    }
    --left;
    RollingTime problem(scene, mesh_for(scanned.centre_path_length),
                        scanned.phi);
    std::optional<ContactEquation> contact;
    if (scene.contact == Contact::Smooth) contact.emplace(problem);
    NewtonOptions options;
    options.tolerance = 1e-10;
    options.max_iterations = 12;
    options.stop = stop;
    const NewtonResult result =
        NewtonSolver(problem, contact ? &*contact : nullptr)
            .solve(sample(scanned, problem), scanned.phi, options);
    out.newton_steps += result.iterations;
    if (stop.met()) break;
    ++lost;
    if (result.status != Status::Solved) continue;
    ContactCandidate found{ExtremalCurve(problem, result.point), result.phi};
    if (!agree(found, contact ? scanned.phi : scanned.centre_path_length,
               scanned.transit_time, kElsewhere)) {
      continue;
    }
    --lost;
    const double T = found.curve.transit_time();
    if (std::none_of(out.contacts.begin(), out.contacts.end(),
                     [&](const ContactCandidate& other) {
                       return agree(other, mark_of(found), T, kSame);
                     })) {
      out.contacts.push_back(std::move(found));
    }
  }
  out.remark = remark(scan, left, lost);
  return out;
}

}  // namespace brachisto
