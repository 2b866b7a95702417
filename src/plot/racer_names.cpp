// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "plot/racer_names.hpp"

#include <algorithm>
#include <cstddef>
#include <filesystem>

namespace brachisto::plot {

namespace {

namespace fs = std::filesystem;

/// The path of a file without its ending, in parts, the last one first.
std::vector<std::string> parts_of(const std::string& file) {
  const fs::path path = fs::absolute(file).lexically_normal();
  std::vector<std::string> parts{path.stem().string()};
  for (fs::path folder = path.parent_path(); folder.has_relative_path();
       folder = folder.parent_path()) {
    parts.push_back(folder.filename().string());
  }
  return parts;
}

/// The last ones of these parts.
std::string joined(const std::vector<std::string>& parts, std::size_t count) {
  std::string name = parts[0];
  for (std::size_t i = 1; i < count; ++i) name = parts[i] + "/" + name;
  std::ranges::replace(name, '_', ' ');
  return name;
}

}  // namespace

std::vector<std::string> racer_names(const std::vector<std::string>& files) {
  std::vector<std::vector<std::string>> parts;
  std::vector<std::string> names;
  for (const std::string& file : files) {
    parts.push_back(parts_of(file));
    names.push_back(joined(parts.back(), 1));
  }
  std::vector<std::size_t> counts(files.size(), 1);
  for (bool longer = true; longer;) {
    longer = false;
    const std::vector<std::string> before = names;
    for (std::size_t i = 0; i < files.size(); ++i) {
      if (std::ranges::count(before, before[i]) == 1) continue;
      if (counts[i] < parts[i].size()) {
        names[i] = joined(parts[i], ++counts[i]);
        longer = true;
      } else {
        names[i] = files[i];
      }
    }
  }
  return names;
}

}  // namespace brachisto::plot
