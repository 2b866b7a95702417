// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "reproduction/family.hpp"

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <system_error>

#include "reproduction/transit.hpp"
#include "sweep/table.hpp"

namespace brachisto::reproduction {

namespace {

/// A directory of its own that goes with the object.
class ScratchDirectory {
 public:
  ScratchDirectory() {
    std::string name =
        (std::filesystem::temp_directory_path() / "brachisto-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) {
      throw std::system_error(errno, std::generic_category(), name);
    }
    path_ = name;
  }
  ~ScratchDirectory() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  ScratchDirectory(const ScratchDirectory&) = delete;
  ScratchDirectory& operator=(const ScratchDirectory&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace

SweepTable solve_family(const sweep::Job& job, int jobs,
                        const Interrupt& interrupt,
                        const sweep::ProgressSink& progress) {
  constexpr double kSecondsPerScene = 120.0;
  const ScratchDirectory scratch;
  sweep::Store store =
      sweep::Store::create(scratch.path(), sweep::store_info(job, "1/1"));
  const sweep::ManagerOptions options{.program = "/proc/self/exe",
                                      .jobs = jobs,
                                      .seconds_per_scene = kSecondsPerScene,
                                      .memory = 0,
                                      .shard = {},
                                      .interrupt = &interrupt};
  sweep::run_manager(job, store, options, progress);
  SweepTable table = sweep::read_table(store, job);
  check(interrupt);
  for (const SweepOutcome& outcome : table.outcomes) {
    if (outcome.state != SweepOutcome::State::Verified) {
      throw NotVerified(job.name +
                        ": a scene has no verified answer: " + outcome.message);
    }
  }
  return table;
}

}  // namespace brachisto::reproduction
