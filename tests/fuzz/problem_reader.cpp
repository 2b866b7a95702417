// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Problem files: a text, and behind zero bytes, which no text has, the points
// of a path and overrides. Whatever they are, they are read or refused.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "brachisto/io/problem_file.hpp"
#include "brachisto/report/result.hpp"
#include "fuzz/law.hpp"
#include "io/path_points.hpp"

namespace brachisto::fuzz {

namespace {

std::vector<std::string> parts_of(std::string_view bytes) {
  std::vector<std::string> parts;
  while (true) {
    const std::size_t end = bytes.find('\0');
    parts.emplace_back(bytes.substr(0, end));
    if (end == std::string_view::npos) return parts;
    bytes.remove_prefix(end + 1);
  }
}

/// Large sweeps are as slow as they are allowed to be.
bool is_large(const std::string& text) {
  double scenes = 1.0;
  const std::string_view key = "count";
  for (std::size_t at = text.find(key); at != std::string::npos;
       at = text.find(key, at + 1)) {
    const std::size_t value = text.find_first_of("0123456789", at);
    if (value == std::string::npos) break;
    scenes *= std::max(1.0, std::strtod(text.c_str() + value, nullptr));
  }
  return scenes > 1e4;
}

/// What the readers promise of a problem that they do not refuse.
void check(const io::ProblemFile& problem) {
  law(validate(problem.scene).empty(), "a scene that was read is valid");
  (void)report::input_json(problem.scene, problem.options);
}

void check(const io::SweepFile& sweep) {
  law(sweep.num_scenes() >= 1 && sweep.num_scenes() <= io::kMaxScenes,
      "a sweep has scenes");
  for (const std::size_t scene : {std::size_t{0}, sweep.num_scenes() - 1}) {
    law(sweep.values(scene).size() == sweep.keys().size(),
        "every key has a value");
    check(sweep.problem(scene));
  }
}

template <class Read>
void read(Read&& what) {
  try {
    what();
  } catch (const io::InputError& error) {
    law(!error.diagnostics().empty(), "a refusal has a reason");
  } catch (const io::IoError&) {
    // The problem names a file of points that is not there.
  }
}

}  // namespace

}  // namespace brachisto::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {
  using namespace brachisto;
  std::vector<std::string> parts =
      fuzz::parts_of({reinterpret_cast<const char*>(data), size});
  for (const std::string& part : parts) {
    if (fuzz::is_large(part)) return -1;
  }
  const std::string text = parts.front();
  std::vector<Point> points;
  if (parts.size() > 1) {
    try {
      points = io::parse_points(parts[1]);
    } catch (const io::PointsError&) {
    }
  }
  parts.erase(
      parts.begin(),
      parts.begin() + std::min<std::ptrdiff_t>(
                          2, static_cast<std::ptrdiff_t>(parts.size())));
  fuzz::read([&] { fuzz::check(io::read_problem_text(text, "f", parts)); });
  fuzz::read(
      [&] { fuzz::check(io::read_sweep_text(text, "f", parts, &points)); });
  return 0;
}
