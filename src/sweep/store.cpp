// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "sweep/store.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <map>
#include <nlohmann/json.hpp>
#include <system_error>
#include <utility>

#include "report/provenance.hpp"
#include "sweep/outcome.hpp"

namespace brachisto::sweep {

namespace {

namespace fs = std::filesystem;

constexpr std::int64_t kApplicationId = 0x62726163;  // "brac"
constexpr std::int64_t kFormat = 2;
/// What SQLite keeps beside a file and reads with it.
constexpr std::array kJournals{"-wal", "-journal"};

fs::path file_in(const fs::path& directory) {
  return directory / Store::kFileName;
}

std::int64_t info_checksum(std::string_view key, std::string_view value) {
  return row_checksum(fmt::format("info {}", key), value);
}
std::int64_t result_checksum(std::size_t scene, std::string_view document) {
  return row_checksum(fmt::format("result {}", scene), document);
}
std::int64_t state_checksum(std::size_t chain, std::size_t scene,
                            std::string_view value) {
  return row_checksum(fmt::format("state {} {}", chain, scene), value);
}

void check_ours(Database& database, const fs::path& file) {
  if (database.pragma("application_id") != kApplicationId) {
    throw StoreError(file.string() + ": not a store of brachisto");
  }
}

void check_format(Database& database, const fs::path& file) {
  const std::int64_t format = database.pragma("user_version");
  if (format == kFormat) return;
  throw StoreError(fmt::format(
      "{}: a store of format {}{}; this program knows format {}", file.string(),
      format, format == 1 ? ", which has no checksums" : "", kFormat));
}

/// What is wrong with the file as such, in SQLite's words; empty if nothing is.
std::string structure_fault(Database& database) {
  try {
    Statement check(database, "PRAGMA quick_check(1)");
    if (!check.step()) return "";
    const std::string text = check.text(0);
    // "*** in database main ***\nTree 3 page 5: …"
    return text == "ok" ? "" : text.substr(text.rfind('\n') + 1);
  } catch (const DamagedStore&) {
    return "it cannot be read in full";
  }
}

void remove_file(const fs::path& file) {
  for (const char* suffix : {"", kJournals[0], kJournals[1], "-shm"}) {
    std::error_code error;
    fs::remove(file.string() + suffix, error);
    if (error) {
      throw StoreError(file.string() +
                       ": cannot be removed: " + error.message());
    }
  }
}

/// The rows of the table `info`.
std::array<std::pair<std::string_view, std::string>, 6> rows_of(
    const StoreInfo& info) {
  return {{{"job", info.job},
           {"input_hash", info.input_hash},
           {"version", info.version},
           {"shard", info.shard},
           {"provenance", info.provenance},
           {"scenes", std::to_string(info.num_scenes)}}};
}

void put_info(Database& database, std::string_view key,
              std::string_view value) {
  Statement(database, "INSERT OR REPLACE INTO info VALUES (?, ?, ?)")
      .with(key, value, info_checksum(key, value))
      .run();
}

}  // namespace

/// Says in the file itself, as long as it lives, that results may stand in the
/// journal only.
class Store::Mark {
 public:
  static constexpr const char* kKey = "journal";

  explicit Mark(Database& database) : database_(database) {
    database.use_journal();
    put_info(database, kKey, "in use");
    database.execute("PRAGMA wal_checkpoint(FULL)");
  }
  ~Mark() {
    try {
      database_.execute("DELETE FROM info WHERE key = 'journal'");
    } catch (const StoreError&) {
      // Then it is still in use, as far as others can tell.
    }
  }
  Mark(const Mark&) = delete;
  Mark& operator=(const Mark&) = delete;

