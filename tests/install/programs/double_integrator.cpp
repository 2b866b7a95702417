// An optimal-control problem of one's own: a cart is pushed from rest at 0 to
// rest at 1, in the least time or with the least effort. double_integrator

#include <array>
#include <brachisto/brachisto.hpp>
#include <cstdio>
#include <exception>

namespace {

namespace ocp = brachisto::ocp;

/// s' = v, v' = u, the states being (s, v) and behind them the control u;
/// minimise ∫ 1 dt with −1 ≤ u ≤ 1, or ∫ u²/2 dt.
struct Cart {
  bool least_effort;

  static constexpr std::size_t kStates = 2;
  /// Written once for every Scalar: derivatives follow from this text.
  template <class Scalar>
  ocp::Rates<Scalar, 2> rates(const std::array<Scalar, 3>& yu) const {
    const auto& [s, v, u] = yu;
    return {least_effort ? u * u * 0.5 : Scalar(1.0), {v, u}};
  }

  std::size_t num_limits() const { return least_effort ? 0 : 1; }
  template <class Scalar>
  Scalar limit(std::size_t /*number*/, const std::array<Scalar, 3>& yu) const {
    return yu[2];
  }
  ocp::Bounds bounds(std::size_t /*number*/) const { return {-1.0, 1.0}; }
  const char* limit_name(std::size_t /*number*/) const { return "push"; }
  const char* state_name(std::size_t i) const { return i == 0 ? "s" : "v"; }
};

}  // namespace

int main() try {
  for (const bool least_effort : {false, true}) {
    ocp::Ends<2> ends{.start = {0.0, 0.0}, .end = {1.0, 0.0}, .duration = {}};
    if (least_effort) ends.duration = 1.0;
    // Eight elements with polynomials of degree three.
    ocp::LeastCost problem(Cart{least_effort}, brachisto::uniform_mesh(3, 8),
                           ends);
    brachisto::IpoptOptions options;
    options.tolerance = 1e-10;
    const brachisto::SolverResult result =
        brachisto::solve_with_ipopt(problem, problem.straight_guess(), options);
    if (result.status != brachisto::Status::Solved) {
      std::fprintf(stderr, "%s\n", result.message.c_str());
      return 1;
    }
    // Moves the problem to the point, so that the cost can be asked for there.
    const double residual =
        brachisto::nlp::kkt_residual(problem, result.point).max();
    std::printf("%s %.6f, KKT residual below 1e-8: %s\n",
                least_effort ? "effort" : "time", problem.eval_f(),
                residual < 1e-8 ? "yes" : "no");
    for (const auto& place : problem.path(result.point)) {
      if (place.s > 0.0 && place.s < 0.9 * result.point.x.back()) continue;
      std::printf("  t %.3f  s %.3f  v %.3f  p_s %.3f  u %.3f\n", place.s,
                  place.states[0], place.states[1], place.costates[0],
                  place.control);
    }
  }
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
