// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "study/size.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

namespace brachisto {

namespace {

constexpr double kNoBound = std::numeric_limits<double>::infinity();

/// The first number of a file; a word such as "max" is none.
std::optional<double> number_in(const std::string& file) {
  std::ifstream in(file);
  double value = 0.0;
  if (!(in >> value)) return std::nullopt;
  return value;
}

/// The number after a word at the beginning of a line.
std::optional<double> number_of(const std::string& file, std::string_view key) {
  std::ifstream in(file);
  std::string name;
  while (in >> name) {
    double value = 0.0;
    if (name == key && in >> value) return value;
    in.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
  }
  return std::nullopt;
}

double of_the_machine() {
  const auto kilobytes = number_of("/proc/meminfo", "MemAvailable:");
  return kilobytes ? 1024.0 * *kilobytes : kNoBound;
}

double of_the_address_space() {
  rlimit limit = {};
  if (::getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) {
    return kNoBound;
  }
  const double page = static_cast<double>(::sysconf(_SC_PAGESIZE));
  const double taken = page * number_in("/proc/self/statm").value_or(0.0);
  return static_cast<double>(limit.rlim_cur) - taken;
}

/// What a control group leaves: files that it has in memory it can give back.
double left_in(const std::string& folder, const char* limit, const char* usage,
               const std::array<const char*, 2>& files) {
  const std::optional<double> most = number_in(folder + limit);
  if (!most) return kNoBound;
  double left = *most - number_in(folder + usage).value_or(0.0);
  for (const char* const key : files) {
    left += number_of(folder + "memory.stat", key).value_or(0.0);
  }
  return left;
}

/// Of both versions, the group of the process and all that it is part of, as
/// far as they can be seen from within a container.
double of_the_control_groups() {
  const std::string root = "/sys/fs/cgroup";
  double least = kNoBound;
  std::ifstream groups("/proc/self/cgroup");
  for (std::string line; std::getline(groups, line);) {
    // "0::/path" or "4:memory:/path"
    const std::size_t name = line.find(':') + 1;
    const std::size_t path = line.find(':', name) + 1;
    if (name == 0 || path == 0) continue;
    const std::string controllers = line.substr(name, path - 1 - name);
    if (!controllers.empty() && controllers != "memory") continue;
    std::filesystem::path group = line.substr(path);
    for (;; group = group.parent_path()) {
      const std::string folder =
          root + (controllers.empty() ? "" : "/memory") + group.string() + "/";
      least = std::min(
          least, controllers.empty()
                     ? left_in(folder, "memory.max", "memory.current",
                               {"inactive_file", "active_file"})
                     : left_in(folder, "memory.limit_in_bytes",
                               "memory.usage_in_bytes",
                               {"total_inactive_file", "total_active_file"}));
      if (!group.has_relative_path()) break;
    }
  }
  return least;
}

}  // namespace

double available_memory() {
  return std::max(0.0, std::min({of_the_machine(), of_the_address_space(),
                                 of_the_control_groups()}));
}

}  // namespace brachisto
