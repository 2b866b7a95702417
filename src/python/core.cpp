// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// brachisto._core: the library for the Python package around it. What is text
// in the library, results and effective inputs as JSON, is text here.

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <future>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "brachisto/io/problem_file.hpp"
#include "brachisto/report/result.hpp"
#include "brachisto/study/solve.hpp"
#include "brachisto/version.hpp"
#include "design/best_track.hpp"
#include "io/consistency.hpp"
#include "plot/racers.hpp"
#include "python/views.hpp"

namespace py = pybind11;
using namespace brachisto;
using python::Answered;

namespace {

/// What stands for a file where a program states a problem by keywords.
constexpr const char* kKeywords = "<keywords>";

/// Text of others, whose bytes need not be UTF-8.
py::str to_python(const std::string& text) {
  return py::reinterpret_steal<py::str>(PyUnicode_DecodeUTF8(
      text.data(), static_cast<py::ssize_t>(text.size()), "replace"));
}

// ---- Problems, and what is wrong with them.

/// Keywords have neither lines nor flags of a command line.
std::vector<io::Diagnostic> told_to_programs(
    std::vector<io::Diagnostic> diagnostics) {
  for (io::Diagnostic& diagnostic : diagnostics) {
    if (diagnostic.line > 0 && diagnostic.file != kKeywords) continue;
    diagnostic.file = kKeywords;
    diagnostic.line = diagnostic.column = 0;
  }
  return diagnostics;
}

/// brachisto.Diagnostic of each.
py::tuple to_python(const std::vector<io::Diagnostic>& diagnostics) {
  const py::object type =
      py::module_::import("brachisto._errors").attr("Diagnostic");
  py::list list;
  for (const io::Diagnostic& d : diagnostics) {
    list.append(type(to_python(d.file), d.line, d.column, to_python(d.key),
                     to_python(d.message)));
  }
  return list;
}

void raise(std::exception_ptr thrown) {
  try {
    std::rethrow_exception(std::move(thrown));
  } catch (const io::InputError& found) {
    const io::InputError error(told_to_programs(found.diagnostics()));
    const py::object type =
        py::module_::import("brachisto._errors").attr("InputError");
    PyErr_SetObject(
        type.ptr(),
        type(to_python(error.what()), to_python(error.diagnostics())).ptr());
  } catch (const io::IoError& error) {
    PyErr_SetObject(PyExc_OSError, to_python(error.what()).ptr());
  } catch (const report::OutputError& error) {
    PyErr_SetObject(PyExc_OSError, to_python(error.what()).ptr());
  }
}

io::ProblemFile read_problem(const std::string& text, const std::string& name,
                             const std::vector<std::string>& changes) {
  io::ProblemFile problem = io::read_problem_text(text, name, changes);
  problem.warnings = told_to_programs(std::move(problem.warnings));
  return problem;
}

/// \throws InputError, IoError  for a file that is neither a problem nor a
/// sweep
void check(const std::string& path) {
  static_cast<void>(io::read_problem_or_sweep_file(path));
}

/// The values of all keys of a sweep in a scene, by name.
py::dict values_of(const io::SweepFile& sweep, std::size_t scene) {
  const std::vector<io::SweepValue> values = sweep.values(scene);
  py::dict by_key;
  for (std::size_t i = 0; i < values.size(); ++i) {
    by_key[py::str(sweep.keys()[i].path)] = values[i];
  }
  return by_key;
}

/// The number of values along its last axis, along which scenes are neighbours.
std::size_t row_of(const io::SweepFile& sweep) {
  return sweep.axes().empty() ? 1 : sweep.axes().back().count;
}

// ---- Solutions.

/// Does work in a thread of its own, while this one lets Python's other threads
/// run and looks after signals: a handler that raises, as that of Ctrl-C does,
/// sets the flag that the work gets, and what it raised comes out when the work
/// has ended.
template <class Work>
std::invoke_result_t<Work, const std::atomic<int>&> in_thread(
    const Work& work) {
  constexpr std::chrono::milliseconds kPatience{20};
  std::atomic<int> interrupt{0};
  auto done = std::async(std::launch::async, [&] { return work(interrupt); });
  const auto is_done = [&] {
    const py::gil_scoped_release others_run;
    return done.wait_for(kPatience) == std::future_status::ready;
  };
  while (!is_done()) {
    if (PyErr_CheckSignals() == 0) continue;
    const py::error_already_set raised;
    interrupt = 1;
    while (!is_done()) continue;
    throw raised;
  }
  return done.get();
}

void add_warnings(Solution& solution, const io::ProblemFile& problem) {
  for (const io::Diagnostic& warning : problem.warnings) {
    solution.warnings.push_back(io::to_string(warning));
  }
}

Answered solve_problem(const io::ProblemFile& problem, const Answered* near) {
  const auto* program = problem.options.of<Collocation>();
  if (program != nullptr && program->certify == Certify::Proof) {
    throw io::InputError(
        {{.file = kKeywords,
          .key = "solver.certify",
          .message = "the package proves nothing; take the command, "
                     "`brachisto solve` or `brachisto prove`"}});
  }
  const auto neighbour = near != nullptr && near->solution.verified()
                             ? near->solution.as_neighbour()
                             : nullptr;
  Answered out{in_thread([&](const std::atomic<int>& interrupt) {
    return solve(problem.scene, problem.options,
                 {.interrupt = &interrupt, .neighbour = neighbour.get()});
  })};
  add_warnings(out.solution, problem);
  return out;
}

/// \throws InputError  if it leaves nothing free
Answered design_problem(const io::ProblemFile& problem) {
  io::require_design(problem, kKeywords);
  Designed found = in_thread([&](const std::atomic<int>& interrupt) {
    return find_design(problem.scene, problem.options, problem.design,
                       &interrupt);
  });
  add_warnings(found.solution, problem);
  return {std::move(found.solution), std::move(found.answer)};
}

py::object trajectory_of(const Answered& answered) {
  const Solution& solution = answered.solution;
  if (!solution.verified()) return py::none();
  py::dict columns;
  for (const report::TrajectoryColumn& column :
       report::trajectory_columns(solution)) {
    if (column.numbers.empty()) {
      columns[py::str(column.name)] =
          py::module_::import("numpy").attr("array")(column.words);
    } else {
      columns[py::str(column.name)] =
          py::array_t<double>(static_cast<py::ssize_t>(column.numbers.size()),
                              column.numbers.data());
    }
  }
  return columns;
}

/// Name, unit and meaning of each column.
py::list trajectory_texts() {
  py::list texts;
  for (const auto& text : report::trajectory_column_texts()) {
    texts.append(py::make_tuple(text.name, text.unit, text.meaning));
  }
  return texts;
}

/// The same answer as if the sensitivities had been asked for.
Answered differentiated(const Answered& answered, bool second) {
  Answered out = answered;
  Solution& solution = out.solution;
  if (solution.options.of<Collocation>() == nullptr) return out;
  solution.options.use<Collocation>().sensitivities =
      second ? SensitivityOrder::Second : SensitivityOrder::First;
  solution.sensitivities = sensitivities(answered.solution, second);
  return out;
}

}  // namespace