 private:
  Database& database_;
};

Store::~Store() = default;
Store::Store(Store&&) noexcept = default;

Store::Store(fs::path file, std::unique_ptr<Database> database)
    : file_(std::move(file)), database_(std::move(database)) {}

bool Store::exists(const fs::path& directory) {
  const fs::path file = file_in(directory);
  std::error_code error;
  const auto lost = [&](const std::string& how) {
    throw StoreError(
        fmt::format("{}: {}; the results that were there are "
                    "lost, and `brachisto sweep` with --force "
                    "begins again",
                    file.string(), how));
  };
  if (!fs::exists(file, error)) {
    // They would become part of a new store of that name.
    for (const char* suffix : kJournals) {
      if (fs::exists(file.string() + suffix, error)) {
        lost(fmt::format("is gone, and its journal ({}) is there", suffix));
      }
    }
    return false;
  }
  if (!fs::is_regular_file(file, error)) {
    throw StoreError(file.string() + ": not a file");
  }
  if (fs::file_size(file, error) == 0) lost("is empty");
  return true;
}

Store Store::create(const fs::path& directory, const StoreInfo& info) {
  const fs::path file = file_in(directory);
  if (exists(directory)) throw StoreError(file.string() + ": is there already");
  // Under another name until it is whole: a store is never half made.
  const fs::path fresh = file.string() + ".new";
  remove_file(fresh);
  try {
    Database database(fresh, Database::Access::Create);
    Transaction transaction(database);
    database.execute(
        fmt::format("PRAGMA application_id = {};"
                    "PRAGMA user_version = {};"
                    "CREATE TABLE info "
                    "(key TEXT PRIMARY KEY, value TEXT, checksum INTEGER) "
                    "WITHOUT ROWID;"
                    "CREATE TABLE result (scene INTEGER PRIMARY KEY, "
                    "document TEXT, checksum INTEGER);"
                    "CREATE TABLE state (chain INTEGER PRIMARY KEY, "
                    "scene INTEGER, value TEXT, checksum INTEGER);",
                    kApplicationId, kFormat)
            .c_str());
    for (const auto& [key, value] : rows_of(info)) {
      put_info(database, key, value);
    }
    transaction.commit();
  } catch (const StoreError&) {
    remove_file(fresh);
    throw;
  }
  std::error_code error;
  fs::rename(fresh, file, error);
  if (error) {
    remove_file(fresh);
    throw StoreError(file.string() + ": cannot be made: " + error.message());
  }
  try {
    return open(directory, Database::Access::ReadWrite);
  } catch (const StoreError&) {
    remove_file(file);
    throw;
  }
}

Store Store::open(const fs::path& directory, Database::Access access) {
  const fs::path file = file_in(directory);
  if (!exists(directory)) {
    throw StoreError(file.string() + ": there is no such store");
  }
  const bool lacks_journal = Database::lacks_journal(file);
  Store store(file, std::make_unique<Database>(file, access));
  check_ours(*store.database_, file);
  check_format(*store.database_, file);
  store.damage_.structure = structure_fault(*store.database_);
  store.read_info(lacks_journal);
  if (access != Database::Access::ReadOnly) {
    if (!store.damage_.structure.empty()) {
      throw StoreError(store.damage_text());
    }
    store.mark_ = std::make_unique<Mark>(*store.database_);
  }
  return store;
}

void Store::remove(const fs::path& directory) {
  const fs::path file = file_in(directory);
  std::error_code error;
  if (fs::file_size(file, error) > 0 && !error) {
    Database database(file, Database::Access::ReadWrite);
    check_ours(database, file);
  }
  remove_file(file);
}

void Store::read_info(bool lacks_journal) {
  std::map<std::string, std::string> sound;
  Statement select(*database_, "SELECT key, value, checksum FROM info");
  while (select.step()) {
    if (info_checksum(select.text(0), select.text(1)) == select.integer(2)) {
      sound[select.text(0)] = select.text(1);
    }
  }
  damage_.journal_lost = lacks_journal && sound.contains(Mark::kKey);
  const auto value = [&](const char* key) {
    if (!sound.contains(key)) damage_.info.emplace_back(key);
    return sound[key];
  };
  info_ = {.job = value("job"),
           .input_hash = value("input_hash"),
           .version = value("version"),
           .shard = value("shard"),
           .provenance = value("provenance")};
  const std::string scenes = value("scenes");
  std::from_chars(scenes.data(), scenes.data() + scenes.size(),
                  info_.num_scenes);
  infer_info();
  if (info_.num_scenes > 0 && info_.num_scenes <= io::kMaxScenes &&
      !info_.input_hash.empty() && !info_.version.empty()) {
    return;
  }
  throw StoreError(
      damage_.info.empty()
          ? nonsense()
          : damage_text() +
                "; without these nothing can be said of its results: sweep "
                "--force begins again");
}

// Of what is damaged the rest may tell. The shard is told by nothing, and only
// keeps results from where they are not expected.
void Store::infer_info() {
  if (damage_.info.empty()) return;
  try {
    if (!info_.job.empty()) {
      const io::SweepFile file = job_from_line(info_.job).file;
      if (info_.num_scenes == 0) info_.num_scenes = file.num_scenes();
      if (info_.input_hash.empty()) info_.input_hash = input_hash(file);
    }
  } catch (const JobError&) {
    throw StoreError(nonsense());
  }
  if (info_.version.empty() && !info_.provenance.empty()) {
    const auto made_with = parse_bounded_json(info_.provenance);
    if (!made_with || !made_with->is_object()) throw StoreError(nonsense());
    info_.version = made_with->value("brachisto", "");
  }
}

std::string Store::nonsense() const {
  return file_.string() + ": says of its sweep what cannot be";
}

Job Store::job() const {
  if (info_.job.empty()) {
    throw StoreError(damage_text() +
                     "; `brachisto sweep FILE --resume` with the problem file "
                     "that it was made from mends that");
  }
  try {
    Job job = job_from_line(info_.job);
    if (job.file.num_scenes() == info_.num_scenes) return job;
  } catch (const JobError&) {
  }
  throw StoreError(nonsense());
}

void Store::check() {
  for_each_result([](std::size_t, const std::string&) {});
  damage_.states = 0;
  Statement select(*database_,
                   "SELECT chain, scene, value, checksum FROM state");
  while (select.step()) {
    const auto chain = static_cast<std::size_t>(select.integer(0));
    const auto scene = static_cast<std::size_t>(select.integer(1));
    if (state_checksum(chain, scene, select.text(2)) != select.integer(3)) {
      ++damage_.states;
    }
  }
}

void Store::mend(const StoreInfo& same) {
  if (!damage_) return;
  forget(
      std::vector<std::size_t>(damage_.scenes.begin(), damage_.scenes.end()));
  Transaction transaction(*database_);
  Statement(*database_, "DELETE FROM result WHERE scene < 0 OR scene >= ?")
      .with(info_.num_scenes)
      .run();
  // Those that are sound can be found again, at the price of their chains.
  if (damage_.states > 0) database_->execute("DELETE FROM state");
  if (!damage_.info.empty()) {
    const std::string shard = info_.shard.empty() ? same.shard : info_.shard;
    info_ = same;
    info_.shard = shard;
    for (const auto& [key, value] : rows_of(info_)) {
      put_info(*database_, key, value);
    }
  }
  transaction.commit();
  damage_ = {};
}

void Store::record(std::span<const Answer> answers, const ChainPlan& plan) {
  if (answers.empty()) return;
  Transaction transaction(*database_);
  Statement insert(*database_, "INSERT INTO result VALUES (?, ?, ?)");
  Statement remember(*database_,
                     "INSERT INTO state VALUES (?1, ?2, ?3, ?4) "
                     "ON CONFLICT (chain) DO UPDATE SET "
                     "scene = ?2, value = ?3, checksum = ?4 WHERE scene < ?2");
  Statement forget_state(*database_, "DELETE FROM state WHERE chain = ?");
  for (const Answer& answer : answers) {
    const std::size_t scene = answer.scene;
    insert.with(scene, answer.result, result_checksum(scene, answer.result))
        .run();
    const Chain chain = plan.of_scene(scene);
    if (scene + 1 == chain.last) {
      forget_state.with(chain.id).run();
    } else if (const auto& state = answer.state) {
      remember
          .with(chain.id, scene, *state,
                state_checksum(chain.id, scene, *state))
          .run();
    }
  }
  transaction.commit();
}

void Store::set_shard(const std::string& shard) {
  put_info(*database_, "shard", shard);
  info_.shard = shard;
}

void Store::forget(std::span<const std::size_t> scenes) {
  Transaction transaction(*database_);
  Statement remove(*database_, "DELETE FROM result WHERE scene = ?");
  for (const std::size_t scene : scenes) remove.with(scene).run();
  transaction.commit();
}

std::size_t Store::for_each_result(
    const std::function<void(std::size_t, const std::string&)>& visit) {
  const Transaction snapshot(*database_, Transaction::Kind::Read);
  // One by one: what is damaged keeps no other from being found.
  Statement select(*database_,
                   "SELECT document, checksum FROM result WHERE scene = ?");
  std::size_t count = 0;
  for (std::size_t scene = 0; scene < info_.num_scenes; ++scene) {
    std::optional<std::string> document;
    try {
      if (!select.with(scene).step()) continue;
      document = select.text(0);
      if (result_checksum(scene, *document) != select.integer(1) ||
          !is_outcome(*document)) {
        document.reset();
      }
      (void)select.step();
    } catch (const DamagedStore&) {
      document.reset();
    }
    if (document) {
      ++count;
      visit(scene, *document);
    } else {
      damage_.scenes.insert(scene);
    }
  }
  try {
    Statement strays(
        *database_,
        "SELECT count(*) FROM result WHERE scene < 0 OR scene >= ?");
    if (strays.with(info_.num_scenes).step()) {
      damage_.strays = static_cast<std::size_t>(strays.integer(0));
    }
  } catch (const DamagedStore&) {
    // The file as such is damaged, and damage_ says so.
  }
  return count;
}

std::optional<std::string> Store::state_after(std::size_t chain,
                                              std::size_t scene) {
  try {
    Statement select(
        *database_,
        "SELECT value, checksum FROM state WHERE chain = ? AND scene = ?");
    if (!select.with(chain, scene).step()) return std::nullopt;
    std::string value = select.text(0);
    if (select.integer(1) == state_checksum(chain, scene, value)) return value;
  } catch (const DamagedStore&) {
    // It is as good as not there.
  }
  return std::nullopt;
}

StoreInfo store_info(const Job& job, const std::string& shard) {
  return {.job = to_line(job),
          .input_hash = input_hash(job.file),
          .version = report::provenance().brachisto,
          .shard = shard,
          .provenance = report::provenance_json(),
          .num_scenes = job.file.num_scenes()};
}

}  // namespace brachisto::sweep
