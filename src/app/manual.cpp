// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "app/manual.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <set>
#include <sstream>
#include <string_view>
#include <type_traits>

#include "app/roff.hpp"
#include "brachisto/version.hpp"
#include "io/key_spec.hpp"

namespace brachisto::app {

namespace {

/// A paragraph, and indented lines under it.
struct Block {
  std::string paragraph;
  std::vector<std::string> lines;
};

/// As the help has it: examples and exit codes after all else.
struct Footer {
  std::vector<Block> blocks;
  std::vector<std::string> examples;
  std::string exit_codes;
};

Footer read_footer(const std::string& text) {
  constexpr std::string_view kCodes = "Exit codes: ";
  Footer footer;
  std::vector<std::string>* lines = nullptr;  // where indented ones go
  std::string* paragraph = nullptr;           // that a line goes on with
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("Example")) {
      lines = &footer.examples;
      paragraph = nullptr;
    } else if (line.starts_with("  ") && lines != nullptr) {
      lines->push_back(line.substr(2));
      paragraph = nullptr;
    } else if (line.starts_with(kCodes)) {
      paragraph = &footer.exit_codes;
      *paragraph = line.substr(kCodes.size());
    } else if (paragraph != nullptr) {
      *paragraph += " " + line;
    } else {
      Block& block = footer.blocks.emplace_back(Block{line, {}});
      paragraph = &block.paragraph;
      lines = &block.lines;
    }
  }
  return footer;
}

/// The value that holds without the flag, where the help shows it.
std::string default_of(const Flag& flag) {
  if (!flag.shows_default) return {};
  return std::visit(
      [](const auto* value) -> std::string {
        using Value = std::remove_cvref_t<decltype(*value)>;
        if constexpr (std::is_same_v<Value, std::vector<std::string>>) {
          return fmt::format("{}", fmt::join(*value, " "));
        } else {
          return fmt::format("{}", *value);
        }
      },
      flag.value);
}

std::string flag_text(const Flag& flag) {
  std::string text = flag.text;
  const auto add = [&text](const std::string& more) { text += ". " + more; };
  if (!flag.check.allowed.empty()) add("Expected: " + flag.check.allowed);
  if (const std::string value = default_of(flag); !value.empty()) {
    add("Default: " + value);
  }
  if (flag.repeats()) add("May be given again and again");
  if (flag.needs != nullptr) add(fmt::format("Needs {}", flag.needs));
  if (flag.excludes != nullptr) add(fmt::format("Not with {}", flag.excludes));
  return text + ".";
}

/// "brachisto export [OPTIONS] DIR {--csv | --json}".
std::string synopsis(const Verb& verb) {
  std::string line =
      roff_bold(fmt::format("brachisto {}", verb.name)) + " [options]";
  std::set<std::string> choices;
  for (const Flag& flag : verb.flags) {
    if (flag.hidden) continue;
    if (flag.choice != nullptr) {
      if (!choices.insert(flag.choice).second) continue;
      std::vector<std::string> heads;
      for (const Flag& other : verb.flags) {
        if (other.choice == nullptr) continue;
        if (std::string_view(other.choice) != flag.choice) continue;
        heads.push_back(heading_of(other));
      }
      line += fmt::format(" {{{}}}", fmt::join(heads, " | "));
    } else if (flag.is_word() || flag.required) {
      const std::string dots = flag.repeats() ? " ..." : "";
      line += flag.required ? " " + heading_of(flag) + dots
                            : " [" + heading_of(flag) + dots + "]";
    }
  }
  return line;
}

std::string page_name(const Verb& verb) {
  return fmt::format("brachisto-{}", verb.name);
}

void add_footer(ManualPage& page, const Footer& footer) {
  if (!footer.examples.empty()) {
    page.section("Examples").example(footer.examples);
  }
  if (!footer.exit_codes.empty()) {
    page.section("Exit status").paragraph(footer.exit_codes);
  }
}

report::OutputFile page_of(const CommandLine& command, const Verb& verb) {
  ManualPage page(page_name(verb), 1, BRACHISTO_VERSION, verb.text);
  page.section("Synopsis").roff_line(synopsis(verb));
  const Footer footer = read_footer(verb.footer);
  page.section("Description").paragraph(std::string(verb.text) + ".");
  for (const Block& block : footer.blocks) {
    page.paragraph(block.paragraph);
    if (!block.lines.empty()) page.example(block.lines);
  }
  page.section("Options");
  for (const Flag& flag : shown_flags(command, verb)) {
    page.entry(heading_of(flag), flag_text(flag));
  }
  add_footer(page, footer);
  page.section("See also")
      .roff_line(".BR brachisto (1),")
      .roff_line(".BR brachisto\\-problem (5)");
  return {page_name(verb) + ".1", page.text()};
}

