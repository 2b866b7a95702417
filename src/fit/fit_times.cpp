// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "fit/fit_times.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "brachisto/math/clock.hpp"
#include "brachisto/math/index.hpp"
#include "math/dense.hpp"
#include "model/losses.hpp"
#include "report/text_table.hpp"

namespace brachisto::fit {

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr const char* kOffset = "offset";

/// Why the laws of motion do not hold at every angle, as they do where A > 0
/// and D > 0; null if they do.
const char* not_evaluable(const Scene& scene) {
  const Body& body = scene.body;
  const double least = (1.0 - body.eta_m) * (1.0 - body.eta_m);
  if (!(least + body.k > 0.0)) return "no body has so little inertia";
  return losses::bounded(body, scene.world.losses.factor(body))
             ? nullptr
             : "the losses are larger than any load";
}

/// The residuals of times, and their derivatives, by the unknowns: the
/// parameters and, last, the offset.
class Residuals {
 public:
  Residuals(const Scene& scene, PlaneCurvePtr centre,
            const std::vector<TimedPlace>& times, const Wanted& wanted)
      : scene_(scene),
        centre_(std::move(centre)),
        times_(times),
        wanted_(wanted) {}

  [[nodiscard]] Eigen::Index unknowns() const {
    return static_cast<Eigen::Index>(wanted_.parameters.size()) +
           (wanted_.offset ? 1 : 0);
  }
  [[nodiscard]] VectorXd start() const {
    VectorXd x = VectorXd::Zero(unknowns());
    Scene scene = scene_;
    for (Eigen::Index i = 0; i < num_parameters(); ++i) {
      x[i] = parameter(i).of(scene);
    }
    return x;
  }
  [[nodiscard]] Scene scene_at(const VectorXd& x) const {
    Scene scene = scene_;
    for (Eigen::Index i = 0; i < num_parameters(); ++i) {
      parameter(i).of(scene) = x[i];
    }
    return scene;
  }
  [[nodiscard]] double offset_in(const VectorXd& x) const {
    return wanted_.offset ? x[x.size() - 1] : 0.0;
  }

  /// The motion with those values, kept until others are asked for; null if
  /// there is none.
  const PrescribedMotion* motion_at(const VectorXd& x) {
    if (evaluations_ == 0 || x != at_) {
      at_ = x;
      ++evaluations_;
      motion_.reset();
      const Scene scene = scene_at(x);
      if (x.allFinite() && not_evaluable(scene) == nullptr) {
        motion_.emplace(scene, centre_);
      }
    }
    return motion_ && !motion_->stall() ? &*motion_ : nullptr;
  }
  /// Why there is none.
  [[nodiscard]] std::string stall() const {
    if (motion_) return motion_->stall()->message();
    const char* because =
        at_.allFinite() ? not_evaluable(scene_at(at_)) : nullptr;
    return because != nullptr ? because : "the numbers are not finite";
  }

  /// (t_i − t₀ − t(q_i; x))/σ_i; false if the body does not arrive.
  bool evaluate(const VectorXd& x, VectorXd& residuals) {
    const PrescribedMotion* motion = motion_at(x);
    if (motion == nullptr) return false;
    for (std::size_t i = 0; i < times_.size(); ++i) {
      const TimedPlace& row = times_[i];
      residuals[static_cast<Eigen::Index>(i)] =
          (row.t - offset_in(x) - motion->at(row.q).t) / row.sigma;
    }
    return true;
  }
  /// (∂t_i/∂x)/σ_i, of the prediction. \pre evaluate() was true there
  void derive(const VectorXd& x, MatrixXd& J) {
    const TimeSensitivity sensitivity(*motion_at(x));
    for (std::size_t i = 0; i < times_.size(); ++i) {
      J.row(static_cast<Eigen::Index>(i)) =
          gradient(sensitivity.at(times_[i].q), wanted_.offset ? 1.0 : 0.0) /
          times_[i].sigma;
    }
  }
  /// Of a time by the unknowns.
  [[nodiscard]] Eigen::RowVectorXd gradient(const SensitiveTime& time,
                                            double by_offset) const {
    Eigen::RowVectorXd row(unknowns());
    if (wanted_.offset) row[unknowns() - 1] = by_offset;
    for (Eigen::Index i = 0; i < num_parameters(); ++i) {
      row[i] = time.by[static_cast<std::size_t>(parameter(i).number)];
    }
    return row;
  }
  [[nodiscard]] std::string key(Eigen::Index i) const {
    return i < num_parameters() ? parameter(i).key : kOffset;
  }
  [[nodiscard]] int evaluations() const { return evaluations_; }

