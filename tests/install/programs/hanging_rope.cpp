// A nonlinear program of one's own: a rope of 1000 links hangs between two
// nails, lies on the ground where it is too long, and takes the shape of least
// potential energy. hanging_rope [DEPTH OF THE GROUND]

#include <brachisto/brachisto.hpp>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace {

namespace nlp = brachisto::nlp;

constexpr double kNone = std::numeric_limits<double>::infinity();

/// minimise −Σ l (z_e + z_{e+1})/2  subject to
///     (l/2)² ≤ (x_{e+1} − x_e)² + (z_{e+1} − z_e)² ≤ l²   for every link e,
///     z_i ≤ ground,
/// with (x_i, z_i), z pointing down, the variables 2i and 2i + 1.
class HangingRope final : public nlp::Problem {
 public:
  HangingRope(int links, double length, double ground)
      : links_(links), l_(length / links) {
    const auto nodes = static_cast<std::size_t>(links) + 1;
    places_.assign(2 * nodes, {-kNone, kNone});
    for (std::size_t i = 0; i < nodes; ++i) places_[2 * i + 1].upper = ground;
    places_[0] = places_[1] = {0.0, 0.0};  // the nails, one metre apart
    places_[2 * nodes - 2] = {1.0, 1.0};
    places_[2 * nodes - 1] = {0.0, 0.0};
    for (int e = 0; e < links; ++e) {
      for (int j = 0; j < 4; ++j) jac_.add(e, 2 * e + j);
    }
    // Of each link's own entries below the diagonal only these two are not
    // zero; positions that links share occur twice and add up.
    for (int e = 0; e < links; ++e) {
      for (int j = 0; j < 4; ++j) hess_.add(2 * e + j, 2 * e + j);
      for (int j = 0; j < 2; ++j) hess_.add(2 * e + 2 + j, 2 * e + j);
    }
  }

  int num_variables() const override { return 2 * (links_ + 1); }
  int num_constraints() const override { return links_; }
  nlp::Range variable_range(int index) const override {
    return places_[static_cast<std::size_t>(index)];
  }
  nlp::Range constraint_range(int) const override {
    return {0.25 * l_ * l_, l_ * l_};
  }
  const nlp::SparsityPattern& jac_g_pattern() const override { return jac_; }
  const nlp::SparsityPattern& hess_lag_pattern() const override {
    return hess_;
  }

  /// Nodes are the separators; between two of them is the multiplier of their
  /// link. Without this the solver would be MUMPS.
  nlp::ChainStructure chain_structure() const override {
    nlp::ChainStructure chain;
    chain.num_links = links_;
    for (int i = 0; i <= links_; ++i)
      chain.block.insert(chain.block.end(), 2, 2 * i);
    for (int e = 0; e < links_; ++e) chain.block.push_back(2 * e + 1);
    return chain;
  }

  std::string variable_name(int i) const override {
    return (i % 2 == 0 ? "x[" : "z[") + std::to_string(i / 2) + "]";
  }
  std::string constraint_name(int e) const override {
    return "link[" + std::to_string(e) + "]";
  }
  std::string refusal() const override { return {}; }

 private:
  /// Coordinate j ∈ {0, 1} of the vector along a link.
  double along(int e, int j) const {
    const auto i = static_cast<std::size_t>(2 * e + j);
    return x_[i + 2] - x_[i];
  }

  bool do_set_point(std::span<const double> x) override {
    x_.assign(x.begin(), x.end());
    return true;  // defined everywhere
  }
  double do_eval_f() const override {
    double depth = 0.0;
    for (int e = 0; e < links_; ++e) {
      const auto i = static_cast<std::size_t>(2 * e + 1);
      depth += 0.5 * (x_[i] + x_[i + 2]);
    }
    return -l_ * depth;
  }
  void do_eval_grad_f(std::span<double> grad_f) const override {
    for (std::size_t i = 0; i < grad_f.size(); i += 2) {
      const bool end = i == 0 || i + 2 == grad_f.size();
      grad_f[i] = 0.0;
      grad_f[i + 1] = end ? -0.5 * l_ : -l_;
    }
  }
  void do_eval_g(std::span<double> g) const override {
    for (int e = 0; e < links_; ++e) {
      g[static_cast<std::size_t>(e)] =
          along(e, 0) * along(e, 0) + along(e, 1) * along(e, 1);
    }
  }
  void do_eval_jac_g(std::span<double> values) const override {
    auto value = values.begin();
    for (int e = 0; e < links_; ++e) {
      for (const double sign : {-2.0, 2.0}) {
        for (int j = 0; j < 2; ++j) *value++ = sign * along(e, j);
      }
    }
  }
  void do_eval_hess_lag(double /*objective_factor*/,
                        std::span<const double> lambda,
                        std::span<double> values) const override {
    auto value = values.begin();
    for (const double multiplier : lambda) {
      for (int j = 0; j < 4; ++j) *value++ = 2.0 * multiplier;
      for (int j = 0; j < 2; ++j) *value++ = -2.0 * multiplier;
    }
  }

  int links_;
  double l_;
  std::vector<double> x_;
  std::vector<nlp::Range> places_;
  nlp::SparsityPattern jac_, hess_;
};

}  // namespace

int main(int argc, char** argv) try {
  const int links = 1000;
  HangingRope rope(links, 1.5, argc > 1 ? std::atof(argv[1]) : kNone);

  brachisto::PrimalDual start;  // no multipliers: a cold start
  for (int i = 0; i <= links; ++i) {
    const double x = static_cast<double>(i) / links;
    start.x.insert(start.x.end(), {x, x * (1.0 - x)});
  }
  brachisto::IpoptOptions options;
  options.tolerance = 1e-9;
  const brachisto::SolverResult result =
      brachisto::solve_with_ipopt(rope, start, options);
  if (result.status != brachisto::Status::Solved) {
    std::fprintf(stderr, "%s\n", result.message.c_str());
    return 1;
  }
  // Moves the problem to the point, so that f can be asked for there.
  const auto residual = brachisto::nlp::kkt_residual(rope, result.point);
  std::printf("%s, KKT residual below 1e-8: %s\n",
              std::string(name(result.linear_solver)).c_str(),
              residual.max() < 1e-8 ? "yes" : "no");
  std::printf("mean depth %.5f, at the middle %.5f\n", -rope.eval_f() / 1.5,
              result.point.x[links + 1]);
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
