// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/report/output_files.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "brachisto/math/stop_condition.hpp"

namespace brachisto::report {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail(const fs::path& path, const char* what, int error) {
  throw OutputError(
      fmt::format("{}: cannot {}: {}", path.string(), what,
                  std::strerror(error)));  // NOLINT: single-threaded
}

/// A temporary file that disappears unless it is kept.
class TemporaryFile {
 public:
  explicit TemporaryFile(const fs::path& target)
      : path_(target.string() + fmt::format(".{}.tmp", ::getpid())) {
    descriptor_ =
        ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor_ < 0) fail(path_, "create", errno);
  }
  ~TemporaryFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (!kept_) ::unlink(path_.c_str());
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  void write(const std::string& content) {
    // To the disk piece by piece, so that a signal need not wait for all.
    constexpr std::size_t kPiece = 8U << 20U;
    std::size_t done = 0;
    std::size_t synced = 0;
    while (done < content.size()) {
      check_stop();
      const ssize_t count = ::write(descriptor_, content.data() + done,
                                    std::min(kPiece, content.size() - done));
      if (count < 0 && errno == EINTR) continue;
      if (count < 0) fail(path_, "write", errno);
      done += static_cast<std::size_t>(count);
      if (done < synced + kPiece) continue;
      if (::fdatasync(descriptor_) != 0) fail(path_, "write", errno);
      synced = done;
    }
    if (::fsync(descriptor_) != 0) fail(path_, "write", errno);
    const int closed = ::close(descriptor_);
    descriptor_ = -1;
    if (closed != 0) fail(path_, "write", errno);
  }

  void rename_to(const fs::path& target) {
    if (::rename(path_.c_str(), target.c_str()) != 0) {
      fail(target, "create", errno);
    }
    kept_ = true;
  }

 private:
  std::string path_;
  int descriptor_ = -1;
  bool kept_ = false;
};

}  // namespace

void check_writable(const fs::path& directory,
                    const std::vector<std::string>& names, bool force) {
  std::error_code error;
  // What is missing would be made; the first thing that is there must let us.
  fs::path there = fs::absolute(directory);
  while (!fs::exists(there, error) && there.has_relative_path()) {
    there = there.parent_path();
  }
  if (!fs::is_directory(there, error)) {
    throw OutputError(there.string() + ": exists and is not a directory");
  }
  if (::access(there.c_str(), W_OK | X_OK) != 0) fail(there, "write to", errno);
  for (const std::string& name : names) {
    const fs::path target = directory / name;
    if (fs::is_directory(target, error)) {
      throw OutputError(target.string() + ": is a directory");
    }
    if (!force && fs::exists(target, error)) {
      throw OutputError(target.string() + ": exists; --force replaces it");
    }
  }
}

void remove_files(const fs::path& directory,
                  const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    std::error_code error;
    fs::remove(directory / name, error);
    if (error) fail(directory / name, "remove", error.value());
  }
}

void write_files(const fs::path& directory,
                 const std::vector<OutputFile>& files, bool force) {
  std::vector<std::string> names;
  names.reserve(files.size());
  for (const OutputFile& file : files) names.push_back(file.name);
  check_writable(directory, names, force);
  std::error_code error;
  fs::create_directories(directory, error);
  if (error) fail(directory, "create", error.value());
  for (const OutputFile& file : files) {
    const fs::path target = directory / file.name;
    TemporaryFile temporary(target);
    temporary.write(file.content);
    temporary.rename_to(target);
  }
}

}  // namespace brachisto::report
