// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "comparison/comparison.hpp"
#include "report/provenance.hpp"
#include "support/table.hpp"

namespace brachisto::benchmarks {

std::string machine() {
  const report::Provenance with = report::provenance();
  return fmt::format(
      "{}, {} cores; {}; brachisto {}, Ipopt {}, MUMPS {}, BLAS {}",
      comparison::this_machine().cpu, sysconf(_SC_NPROCESSORS_ONLN),
      with.compiler, with.brachisto, with.ipopt, with.mumps, with.blas);
}

void write_file(const std::string& path, const std::string& content) {
  const std::filesystem::path folder =
      std::filesystem::path(path).parent_path();
  if (!folder.empty()) std::filesystem::create_directories(folder);
  std::ofstream file(path);
  file << content;
  if (!file.flush()) throw std::runtime_error("cannot write " + path);
}

void write_figure(const report::Figure& figure, const std::string& path) {
  const report::DrawnFiles drawn =
      report::draw(figure, report::Format::Svg, nullptr);
  if (!drawn.missing.empty()) fmt::print(stderr, "{}\n", drawn.missing);
  const std::filesystem::path folder =
      std::filesystem::path(path).parent_path();
  for (const report::OutputFile& file : drawn.files) {
    write_file((folder / file.name).string(), file.content);
  }
}

}  // namespace brachisto::benchmarks
