// A bead from rest to a place 3 away and 1 below. fastest_bead

#include <brachisto/ocp.hpp>
#include <cmath>
#include <cstdio>

namespace ocp = brachisto::ocp;

/// x, z downwards, v, and the slope for a control; g = 1/2.
struct Bead : ocp::Sizes<3, 1> {
  template <class S>
  Rates<S> rates(const Point<S>& at) const {
    const S& v = at.states[2];
    const S c = cos(at.controls[0]), s = sin(at.controls[0]);
    return {S(1.0), {v * c, v * s, s * 0.5}};
  }
};

int main() {
  const auto root = [](double share) { return std::sqrt(share); };
  const auto turning = [](double share) { return 1.5 - 2.0 * share; };
  const ocp::Problem bead(
      Bead{},
      {.name = "bead",
       .states = {{.name = "x", .start = 0.0, .end = 3.0},
                  {.name = "z", .start = 0.0, .end = 1.0},
                  {.name = "v", .lower = 0.0, .start = 0.0, .guess = root}},
       .controls =
           {{.name = "slope", .lower = -2, .upper = 2, .guess = turning}},
       .duration = {.guess = 4.0}});
  const ocp::Answer answer = bead.solve({.tolerance = 1e-11});
  std::printf("%s: %.10f, by x %.6f\n",
              answer.verified() ? "verified" : answer.why_not().c_str(),
              answer.cost, answer.by_end[0]);
}
