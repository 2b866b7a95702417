// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Every piece of work in a process of its own: a crash or a hang is a result
/// like any other, and MUMPS, which may not run in two threads, may run in two
/// processes.

#pragma once

#include <cstring>
#include <functional>
#include <optional>
#include <string>
#include <type_traits>

namespace brachisto::benchmarks {

/// How many processes at a time, and for how long each.
struct ProcessLimits {
  int jobs = 1;
  unsigned seconds = 600;  ///< wall clock; then it is killed
  /// The same for processor time, which other work does not stretch; 0: none.
  unsigned cpu_seconds = 0;
};

/// Runs work(0) … work(count − 1), each in a fork of this process, and hands
/// the bytes that each returns to done(i, bytes, ""), in the order in which
/// they finish. A process that crashed, hung or threw has no bytes; `fate` then
/// says what happened.
///
/// \throws std::system_error if no process can be made
void run_in_processes(int count, const ProcessLimits& limits,
                      const std::function<std::string(int)>& work,
                      const std::function<void(int, const std::string& bytes,
                                               const std::string& fate)>& done);

/// The same for a record that may be copied byte by byte.
template <typename Record>
void run_isolated(
    int count, const ProcessLimits& limits,
    const std::function<Record(int)>& work,
    const std::function<void(int, const std::optional<Record>& record,
                             const std::string& fate)>& done) {
  static_assert(std::is_trivially_copyable_v<Record>);
  run_in_processes(
      count, limits,
      [&](int i) {
        const Record record = work(i);
        return std::string(reinterpret_cast<const char*>(&record),
                           sizeof(Record));
      },
      [&](int i, const std::string& bytes, const std::string& fate) {
        if (bytes.size() != sizeof(Record)) {
          done(i, std::nullopt, fate.empty() ? "incomplete answer" : fate);
          return;
        }
        Record record;
        std::memcpy(&record, bytes.data(), sizeof(Record));
        done(i, record, {});
      });
}

}  // namespace brachisto::benchmarks
