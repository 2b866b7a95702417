// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "proof/root.hpp"

#include <arb_mat.h>

#include <algorithm>
#include <cmath>

namespace brachisto::proof {

namespace {

/// Of a matrix near the middle of one.
Matrix inverse_of_middle(const Matrix& of) {
  const auto size = static_cast<slong>(of.size());
  arb_mat_t a, b;
  arb_mat_init(a, size, size);
  arb_mat_init(b, size, size);
  for (slong i = 0; i < size; ++i) {
    for (slong j = 0; j < size; ++j) {
      const Real& entry =
          of[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
      arb_set(arb_mat_entry(a, i, j), entry.middle().get());
    }
  }
  const bool regular = arb_mat_inv(b, a, working_bits) != 0;
  Matrix out(of.size(), Vector(of.size()));
  for (slong i = 0; regular && i < size; ++i) {
    for (slong j = 0; j < size; ++j) {
      Real& entry =
          out[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
      arb_set(entry.get(), arb_mat_entry(b, i, j));
      entry = entry.middle();
    }
  }
  arb_mat_clear(a);
  arb_mat_clear(b);
  if (!regular) throw NotProven("the equations of the ends are singular");
  return out;
}

Vector product(const Matrix& a, const Vector& v) {
  Vector out(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < v.size(); ++j) out[i] += a[i][j] * v[j];
  }
  return out;
}

/// In units of these.
double largest(const Vector& of, const std::vector<double>& units) {
  double out = 0.0;
  for (std::size_t i = 0; i < of.size(); ++i) {
    out = std::max(out, of[i].abs().upper() / units[i]);
  }
  return out;
}

Vector middle_of(const Vector& box) {
  Vector out;
  for (const Real& each : box) out.push_back(each.middle());
  return out;
}

/// C, of which nothing is promised.
Matrix rough_inverse(const ShootingSystem& system, const Vector& at) {
  const Bits bits(kRough.bits);
  return inverse_of_middle(system.evaluate(at, kRough, true).slopes);
}

/// K, which holds every root that X holds.
///
/// \param missed  encloses F(m)
/// \param slopes  enclose F'(X)
Vector image(const Vector& box, const Matrix& inverse, const Vector& missed,
             const Matrix& slopes) {
  const std::size_t size = box.size();
  const Vector step = product(inverse, missed);
  Vector out(size);
  for (std::size_t i = 0; i < size; ++i) {
    Real rest;
    for (std::size_t k = 0; k < size; ++k) {
      Real contracts(i == k ? 1.0 : 0.0);
      for (std::size_t j = 0; j < size; ++j) {
        if (arb_is_zero(slopes[j][k].get()) != 0) continue;
        contracts = contracts - inverse[i][j] * slopes[j][k];
      }
      rest += contracts * (box[k] - box[k].middle());
    }
    out[i] = box[i].middle() - step[i] + rest;
  }
  return out;
}

/// Whether K has to lie in the interior of X, which shows that X holds a root.
enum class Holds { IsAsked, IsKnown };

Root krawczyk(const ShootingSystem& system, const Vector& box,
              const Matrix& inverse, const Accuracy& accuracy, Holds holds) {
  const Vector middle = middle_of(box);
  const ShootingSystem::Value centre = system.evaluate(middle, accuracy, false);
  const ShootingSystem::Value over = system.evaluate(box, accuracy, true);
  Root out{box, image(box, inverse, centre.missed, over.slopes), centre.ends,
           over.steps};
  for (std::size_t i = 0; i < box.size() && holds == Holds::IsAsked; ++i) {
    if (!out.found[i].finite() || !out.found[i].inside(box[i])) {
      throw TooFewBits(
          "Krawczyk's operator does not map the box into itself: it holds no "
          "root, or the precision is too low");
    }
  }
  // y(m) + y'(X) (x − m) for every x of the part found.
  const std::size_t numbers = system.per_arc() - 1;
  for (std::size_t a = 0; a < out.ends.size(); ++a) {
    const std::size_t begin = a * system.per_arc(), length = begin + numbers;
    for (std::size_t i = 0; i < kComponents; ++i) {
      Real& end = out.ends[a][i];
      for (std::size_t j = 0; j < numbers; ++j) {
        end += system.slope(over.ends[a], a, i, j) *
               (out.found[begin + j] - middle[begin + j]);
      }
      end += over.rates[a][i] * (out.found[length] - middle[length]);
    }
    if (!out.found[length].positive()) {
      throw TooFewBits("that an arc has a length is not shown");
    }
  }
  system.check_ends(out.ends);
  return out;
}

/// Newton's method with one inverse, to the digits of half the bits.
/// \param at  [in,out] middles alone
void converge(const ShootingSystem& system, Vector& at, const Matrix& inverse,
              Accuracy accuracy) {
  constexpr int kMostSteps = 12;
  accuracy.near = true;
  const std::vector<double> units = system.units();
  const double enough = std::ldexp(1.0, -accuracy.bits / 2);
  double step = 1.0;
  for (int i = 0; i < kMostSteps && step > enough; ++i) {
    const Vector by =
        product(inverse, system.evaluate(at, accuracy, false).missed);
    step = largest(by, units);
    if (!(step < 1.0)) throw NotProven("Newton's method does not converge");
    for (std::size_t k = 0; k < at.size(); ++k) {
      at[k] = (at[k] - by[k]).middle();
    }
  }
  if (!(step <= enough)) {
    throw TooFewBits("Newton's method stops short of the precision");
  }
}

}  // namespace

Root find_root(const ShootingSystem& system, Vector near,
               const Accuracy& accuracy) {
  constexpr double kTimes = 1024.0;
  const Bits bits(accuracy.bits);
  system.settle(near);
  const Matrix inverse = rough_inverse(system, near);
  converge(system, near, inverse, accuracy);
  const std::vector<double> units = system.units();
  const auto in_a_box = [&](double radius) {
    Vector box;
    for (std::size_t k = 0; k < near.size(); ++k) {
      box.push_back(near[k].widened(Real(radius * units[k])));
    }
    return krawczyk(system, box, inverse, accuracy, Holds::IsAsked);
  };
  const double usual = std::ldexp(1.0, -(2 * accuracy.bits) / 5);
  try {
    return in_a_box(usual);
  } catch (const NotProven&) {
    // Where wrapping is bad, one that is not much wider than what one
    // integration leaves open.
    const double radius =
        kTimes *
        largest(product(inverse, system.evaluate(near, accuracy, false).missed),
                units);
    if (!(radius < usual)) throw;
    return in_a_box(radius);
  }
}

Root verify_root(const ShootingSystem& system, const Vector& box,
                 const Accuracy& accuracy) {
  const Bits bits(accuracy.bits);
  return krawczyk(system, box, rough_inverse(system, middle_of(box)), accuracy,
                  Holds::IsAsked);
}

Vector narrowed(const ShootingSystem& system, const Vector& found,
                const Accuracy& accuracy) {
  const Bits bits(accuracy.bits);
  return krawczyk(system, found, rough_inverse(system, middle_of(found)),
                  accuracy, Holds::IsKnown)
      .found;
}

}  // namespace brachisto::proof
