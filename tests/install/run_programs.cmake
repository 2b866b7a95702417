# cmake -DPROGRAMS=DIRECTORY -DPROBLEMS=DIRECTORY -DPACKAGE=KIND -P run_programs.cmake
#
# Runs the programs of an install tree and compares what they print with numbers that
# come from elsewhere.

# expect(CODE PATTERN PROGRAM ARGUMENTS…): exit code and what standard output matches.
function(expect code pattern program)
  execute_process(COMMAND ${PROGRAMS}/${program} ${ARGN}
    WORKING_DIRECTORY ${PROGRAMS}
    RESULT_VARIABLE result OUTPUT_VARIABLE out ERROR_VARIABLE err TIMEOUT 120)
  if(NOT result STREQUAL code OR NOT out MATCHES "${pattern}")
    message(SEND_ERROR "${program} ${ARGN}: exit code ${result}, not ${code}; "
      "or this does not match ${pattern}:\n${out}\n${err}")
  endif()
endfunction()

# docs/validation.md, reference_case.
expect(0 "tau = 5\\.09344446" solve_scene)
# By hand: √3, with the switch at 1/√3 and the speed 2/√3.
expect(0 "^verified: 1\\.73205080[78].*yes\nswitch at 0\\.5774, v there 1\\.1547" least_time)
if(PACKAGE STREQUAL "pkg-config")
  return()  # no more are built
endif()
expect(0 "tau = 5\\.09344446" read_track)
# The rows begin at rest in A and end in B.
expect(0 "\n +0\\.0000 +-?0\\.0000 +-?0\\.0000 .* 3\\.0000 +1\\.0000 +[0-9.]+\n$" read_track)
file(STRINGS ${PROGRAMS}/track/trajectory.csv rows)
list(LENGTH rows count)
if(count LESS 20)
  message(SEND_ERROR "track/trajectory.csv has ${count} lines")
endif()
expect(0 "tau = 5\\.09344446" read_track ${PROBLEMS}/paper/fig04_reference_case.yaml)
expect(1 "^$" read_track ${PROBLEMS}/no_such_file.yaml)
expect(0 "eta_m = 0\\.00: .*eta_m = 0\\.60: tau" follow_offset)
expect(130 "^eta_m = 0\\.00: [^\n]*\n$" follow_offset 0)
# A catenary: 2a sinh(1/2a) = 1.5, at the middle a (cosh(1/2a) − 1) deep, mean depth
# ∫ z ds / 1.5. With a ground at 0.4 two arcs of catenaries and a straight piece. 1000
# links err by about 1e-6.
expect(0 "^chain, .*yes\nmean depth 0\\.30269, at the middle 0\\.50263\n" hanging_rope)
expect(0 "^chain, .*yes\nmean depth 0\\.28520, at the middle 0\\.40000\n" hanging_rope 0.4)
# By hand: 2 = 2 √1 with p_s = −1; ∫ (6 − 12 t)²/2 = 6 with p_s = −12.
expect(0 "^time 2\\.000000, .*yes\n.*p_s -1\\.000.*\neffort 6\\.000000, .*yes\n.*p_s -12\\.000"
  double_integrator)
# By hand: 4/(9 l) = 4 at l = 1/9, by l −36; the cycloid of the bead.
expect(0 "optimality conditions: yes\n.*estimated error: yes\n.*4\\.000, by a higher wall -36\\.0" keeping_off)
expect(0 "^verified: 4\\.510563136[78], by x" fastest_bead)
