// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "sweep/store.hpp"

#include <utility>

namespace brachisto::sweep {

namespace {

namespace fs = std::filesystem;

constexpr std::int64_t kApplicationId = 0x62726163;  // "brac"
constexpr std::int64_t kFormat = 1;

fs::path file_in(const fs::path& directory) {
  return directory / Store::kFileName;
}

std::int64_t to_integer(std::size_t value) {
  return static_cast<std::int64_t>(value);
}

/// A file that another process is about to fill has no tables yet.
bool has_tables(Database& database) {
  Statement count(database, "SELECT count(*) FROM sqlite_master");
  return count.step() && count.integer(0) > 0;
}

void make_durable(Database& database) {
  // Readers do not stop the writer; each commit is flushed to the disk.
  database.execute("PRAGMA journal_mode = WAL");
  database.execute("PRAGMA synchronous = FULL");
}

StoreInfo read_info(Database& database) {
  Statement select(database, "SELECT value FROM info WHERE key = ?");
  const auto value = [&](const char* key) {
    select.bind(1, std::string_view(key));
    std::string text = select.step() ? select.text(0) : "";
    while (select.step()) {
    }
    return text;
  };
  return {.job = value("job"),
          .input_hash = value("input_hash"),
          .version = value("version"),
          .shard = value("shard"),
          .provenance = value("provenance")};
}

void check_ours(Database& database, const std::string& path) {
  if (database.pragma("application_id") != kApplicationId) {
    throw StoreError(path + ": not a store of brachisto");
  }
}

}  // namespace

Store::Store(std::unique_ptr<Database> database, StoreInfo info)
    : database_(std::move(database)), info_(std::move(info)) {}

bool Store::exists(const fs::path& directory) {
  std::error_code error;
  if (!fs::exists(file_in(directory), error)) return false;
  Database database(file_in(directory).string(), Database::Access::ReadWrite);
  return has_tables(database);
}

Store Store::create(const fs::path& directory, const StoreInfo& info) {
  auto database = std::make_unique<Database>(file_in(directory).string(),
                                             Database::Access::Create);
  make_durable(*database);
  Transaction transaction(*database);
  database->execute(
      ("PRAGMA application_id = " + std::to_string(kApplicationId)).c_str());
  database->execute(
      ("PRAGMA user_version = " + std::to_string(kFormat)).c_str());
  database->execute(
      "CREATE TABLE info (key TEXT PRIMARY KEY, value TEXT NOT NULL);"
      "CREATE TABLE result (scene INTEGER PRIMARY KEY, document TEXT NOT NULL);"
      "CREATE TABLE state (chain INTEGER PRIMARY KEY, value TEXT NOT NULL);");
  Statement insert(*database, "INSERT INTO info VALUES (?, ?)");
  const auto put = [&](std::string_view key, const std::string& value) {
    insert.bind(1, key).bind(2, std::string_view(value)).run();
  };
  put("job", info.job);
  put("input_hash", info.input_hash);
  put("version", info.version);
  put("shard", info.shard);
  put("provenance", info.provenance);
  transaction.commit();
  return {std::move(database), info};
}

Store Store::open(const fs::path& directory, Database::Access access) {
  const std::string path = file_in(directory).string();
  std::error_code error;
  if (!fs::exists(path, error)) {
    throw StoreError(path + ": there is no such store");
  }
  auto database = std::make_unique<Database>(path, access);
  check_ours(*database, path);
  const std::int64_t format = database->pragma("user_version");
  if (format != kFormat) {
    throw StoreError(path + ": a store of format " + std::to_string(format) +
                     "; this program knows format " + std::to_string(kFormat));
  }
  Statement check(*database, "PRAGMA quick_check(1)");
  if (check.step() && check.text(0) != "ok") {
    throw StoreError(path + ": damaged: " + check.text(0));
  }
  if (access != Database::Access::ReadOnly) make_durable(*database);
  StoreInfo info = read_info(*database);
  return {std::move(database), std::move(info)};
}

void Store::remove(const fs::path& directory) {
  const std::string path = file_in(directory).string();
  std::error_code error;
  if (!fs::exists(path, error)) return;
  if (fs::file_size(path) > 0) {
    Database database(path, Database::Access::ReadWrite);
    check_ours(database, path);
  }
  for (const char* suffix : {"", "-wal", "-shm"}) {
    fs::remove(file_in(directory).string() + suffix);
  }
}

void Store::record(std::span<const Answer> answers, const ChainPlan& plan) {
  if (answers.empty()) return;
  Transaction transaction(*database_);
  Statement insert(*database_, "INSERT INTO result VALUES (?, ?)");
  Statement remember(*database_, "INSERT OR REPLACE INTO state VALUES (?, ?)");
  Statement forget(*database_, "DELETE FROM state WHERE chain = ?");
  for (const Answer& answer : answers) {
    insert.bind(1, to_integer(answer.scene))
        .bind(2, std::string_view(answer.result))
        .run();
    const Chain chain = plan.of_scene(answer.scene);
    const bool is_last = answer.scene + 1 == chain.last;
    if (is_last || answer.state.empty()) {
      forget.bind(1, to_integer(chain.id)).run();
    } else {
      remember.bind(1, to_integer(chain.id))
          .bind(2, std::string_view(answer.state))
          .run();
    }
  }
  transaction.commit();
}

void Store::set_shard(const std::string& shard) {
  Statement update(*database_, "UPDATE info SET value = ? WHERE key = 'shard'");
  update.bind(1, std::string_view(shard)).run();
  info_.shard = shard;
}

void Store::forget(std::span<const std::size_t> scenes) {
  Transaction transaction(*database_);
  Statement remove(*database_, "DELETE FROM result WHERE scene = ?");
  for (const std::size_t scene : scenes) {
    remove.bind(1, to_integer(scene)).run();
  }
  transaction.commit();
}

std::size_t Store::num_results() {
  Statement count(*database_, "SELECT count(*) FROM result");
  return count.step() ? static_cast<std::size_t>(count.integer(0)) : 0;
}

std::vector<bool> Store::finished(std::size_t num_scenes) {
  std::vector<bool> done(num_scenes, false);
  Statement select(*database_, "SELECT scene FROM result");
  while (select.step()) {
    const auto scene = static_cast<std::size_t>(select.integer(0));
    if (scene >= num_scenes) throw StoreError("a result of no scene");
    done[scene] = true;
  }
  return done;
}

void Store::for_each_result(
    const std::function<void(std::size_t, const std::string&)>& visit) {
  Statement select(*database_,
                   "SELECT scene, document FROM result ORDER BY scene");
  while (select.step()) {
    visit(static_cast<std::size_t>(select.integer(0)), select.text(1));
  }
}

std::string Store::state_of(std::size_t chain) {
  Statement select(*database_, "SELECT value FROM state WHERE chain = ?");
  select.bind(1, to_integer(chain));
  return select.step() ? select.text(0) : "";
}

}  // namespace brachisto::sweep
