#include <brachisto/brachisto.hpp>
#include <cstdio>

int main() {
  brachisto::Scene scene;
  scene.body = brachisto::Body::cylinder(1.0 / 3, 2.0 / 3, 0.0, 0.5);
  scene.L = 3.0;
  scene.H = 1.0;
  const brachisto::Solution solution = brachisto::solve(scene);
  if (!solution.verified()) return 1;
  std::printf("tau = %.12f\n", solution.motion()->tau());
}
