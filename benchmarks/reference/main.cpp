// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// The reference set: all classics and rows of rolling bodies, with a page, a
// table for machines and .nl files.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>

#include "reference/rows.hpp"

int main(int argc, char** argv) try {
  using namespace brachisto::benchmarks;
  CLI::App app("Solves the reference set of optimal-control problems");
  std::string out = "reference_set", page, stamp = "*Not stamped.*", only;
  app.add_option("--out", out, "folder of the JSON file and the .nl files");
  app.add_option("--page", page, "Markdown page to write");
  app.add_option("--stamp", stamp, "when and where, a line of the page");
  app.add_option("--only", only, "classics with this in their name alone");
  CLI11_PARSE(app, argc, argv);

  std::filesystem::create_directories(out);
  std::vector<Classic> classics = mechanics();
  std::ranges::move(machines(), std::back_inserter(classics));
  ReferenceSet set{{}, {}, stamp};
  for (const Classic& classic : classics) {
    if (classic.name.find(only) == std::string::npos) continue;
    set.classics.push_back(measured(classic, out));
    const ClassicRow& row = set.classics.back();
    std::printf("%s: %.13g, estimate %s, second method %s, %s\n",
                classic.name.c_str(), row.value, brief(row.estimate).c_str(),
                brief(row.value - classic.second.value).c_str(),
                row.verified ? "verified" : row.why_not.c_str());
    std::fflush(stdout);
  }
  if (only.empty()) set.rolling = rolling_rows();
  std::ofstream(std::filesystem::path(out) / "reference_set.json")
      << json_of(set).dump(2) << '\n';
  if (!page.empty()) std::ofstream(page) << page_of(set);
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