PYBIND11_MODULE(_core, module) {
  py::register_exception_translator(raise);
  module.attr("__version__") = BRACHISTO_VERSION;
  module.attr("KEYWORDS") = kKeywords;
  module.attr("MAX_FILE_SIZE") = io::kMaxFileSize;
  module.def("result_schema", &report::result_schema);
  module.def("trajectory_texts", &trajectory_texts);

  module.def("check", &check, py::arg("path"));

  py::class_<io::ProblemFile>(module, "Problem")
      .def(py::init(&read_problem), py::arg("text"), py::arg("name"),
           py::arg("changes"))
      .def_property_readonly("input",
                             [](const io::ProblemFile& problem) {
                               return report::input_json(problem.scene,
                                                         problem.options);
                             })
      .def_property_readonly("warnings",
                             [](const io::ProblemFile& problem) {
                               return to_python(problem.warnings);
                             })
      .def(
          "on_track_of",
          [](io::ProblemFile problem, const Answered& first) {
            plot::check_track("the first one", first.solution.scene);
            problem.scene = plot::on_track(std::move(problem.scene),
                                           plot::track_of(first.solution));
            return problem;
          },
          py::arg("first"));

  py::class_<io::SweepFile>(module, "Sweep")
      .def(py::init([](const std::string& text, const std::string& name,
                       const std::vector<std::string>& changes) {
             return io::read_sweep_text(text, name, changes);
           }),
           py::arg("text"), py::arg("name"), py::arg("changes"))
      .def("__len__", &io::SweepFile::num_scenes)
      .def("values", &values_of, py::arg("scene"))
      .def("problem", &io::SweepFile::problem, py::arg("scene"))
      .def_property_readonly("row", &row_of)
      .def_property_readonly("warm_start", &io::SweepFile::warm_start);

  py::class_<Answered>(module, "Answer")
      .def("json", &Answered::json)
      .def("summary", &Answered::summary)
      .def("trajectory", &trajectory_of)
      .def("differentiated", &differentiated, py::arg("second"))
      .def("card", &python::card_of)
      .def("page", [](const Answered& answered) {
        return in_thread([&](const std::atomic<int>& interrupt) {
          return python::page_of(answered, interrupt);
        });
      });

  module.def("solve", &solve_problem, py::arg("problem"), py::arg("near"));
  module.def("design", &design_problem, py::arg("problem"));

  module.attr("FEWEST_RACERS") = plot::kFewestRacers;
  module.attr("MOST_RACERS") = plot::kMostRacers;
  py::class_<python::Race>(module, "Race")
      .def(py::init<const std::vector<std::string>&,
                    const std::vector<const Answered*>&, bool>(),
           py::arg("names"), py::arg("answers"), py::arg("same_track"))
      .def_property_readonly("names", &python::Race::names)
      .def_property_readonly("behind", &python::Race::behind)
      .def("card", &python::Race::card)
      .def("page", [](const python::Race& race) {
        return in_thread([&](const std::atomic<int>& interrupt) {
          return race.page(interrupt);
        });
      });

  module.def("write_page", &python::write_page, py::arg("path"),
             py::arg("page"), py::arg("force"));
  module.def("check_page", &python::check_page, py::arg("path"),
             py::arg("force"));
}