report::OutputFile front_page(const CommandLine& command) {
  ManualPage page("brachisto", 1, BRACHISTO_VERSION,
                  "smooth-contact extremals of rolling bodies");
  page.section("Synopsis")
      .roff_line(roff_bold("brachisto") + " " + roff_italic("VERB") +
                 " [options]")
      .roff_line(".br")
      .roff_line(roff_bold("brachisto") + " " + roff_italic("VERB") + " " +
                 roff_bold("--help"))
      .roff_line(".br")
      .roff_line(roff_bold("brachisto") + " " + roff_bold("--help") + " | " +
                 roff_bold("--version"));
  page.section("Description").paragraph(command.text);
  page.section("Verbs");
  for (const Verb* verb : shown_verbs(command)) {
    page.entry(roff_bold(verb->name),
               fmt::format("{}; see {}(1).", verb->text, page_name(*verb)));
  }
  page.section("Options");
  page.entry(roff_bold("--help"), "Print this help message and exit.");
  page.entry(roff_bold("--version"),
             "Print versions of the program and its libraries.");
  for (const Flag& flag : command.everywhere) {
    page.entry(heading_of(flag), "Of every verb: " + flag_text(flag));
  }
  add_footer(page, read_footer(command.footer));
  page.section("Environment")
      .entry(roff_bold("NO_COLOR"),
             "If it is set and not empty, there are no colours unless "
             "--color always asks for them.")
      .entry(roff_bold("TERM"), "\"dumb\": there are no colours either.");
  page.section("See also").roff_line(".BR brachisto\\-problem (5),");
  const std::vector<const Verb*> verbs = shown_verbs(command);
  for (const Verb* verb : verbs) {
    page.roff_line(fmt::format(".BR {} (1){}", roff(page_name(*verb)),
                               verb == verbs.back() ? "" : ","));
  }
  return {"brachisto.1", page.text()};
}

}  // namespace

std::string heading_of(const Flag& flag) {
  if (flag.is_word()) return roff_italic(flag.name);
  std::string head = roff_bold(flag.name);
  if (flag.has_value()) head += " " + roff_italic(flag.placeholder);
  return head;
}

std::vector<report::OutputFile> command_pages(const CommandLine& command) {
  std::vector<report::OutputFile> pages{front_page(command)};
  for (const Verb* verb : shown_verbs(command)) {
    pages.push_back(page_of(command, *verb));
  }
  return pages;
}

report::OutputFile problem_page() {
  ManualPage page("brachisto-problem", 5, BRACHISTO_VERSION,
                  "which body rolls where, and how its track is computed");
  page.section("Description")
      .paragraph(
          "A problem file is a YAML document. The shortest one, in which all "
          "else has its default, is")
      .example({"scene: {body: {shape: bead}, finish: {L: 3, H: 1}}"})
      .paragraph(
          "Below, scene.finish.L is the key L of the map finish in the map "
          "scene. Numbers may be expressions of constants, as 1/3 or "
          "sqrt(1-0.5), angles in radians or, as -30 deg, in degrees. What is "
          "not listed is a mistake, and so are values out of their bounds.");
  page.section("Keys");
  for (const io::KeySpec& spec : io::key_table()) {
    if (spec.type() == io::KeyType::Reserved) continue;
    if (spec.parent().empty()) page.subsection(spec.path);
    page.entry(fmt::format("{} ({})", roff_bold(spec.path),
                           io::type_name(spec.type())),
               io::described(spec) + ".");
  }
  page.section("Examples")
      .paragraph("brachisto new writes a file with comments to begin with:")
      .example({"brachisto new track", "brachisto solve track.yaml"});
  page.section("See also")
      .roff_line(".BR brachisto (1),")
      .roff_line(".BR brachisto\\-new (1),")
      .roff_line(".BR brachisto\\-validate (1),")
      .roff_line(".BR brachisto\\-schema (1)");
  return {"brachisto-problem.5", page.text()};
}

}  // namespace brachisto::app
