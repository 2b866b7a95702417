// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/report/result.hpp"

#include <fmt/format.h>

#include <iterator>

#include "brachisto/math/stop_condition.hpp"

namespace brachisto::report {

std::string trajectory_csv(const Motion& motion) {
  std::string out =
      "u,t,x_c,z_c,x_cm,z_cm,x_b,z_b,theta,beta,v_c,omega,R_n,R_t,kappa_b\n";
  const bool rolls = motion.scene().body.rolls();
  const auto number = [](double value) {
    return fmt::format("{:.17g}", value);
  };
  const auto rolling = [&](double value) {
    return rolls ? number(value) : std::string{};
  };
  for (const TrajectoryPoint& row : motion.at_nodes()) {
    check_stop();
    const Kinematics& at = row.motion;
    fmt::format_to(std::back_inserter(out),
                   "{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n",
                   number(row.u), number(row.t), number(row.centre.x),
                   number(row.centre.z), number(at.mass_centre.x),
                   number(at.mass_centre.z), number(at.contact.x),
                   number(at.contact.z), rolling(row.theta), number(row.beta),
                   number(at.v_c), rolling(at.omega), number(at.R_n),
                   rolling(at.R_t), number(at.kappa_b));
  }
  return out;
}

}  // namespace brachisto::report
