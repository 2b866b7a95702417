// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "sweep/directory_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>

#include "sweep/store.hpp"

namespace brachisto::sweep {

DirectoryLock::DirectoryLock(const std::filesystem::path& directory)
    : made_(directory, error_) {
  namespace fs = std::filesystem;
  const auto fail = [&](const std::string& reason) {
    throw StoreError(directory.string() + ": " + reason);
  };
  std::error_code ignored;
  if (fs::exists(directory, ignored) && !fs::is_directory(directory, ignored)) {
    fail("exists and is not a directory");
  }
  if (error_) fail("cannot be made: " + error_.message());
  // The lock is on the directory; the store must not be in another one.
  if (fs::is_symlink(directory / Store::kFileName, ignored)) {
    fail(std::string(Store::kFileName) +
         " is a link; name the directory that it leads to");
  }
  if (::access(directory.c_str(), W_OK | X_OK) != 0) {
    fail("cannot be written to: " + std::generic_category().message(errno));
  }
  descriptor_ = ::open(directory.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor_ < 0) fail(std::generic_category().message(errno));
  if (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0) {
    const int reason = errno;
    ::close(descriptor_);
    fail(reason == EWOULDBLOCK
             ? "another brachisto is writing there"
             : "cannot be locked: " + std::generic_category().message(reason));
  }
}

DirectoryLock::~DirectoryLock() {
  ::close(descriptor_);
}

}  // namespace brachisto::sweep
