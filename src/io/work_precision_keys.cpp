// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// work_precision_keys(): which methods are run on which meshes.

#include "io/key_sections.hpp"
#include "io/work_precision_lists.hpp"

namespace brachisto::io {

std::vector<KeySpec> work_precision_keys() {
  constexpr double kMostRepetitions = 1000;
  return {
      {.path = "work_precision",
       .type = KeyType::Map,
       .description = "what `brachisto work-precision` runs; other verbs read "
                      "it and go their way"},
      {.path = "work_precision.methods",
       .type = KeyType::List,
       .fallback = "[{rolling_time: [1, 2, 3, 4, 5, 6]}, arc_length, "
                   "extremal, fsolve]",
       .bounds = "a list of rolling_time, arc_length, extremal, fsolve, "
                 "{rolling_time: [degrees]} and {fsolve: [arms]}",
       .description = "lines of the diagram; the arms of fsolve are rest, "
                      "release (the hybrid method with either datum), newton "
                      "and lifted, the first two if none is named",
       .read_list = read_methods},
      {.path = "work_precision.meshes",
       .type = KeyType::List,
       .fallback = "[10, 20, 40, 80]",
       .bounds = "a list of integers from 2 to 1000000",
       .description = "points of each line: elements of rolling_time, pieces "
                      "of arc_length, nodes of fsolve",
       .read_list = read_meshes},
      {.path = "work_precision.repetitions",
       .type = KeyType::Integer,
       .fallback = "5",
       .bounds = "from 1 to 1000",
       .description = "timed runs of a point, of which the median counts; "
                      "fewer where a run takes seconds",
       .interval = {1, kMostRepetitions},
       .set =
           [](ProblemFile& p, double v) {
             p.work_precision.repetitions = static_cast<int>(v);
           }},
      {.path = "work_precision.seconds_per_point",
       .type = KeyType::Number,
       .unit = "s",
       .fallback = "60",
       .bounds = "> 0",
       .description = "wall-clock time after which a point is given up",
       .interval = {.lower = 0.0, .lower_allowed = false},
       .set = [](ProblemFile& p,
                 double v) { p.work_precision.seconds_per_point = v; }},
  };
}

}  // namespace brachisto::io
