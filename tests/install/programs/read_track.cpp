// Solves a scene and reads the track: read_track [PROBLEM.yaml]

#include <brachisto/brachisto.hpp>
#include <cstdio>
#include <exception>
#include <string>

int main(int argc, char** argv) try {
  brachisto::Scene scene;
  brachisto::SolveOptions options;
  if (argc > 1) {
    // What the command `brachisto solve` reads, checked as strictly.
    const auto file = brachisto::io::read_problem_file(argv[1]);
    scene = file.scene;
    options = file.options;
  } else {
    // r, η_m, θ_m and k; B lies 3 m to the right of A and 1 m below it.
    scene.body = brachisto::Body::cylinder(1.0 / 3, 2.0 / 3, 0.0, 0.5);
    scene.L = 3.0;
    scene.H = 1.0;
    options.use<brachisto::Collocation>().discretisation.tolerance = 1e-11;
  }

  const brachisto::Solution solution = brachisto::solve(scene, options);
  if (!solution.verified()) {
    std::fprintf(stderr, "%s\n", solution.message.c_str());
    return 1;
  }
  const brachisto::Motion& motion = *solution.motion();
  std::printf("T = %.10f s, tau = %.10f, relative error %.0e\n",
              motion.transit_time(), motion.tau(),
              solution.estimated_error.value_or(0.0));
  for (const std::string& reason : solution.infeasible_because()) {
    std::printf("infeasible: %s\n", reason.c_str());
  }
  // Eleven places of the track; z points down, R_n is in units of m g.
  std::printf("%8s %8s %8s %8s\n", "t", "x_b", "z_b", "R_n");
  for (int i = 0; i <= 10; ++i) {
    const brachisto::TrajectoryPoint place = motion.at(i / 10.0);
    std::printf("%8.4f %8.4f %8.4f %8.4f\n", place.t, place.motion.contact.x,
                place.motion.contact.z, place.motion.R_n);
  }
  // All nodes, as the command writes them.
  brachisto::report::write_files(
      "track", {{"trajectory.csv", brachisto::report::trajectory_csv(motion)}},
      /*force=*/true);
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
