// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What formulas for any scalar compute their constants with.

#pragma once

#include "brachisto/math/jet.hpp"

namespace brachisto::math {

template <class Scalar>
struct ConstantType {
  using type = double;
};
template <class Scalar>
requires requires {
  typename Scalar::Constant;
}
struct ConstantType<Scalar> {
  using type = typename Scalar::Constant;
};
template <class Real, int Size>
struct ConstantType<Jet1<Real, Size>> : ConstantType<Real> {};
template <class Real, int Size>
struct ConstantType<Jet2<Real, Size>> : ConstantType<Real> {};

/// double, unless a scalar asks for more by its type `Constant`, as one that
/// encloses what it computes has to: then no constant of a formula is rounded
/// before it comes to it.
template <class Scalar>
using ConstantOf = typename ConstantType<Scalar>::type;

}  // namespace brachisto::math
