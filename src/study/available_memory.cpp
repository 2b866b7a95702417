// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "study/size.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <optional>
#include <string>

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

double of_the_machine() {
  std::ifstream info("/proc/meminfo");
  std::string name;
  while (info >> name) {
    double kilobytes = 0.0;
    if (name == "MemAvailable:" && info >> kilobytes) return 1024.0 * kilobytes;
    info.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
  }
  return kNoBound;
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

/// All it may have: what it has taken contains files that can be given back.
double of_the_control_group() {
  const std::string folder = "/sys/fs/cgroup/";
  return std::min(
      number_in(folder + "memory.max").value_or(kNoBound),
      number_in(folder + "memory/memory.limit_in_bytes").value_or(kNoBound));
}

}  // namespace

double available_memory() {
  return std::max(0.0, std::min({of_the_machine(), of_the_address_space(),
                                 of_the_control_group()}));
}

}  // namespace brachisto
