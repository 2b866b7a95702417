// Solves a row of scenes, each from the solution of the one before, until all
// are solved, Ctrl-C is hit or time is over: follow_offset [SECONDS]

#include <atomic>
#include <brachisto/brachisto.hpp>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <string_view>

namespace {

// Nonzero: every solve that is under way stops at its next step.
std::atomic<int> interrupt{0};

}  // namespace

int main(int argc, char** argv) {
  std::signal(SIGINT, [](int) { interrupt = 1; });
  const brachisto::StopCondition budget(argc > 1 ? std::atof(argv[1]) : 60.0,
                                        &interrupt);

  brachisto::Scene scene;
  scene.L = 3.0;
  scene.H = 1.0;
  std::shared_ptr<const brachisto::Neighbour> neighbour;
  for (int percent = 0; percent <= 60; percent += 10) {
    scene.body = brachisto::Body::cylinder(0.3, percent / 100.0, 0.0, 0.5);

    brachisto::SolveHooks hooks;
    hooks.interrupt = &interrupt;
    hooks.neighbour = neighbour.get();
    // Called from within solve(), in this thread.
    hooks.progress = [&](std::string_view phase, const std::string& text) {
      std::fprintf(stderr, "0.%02d: %.*s %s\n", percent,
                   static_cast<int>(phase.size()), phase.data(), text.c_str());
      if (budget.met()) interrupt = 1;
    };

    const brachisto::Solution solution = brachisto::solve(scene, {}, hooks);
    if (!solution.verified()) {
      std::printf("eta_m = 0.%02d: %s\n", percent, solution.message.c_str());
      const bool stopped = solution.status == brachisto::Status::Interrupted;
      return stopped ? 130 : 1;
    }
    std::printf("eta_m = 0.%02d: tau = %.9f%s\n", percent,
                solution.motion()->tau(),
                solution.feasible() ? "" : ", infeasible");
    neighbour = solution.as_neighbour();
  }
}
