// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/report/trajectory_csv.hpp"

#include <fmt/format.h>

#include <iterator>

namespace brachisto::report {

std::string trajectory_csv(const Trajectory& trajectory) {
  std::string out =
      "u,t,x_c,z_c,x_cm,z_cm,x_b,z_b,theta,beta,v_c,omega,R_n,R_t,kappa_b\n";
  const bool rolls = trajectory.scene().body.rolls();
  const auto number = [](double value) {
    return fmt::format("{:.17g}", value);
  };
  const auto rolling = [&](double value) {
    return rolls ? number(value) : std::string{};
  };
  for (const TrajectoryPoint& row : trajectory.at_nodes()) {
    const Kinematics& motion = row.motion;
    fmt::format_to(
        std::back_inserter(out),
        "{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", number(row.u),
        number(row.t), number(row.centre.x), number(row.centre.z),
        number(motion.mass_centre.x), number(motion.mass_centre.z),
        number(motion.contact.x), number(motion.contact.z), rolling(row.theta),
        number(row.beta), number(motion.v_c), rolling(motion.omega),
        number(motion.R_n), rolling(motion.R_t), number(motion.kappa_b));
  }
  return out;
}

}  // namespace brachisto::report
