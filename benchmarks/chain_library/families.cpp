// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include <cmath>
#include <random>
#include <stdexcept>

#include "chain_library/separable_program.hpp"

namespace brachisto::benchmarks {

namespace {

using Number = SeparableProgram::Number;
using Element = SeparableProgram::Element;

constexpr double kFree = 1e20;

/// x' = (1 − y²) x − y + u, y' = x, cost x² + y² + u², by the trapezoidal rule.
void van_der_pol(const Element&, double h, const Number* v, Number& cost,
                 Number* rows) {
  const auto rate = [&](int at) {
    return (Number(1.0) - v[at + 1] * v[at + 1]) * v[at] - v[at + 1] +
           v[at + 2];
  };
  rows[0] = v[3] - v[0] - (rate(0) + rate(3)) * (0.5 * h);
  rows[1] = v[4] - v[1] - (v[0] + v[3]) * (0.5 * h);
  for (int i = 0; i < 6; ++i) cost += v[i] * v[i] * (0.5 * h);
}

/// A pendulum with a motor, over four steps of Runge and Kutta's.
void pendulum(const Element&, double h, const Number* v, Number& cost,
              Number* rows) {
  constexpr int kSteps = 4;
  const double step = h / kSteps;
  Number angle = v[0], speed = v[1];
  const auto bend = [&](const Number& at) { return v[2] - sin(at); };
  for (int i = 0; i < kSteps; ++i) {
    const Number a1 = speed, s1 = bend(angle);
    const Number a2 = speed + s1 * (0.5 * step);
    const Number s2 = bend(angle + a1 * (0.5 * step));
    const Number a3 = speed + s2 * (0.5 * step);
    const Number s3 = bend(angle + a2 * (0.5 * step));
    const Number a4 = speed + s3 * step;
    const Number s4 = bend(angle + a3 * step);
    angle += (a1 + a2 * 2.0 + a3 * 2.0 + a4) * (step / 6.0);
    speed += (s1 + s2 * 2.0 + s3 * 2.0 + s4) * (step / 6.0);
  }
  rows[0] = v[3] - angle;
  rows[1] = v[4] - speed;
  cost += v[2] * v[2] * h;
}

/// A block with two variables of its own and four parameters.
void block(const Element& e, double, const Number* v, Number& cost,
           Number* rows) {
  const double t = e.data;
  rows[0] = v[0] - sin(v[2] * t) * v[3];
  rows[1] = v[1] - v[0] * v[4] - v[5];
  const Number off = v[1] - Number(2.0 * std::sin(1.3 * t) + 0.5);
  cost += off * off + (v[0] * v[0]) * 1e-3;
}

/// Neighbours that should be alike, near given values, of a convex function
/// that is not quadratic.
void alike(const Element& e, double, const Number* v, Number& cost, Number*) {
  const Number off = v[0] - Number(e.data);
  cost += off * off;
  for (int i = 1; i < e.count; ++i) {
    const Number apart = v[0] - v[i];
    cost += sqrt(apart * apart + 1.0);
  }
}

using Make = SeparableProgram (*)(int size);

SeparableProgram make_van_der_pol(int size) {
  const int N = size / 3 + 1;
  SeparableProgram out;
  out.formulas = van_der_pol;
  out.step = 10.0 / N;
  for (int k = 0; k <= N; ++k) {
    const bool first = k == 0;
    out.add_variable(0.0, first ? 0.0 : -kFree, first ? 0.0 : kFree);
    out.add_variable(1.0, first ? 1.0 : -kFree, first ? 1.0 : kFree);
    out.add_variable(0.0, -0.3, 1.0);
    if (k == 0) continue;
    const int at = 3 * k - 3;
    out.elements.push_back(
        {{at, at + 1, at + 2, at + 3, at + 4, at + 5}, 6, 2, 0.0});
  }
  return out;
}

SeparableProgram make_pendulum(int size) {
  const int N = size / 3 + 1;
  SeparableProgram out;
  out.formulas = pendulum;
  out.step = 4.0 / N;
  for (int k = 0; k <= N; ++k) {
    const bool end = k == 0 || k == N;
    const double angle = 3.14159265358979 * k / N;
    out.add_variable(angle, end ? angle : -kFree, end ? angle : kFree);
    out.add_variable(end ? 0.0 : 0.8, end ? 0.0 : -kFree, end ? 0.0 : kFree);
    out.add_variable(0.1, -2.0, 2.0);
    if (k == 0) continue;
    const int at = 3 * k - 3;
    out.elements.push_back({{at, at + 1, at + 2, at + 3, at + 4}, 5, 2, 0.0});
  }
  return out;
}

SeparableProgram make_blocks(int size) {
  SeparableProgram out;
  out.formulas = block;
  for (const double start : {1.2, 1.0, 1.0, 0.3}) {
    out.add_variable(start, 0.0, 5.0);
  }
  const int blocks = size / 2;
  for (int k = 0; k < blocks; ++k) {
    const int a = out.add_variable(0.5), b = out.add_variable(0.5);
    out.elements.push_back({{a, b, 0, 1, 2, 3}, 6, 2, 3.0 * k / blocks});
  }
  return out;
}

/// Each variable and its neighbours ahead in a grid.
SeparableProgram make_grid(int size, int dimensions) {
  SeparableProgram out;
  out.formulas = alike;
  const int side =
      static_cast<int>(std::ceil(std::pow(size, 1.0 / dimensions) - 1e-9));
  int count = 1;
  for (int d = 0; d < dimensions; ++d) count *= side;
  std::mt19937 random(1);
  for (int i = 0; i < count; ++i) {
    out.add_variable(0.0);
    Element e{{i}, 1, 0, 1e-2 * static_cast<double>(random() % 1000)};
    for (int d = 0, stride = 1; d < dimensions; ++d, stride *= side) {
      if (i / stride % side + 1 == side) continue;
      e.variables[static_cast<std::size_t>(e.count++)] = i + stride;
    }
    out.elements.push_back(e);
  }
  return out;
}

/// Each variable and some that `next` says.
template <class Next>
SeparableProgram make_others(int size, int neighbours, Next&& next) {
  SeparableProgram out;
  out.formulas = alike;
  for (int i = 0; i < size; ++i) {
    out.add_variable(0.0);
    Element e{{i}, 1, 0, 10.0 * std::sin(0.37 * i * i)};
    for (int k = 0; k < neighbours; ++k) {
      const int other = next(i, k);
      if (other == i || other < 0 || other >= size) continue;
      e.variables[static_cast<std::size_t>(e.count++)] = other;
    }
    out.elements.push_back(e);
  }
  return out;
}

}  // namespace

const std::vector<std::string>& chain_families() {
  static const std::vector<std::string> all{"collocation", "shooting", "banded",
                                            "block-arrow"};
  return all;
}

const std::vector<std::string>& other_families() {
  static const std::vector<std::string> all{"plane", "cube", "random", "dense",
                                            "tree"};
  return all;
}

SeparableProgram make_program(const std::string& family, int size) {
  if (family == "collocation") return make_van_der_pol(size);
  if (family == "shooting") return make_pendulum(size);
  if (family == "block-arrow") return make_blocks(size);
  if (family == "plane") return make_grid(size, 2);
  if (family == "cube") return make_grid(size, 3);
  if (family == "banded") {
    return make_others(size, 3, [](int i, int k) { return i + 1 + k; });
  }
  std::mt19937 random(1);
  if (family == "random") {
    return make_others(size, 3, [&](int, int) {
      return static_cast<int>(random() % static_cast<unsigned>(size));
    });
  }
  if (family == "dense") {
    // Elements of eight at random, nine for each variable.
    SeparableProgram out = make_others(size, 0, [](int, int) { return 0; });
    for (int i = 0; i < 9 * size; ++i) {
      Element e{{}, SeparableProgram::kWidth, 0, 0.0};
      for (int& variable : e.variables) {
        variable = static_cast<int>(random() % static_cast<unsigned>(size));
      }
      out.elements.push_back(e);
    }
    return out;
  }
  if (family == "tree") {
    return make_others(size, 2, [](int i, int k) { return 2 * i + 1 + k; });
  }
  throw std::invalid_argument("no such family: " + family);
}

}  // namespace brachisto::benchmarks
