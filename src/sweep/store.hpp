// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The store of a sweep: one SQLite file in a directory of its own.

#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "sweep/chain_plan.hpp"
#include "sweep/damage.hpp"
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
  std::size_t num_scenes = 0;
};

/// What a store says of a sweep that this program solves.
[[nodiscard]] StoreInfo store_info(const Job& job, const std::string& shard);

/// Results of a sweep as far as they are there. Written by one process alone;
/// others may read meanwhile. Whatever record() was given survives a crash of
/// the process or the machine.
///
/// Each row has a checksum over its key and content. What does not match it is
/// passed over, as if it were not there, and named in damage().
class Store {
 public:
  static constexpr const char* kFileName = "sweep.sqlite";

  ~Store();
  Store(Store&&) noexcept;
  Store& operator=(Store&&) = delete;

  /// True if the directory has a store, whole or not.
  /// \throws StoreError  if the file is empty, which no store ever is, or gone
  ///                     from beside its journal
  [[nodiscard]] static bool exists(const std::filesystem::path& directory);

  /// Makes a store, in full or not at all.
  /// \throws StoreError  if there is one already, or none can be written
  [[nodiscard]] static Store create(const std::filesystem::path& directory,
                                    const StoreInfo& info);
  /// Reads also from where nothing can be written.
  /// \throws StoreError  if there is none, if it is not ours or not readable
  ///                     at all, or if it is to be written to and damaged in
  ///                     more than rows
  [[nodiscard]] static Store open(const std::filesystem::path& directory,
                                  Database::Access access);
  /// Removes a store and what SQLite keeps beside it.
  /// \throws StoreError  if the file is something else
  static void remove(const std::filesystem::path& directory);

  /// Without what damage() names, unless the rest tells it. An empty shard is
  /// not known.
  [[nodiscard]] const StoreInfo& info() const { return info_; }
  /// \throws StoreError  if it is damaged
  [[nodiscard]] Job job() const;

  /// What was found so far; reading finds it.
  [[nodiscard]] const Damage& damage() const { return damage_; }
  /// The same as lines of text.
  [[nodiscard]] std::string damage_text() const {
    return describe(damage_, file_);
  }
  /// Reads everything.
  void check();
  /// Removes what is damaged, so that it is solved again, and takes what the
  /// info lacks from that of the same sweep.
  void mend(const StoreInfo& same);

  /// Adds answers, all or none; they are on disk afterwards. Each state
  /// replaces that of an earlier scene of its chain.
  /// \throws StoreError  also if a scene has a result already
  void record(std::span<const Answer> answers, const ChainPlan& plan);

  /// Changes info().shard.
  void set_shard(const std::string& shard);
  /// Removes results, so that their scenes are solved again.
  void forget(std::span<const std::size_t> scenes);

  /// Calls `visit` for each result in the order of scenes.
  /// \return how many there are
  std::size_t for_each_result(
      const std::function<void(std::size_t, const std::string&)>& visit);
  /// What the next scene starts from; empty: the cycloid. Only the states of
  /// last scenes are kept: nothing if that of this one is not known.
  [[nodiscard]] std::optional<std::string> state_after(std::size_t chain,
                                                       std::size_t scene);

 private:
  class Mark;

  Store(std::filesystem::path file, std::unique_ptr<Database> database);

  void read_info(bool lacks_journal);
  void infer_info();
  [[nodiscard]] std::string nonsense() const;

  std::filesystem::path file_;
  std::unique_ptr<Database> database_;
  std::unique_ptr<Mark> mark_;  ///< nullptr: not to be written to
  StoreInfo info_;
  Damage damage_;
};

}  // namespace brachisto::sweep
