// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "math/roots.hpp"

#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>

namespace brachisto::math {

double find_root(const std::function<double(double)>& f, double lower,
                 double upper) {
  return find_root(f, lower, upper, f(lower), f(upper));
}

double find_root(const std::function<double(double)>& f, double lower,
                 double upper, double f_lower, double f_upper) {
  if (f_lower == 0.0) return lower;
  if (f_upper == 0.0) return upper;
  std::uintmax_t evaluations = 200;
  const boost::math::tools::eps_tolerance<double> tolerance(53);
  const auto [a, b] = boost::math::tools::toms748_solve(
      f, lower, upper, f_lower, f_upper, tolerance, evaluations);
  return std::abs(f(a)) <= std::abs(f(b)) ? a : b;
}

}  // namespace brachisto::math
