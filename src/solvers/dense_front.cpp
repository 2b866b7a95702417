// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "solvers/dense_front.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "brachisto/math/index.hpp"
#include "solvers/numeric_factorisation.hpp"

namespace brachisto {

namespace {

using Front = FrontStack::Front;

/// Exchanges unknowns i and j.
void exchange(Front& front, int i, int j) {
  if (i == j) return;
  const int n = front.size();
  std::swap(front.unknowns[at(i)], front.unknowns[at(j)]);
  for (int c = 0; c < n; ++c) std::swap(front.at(i, c), front.at(j, c));
  for (int r = 0; r < n; ++r) std::swap(front.at(r, i), front.at(r, j));
}

/// Largest entry of a column below row `from`, rows `skip` left out, and the
/// candidate row where the largest among candidates stands.
struct ColumnMax {
  double value = 0.0;
  double among_candidates = 0.0;
  int row = -1;
};

ColumnMax column_max(Front& front, int column, int from, int skip) {
  double* const a = &front.at(0, column);
  // Zeros are never the largest.
  const double left_out[] = {std::exchange(a[column], 0.0),
                             skip < 0 ? 0.0 : std::exchange(a[skip], 0.0)};
  ColumnMax max;
  max.among_candidates = largest_of(a + from, front.candidates - from);
  max.value = std::max(
      max.among_candidates,
      largest_of(a + front.candidates, front.size() - front.candidates));
  if (max.among_candidates > 0.0) {
    max.row = from;
    while (!(std::abs(a[max.row]) == max.among_candidates)) ++max.row;
  }
  if (skip >= 0) a[skip] = left_out[1];
  a[column] = left_out[0];
  return max;
}

/// Sorts candidates by how many entries they have. Where many limits hold or
/// might, most have two or a handful, and who goes first keeps the others so.
void begin_with_the_sparse(Front& front) {
  const int n = front.size();
  std::vector<int> count(at(n));
  for (int j = 0; j < n; ++j) {
    const double* const a = &front.at(0, j);
    count[at(j)] = n - static_cast<int>(std::count(a, a + n, 0.0));
  }
  for (int k = 0; k < front.candidates; ++k) {
    const auto from = count.begin() + k;
    const auto least = std::min_element(from, count.begin() + front.candidates);
    exchange(front, k, static_cast<int>(least - count.begin()));
    std::iter_swap(from, least);
  }
}

}  // namespace

void FrontStack::clear() {
  records_.clear();
  widths_.clear();
  rows_.clear();
  values_.clear();
  negative_ = zero_ = 0;
  updates_ = 0.0;
}

/// Moves an acceptable pivot to k (and k + 1). Candidates are looked through
/// from `next` on, around: those before it were no pivots when they were last
/// looked at, and mostly are none yet.
bool FrontStack::choose(Front& front, int k, const Rule& rule, int& next,
                        Width& width) {
  const auto take = [&](int row, int partner) {
    next = row + 1;
    exchange(front, k, row);
    if (partner >= 0) exchange(front, k + 1, partner == k ? row : partner);
    width = partner < 0 ? Width::Single : Width::Pair;
    return true;
  };
  constexpr int kAlone = -1;
  // The largest of the ratios 1/multiplier that pivots offered.
  double best = 0.0;
  int best_row = -1;
  int best_partner = kAlone;
  for (int tried = k; tried < front.candidates; ++tried, ++next) {
    if (next < k || next >= front.candidates) next = k;
    const int j = next;
    const ColumnMax max = column_max(front, j, k, -1);
    const double diagonal = std::abs(front.at(j, j));
    if (diagonal <= rule.zero && max.value <= rule.zero) {
      // A null vector: a pivot of zero with nothing below.
      for (int i = k; i < front.size(); ++i) {
        front.at(i, j) = front.at(j, i) = 0.0;
      }
      return take(j, kAlone);
    }
    const double single = diagonal / max.value;
    if (diagonal > rule.zero && !(single < rule.threshold)) {
      return take(j, kAlone);
    }
    if (single > best) {
      best = single;
      best_row = j;
      best_partner = kAlone;
    }
    if (max.row < 0) continue;
    const int r = max.row;
    const double a = front.at(j, j);
    const double b = front.at(r, j);
    const double c = front.at(r, r);
    const double det = std::abs(a * c - b * b);
    const double largest = std::max({std::abs(a), std::abs(b), std::abs(c)});
    // A determinant that is all cancellation is no pivot.
    const double regular = det / (std::abs(a * c) + b * b);
    // Whether at most so much can be of use: columns are looked through only
    // where it can.
    const auto is_of_use = [&](double most) {
      return !(most < rule.threshold && most <= best);
    };
    if (!is_of_use(regular)) continue;
    const double below_j = column_max(front, j, k, r).value;
    if (!is_of_use(det / (std::max(std::abs(b), std::abs(c)) * below_j))) {
      continue;
    }
    const double below_r = column_max(front, r, k, j).value;
    const double growth =
        std::max(std::abs(c) * below_j + std::abs(b) * below_r,
                 std::abs(b) * below_j + std::abs(a) * below_r) /
        det;
    const double pair = std::min(1.0 / growth, regular);
    if (largest > rule.zero && !(pair < rule.threshold)) {
      return take(j, r);
    }
    if (pair > best) {
      best = pair;
      best_row = j;
      best_partner = r;
    }
  }
  if (!rule.complete || best_row < 0) return false;
  return take(best_row, best_partner);
}

/// Eliminates the pivot at k (and k + 1). Its columns take the factor: the
/// inverse of the pivot, below it the multipliers.
void FrontStack::step(Front& front, int k, Width width) {
  const int n = front.size();
  const auto book = [&](double pivots, int columns) {
    const int left = n - k - static_cast<int>(pivots);
    updates_ += pivots * n * n * (left > 0 ? 1.0 * columns / left : 1.0);
  };
  double* const p = &front.at(0, k);
  if (width == Width::Single) {
    const double d = p[k];
    const double inverse = d == 0.0 ? 0.0 : 1.0 / d;
    if (d < 0.0) ++negative_;
    if (d == 0.0) ++zero_;
    for (int i = k + 1; i < n; ++i) local_l_[at(i)] = p[i] * inverse;
    book(1.0,
         subtract_outer(front.values.data(), n, k + 1, local_l_.data(), p));
    p[k] = inverse;
    std::copy_n(&local_l_[at(k) + 1], n - k - 1, p + k + 1);
    return;
  }
  double* const q = &front.at(0, k + 1);
  const double a = p[k];
  const double b = p[k + 1];
  const double c = q[k + 1];
  const double det = a * c - b * b;
  if (det < 0.0) {
    ++negative_;
  } else if (a < 0.0) {
    negative_ += 2;
  }
  const double i_pp = c / det;
  const double i_pq = -b / det;
  const double i_qq = a / det;
  for (int i = k + 2; i < n; ++i) {
    local_l_[at(i)] = i_pp * p[i] + i_pq * q[i];
    local_m_[at(i)] = i_pq * p[i] + i_qq * q[i];
  }
  book(2.0, subtract_outer(front.values.data(), n, k + 2, local_l_.data(), p,
                           local_m_.data(), q));
  p[k] = i_pp;
  p[k + 1] = i_pq;
  q[k + 1] = i_qq;
  std::copy_n(&local_l_[at(k) + 2], n - k - 2, p + k + 2);
  std::copy_n(&local_m_[at(k) + 2], n - k - 2, q + k + 2);
}

void FrontStack::eliminate(Front& front, const Rule& rule) {
  constexpr int kManyCandidates = 64;
  const int n = front.size();
  if (front.candidates > kManyCandidates) begin_with_the_sparse(front);
  local_l_.resize(std::max(local_l_.size(), at(n) + 1));
  local_m_.resize(local_l_.size());
  Record record;
  record.rows = rows_.size();
  record.size = n;
  Width width = Width::Single;
  int k = 0, next = 0;
  while (k < front.candidates && choose(front, k, rule, next, width)) {
    step(front, k, width);
    widths_.push_back(width);
    if (width == Width::Pair) widths_.push_back(width);
    k += width == Width::Pair ? 2 : 1;
  }
  record.eliminated = k;
  if (k > 0) {
    // Only now: exchanges move the rows of earlier multipliers too.
    double* value = record.values = values_.top(record.num_values());
    for (int j = 0; j < k; ++j) {
      value = std::copy(&front.at(0, j) + j, &front.at(0, j) + n, value);
    }
    values_.keep(record.num_values());
    rows_.insert(rows_.end(), front.unknowns.begin(), front.unknowns.end());
    widths_.resize(rows_.size(), Width::Single);
    records_.push_back(record);
  }
  // What is left moves to the front of the matrix.
  for (int j = k; j < n; ++j) {
    for (int i = k; i < n; ++i) {
      front.values[at(i - k) + at(n - k) * at(j - k)] = front.at(i, j);
    }
  }
  front.unknowns.erase(front.unknowns.begin(), front.unknowns.begin() + k);
  front.values.resize(at(n - k) * at(n - k));
  front.candidates -= k;
}

void FrontStack::forward(std::span<double> x) const {
  for (const Record& record : records_) {
    const int n = record.size;
    const int* const rows = rows_.data() + record.rows;
    const Width* const widths = widths_.data() + record.rows;
    const double* l = record.values;
    local_.resize(std::max(local_.size(), at(n)));
    for (int i = 0; i < n; ++i) local_[at(i)] = x[at(rows[i])];
    for (int k = 0; k < record.eliminated;) {
      const double y_p = local_[at(k)];
      if (widths[k] == Width::Single) {
        local_[at(k)] = y_p * l[0];
        for (int i = k + 1; i < n; ++i) local_[at(i)] -= l[i - k] * y_p;
        l += n - k;
        k += 1;
      } else {
        const double* const m = l + n - k;
        const double y_q = local_[at(k + 1)];
        local_[at(k)] = l[0] * y_p + l[1] * y_q;
        local_[at(k + 1)] = l[1] * y_p + m[0] * y_q;
        for (int i = k + 2; i < n; ++i) {
          local_[at(i)] -= l[i - k] * y_p + m[i - k - 1] * y_q;
        }
        l = m + n - k - 1;
        k += 2;
      }
    }
    for (int i = 0; i < n; ++i) x[at(rows[i])] = local_[at(i)];
  }
}

void FrontStack::backward(std::span<double> x) const {
  for (std::size_t f = records_.size(); f-- > 0;) {
    const Record& record = records_[f];
    const int n = record.size;
    const int* const rows = rows_.data() + record.rows;
    const Width* const widths = widths_.data() + record.rows;
    // From the end of this front's values backwards.
    const double* l = record.values + record.num_values();
    local_.resize(std::max(local_.size(), at(n)));
    for (int i = 0; i < n; ++i) local_[at(i)] = x[at(rows[i])];
    for (int k = record.eliminated; k > 0;) {
      // The first row past the pivot is k.
      const bool pair = widths[k - 1] == Width::Pair;
      l -= n - k + 1;
      double by_last = 0.0;
      for (int i = k; i < n; ++i) by_last += l[i - k + 1] * local_[at(i)];
      local_[at(k - 1)] -= by_last;
      --k;
      if (!pair) continue;
      l -= n - k + 1;
      double by_first = 0.0;
      for (int i = k + 1; i < n; ++i) by_first += l[i - k + 1] * local_[at(i)];
      local_[at(k - 1)] -= by_first;
      --k;
    }
    for (int i = 0; i < record.eliminated; ++i) {
      x[at(rows[i])] = local_[at(i)];
    }
  }
}

}  // namespace brachisto
