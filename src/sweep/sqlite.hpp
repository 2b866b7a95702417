// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// As much of SQLite as a store needs, with exceptions.

#pragma once

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

namespace brachisto::sweep {

/// A store cannot be read or written; what() names it and the reason.
class StoreError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What is read is damaged; more of the store may be sound.
class DamagedStore : public StoreError {
 public:
  using StoreError::StoreError;
};

/// An open database.
class Database {
 public:
  enum class Access { ReadOnly, ReadWrite, Create };
  Database(std::string path, Access access);
  ~Database();
  Database(const Database&) = delete;
  Database& operator=(const Database&) = delete;

  /// Readers do not stop the writer from now on, and each commit is flushed to
  /// the disk, into a journal beside the file, which is gone when the database
  /// is closed in order.
  void use_journal();
  /// True if the file is in use with a journal that is not there. To be asked
  /// before it is opened, which may make a new one.
  [[nodiscard]] static bool lacks_journal(const std::string& path);

  void execute(const char* sql);
  [[nodiscard]] std::int64_t pragma(const char* name);
  [[noreturn]] void fail() const;
  [[nodiscard]] sqlite3* handle() const { return handle_; }

 private:
  std::string path_;
  sqlite3* handle_ = nullptr;
  bool uses_journal_ = false;
};

/// A prepared statement. Parameters are numbered from 1, columns from 0.
class Statement {
 public:
  Statement(Database& database, const char* sql);
  ~Statement();
  Statement(const Statement&) = delete;
  Statement& operator=(const Statement&) = delete;

  /// Sets the parameters, in order; texts are copied.
  template <class... Values>
  Statement& with(const Values&... values) {
    int parameter = 0;
    (bind(++parameter, values), ...);
    return *this;
  }
  /// True if there is a row; after the last one the statement is reset.
  [[nodiscard]] bool step();
  void run() {
    while (step()) {
    }
  }
  [[nodiscard]] std::int64_t integer(int column) const;
  [[nodiscard]] std::string text(int column) const;

 private:
  void bind(int parameter, std::int64_t value);
  /// SQLite has no unsigned integers; no count comes near the end of the
  /// signed.
  void bind(int parameter, std::size_t value) {
    bind(parameter, static_cast<std::int64_t>(value));
  }
  void bind(int parameter, std::string_view value);

  Database& database_;
  sqlite3_stmt* handle_ = nullptr;
};

/// A transaction, undone unless it is committed.
class Transaction {
 public:
  enum class Kind { Write, Read };
  explicit Transaction(Database& database, Kind kind = Kind::Write)
      : database_(database) {
    database_.execute(kind == Kind::Write ? "BEGIN IMMEDIATE" : "BEGIN");
  }
  ~Transaction();
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;
  void commit();

 private:
  Database& database_;
  bool open_ = true;
};

}  // namespace brachisto::sweep
