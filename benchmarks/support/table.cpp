// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "support/table.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <stdexcept>

#include "brachisto/report/provenance.hpp"

namespace brachisto::benchmarks {

namespace {

/// Characters, not bytes.
std::size_t width(const std::string& text) {
  constexpr unsigned kMask = 0xc0, kContinues = 0x80;
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) {
        return (static_cast<unsigned char>(c) & kMask) != kContinues;
      }));
}

std::string processor() {
  std::ifstream info("/proc/cpuinfo");
  std::string line;
  while (std::getline(info, line)) {
    const std::size_t colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) {
      return line.substr(colon + 2);
    }
  }
  return "unknown processor";
}

}  // namespace

std::string Table::markdown() const {
  std::vector<std::size_t> widths(rows_.front().size(), 3);
  for (const auto& row : rows_) {
    for (std::size_t c = 0; c < row.size(); ++c) {
      widths[c] = std::max(widths[c], width(row[c]));
    }
  }
  std::string text;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    for (std::size_t c = 0; c < rows_[i].size(); ++c) {
      const std::string& cell = rows_[i][c];
      text += "| " + cell + std::string(widths[c] - width(cell) + 1, ' ');
    }
    text += "|\n";
    if (i > 0) continue;
    for (const std::size_t w : widths) text += "| " + std::string(w, '-') + ' ';
    text += "|\n";
  }
  return text;
}

double quantile(std::vector<double> values, double q) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  const auto rank = static_cast<std::ptrdiff_t>(
      std::lround(q * static_cast<double>(values.size() - 1)));
  std::nth_element(values.begin(), values.begin() + rank, values.end());
  return values[static_cast<std::size_t>(rank)];
}

std::string machine() {
  const report::Provenance with = report::provenance();
  return fmt::format(
      "{}, {} cores; {}; brachisto {}, Ipopt {}, MUMPS {}, BLAS {}",
      processor(), sysconf(_SC_NPROCESSORS_ONLN), with.compiler, with.brachisto,
      with.ipopt, with.mumps, with.blas);
}

void write_file(const std::string& path, const std::string& content) {
  const std::filesystem::path folder =
      std::filesystem::path(path).parent_path();
  if (!folder.empty()) std::filesystem::create_directories(folder);
  std::ofstream file(path);
  file << content;
  if (!file.flush()) throw std::runtime_error("cannot write " + path);
}

}  // namespace brachisto::benchmarks
