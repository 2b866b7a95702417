// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/report/result.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <utility>

#include "brachisto/math/clock.hpp"
#include "report/in_full.hpp"

namespace brachisto::report {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail(const fs::path& path, const char* what, int error) {
  throw OutputError(
      fmt::format("{}: cannot {}: {}", path.string(), what,
                  std::strerror(error)));  // NOLINT: single-threaded
}

/// A file under a temporary name, which disappears unless it gets its own.
class TemporaryFile {
 public:
  explicit TemporaryFile(fs::path target)
      : target_(std::move(target)),
        path_(target_.string() + fmt::format(".{}.tmp", ::getpid())) {
    descriptor_ =
        ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor_ < 0) fail(path_, "create", errno);
  }
  ~TemporaryFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (!path_.empty()) ::unlink(path_.c_str());
  }
  TemporaryFile(TemporaryFile&& other) noexcept
      : target_(std::move(other.target_)),
        path_(std::exchange(other.path_, {})),
        descriptor_(std::exchange(other.descriptor_, -1)),
        not_synced_(other.not_synced_) {}
  TemporaryFile& operator=(TemporaryFile&&) = delete;

  void append(std::string_view content) {
    // To the disk piece by piece, so that a signal need not wait for all. One
    // that is held changes no condition in force.
    constexpr std::size_t kPiece = 8U << 20U;
    while (!content.empty()) {
      check_stop();
      if (HeldSignals::waiting()) throw Stopped();
      const ssize_t count = ::write(descriptor_, content.data(),
                                    std::min(kPiece, content.size()));
      if (count < 0 && errno == EINTR) continue;
      if (count < 0) fail(path_, "write", errno);
      content.remove_prefix(static_cast<std::size_t>(count));
      not_synced_ += static_cast<std::size_t>(count);
      if (not_synced_ < kPiece) continue;
      if (::fdatasync(descriptor_) != 0) fail(path_, "write", errno);
      not_synced_ = 0;
    }
  }

  void close() {
    if (::fsync(descriptor_) != 0) fail(path_, "write", errno);
    const int closed = ::close(std::exchange(descriptor_, -1));
    if (closed != 0) fail(path_, "write", errno);
  }

  void rename_to_target() {
    if (::rename(path_.c_str(), target_.c_str()) != 0) {
      fail(target_, "create", errno);
    }
    path_.clear();
  }

 private:
  fs::path target_;
  std::string path_;
  int descriptor_ = -1;
  std::size_t not_synced_ = 0;
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

void write_files(const fs::path& directory,
                 const std::vector<OutputFile>& files, bool force,
                 const std::vector<std::string>& obsolete) {
  std::vector<StreamedFile> streamed;
  streamed.reserve(files.size());
  for (const OutputFile& file : files) {
    streamed.push_back(
        {file.name, [&file](const TextSink& put) { put(file.content); }});
  }
  write_streamed_files(directory, streamed, force, obsolete);
}

void write_streamed_files(const fs::path& directory,
                          const std::vector<StreamedFile>& files, bool force,
                          const std::vector<std::string>& obsolete) {
  std::vector<std::string> names;
  names.reserve(files.size());
  for (const StreamedFile& file : files) names.push_back(file.name);
  check_writable(directory, names, force);
  const HeldSignals held;
  std::error_code error;
  const NewDirectories made(directory, error);
  if (error) fail(directory, "create", error.value());
  // Whatever needs room on the disk comes before the first change.
  std::vector<TemporaryFile> written;
  written.reserve(files.size());
  for (const StreamedFile& file : files) {
    TemporaryFile& out = written.emplace_back(directory / file.name);
    file.tell([&out](std::string_view piece) { out.append(piece); });
    out.close();
  }
  for (const std::string& name : obsolete) {
    fs::remove(directory / name, error);
    if (error) fail(directory / name, "remove", error.value());
  }
  for (TemporaryFile& file : written) file.rename_to_target();
}

namespace {

std::atomic<int> received{0};
static_assert(std::atomic<int>::is_always_lock_free,
              "a signal handler may touch lock-free atomics only");

extern "C" void hold(int signal) {
  received.store(signal);
}

}  // namespace

// A mask would not do: it holds for one thread, and the BLAS may have others.
HeldSignals::HeldSignals() {
  struct sigaction action = {};
  action.sa_handler = hold;
  action.sa_flags = SA_RESTART;
  sigemptyset(&action.sa_mask);
  for (std::size_t i = 0; i < kSignals.size(); ++i) {
    sigaction(kSignals[i], nullptr, &before_[i]);
    // What is ignored stays so: under nohup, for instance.
    if (before_[i].sa_handler != SIG_IGN) {
      sigaction(kSignals[i], &action, nullptr);
    }
  }
}

HeldSignals::~HeldSignals() {
  for (std::size_t i = 0; i < kSignals.size(); ++i) {
    sigaction(kSignals[i], &before_[i], nullptr);
  }
  if (const int signal = received.exchange(0); signal != 0) ::raise(signal);
}

bool HeldSignals::waiting() {
  return received.load() != 0;
}

NewDirectories::NewDirectories(const fs::path& directory,
                               std::error_code& error) {
  std::error_code ignored;
  for (fs::path missing = fs::absolute(directory);
       !fs::exists(missing, ignored) && missing.has_relative_path();
       missing = missing.parent_path()) {
    made_.push_back(missing);
  }
  fs::create_directories(directory, error);
}

NewDirectories::~NewDirectories() {
  // The call refuses a directory that something is in.
  for (const fs::path& one : made_) ::rmdir(one.c_str());
}

}  // namespace brachisto::report