 private:
  [[nodiscard]] Eigen::Index num_parameters() const {
    return static_cast<Eigen::Index>(wanted_.parameters.size());
  }
  [[nodiscard]] const Parameter& parameter(Eigen::Index i) const {
    return *wanted_.parameters[static_cast<std::size_t>(i)];
  }

  const Scene& scene_;
  PlaneCurvePtr centre_;
  const std::vector<TimedPlace>& times_;
  const Wanted& wanted_;
  VectorXd at_;
  std::optional<PrescribedMotion> motion_;
  int evaluations_ = 0;
};

/// J with columns of length 1, what they were, and its singular values.
struct ScaledColumns {
  VectorXd norms;
  math::SingularValues of;

  explicit ScaledColumns(const MatrixXd& J) : norms(J.colwise().norm()) {
    const VectorXd inverse = norms.unaryExpr(
        [](double norm) { return norm > 0.0 ? 1.0 / norm : 0.0; });
    of = math::singular_values(J * inverse.asDiagonal());
  }
  /// Of the normal matrix.
  [[nodiscard]] double condition() const {
    const double root = of.values[0] / of.values[of.values.size() - 1];
    return root * root;
  }
};

/// \throws CannotFit  if the normal matrix is singular; jets leave a dependent
///                    column about 1e-13 of its length, whose square is far
///                    below
void check_told_apart(const ScaledColumns& columns, const Residuals& of) {
  constexpr double kSingular = 1e12;
  for (Eigen::Index i = 0; i < columns.norms.size(); ++i) {
    if (!(columns.norms[i] > 0.0)) {
      throw CannotFit(fmt::format("the times do not depend on {}", of.key(i)));
    }
  }
  const double condition = columns.condition();
  if (condition < kSingular) return;
  const VectorXd least =
      columns.of.right.col(columns.norms.size() - 1).cwiseAbs();
  constexpr double kTakesPart = 0.1;
  std::vector<std::string> names;
  for (Eigen::Index i = 0; i < least.size(); ++i) {
    if (least[i] > kTakesPart * least.maxCoeff()) names.push_back(of.key(i));
  }
  throw CannotFit(fmt::format(
      "these times cannot tell {} apart: they answer to all of them in one "
      "proportion (condition of the normal matrix {:.0e}); fit one less, or "
      "measure on a track of another shape",
      fmt::join(names, " and "), condition));
}

/// χ² ends where the body ceases to arrive, or to be one, and may still fall
/// there: that is no minimum, and errors about it mean nothing.
///
/// \param values  of the residuals, over sigma
void check_is_minimum(const MatrixXd& J, const VectorXd& values,
                      const std::vector<TimedPlace>& times, Residuals& of,
                      const VectorXd& x) {
  constexpr double kOfRounding = 1e-9, kSteep = 1e-3, kStep = 1e-6;
  double size = 0.0;  // of the times likewise
  for (const TimedPlace& time : times) {
    size = std::hypot(size, time.t / time.sigma);
  }
  if (!(values.norm() > kOfRounding * size)) return;
  bool steep = false;
  for (Eigen::Index i = 0; i < J.cols(); ++i) {
    const double slope = J.col(i).dot(values);
    if (!(std::abs(slope) > kSteep * J.col(i).norm() * values.norm())) continue;
    steep = true;
    VectorXd downhill = x;
    downhill[i] += std::copysign(kStep * std::max(1.0, std::abs(x[i])), slope);
    if (of.motion_at(downhill) != nullptr) continue;
    throw CannotFit(fmt::format(
        "χ² falls all the way to {} = {:.6g}, beyond which there is no motion: "
        "{}; are these times of this track?",
        of.key(i), x[i], of.stall()));
  }
  if (steep) {
    throw CannotFit(
        "χ² still falls where the least squares end; are these times of this "
        "track?");
  }
}

/// The values of the least χ².
VectorXd minimise(Residuals& residuals, std::size_t rows) {
  const math::SumOfSquares chi_squared{
      .rows = static_cast<Eigen::Index>(rows),
      .residuals =
          [&](const VectorXd& x, VectorXd& values) {
            // Where the body does not arrive any step back is a gain.
            constexpr double kFar = 1e30;
            if (!residuals.evaluate(x, values)) values.setConstant(kFar);
          },
      .jacobian =
          [&](const VectorXd& x, MatrixXd& J) {
            residuals.derive(x, J);
            J = -J;
          }};
  // χ² is flat about its minimum: its digits end at √ε of the values, which is
  // far within their errors, and ε of rounding ends what is asked for here.
  constexpr double kTolerance = 1e-12;
  const std::optional<VectorXd> x =
      math::least_sum_of_squares(chi_squared, residuals.start(), kTolerance);
  if (!x) {
    throw CannotFit(
        fmt::format("the least squares do not converge within {} evaluations",
                    residuals.evaluations()));
  }
  return *x;
}

}  // namespace

