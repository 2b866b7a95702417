# Of the layers below, what a solve by shooting and a ride on a given path need.
set(sources
  math/dense.cpp math/gauss.cpp math/minima.cpp math/polynomial_basis.cpp math/roots.cpp
  math/stop_condition.cpp
  model/ball.cpp model/centre_curve.cpp model/contact.cpp model/cubic_spline.cpp model/cycloid.cpp
  model/field.cpp model/hamiltonian.cpp model/kinematics.cpp model/limits_check.cpp
  model/path_inequality.cpp model/plane_curve.cpp model/scene.cpp
  model/spline_curve.cpp model/start_angle.cpp model/start_limits.cpp
  model/start_under_limits.cpp model/units.cpp model/world_check.cpp
  model/world_hamiltonian.cpp
  ocp/chain_elimination.cpp
  extremal/arc_boundary.cpp extremal/arc_flow.cpp extremal/arc_newton.cpp
  extremal/arc_path.cpp extremal/arc_system.cpp extremal/continuation.cpp
  extremal/extremal_path.cpp extremal/shooting.cpp
  trajectory/grip.cpp trajectory/motion.cpp trajectory/prescribed_motion.cpp trajectory/prescribed_places.cpp trajectory/self_crossing.cpp
  model/limit_table.cpp  # last: its overloads are names of others
  playground/playground.cpp)
list(TRANSFORM sources PREPEND ${PROJECT_SOURCE_DIR}/src/)
# Compiled as one, like a unity build: Eigen is read once.
set(unity ${CMAKE_CURRENT_BINARY_DIR}/unity.cpp)
list(TRANSFORM sources REPLACE "(.+)" "#include \"\\1\"" OUTPUT_VARIABLE includes)
list(JOIN includes "\n" includes)
file(CONFIGURE OUTPUT ${unity} CONTENT "${includes}\n")
