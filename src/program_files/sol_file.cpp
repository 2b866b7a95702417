// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include <fmt/format.h>

#include <charconv>
#include <fstream>
#include <string_view>

#include "brachisto/io/problem_file.hpp"
#include "io/text_lines.hpp"
#include "program_files/foreign_answer.hpp"

namespace brachisto::program_files {

namespace {

using io::trimmed;

/// The lines of a .sol file, one after the other.
class Lines {
 public:
  explicit Lines(const std::filesystem::path& file)
      : name_(file.string()), in_(file, std::ios::binary) {
    if (!in_) throw io::IoError(name_ + ": cannot be opened");
  }

  [[noreturn]] void refuse(const std::string& why) const {
    throw io::InputError({{name_, line_, line_ > 0 ? 1 : 0, "", why}});
  }
  /// False at the end of the file.
  bool next() {
    if (!std::getline(in_, text_)) {
      if (in_.bad()) throw io::IoError(name_ + ": cannot be read");
      return false;
    }
    ++line_;
    if (!text_.empty() && text_.back() == '\r') text_.pop_back();
    return true;
  }
  [[nodiscard]] const std::string& text() const { return text_; }

  template <class Number>
  [[nodiscard]] Number number(const char* what) {
    if (!next()) refuse(fmt::format("the file ends before {}", what));
    std::string_view word = trimmed(text_);
    if (!word.empty() && word.front() == '+') word.remove_prefix(1);
    Number value{};
    const auto [end, error] =
        std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc{} || end != word.data() + word.size()) {
      refuse(
          fmt::format("expected {}, a number; read \"{:.60}\"", what, text_));
    }
    return value;
  }
  [[nodiscard]] int count(const char* what, int most) {
    const int value = number<int>(what);
    if (value < 0 || value > most) {
      refuse(fmt::format("{} is {}; from 0 to {} are possible", what, value,
                         most));
    }
    return value;
  }

 private:
  std::string name_;
  std::ifstream in_;
  std::string text_;
  int line_ = 0;
};

}  // namespace

SolFile read_sol(const std::filesystem::path& file) {
  constexpr int kMostOptions = 16, kMostNumbers = 100'000'000;
  Lines lines(file);
  SolFile out;
  for (bool options = false; !options;) {
    if (!lines.next()) {
      lines.refuse(
          "no .sol file in text: it has no line \"Options\"; solvers write "
          "text to what was read as text");
    }
    options = lines.text() == "Options";
    if (options) break;
    const std::string_view line = trimmed(lines.text());
    if (!out.message.empty() && !line.empty()) out.message += "; ";
    out.message += line;
  }
  // Where there are more than four, two of them stand for one number behind
  // the counts.
  int options = lines.count("the number of options", kMostOptions);
  const bool tolerance = options > 4;
  if (tolerance) options -= 2;
  for (int i = 0; i < options; ++i) {
    static_cast<void>(lines.number<double>("an option"));
  }
  out.num_constraints = lines.count("the number of constraints", kMostNumbers);
  const int multipliers =
      lines.count("the number of multipliers", out.num_constraints);
  out.num_variables = lines.count("the number of variables", kMostNumbers);
  const int variables = lines.count("the number of values", out.num_variables);
  if (tolerance) static_cast<void>(lines.number<double>("a tolerance"));
  for (int i = 0; i < multipliers; ++i) {
    out.multipliers.push_back(lines.number<double>("a multiplier"));
  }
  for (int i = 0; i < variables; ++i) {
    out.variables.push_back(lines.number<double>("the value of a variable"));
  }
  while (lines.next()) {
    int objective = 0, code = 0;
    if (std::sscanf(lines.text().c_str(), "objno %d %d", &objective, &code) ==
        2) {
      out.code = code;
      break;
    }
  }
  return out;
}

}  // namespace brachisto::program_files
