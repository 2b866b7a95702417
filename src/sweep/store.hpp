// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The store of a sweep: one SQLite file in a directory of its own.

#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "sweep/chain_plan.hpp"
#include "sweep/job.hpp"
#include "sweep/message.hpp"
#include "sweep/sqlite.hpp"

namespace brachisto::sweep {

/// In place of a shard, for a store that merge() made.
inline constexpr const char* kMerged = "merged";

/// What all scenes of a store share.
struct StoreInfo {
  std::string job;         ///< see to_line(const Job&)
  std::string input_hash;  ///< see input_hash()
  std::string version;     ///< of the program that solves
  std::string shard;       ///< "i/N", or kMerged
  std::string provenance;  ///< JSON
};

/// What a store says of a sweep that this program solves.
[[nodiscard]] StoreInfo store_info(const Job& job, const std::string& shard);

/// Results of a sweep as far as they are there. Written by one process alone;
/// others may read meanwhile. Whatever record() was given survives a crash of
/// the process or the machine.
class Store {
 public:
  static constexpr const char* kFileName = "sweep.sqlite";

  /// True if the directory has a store that was begun.
  [[nodiscard]] static bool exists(const std::filesystem::path& directory);

  /// \throws StoreError  if there is one already, or none can be written
  [[nodiscard]] static Store create(const std::filesystem::path& directory,
                                    const StoreInfo& info);
  /// Reads also from where nothing can be written.
  /// \throws StoreError  if there is none, or if it is damaged or not ours
  [[nodiscard]] static Store open(const std::filesystem::path& directory,
                                  Database::Access access);
  /// Removes a store and what SQLite keeps beside it.
  /// \throws StoreError  if the file is something else
  static void remove(const std::filesystem::path& directory);

  [[nodiscard]] const StoreInfo& info() const { return info_; }

  /// Adds answers, all or none; they are on disk afterwards. Each state
  /// replaces that of the scene before it in its chain.
  /// \throws StoreError  also if a scene has a result already
  void record(std::span<const Answer> answers, const ChainPlan& plan);

  /// Changes info().shard.
  void set_shard(const std::string& shard);
  /// Removes results, so that their scenes are solved again.
  void forget(std::span<const std::size_t> scenes);

  [[nodiscard]] std::size_t num_results();
  /// For each scene of the sweep, whether it has a result.
  [[nodiscard]] std::vector<bool> finished(std::size_t num_scenes);
  /// Calls `visit` for each result in the order of scenes.
  void for_each_result(
      const std::function<void(std::size_t, const std::string&)>& visit);
  /// What the scene after the last finished one of a chain starts from.
  [[nodiscard]] std::string state_of(std::size_t chain);

 private:
  Store(std::unique_ptr<Database> database, StoreInfo info);

  std::unique_ptr<Database> database_;
  StoreInfo info_;
};

}  // namespace brachisto::sweep
