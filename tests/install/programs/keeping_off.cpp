// Bryson and Denham's problem: out and back with x <= 1/9. keeping_off

#include <brachisto/ocp.hpp>
#include <cstdio>
#include <fstream>

namespace ocp = brachisto::ocp;

struct Push : ocp::Sizes<2, 1> {
  template <class S>
  Rates<S> rates(const Point<S>& at) const {
    const S& u = at.controls[0];
    return {u * u * 0.5, {at.states[1], u}};
  }
};

int main() {
  const ocp::Problem problem(
      Push{}, {.name = "keeping off",
               .states = {{.name = "x", .upper = 1.0 / 9, .start = 0, .end = 0},
                          {.name = "v", .start = 1.0, .end = -1.0}},
               .controls = {{.name = "u"}},
               .duration = ocp::Duration::fixed(1.0)});
  const ocp::Answer answer = problem.solve();
  for (const ocp::Check& check : answer.certificate) {
    std::printf("%s: %s\n", check.name.c_str(), check.passed() ? "yes" : "no");
  }
  std::printf("%.3f, by a higher wall %.1f\n", answer.cost,
              answer.prices.front().by_upper);
  std::ofstream("keeping_off.csv") << answer.csv();
  std::ofstream("keeping_off.svg") << answer.svg();
}
