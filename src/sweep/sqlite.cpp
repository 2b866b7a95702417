// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "sweep/sqlite.hpp"
#include "math/enum_table.hpp"
#include "report/rich_text.hpp"

#include <sqlite3.h>
#include <unistd.h>

#include <array>
#include <fstream>
#include <system_error>
#include <utility>

namespace brachisto::sweep {

namespace {

int flags_of(Database::Access access) {
  constexpr auto kFlags =
      table_by<Database::Access>(SQLITE_OPEN_READONLY, SQLITE_OPEN_READWRITE,
                                 SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE);
  return kFlags[access];
}

/// Beside the file, as long as it is in use.
std::string journal_of(const std::string& path) {
  return path + "-wal";
}

/// With the characters escaped that mean something in a URI.
std::string uri_path(const std::string& path) {
  using report::replaced;
  return replaced(replaced(replaced(path, "%", "%25"), "?", "%3f"), "#", "%23");
}

}  // namespace

Database::Database(std::string path, Access access) : path_(std::move(path)) {
  // Without its journal the file is read as it is: a new one would hide that.
  const bool immutable = access == Access::ReadOnly && lacks_journal(path_);
  const std::string name =
      immutable ? "file:" + uri_path(path_) + "?immutable=1" : path_;
  const int code = sqlite3_open_v2(
      name.c_str(), &handle_,
      flags_of(access) | (immutable ? SQLITE_OPEN_URI : 0), nullptr);
  if (code != SQLITE_OK) {
    const std::string reason =
        handle_ != nullptr ? sqlite3_errmsg(handle_) : sqlite3_errstr(code);
    sqlite3_close(handle_);
    throw StoreError(path_ + ": " + reason);
  }
  // Readers of a running sweep hold the file for moments only.
  sqlite3_busy_timeout(handle_, 10'000);
}

Database::~Database() {
  // If somebody still reads, the journal stays, and the file goes on saying so.
  if (uses_journal_) {
    sqlite3_exec(handle_, "PRAGMA journal_mode = MEMORY", nullptr, nullptr,
                 nullptr);
  }
  sqlite3_close(handle_);
}

void Database::use_journal() {
  uses_journal_ = true;
  Statement mode(*this, "PRAGMA journal_mode");
  const bool in_use = mode.step() && mode.text(0) == "wal";  // after a kill
  (void)mode.step();
  if (!in_use) {
    // The change of one page that says so needs no journal of the other kind,
    // which readers could not undo after another kill.
    execute("PRAGMA journal_mode = MEMORY");
    execute("PRAGMA journal_mode = WAL");
  }
  execute("PRAGMA synchronous = FULL");
  // The files beside it are made with the first transaction, or cannot be.
  const Transaction first(*this);
}

bool Database::lacks_journal(const std::string& path) {
  // "File format write version" and "read version", 2 for WAL:
  // https://www.sqlite.org/fileformat.html, section 1.3.3
  std::array<char, 20> header{};
  std::ifstream(path, std::ios::binary).read(header.data(), header.size());
  return header[18] == 2 && header[19] == 2 &&
         ::access(journal_of(path).c_str(), F_OK) != 0;
}

void Database::fail() const {
  std::string reason = sqlite3_errmsg(handle_);
  const int code = sqlite3_errcode(handle_) & 0xff;
  if (code == SQLITE_CORRUPT) {
    throw DamagedStore(path_ + ": damaged: " + reason);
  }
  const int system = sqlite3_system_errno(handle_);
  if (code == SQLITE_IOERR && system != 0) {
    reason += ": " + std::generic_category().message(system);
  }
  throw StoreError(path_ + ": " + reason);
}

void Database::execute(const char* sql) {
  if (sqlite3_exec(handle_, sql, nullptr, nullptr, nullptr) != SQLITE_OK) {
    fail();
  }
}

std::int64_t Database::pragma(const char* name) {
  Statement statement(*this, (std::string("PRAGMA ") + name).c_str());
  return statement.step() ? statement.integer(0) : 0;
}

Statement::Statement(Database& database, const char* sql)
    : database_(database) {
  if (sqlite3_prepare_v2(database.handle(), sql, -1, &handle_, nullptr) !=
      SQLITE_OK) {
    database_.fail();
  }
}

Statement::~Statement() {
  sqlite3_finalize(handle_);
}

void Statement::bind(int parameter, std::int64_t value) {
  if (sqlite3_bind_int64(handle_, parameter, value) != SQLITE_OK) {
    database_.fail();
  }
}

void Statement::bind(int parameter, std::string_view value) {
  if (sqlite3_bind_text64(handle_, parameter, value.data(), value.size(),
                          SQLITE_TRANSIENT, SQLITE_UTF8) != SQLITE_OK) {
    database_.fail();
  }
}

bool Statement::step() {
  const int code = sqlite3_step(handle_);
  if (code == SQLITE_ROW) return true;
  if (code != SQLITE_DONE) {
    sqlite3_reset(handle_);
    database_.fail();
  }
  sqlite3_reset(handle_);
  return false;
}

std::int64_t Statement::integer(int column) const {
  return sqlite3_column_int64(handle_, column);
}

std::string Statement::text(int column) const {
  const auto* bytes = sqlite3_column_text(handle_, column);
  if (bytes == nullptr) return {};
  return {reinterpret_cast<const char*>(bytes),
          static_cast<std::size_t>(sqlite3_column_bytes(handle_, column))};
}

Transaction::~Transaction() {
  if (open_) {
    sqlite3_exec(database_.handle(), "ROLLBACK", nullptr, nullptr, nullptr);
  }
}

void Transaction::commit() {
  database_.execute("COMMIT");
  open_ = false;
}

}  // namespace brachisto::sweep
