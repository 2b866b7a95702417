// A cart in the least time: it is pushed by 2 and braked by 1. least_time

#include <brachisto/ocp.hpp>
#include <cstdio>

namespace ocp = brachisto::ocp;

/// Two states (s, v), one control.
struct Cart : ocp::Sizes<2, 1> {
  template <class S>
  Rates<S> rates(const Point<S>& at) const {
    return {S(1.0), {at.states[1], at.controls[0]}};
  }
};

int main() {
  const ocp::Problem cart(
      Cart{},
      {.name = "cart",
       .states = {{.name = "s", .unit = "m", .start = 0.0, .end = 1.0},
                  {.name = "v", .unit = "m/s", .start = 0.0, .end = 0.0}},
       .controls = {{.name = "push", .lower = -1.0, .upper = 2.0}}});
  const ocp::Answer answer = cart.solve();
  std::printf("%s: %.9f, to within 1e-9: %s\n",
              answer.verified() ? "verified" : answer.why_not().c_str(),
              answer.cost, answer.estimated_error < 1e-9 ? "yes" : "no");
  std::printf("switch at %.4f, v there %.4f\n", answer.junctions.front(),
              answer.at(answer.junctions.front()).states[1]);
}
