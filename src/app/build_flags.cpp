// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "app/build_flags.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <locale>
#include <optional>
#include <sstream>
#include <utility>

#include "brachisto/report/result.hpp"
#include "io/visible_text.hpp"
#include "report/cutting_template.hpp"

namespace brachisto::app {

namespace fs = std::filesystem;
using report::cutting::Build;
using report::cutting::Drawing;

namespace {

/// Directories are asked for in two formats.
struct Format {
  const char* ending;
  std::string (*written)(const Drawing&);
};
constexpr Format kSvg{".svg", report::cutting::as_svg};
constexpr Format kDxf{".dxf", report::cutting::as_dxf};

/// Two numbers with a letter between them; nothing if a text is not that.
std::optional<std::array<double, 2>> two_numbers(const std::string& text,
                                                 char between) {
  std::array<double, 2> numbers{};
  char read = 0;
  std::istringstream in(text);
  in.imbue(std::locale::classic());
  if (!(in >> numbers[0] >> read >> numbers[1]) || read != between ||
      in.peek() != std::istringstream::traits_type::eof()) {
    return std::nullopt;
  }
  return numbers;
}

TextCheck checked(char between, double least, double most,
                  const std::string& expected) {
  return {[=](const std::string& text) -> std::string {
            const auto numbers = two_numbers(text, between);
            const bool fine =
                numbers && std::ranges::all_of(*numbers, [&](double number) {
                  return number >= least && number <= most;
                });
            return fine ? ""
                        : io::in_quotes(text) + " was read; expected " +
                              expected;
          },
          {}};
}

TextCheck millimetres() {
  return number("of millimetres from 0.1 to 100000",
                [](double mm) { return mm >= 0.1 && mm <= 1e5; });
}

/// "sheet-01.svg", "assembly-12.svg".
bool is_ours(const std::string& name, const std::string& ending) {
  for (const std::string kind : {"sheet-", "assembly-"}) {
    if (!name.starts_with(kind) || !name.ends_with(ending) ||
        name.size() < kind.size() + ending.size() + 2) {
      continue;
    }
    return std::all_of(name.begin() + static_cast<std::ptrdiff_t>(kind.size()),
                       name.end() - static_cast<std::ptrdiff_t>(ending.size()),
                       [](unsigned char c) { return std::isdigit(c) != 0; });
  }
  return false;
}

/// What an earlier track left in a directory.
std::vector<std::string> ours_in(const fs::path& directory,
                                 const std::string& ending) {
  std::vector<std::string> names;
  std::error_code error;
  for (fs::directory_iterator at(directory, error), end; !error && at != end;
       at.increment(error)) {
    const std::string name = at->path().filename().string();
    if (is_ours(name, ending)) names.push_back(name);
  }
  return names;
}

std::vector<std::string> names_of(const std::vector<Drawing>& drawings,
                                  const char* ending) {
  std::vector<std::string> names;
  for (const Drawing& drawing : drawings) {
    names.push_back(drawing.name + ending);
  }
  return names;
}

void or_usage_error(const auto& action) {
  try {
    action();
  } catch (const report::cutting::TemplateError& error) {
    throw UsageError("brachisto solve", error.what());
  }
}

void write_into(const std::string& directory, const Format& format,
                const std::vector<Drawing>& drawings, bool force) {
  if (directory.empty()) return;
  std::vector<report::OutputFile> files;
  std::vector<std::string> obsolete = ours_in(directory, format.ending);
  for (const Drawing& drawing : drawings) {
    files.push_back({drawing.name + format.ending, format.written(drawing)});
    std::erase(obsolete, files.back().name);
  }
  report::write_files(directory, files, force, obsolete);
}

}  // namespace

Build BuildFlags::build() const {
  const auto sheet = *two_numbers(sheet_, 'x');
  const auto scale = *two_numbers(scale_, ':');
  Build build{.width = sheet[0],
              .height = sheet[1],
              .scale = scale[0] / scale[1],
              .strip = strip_,
              .thickness = thickness_,
              .hole = hole_};
  if (gauge_ > 0.0) build.gauge = gauge_;
  return build;
}

void BuildFlags::check(const Scene& scene, bool force) const {
  if (!any()) return;
  or_usage_error([&] { report::cutting::check_build(build(), scene); });
  for (const auto& [directory, format] :
       {std::pair(svg_, kSvg), std::pair(dxf_, kDxf)}) {
    if (directory.empty()) continue;
    report::check_writable(directory, ours_in(directory, format.ending), force);
  }
}

std::vector<Drawing> BuildFlags::drawings(const Solution& solution,
                                          const std::vector<MassPart>& made_of,
                                          bool force) const {
  if (!any() || !solution.verified() || !solution.feasible()) return {};
  std::vector<Drawing> drawings;
  or_usage_error([&] {
    drawings = report::cutting::cutting_template(solution, made_of, build());
  });
  for (const auto& [directory, format] :
       {std::pair(svg_, kSvg), std::pair(dxf_, kDxf)}) {
    if (directory.empty()) continue;
    report::check_writable(directory, names_of(drawings, format.ending), force);
  }
  return drawings;
}

void BuildFlags::write(const std::vector<Drawing>& drawings, bool force) const {
  if (drawings.empty()) return;
  write_into(svg_, kSvg, drawings, force);
  write_into(dxf_, kDxf, drawings, force);
}

std::vector<Flag> BuildFlags::flags() {
  const std::vector<const char*> directories{"--track-svg", "--track-dxf"};
  const auto in_millimetres = [&](const char* name, auto& value,
                                  const char* text, const char* placeholder) {
    return Flag{.name = name,
                .value = &value,
                .text = text,
                .placeholder = placeholder,
                .check = millimetres(),
                .shows_default = true,
                .needs = directories};
  };
  return {
      directory_flag("--track-svg", svg_,
                     "Write the track there in parts to cut, with all that a "
                     "builder has to know, if it is verified and feasible"),
      directory_flag(
          "--track-dxf", dxf_,
          "The same as DXF; the six flags that follow need one of these two"),
      {.name = "--sheet",
       .value = &sheet_,
       .text = "Size of the sheets to cut [mm]",
       .placeholder = "WIDTHxHEIGHT",
       .check = checked('x', 150.0, 1e5,
                        "two numbers from 150 to 100000, as in 600x400"),
       .shows_default = true,
       .needs = directories},
      {.name = "--scale",
       .value = &scale_,
       .text = "Lengths as built to those of the scene",
       .placeholder = "BUILT:SCENE",
       .check = checked(':', 1e-3, 1e6,
                        "two numbers from 0.001 to 1000000, as in 1:5"),
       .shows_default = true,
       .needs = directories},
      in_millimetres("--strip", strip_, "Width of the strips, at most [mm]",
                     "WIDTH"),
      in_millimetres("--thickness", thickness_,
                     "Thickness of the material [mm]", "THICKNESS"),
      in_millimetres("--hole", hole_, "Diameter of the holes [mm]", "DIAMETER"),
      {.name = "--rails",
       .value = &gauge_,
       .text = "Two strips with so much between them, and spacers [mm]",
       .placeholder = "GAUGE",
       .check = millimetres(),
       .needs = directories}};
}

}  // namespace brachisto::app