const Parameter* find_parameter(std::string_view key) {
  const auto* found = std::ranges::find(kParameters, key, &Parameter::key);
  return found == kParameters.end() ? nullptr : found;
}

std::string objection(const Parameter& parameter, const Scene& scene) {
  if (parameter.number == MotionNumber::Inertia && scene.body.ball) {
    return fmt::format(
        "{} of a ball is not fitted: its inertia is that of what it is made of",
        parameter.key);
  }
  if (parameter.of_bead == !scene.body.rolls()) return "";
  return parameter.of_bead
             ? fmt::format("{} is of a bead, and the body of the scene rolls",
                           parameter.key)
             : fmt::format(
                   "{} is of what rolls, and the body of the scene is "
                   "a bead",
                   parameter.key);
}

std::optional<double> Fit::reduced_chi_squared() const {
  if (!sigma_known || freedom == 0) return std::nullopt;
  return chi_squared / freedom;
}

std::optional<double> Fit::scatter() const {
  if (freedom == 0) return std::nullopt;
  double sum = 0.0;
  for (const Residual& row : residuals) sum += row.value() * row.value();
  return std::sqrt(sum / freedom);
}

Fit fit_times(const Scene& scene, const PlaneCurvePtr& centre,
              const std::vector<TimedPlace>& times, const Wanted& wanted) {
  Residuals residuals(scene, centre, times, wanted);
  const Eigen::Index n = residuals.unknowns();
  const auto rows = static_cast<Eigen::Index>(times.size());
  // Without sigma one row has to tell how good the times are.
  const Eigen::Index needed = n + (wanted.sigma_known ? 0 : 1);
  if (rows < needed) {
    throw CannotFit(fmt::format(
        "{} cannot tell {}{}; expected {} or more",
        report::counted(times.size(), "row"),
        report::counted(static_cast<std::size_t>(n), "number"),
        wanted.sigma_known ? "" : " and, without sigma, their errors", needed));
  }
  VectorXd x = residuals.start();
  MatrixXd J(rows, n);
  if (residuals.motion_at(x) == nullptr) {
    throw CannotFit(
        fmt::format("with the values of the file the body does not arrive: {}",
                    residuals.stall()));
  }
  residuals.derive(x, J);
  check_told_apart(ScaledColumns(J), residuals);
  x = minimise(residuals, times.size());

  residuals.derive(x, J);
  const ScaledColumns columns(J);
  check_told_apart(columns, residuals);
  VectorXd last(rows);
  residuals.evaluate(x, last);
  check_is_minimum(J, last, times, residuals, x);
  Fit out;
  out.scene = residuals.scene_at(x);
  out.chi_squared = last.squaredNorm();
  out.freedom = static_cast<int>(rows - n);
  out.sigma_known = wanted.sigma_known;
  out.condition = columns.condition();
  // (JᵀJ)⁻¹ from J = U Σ Vᵀ of the scaled columns.
  const VectorXd inverse = columns.of.values.cwiseInverse();
  const MatrixXd root = columns.norms.cwiseInverse().asDiagonal() *
                        columns.of.right * inverse.asDiagonal();
  MatrixXd covariance = root * root.transpose();
  if (!wanted.sigma_known) covariance *= out.chi_squared / out.freedom;
  const VectorXd errors = covariance.diagonal().cwiseSqrt();
  const VectorXd start = residuals.start();
  for (Eigen::Index i = 0; i < n; ++i) {
    out.estimates.push_back({residuals.key(i), start[i], x[i], errors[i]});
    std::vector<double>& row = out.correlation.emplace_back();
    for (Eigen::Index j = 0; j < n; ++j) {
      // Also where all residuals are zero.
      const double scale = root.row(i).norm() * root.row(j).norm();
      row.push_back(i == j ? 1.0 : root.row(i).dot(root.row(j)) / scale);
    }
  }
  const double t_0 = residuals.offset_in(x);
  const PrescribedMotion& motion = *residuals.motion_at(x);
  for (const TimedPlace& time : times) {
    out.residuals.push_back({time, t_0 + motion.at(time.q).t});
  }
  out.transit_time = motion.transit_time();
  const Eigen::RowVectorXd by =
      residuals.gradient(TimeSensitivity(motion).at(1.0), 0.0);
  out.transit_time_error = std::sqrt(by * covariance * by.transpose());
  out.evaluations = residuals.evaluations();
  return out;
}

}  // namespace brachisto::fit
